#include "PythonStatistics.h"

#include "Arguments.h"
#include "ArrayOutput.h"
#include "PythonMesh.h"
#include "ScaledJacobians.h"
#include "Unlocked.h"
#include "moserhex/ShapeStatistics/EqualVolumeShape.h"
#include "moserhex/ShapeStatistics/GroupDesign.h"
#include "moserhex/ShapeStatistics/Procrustes.h"
#include "moserhex/ShapeStatistics/ShapeModel.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <memory>

namespace moserhex::python
{
namespace
{

namespace py = pybind11;
using Matrix = Eigen::MatrixXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/** A row for each subject, the coordinates of its P points one after the other. */
class ShapeRows
{
public:
  /** \param shapes  S x P x 3 \throws BadInput (Dimension) */
  explicit ShapeRows(const py::object & shapes) : m_Numbers(numbersFrom("shapes", shapes, m_Shape))
  {
    if (m_Shape[2] != 3 || m_Numbers.empty())
    {
      throw BadInput(ErrorCode::Dimension, "shapes", "not points of many subjects", "give an array of shape (S, P, 3)");
    }
  }

  [[nodiscard]] std::size_t
  subjects() const
  {
    return m_Shape[0];
  }

  [[nodiscard]] std::size_t
  points() const
  {
    return m_Shape[1];
  }

  [[nodiscard]] Positions
  subject(std::size_t number) const
  {
    Positions      positions(points());
    const double * next = m_Numbers.data() + 3 * points() * number;
    for (Vector3 & position : positions)
    {
      position = { next[0], next[1], next[2] };
      next += 3;
    }
    return positions;
  }

  [[nodiscard]] Matrix
  rows() const
  {
    return Eigen::Map<const RowMajor>(
      m_Numbers.data(), static_cast<Eigen::Index>(subjects()), static_cast<Eigen::Index>(3 * points()));
  }

private:
  std::vector<std::size_t> m_Shape = std::vector<std::size_t>(3);
  std::vector<double>      m_Numbers;
};

/** A table in memory that lets Ctrl-C through. */
class WatchedTable : public MatrixTable
{
public:
  WatchedTable(Matrix values, Watch & watch) : MatrixTable(std::move(values)), m_Watch(watch)
  {}

