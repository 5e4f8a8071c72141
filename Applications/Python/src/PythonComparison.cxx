#include "PythonComparison.h"

#include "ArgumentNames.h"
#include "Arguments.h"
#include "ArrayOutput.h"
#include "Comparison.h"
#include "PythonMesh.h"
#include "Unlocked.h"

#include <pybind11/stl.h>

#include <cstdint>

namespace moserhex::python
{
namespace
{

namespace py = pybind11;

/** One number or matrix of every cell's strain. */
template <typename TValue, typename TOf>
std::vector<TValue>
ofCells(const CellDeformation & cells, const TOf & of)
{
  std::vector<TValue> values;
  values.reserve(cells.strain.size());
  for (const CellStrain & strain : cells.strain)
  {
    values.push_back(of(strain));
  }
  return values;
}

/** 4 x 4, from millimetres of `space` to the same. */
py::array
matrixOf(const SimilarityTransform & transform, Space space)
{
  const Vector3   signs = flip(Vector3::Ones(), space);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(4, 4);
  matrix.topLeftCorner(3, 3) = transform.scale * (signs.asDiagonal() * transform.rotation * signs.asDiagonal());
  matrix.topRightCorner(3, 1) = flip(transform.translation, space);
  return arrayOf(matrix);
}

/** \param name  of the mesh in messages */
app::TimedMesh
timedMesh(const PythonMesh & mesh, const std::string & name)
{
  return { { name, "" }, mesh.lattice(), mesh.record(), "" };
}

py::dict
compare(const PythonMesh & baseline, const PythonMesh & followUp, const std::string & align, long long threads)
{
  (void)alignmentFrom(align); // refuses unknown ones
  const unsigned int          count = threadsFrom(threads);
  const app::Comparison       comparison = unlocked([&](Watch &) {
    return app::compareSeries(
      app::timeSeriesOf({ timedMesh(baseline, "baseline"), timedMesh(followUp, "follow-up") }), align, {}, count);
  });
  const app::TimeComparison & result = comparison.times[1];
  const Space                 space = baseline.space();
  const CellDeformation &     cells = result.cells;
  const auto                  count3 = static_cast<py::ssize_t>(cells.strain.size());
  py::dict                    answer;
  answer["alignment"] = matrixOf(result.alignment, space);
  answer["displacement"] = arrayOf(result.displacement, space);
  answer["growth"] = cells.growth;
  answer["deformation_gradient"] = arrayOf(cells.gradient, space);
  answer["volume_ratio"] = arrayOf(cells.volumeRatio, { count3 });
  answer["volumetric"] = arrayOf(cells.volumetric, { count3 });
  answer["strain"] = arrayOf(ofCells<Matrix3>(cells, [](const CellStrain & s) { return s.tensor; }), space);
  answer["principal_strains"] =
    arrayOf(ofCells<Vector3>(cells, [](const CellStrain & s) { return s.principal; }), Space::LPS);
  answer["deviatoric_strain"] =
    arrayOf(ofCells<double>(cells, [](const CellStrain & s) { return s.deviatoric; }), { count3 });
  answer["largest_stretch"] =
    arrayOf(ofCells<double>(cells, [](const CellStrain & s) { return s.largestStretch; }), { count3 });
  answer["thickness_change"] = arrayOf(result.thicknessChange, Space::LPS);
  const SurfaceMotion & surface = result.surface;
  const auto            nodes = static_cast<py::ssize_t>(surface.nodes.size());
  answer["surface_nodes"] =
    py::array_t<std::int64_t>(nodes, std::vector<std::int64_t>(surface.nodes.begin(), surface.nodes.end()).data());
  answer["normal_motion"] = arrayOf(surface.normalMotion, { nodes });
  answer["signed_distance"] = arrayOf(surface.signedDistance, { nodes });
  answer["baseline_signed_distance"] = arrayOf(surface.baselineSignedDistance, { nodes });
  answer["warnings"] = py::tuple(py::cast(withArguments(comparison.series.warnings)));
  return answer;
}

} // namespace

void
addComparison(py::module_ & module)
{
  module.def("compare", &compare);
}

} // namespace moserhex::python
