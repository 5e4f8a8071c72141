#include "ComparisonFiles.h"

#include "TextTable.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>
#include <utility>

namespace moserhex::app
{
namespace
{

constexpr double noValue = std::numeric_limits<double>::quiet_NaN();

std::string
inFolder(const std::string & folder, const std::string & name)
{
  return (std::filesystem::path(folder) / name).string();
}

NamedArray
vectorArray(const std::string & name, const Positions & vectors)
{
  NamedArray array{ name, 3, {} };
  array.values.reserve(3 * vectors.size());
  for (const Vector3 & vector : vectors)
  {
    array.values.insert(array.values.end(), vector.data(), vector.data() + 3);
  }
  return array;
}

/** On the boundary; no value inside. */
NamedArray
boundaryArray(const std::string & name, const TimeComparison & time, const std::vector<double> & values)
{
  NamedArray array{ name, 1, std::vector<double>(time.mesh.nodes.size(), noValue) };
  for (std::size_t b = 0; b < values.size(); ++b)
  {
    array.values[time.surface.nodes[b]] = values[b];
  }
  return array;
}

/** Area after over area before of the quadrilaterals around every boundary node. */
NamedArray
areaRatioArray(const TimeComparison & time)
{
  const std::vector<Quadrilateral> quads = boundaryQuads(time.mesh);
  std::vector<double>              before(time.mesh.nodes.size(), 0.0);
  NamedArray                       array{ "AreaRatio", 1, std::vector<double>(time.mesh.nodes.size(), 0.0) };
  for (std::size_t quad = 0; quad < quads.size(); ++quad)
  {
    for (const std::size_t node : quads[quad])
    {
      before[node] += time.surface.area[quad];
      array.values[node] += time.surface.area[quad] * time.surface.areaRatio[quad];
    }
  }
  for (std::size_t node = 0; node < before.size(); ++node)
  {
    array.values[node] = before[node] > 0.0 ? array.values[node] / before[node] : noValue;
  }
  return array;
}

std::vector<NamedArray>
pointArrays(const TimeComparison & time)
{
  return { vectorArray("Displacement", time.displacement),
           vectorArray("Thickness", time.thickness),
           vectorArray("ThicknessChange", time.thicknessChange),
           boundaryArray("NormalMotion", time, time.surface.normalMotion),
           boundaryArray("SignedDistance", time, time.surface.signedDistance),
           boundaryArray("BaselineSignedDistance", time, time.surface.baselineSignedDistance),
           areaRatioArray(time) };
}

NamedArray
directionArray(const CellDeformation & cells, int number)
{
  Positions directions;
  directions.reserve(cells.strain.size());
  for (const CellStrain & strain : cells.strain)
  {
    directions.emplace_back(strain.directions.col(number));
  }
  return vectorArray("PrincipalDirection" + std::to_string(number + 1), directions);
}

std::vector<NamedArray>
cellArrays(const CellDeformation & cells)
{
  NamedArray gradient{ "DeformationGradient", 9, {} };
  NamedArray tensor{ "Strain", 6, {} };
  NamedArray principal{ "PrincipalStrain", 3, {} };
  NamedArray deviatoric{ "DeviatoricStrain", 1, {} };
  NamedArray stretch{ "LargestStretch", 1, {} };
  for (std::size_t cell = 0; cell < cells.strain.size(); ++cell)
  {
    const CellStrain & strain = cells.strain[cell];
    const Matrix3 &    E = strain.tensor;
    for (int row = 0; row < 3; ++row)
    {
      const Vector3 F = cells.gradient[cell].row(row);
      gradient.values.insert(gradient.values.end(), F.data(), F.data() + 3);
      principal.values.push_back(strain.principal[row]);
    }
    tensor.values.insert(tensor.values.end(), { E(0, 0), E(1, 1), E(2, 2), E(0, 1), E(1, 2), E(0, 2) });
    deviatoric.values.push_back(strain.deviatoric);
    stretch.values.push_back(strain.largestStretch);
  }
  return { { "DetF", 1, cells.volumeRatio },
           { "Volumetric", 1, cells.volumetric },
           gradient,
           tensor,
           principal,
           directionArray(cells, 0),
           directionArray(cells, 1),
           directionArray(cells, 2),
           deviatoric,
           stretch };
}

std::string
capitalised(std::string name)
{
  name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
  return name;
}

/** One array for each axis, as halves along different axes overlap; named by its two halves, "HalvesRightLeft". The
 * numbers are those of the set. */
std::vector<NamedArray>
halfArrays(const std::vector<CubeRegion> & halves, int nodesPerSide)
{
  std::vector<NamedArray> arrays;
  for (std::size_t first = 0; first + 1 < halves.size(); first += 2)
  {
    NamedArray array{ "Halves" + capitalised(halves[first].name) + capitalised(halves[first + 1].name), 1, {} };
    for (const int number : regionOfCells({ halves[first], halves[first + 1] }, nodesPerSide))
    {
      array.values.push_back(number == 0 ? 0.0 : static_cast<double>(first) + number);
    }
    arrays.push_back(std::move(array));
  }
  return arrays;
}

/** ParaView's list of the files of a series. The names hold nothing that XML would mistake. */
std::string
collectionText(const TimeSeries & series)
{
  std::string text = "<?xml version=\"1.0\"?>\n"
                     "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  <Collection>\n";
  for (std::size_t time = 0; time < series.points.size(); ++time)
  {
    const double at = series.points[time].months.value_or(static_cast<double>(time));
    text += "    <DataSet timestep=\"" + numberText(at) + "\" part=\"0\" file=\"" + meshFileOfTime(time) + "\"/>\n";
  }
  return text + "  </Collection>\n</VTKFile>\n";
}

/** Of the mesh as it is written, aligned: a turn of the lattice is that of the mesh as it was read only. */
std::vector<NamedArray>
recordOfAligned(const TimePoint & point, const TimeComparison & found)
{
  constexpr double        sameTurn = 0.5; // [degree]
  std::vector<NamedArray> record = point.record;
  if (found.alignment.angle() > sameTurn)
  {
    const auto isTurn = [](const NamedArray & array) { return array.name == "LatticeTurn"; };
    record.erase(std::remove_if(record.begin(), record.end(), isTurn), record.end());
  }
  return record;
}

} // namespace

std::vector<NamedArray>
regionArrays(const std::vector<RegionSet> & sets, int nodesPerSide)
{
  std::vector<NamedArray> arrays;
  for (const RegionSet & set : sets)
  {
    if (set.name == "octants" || set.name == "boxes")
    {
      const std::vector<int> numbers = regionOfCells(set.regions, nodesPerSide);
      arrays.push_back({ capitalised(set.name), 1, { numbers.begin(), numbers.end() } });
    }
    if (set.name == "halves")
    {
      const std::vector<NamedArray> halves = halfArrays(set.regions, nodesPerSide);
      arrays.insert(arrays.end(), halves.begin(), halves.end());
    }
  }
  return arrays;
}

std::string
meshFileOfTime(std::size_t time)
{
  const std::string number = std::to_string(time);
  return "time-" + std::string(number.size() < 3 ? 3 - number.size() : 0, '0') + number + ".vtu";
}

std::vector<std::string>
filesOf(const TimeSeries & series, const std::string & folder)
{
  std::vector<std::string> files{ inFolder(folder, "series.pvd"),
                                  inFolder(folder, "regions.csv"),
                                  inFolder(folder, "summary.json") };
  for (std::size_t time = 0; time < series.points.size(); ++time)
  {
    files.push_back(inFolder(folder, meshFileOfTime(time)));
  }
  return files;
}

void
writeTimeMesh(const std::string & fileName, const Comparison & comparison, std::size_t time)
{
  const TimeComparison & at = comparison.times[time];
  HexMeshFields          fields;
  fields.pointArrays = pointArrays(at);
  fields.cellArrays = cellArrays(at.cells);
  fields.meshArrays = recordOfAligned(comparison.series.points[time], at);
  for (NamedArray & array : regionArrays(comparison.sets, at.mesh.nodesPerSide))
  {
    fields.cellArrays.push_back(std::move(array));
  }
  writeHexMesh(fileName, at.mesh, fields);
}

void
writeTimeMeshes(const std::string & folder, const Comparison & comparison)
{
  for (std::size_t time = 0; time < comparison.times.size(); ++time)
  {
    writeTimeMesh(inFolder(folder, meshFileOfTime(time)), comparison, time);
  }
  writeTextFile(inFolder(folder, "series.pvd"), collectionText(comparison.series));
}

std::string
regionTable(const Comparison & comparison, char separator)
{
  std::string text = tableLine({ "time",
                                 "name",
                                 "months",
                                 "set",
                                 "region",
                                 "region_volume_mm3",
                                 "measure",
                                 "unit",
                                 "mean",
                                 "min",
                                 "p05",
                                 "median",
                                 "p95",
                                 "max" },
                               separator);
  for (std::size_t time = 0; time < comparison.rows.size(); ++time)
  {
    const TimePoint & point = comparison.series.points[time];
    for (const RegionRow & row : comparison.rows[time])
    {
      text += tableLine({ std::to_string(time),
                          point.name,
                          numberText(point.months.value_or(noValue)),
                          row.set,
                          row.region,
                          numberText(row.volume),
                          row.measure,
                          row.unit,
                          numberText(row.values.mean),
                          numberText(row.values.minimum),
                          numberText(row.values.p05),
                          numberText(row.values.median),
                          numberText(row.values.p95),
                          numberText(row.values.maximum) },
                        separator);
    }
  }
  return text;
}

} // namespace moserhex::app
