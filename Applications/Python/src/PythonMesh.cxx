#include "PythonMesh.h"

#include "ArrayOutput.h"
#include "Interruption.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/HexMeshIO/QualityReport.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace moserhex::python
{
namespace
{

namespace py = pybind11;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void
flipAll(Positions & positions, Space space)
{
  for (Vector3 & position : positions)
  {
    position = flip(position, space);
  }
}

} // namespace

PythonMesh::PythonMesh(HexMesh                  mesh,
                       HexMeshFields            fields,
                       Space                    space,
                       std::vector<std::string> warnings,
                       std::string              report)
  : m_Mesh(std::move(mesh))
  , m_Fields(std::move(fields))
  , m_Space(space)
  , m_Warnings(std::move(warnings))
  , m_Report(std::move(report))
{}

py::array
PythonMesh::points() const
{
  return arrayOf(m_Mesh.nodes, m_Space);
}

py::array
PythonMesh::cells() const
{
  py::array_t<std::int64_t> array({ static_cast<py::ssize_t>(m_Mesh.cellCount()), py::ssize_t{ 8 } });
  std::int64_t *            next = array.mutable_data();
  for (std::size_t cell = 0; cell < m_Mesh.cellCount(); ++cell)
  {
    const auto nodes = m_Mesh.cellNodes(cell);
    next = std::copy(nodes.begin(), nodes.end(), next);
  }
  return array;
}

std::string
PythonMesh::quality(unsigned int threads) const
{
  const py::gil_scoped_release release;
  QualityReport                report;
  report.nodes = m_Mesh.nodes.size();
  report.quality = summarizeQuality(m_Mesh, threads);
  return toJson(report);
}

py::array
PythonMesh::cubeCoordinates(const py::object & points, unsigned int threads) const
{
  constexpr std::size_t atOnce = 1 << 17;
  Positions             all = rowsFrom("points", points);
  Interruption          interruption;
  bool                  goOn = true;
  {
    const py::gil_scoped_release release;
    const CubeMap &              map = cubeMap();
    flipAll(all, m_Space);
    for (std::size_t begin = 0; begin < all.size() && goOn; begin += atOnce)
    {
      const std::size_t end = std::min(begin + atOnce, all.size());
      const Positions   some(all.begin() + static_cast<std::ptrdiff_t>(begin),
                           all.begin() + static_cast<std::ptrdiff_t>(end));
      const auto        places = map.find(some, threads);
      for (std::size_t n = begin; n < end; ++n)
      {
        const auto & place = places[n - begin];
        all[n] = place ? map.cubeCoordinates(*place) : Vector3(nan, nan, nan);
      }
      goOn = interruption.goOn(static_cast<double>(end) / static_cast<double>(all.size()));
    }
  }
  interruption.rethrow();
  return arrayOf(all, Space::LPS);
}

py::array
PythonMesh::positions(const py::object & cubeCoordinates) const
{
  Positions all = rowsFrom("cube coordinates", cubeCoordinates);
  {
    const py::gil_scoped_release release;
    const CubeMap &              map = cubeMap();
    for (Vector3 & row : all)
    {
      row = row.array().isNaN().any() ? Vector3(nan, nan, nan) : map.position(map.place(row));
    }
  }
  return arrayOf(all, m_Space);
}

void
PythonMesh::write(const std::string & fileName) const
{
  const py::gil_scoped_release release;
  HexMeshFields                fields = m_Fields;
  if (!holdsNamedArrays(fileName))
  {
    fields.meshArrays.clear();
  }
  writeHexMesh(fileName, m_Mesh, fields);
}

const CubeMap &
PythonMesh::cubeMap() const
{
  std::call_once(m_MapIsMade, [this] { m_Map = std::make_unique<const CubeMap>(m_Mesh); });
  return *m_Map;
}

} // namespace moserhex::python