  [[nodiscard]] Matrix
  read(std::size_t firstColumn, std::size_t count) const override
  {
    m_Watch.look();
    return MatrixTable::read(firstColumn, count);
  }

private:
  Watch & m_Watch;
};

py::array
vectorArray(const Eigen::VectorXd & vector)
{
  return arrayOf(std::vector<double>(vector.data(), vector.data() + vector.size()),
                 { static_cast<py::ssize_t>(vector.size()) });
}

/** Columns of coordinates, one shape each: (columns, P, 3). */
py::array
shapesArray(const Matrix & columns)
{
  return arrayOf(std::vector<double>(columns.data(), columns.data() + columns.size()),
                 { static_cast<py::ssize_t>(columns.cols()), static_cast<py::ssize_t>(columns.rows() / 3), 3 });
}

/** \throws BadInput (Dimension) */
Eigen::VectorXd
vectorFrom(const std::string & name, const py::object & numbers)
{
  std::vector<std::size_t>  shape(1);
  const std::vector<double> values = numbersFrom(name, numbers, shape);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/** (rows, columns). \throws BadInput (Dimension) */
Matrix
matrixFrom(const std::string & name, const py::object & numbers)
{
  std::vector<std::size_t>  shape(2);
  const std::vector<double> values = numbersFrom(name, numbers, shape);
  return Eigen::Map<const RowMajor>(
    values.data(), static_cast<Eigen::Index>(shape[0]), static_cast<Eigen::Index>(shape[1]));
}

/** mean, aligned, matrices, size, deviation, converged. */
py::tuple
procrustes(const py::object & shapes, const std::string & align, double tolerance, int steps, long long threads)
{
  const ShapeRows   rows(shapes);
  ProcrustesOptions options;
  options.kind = alignmentFrom(align);
  options.tolerance = tolerance;
  options.maximumSteps = steps;
  options.threads = threadsFrom(threads);
  const ProcrustesResult result = unlocked([&](Watch & watch) {
    const auto load = [&](std::size_t subject) {
      watch.look();
      return rows.subject(subject);
    };
    return generalisedProcrustes(rows.subjects(), load, options);
  });
  const auto             count = static_cast<py::ssize_t>(rows.subjects());
  std::vector<double>    aligned;
  std::vector<double>    matrices;
  for (std::size_t subject = 0; subject < rows.subjects(); ++subject)
  {
    const SimilarityTransform & transform = result.transforms[subject];
    for (const Vector3 & point : transformed(rows.subject(subject), transform))
    {
      aligned.insert(aligned.end(), point.data(), point.data() + 3);
    }
    RowMajor matrix = RowMajor::Identity(4, 4);
    matrix.topLeftCorner(3, 3) = transform.scale * transform.rotation;
    matrix.topRightCorner(3, 1) = transform.translation;
    matrices.insert(matrices.end(), matrix.data(), matrix.data() + matrix.size());
  }
  return py::make_tuple(arrayOf(result.mean, Space::LPS),
                        arrayOf(aligned, { count, static_cast<py::ssize_t>(rows.points()), 3 }),
                        arrayOf(matrices, { count, 4, 4 }),
                        result.size,
                        result.deviation,
                        result.report.converged);
}

/** The exact mesh of a mean of lattices. \param points  P x 3, in `space` */
std::unique_ptr<PythonMesh>
exactMean(const py::object &  points,
          const std::string & space,
          int                 nodesPerSide,
          int                 paddingLayers,
          long long           threads,
          const py::object &  progress)
{
  const Space        ownSpace = spaceOf(space);
  const unsigned int count = threadsFrom(threads);
  HexMesh            mean;
  mean.nodesPerSide = nodesPerSide;
  mean.paddingLayers = paddingLayers;
  mean.nodes = rowsFrom("points", points);
  for (Vector3 & node : mean.nodes)
  {
    node = flip(node, ownSpace);
  }
  return unlocked(
    [&](Watch & watch) {
      EqualVolumeOptions options;
      options.threads = count;
      EqualVolumeShape result =
        equalVolumeShape(mean, options, [&watch](double fraction) { return watch.goOn(fraction); });
      if (!watch.goOn(1.0))
      {
        throw Cancelled();
      }
      HexMeshFields fields;
      fields.scaledJacobian = app::scaledJacobiansOf(result.mesh);
      return std::make_unique<PythonMesh>(std::move(result.mesh), std::move(fields), ownSpace, result.shortcomings, "");
    },
    progress);
}

/** mean, modes, variances, total variance, scores of the modes kept. */
py::tuple
fitShapes(const py::object & shapes, long long modes, double variance, long long threads)
{
  const ShapeRows   rows(shapes);
  ShapeModelOptions options;
  if (modes < 0)
  {
    throw InvalidInput(ErrorCode::Usage, "modes: " + std::to_string(modes) + ", need at least 1");
  }
  options.maximumModes = static_cast<std::size_t>(modes);
  options.varianceFraction = variance;
  options.threads = threadsFrom(threads);
  const ShapeModelResult fit =
    unlocked([&](Watch & watch) { return fitShapeModel(WatchedTable(rows.rows(), watch), options); });
  const ShapeModel & model = fit.model;
  const Matrix       scores = fit.scores.leftCols(model.modes.cols());
  return py::make_tuple(arrayOf(pointsOf(model.mean), Space::LPS),
                        shapesArray(model.modes),
                        vectorArray(model.variances),
                        model.totalVariance,
                        arrayOf(scores));
}

/** \param modes  K x P x 3 */
ShapeModel
modelFrom(const py::object & mean, const py::object & modes)
{
  const ShapeRows rows(modes);
  ShapeModel      model;
  model.mean = coordinatesOf(rowsFrom("mean", mean));
  model.modes = rows.rows().transpose();
  if (model.modes.rows() != model.mean.size())
  {
    throw InvalidInput("modes: of another number of points than the mean");
  }
  return model;
}

py::array
scoresOfShape(const py::object & mean, const py::object & modes, const py::object & shape)
{
  return vectorArray(scoresOf(modelFrom(mean, modes), coordinatesOf(rowsFrom("shape", shape))));
}

py::array
reconstructShape(const py::object & mean, const py::object & modes, const py::object & scores)
{
  return arrayOf(pointsOf(reconstruct(modelFrom(mean, modes), vectorFrom("scores", scores))), Space::LPS);
}

/** \param groups  of each subject, 0 to count - 1 */
py::array
columnsOfGroups(const py::object & groups, std::size_t count)
{
  const Eigen::VectorXd    numbers = vectorFrom("groups", groups);
  std::vector<std::size_t> groupOf(static_cast<std::size_t>(numbers.size()));
  std::transform(numbers.data(), numbers.data() + numbers.size(), groupOf.begin(), [](double number) {
    return static_cast<std::size_t>(number);
  });
  return arrayOf(Matrix(groupColumns(groupOf, count)));
}

/** \param values  S x (L q) \param effect  S x h */
py::dict
testByPermutation(const py::object & values,
                  long long          componentsPerPlace,
                  const py::object & effect,
                  const py::object & nuisance,
                  long long          permutations,
                  std::uint64_t      seed,
                  long long          threads)
{
  if (permutations < 1 || componentsPerPlace < 1)
  {
    throw InvalidInput(ErrorCode::Usage, "permutations: " + std::to_string(permutations) + ", need at least 1");
  }
  Matrix             table = matrixFrom("values", values);
  const LinearDesign design{ matrixFrom("effect", effect), matrixFrom("nuisance", nuisance) };
  PermutationOptions options;
  options.permutations = static_cast<std::size_t>(permutations);
  options.seed = seed;
  options.componentsPerPlace = static_cast<std::size_t>(componentsPerPlace);
  options.threads = threadsFrom(threads);
  const PermutationResult result =
    unlocked([&](Watch & watch) { return permutationTest(WatchedTable(std::move(table), watch), design, options); });
  py::dict answer;
  answer["slope"] = arrayOf(Matrix(result.slope.transpose()));
  answer["pillai_trace"] = vectorArray(result.pillaiTrace);
  answer["statistic"] = vectorArray(result.statistic);
  answer["p"] = vectorArray(result.p);
  answer["p_family_wise"] = vectorArray(result.pFamilyWise);
  answer["q_false_discovery"] = vectorArray(result.qFalseDiscovery);
  answer["partial_correlation"] = vectorArray(result.partialCorrelation);
  answer["standardised_difference"] =
    result.standardisedDifference.size() > 0 ? py::object(vectorArray(result.standardisedDifference)) : py::none();
  answer["permutations"] = result.permutations;
  answer["is_exact"] = result.isExact;
  answer["smallest_possible_p"] = result.smallestPossibleP;
  answer["nuisance_left_out"] = result.nuisanceLeftOut;
  answer["degrees_of_freedom"] = result.degreesOfFreedom;
  return answer;
}

} // namespace

void
addShapeStatistics(py::module_ & module)
{
  module.def("procrustes", &procrustes);
  module.def("exact_mean", &exactMean);
  module.def("fit_shapes", &fitShapes);
  module.def("scores_of", &scoresOfShape);
  module.def("reconstruct", &reconstructShape);
  module.def("group_columns", &columnsOfGroups);
  module.def("permutation_test", &testByPermutation);
}

} // namespace moserhex::python
