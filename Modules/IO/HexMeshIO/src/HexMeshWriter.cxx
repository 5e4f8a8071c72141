#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include "FileNames.h"
#include "HexMeshFormats.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>

namespace moserhex
{
namespace
{

void
requireSize(const char * what, std::size_t actual, std::size_t expected)
{
  if (actual != expected)
  {
    throw InvalidInput(std::string("writeHexMesh: ") + std::to_string(actual) + " " + what + ", need " +
                       std::to_string(expected));
  }
}

void
requireUsable(const NamedArray & array, std::size_t places)
{
  if (array.name.empty())
  {
    throw InvalidInput("writeHexMesh: an array has no name");
  }
  if (array.components != 1 && array.components != 3 && array.components != 6 && array.components != 9)
  {
    throw InvalidInput("writeHexMesh: array " + array.name + " has " + std::to_string(array.components) +
                       " components, need 1, 3, 6 or 9");
  }
  requireSize(
    ("values of " + array.name).c_str(), array.values.size(), places * static_cast<std::size_t>(array.components));
}

void
requireUsableArrays(const std::string & fileName, const HexMesh & mesh, const HexMeshFields & fields)
{
  const bool isAny = !fields.pointArrays.empty() || !fields.cellArrays.empty() || !fields.meshArrays.empty();
  if (isAny && !holdsNamedArrays(fileName))
  {
    throw InvalidInput("writeHexMesh: named arrays are written to .vtu and .vtk only");
  }
  for (const NamedArray & array : fields.pointArrays)
  {
    requireUsable(array, mesh.nodes.size());
  }
  for (const NamedArray & array : fields.cellArrays)
  {
    requireUsable(array, mesh.cellCount());
  }
  for (const NamedArray & array : fields.meshArrays)
  {
    requireUsable(array, 1);
  }
}

/** Volume of each cell over their mean. */
std::vector<double>
checkedVolumeRatios(const HexMesh & mesh, const HexMeshFields & fields)
{
  if (mesh.nodesPerSide < 2 || mesh.paddingLayers < 0)
  {
    throw InvalidInput("writeHexMesh: nodesPerSide = " + std::to_string(mesh.nodesPerSide) +
                       ", paddingLayers = " + std::to_string(mesh.paddingLayers) + ", need >= 2 and >= 0");
  }
  requireSize("nodes", mesh.nodes.size(), nodeCount(mesh.nodesPerSide, mesh.paddingLayers));
  if (!fields.scaledJacobian.empty())
  {
    requireSize("scaled Jacobians", fields.scaledJacobian.size(), mesh.cellCount());
  }
  if (!fields.label.empty())
  {
    requireSize("labels", fields.label.size(), mesh.cellCount());
  }
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    if (!mesh.nodes[node].allFinite())
    {
      throw InvalidInput("writeHexMesh: node " + std::to_string(node) + " is not finite");
    }
  }
  std::vector<double> ratios = cellVolumes(mesh);
  double              sum = 0.0;
  for (const double volume : ratios)
  {
    sum += volume;
  }
  const double mean = sum / static_cast<double>(ratios.size());
  if (!(mean > 0.0))
  {
    throw InvalidInput("writeHexMesh: mean cell volume " + std::to_string(mean) + " mm^3, need > 0");
  }
  for (double & ratio : ratios)
  {
    ratio /= mean;
  }
  return ratios;
}

/** \param fileName  an ending other than VTK's */
std::string
bytesOf(const std::string & fileName, const HexMeshContent & content, const HexMeshWriterOptions & options)
{
  if (endsWith(fileName, ".msh"))
  {
    return gmshText(content, options.gmshVersion);
  }
  if (endsWith(fileName, ".mesh"))
  {
    return meditText(content);
  }
  if (endsWith(fileName, ".inp"))
  {
    return abaqusText(content);
  }
  return endsWith(fileName, ".feb") ? febioText(content) : exodusBytes(content);
}

[[noreturn]] void
throwReadsBackDifferently(const AtomicFile & file)
{
  throw IOError(ErrorCode::InputOutput,
                file.finalName(),
                "the mesh reads back differently",
                "free some space or choose another folder");
}

/** Coordinates of .inp have 17 places at least, all others come back to the last bit. */
void
requireSame(const AtomicFile & file, const HexMesh & mesh)
{
  const bool rounded = endsWith(file.finalName(), ".inp");
  const auto same = [rounded](const Vector3 & a, const Vector3 & b) {
    return rounded ? (a - b).cwiseAbs().maxCoeff() <= 1e-15 : std::memcmp(a.data(), b.data(), 3 * sizeof(double)) == 0;
  };
  try
  {
    ReadOptions options;
    options.sandbox = false; // a file of our own, in a program that may be busy with threads
    const HexMesh read = readHexMesh(file.partName(), options);
    if (read.nodesPerSide == mesh.nodesPerSide && read.paddingLayers == mesh.paddingLayers &&
        std::equal(mesh.nodes.begin(), mesh.nodes.end(), read.nodes.begin(), read.nodes.end(), same))
    {
      return;
    }
  }
  catch (const BadInput &)
  {
    // Reported below, under the file's own name.
  }
  throwReadsBackDifferently(file);
}

/** For .feb and .exo, which no reader of ours takes. */
void
requireSameBytes(const AtomicFile & file, const std::string & bytes)
{
  std::ifstream     stream(file.partName(), std::ios::binary);
  const std::string read{ std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
  if (read != bytes)
  {
    throwReadsBackDifferently(file);
  }
}

} // namespace

bool
holdsNamedArrays(const std::string & fileName)
{
  return endsWithAny(fileName, { ".vtu", ".vtk" });
}

bool
isHexMeshName(const std::string & fileName)
{
  return holdsNamedArrays(fileName) || endsWithAny(fileName, { ".msh", ".inp", ".mesh", ".feb", ".exo" });
}

void
writeHexMesh(const std::string &          fileName,
             const HexMesh &              mesh,
             const HexMeshFields &        fields,
             const HexMeshWriterOptions & options)
{
  if (!isHexMeshName(fileName))
  {
    throw BadInput(ErrorCode::Usage,
                   fileName,
                   "not a mesh file's name",
                   std::string("give a name that ends with ") + hexMeshEndings);
  }
  std::vector<double> ratios = checkedVolumeRatios(mesh, fields);
  requireUsableArrays(fileName, mesh, fields);
  const HexMeshContent content{ mesh, fields, std::move(ratios), shellOfCells(mesh) };
  AtomicFile           file(fileName);
  if (holdsNamedArrays(fileName))
  {
    writeVtkMesh(file, content, options);
    requireSame(file, mesh);
  }
  else
  {
    const std::string bytes = bytesOf(fileName, content, options);
    file.writeText(bytes);
    isHexCellName(fileName) ? requireSame(file, mesh) : requireSameBytes(file, bytes);
  }
  file.commit();
}

} // namespace moserhex
