#include "PythonComparison.h"

#include "Arguments.h"
#include "ArrayOutput.h"
#include "PythonMesh.h"
#include "Unlocked.h"
#include "moserhex/Deformation/CellDeformation.h"
#include "moserhex/Deformation/LatticeAlignment.h"

namespace moserhex::python
{
namespace
{

namespace py = pybind11;

struct Comparison
{
  SimilarityTransform alignment;
  Positions           displacement; ///< aligned follow-up minus baseline [mm, LPS]
  CellDeformation     cells;
};

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

py::dict
compare(const PythonMesh & baseline, const PythonMesh & followUp, const std::string & align, long long threads)
{
  const AlignmentKind     kind = alignmentFrom(align);
  const unsigned int      count = threadsFrom(threads);
  const Comparison        result = unlocked([&](Watch &) {
    Comparison comparison;
    comparison.alignment = latticeAlignment(followUp.lattice(), baseline.lattice(), kind);
    const HexMesh moved = transformed(followUp.lattice(), comparison.alignment);
    comparison.displacement = displacements(baseline.lattice(), moved);
    comparison.cells = cellDeformation(baseline.lattice(), moved, count);
    return comparison;
  });
  const Space             space = baseline.space();
  const CellDeformation & cells = result.cells;
  const auto              count3 = static_cast<py::ssize_t>(cells.strain.size());
  py::dict                answer;
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
  return answer;
}

} // namespace

void
addComparison(py::module_ & module)
{
  module.def("compare", &compare);
}

} // namespace moserhex::python
