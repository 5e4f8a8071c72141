#include "EndToEnd.h"

#include "PointFile.h"
#include "moserhex/CubeTransfer/FieldFunction.h"
#include "moserhex/HexMeshIO/FieldImageReader.h"
#include "moserhex/HexMeshIO/HexCellReader.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"
#include "moserhex/HexMeshIO/SurfaceReader.h"
#include "moserhex/HexMeshIO/SurfaceVoxelisation.h"
#include "moserhex/LevelSet/VoxelTopology.h"
#include "moserhex/Quality/HexQuality.h"

#include <itkMassPreservingHexahedralMeshFilter.h>

#include <typeinfo>

namespace moserhex::fuzz
{
namespace
{

/** FNV-1a of bytes, for comparing what two files gave. */
class Fingerprint
{
public:
  void
  add(const void * bytes, std::size_t size)
  {
    const auto * byte = static_cast<const unsigned char *>(bytes);
    for (std::size_t i = 0; i < size; ++i)
    {
      m_Hash = (m_Hash ^ byte[i]) * 0x100000001B3ULL;
    }
  }

  void
  add(const Positions & points)
  {
    for (const Vector3 & point : points)
    {
      add(point.data(), 3 * sizeof(double));
    }
  }

  [[nodiscard]] std::string
  text() const
  {
    return std::to_string(m_Hash);
  }

private:
  std::uint64_t m_Hash{ 0xCBF29CE484222325ULL };
};

/** A message or a warning that is not one line of at most 200 bytes. */
class BadLine : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

void
requireShortLine(const std::string & line)
{
  if (line.empty() || line.size() > 200 || line.find_first_of("\n\r") != std::string::npos)
  {
    throw BadLine("not a short line: " + line);
  }
}

void
requireShortLines(const std::vector<std::string> & lines)
{
  for (const std::string & line : lines)
  {
    requireShortLine(line);
  }
}

void
runPipeline(const LabelImageType * image, LabelValue label)
{
  const auto filter = itk::MassPreservingHexahedralMeshFilter<LabelImageType, itk::LatticeHexMesh>::New();
  filter->SetInput(image);
  filter->SetLabel(label);
  filter->SetNumberOfShells(3);
  filter->SetNumberOfWorkUnits(1);
  filter->SetAllowPartial(true);
  filter->Update();
}

std::string
readLabelmap(const std::string & fileName, bool withPipeline)
{
  const LabelImage image = readLabelImage(fileName);
  requireShortLines(image.warnings);
  const LabelValue  label = image.labels.front().value;
  const LabelVolume volume = labelVolumeOf(*image.image, label);
  (void)voxelTopology(volume);
  if (withPipeline)
  {
    runPipeline(image.image, label);
  }
  Fingerprint fingerprint;
  fingerprint.add(volume.inside.data(), volume.inside.size());
  fingerprint.add({ volume.spacing, volume.origin, volume.direction.col(0), volume.direction.col(1) });
  return fingerprint.text();
}

std::string
readTriangles(const std::string & fileName, bool withPipeline)
{
  const SurfaceFile surface = readSurface(fileName);
  requireShortLines(surface.warnings);
  SurfaceVoxelisationOptions options;
  options.voxelsInBox = 1e4;
  const LabelVolume volume = voxelise(surface.mesh, options);
  (void)voxelTopology(volume);
  if (withPipeline)
  {
    runPipeline(labelImageOf(volume), 1);
  }
  Fingerprint fingerprint;
  fingerprint.add(surface.mesh.vertices);
  fingerprint.add(surface.mesh.triangles.data(), surface.mesh.triangles.size() * sizeof(Triangle));
  return fingerprint.text();
}

std::string
readHexahedra(const std::string & fileName)
{
  const HexCellFile file = readHexCells(fileName);
  requireShortLines(file.warnings);
  (void)summarizeQuality(file.mesh);
  Fingerprint fingerprint;
  fingerprint.add(file.mesh.nodes);
  fingerprint.add(file.mesh.cells.data(), file.mesh.cells.size() * sizeof(file.mesh.cells[0]));
  return fingerprint.text();
}

/** Also what the command does first with it: its value in the middle. */
std::string
readField(const std::string & fileName)
{
  const FieldImage image = readFieldImage(fileName);
  requireShortLines(image.warnings);
  const FieldVolume & volume = image.volume;
  std::vector<double> middle(static_cast<std::size_t>(volume.components));
  const FieldFunction function(volume, image.hasValue, ImageInterpolation::Linear);
  (void)function.evaluate(volume.point(volume.size[0] / 2, volume.size[1] / 2, volume.size[2] / 2), middle.data());
  Fingerprint fingerprint;
  fingerprint.add(volume.values.data(), volume.values.size() * sizeof(double));
  fingerprint.add(image.hasValue.data(), image.hasValue.size());
  fingerprint.add({ volume.spacing, volume.origin, volume.direction.col(0), volume.direction.col(1) });
  return fingerprint.text();
}

std::string
readPointList(const std::string & fileName)
{
  Fingerprint fingerprint;
  for (const app::ListedPoint & point : app::readPoints(fileName).points)
  {
    fingerprint.add(point.label.data(), point.label.size());
    fingerprint.add({ point.position.value_or(Vector3::Zero()), point.cube.value_or(Vector3::Zero()) });
  }
  return fingerprint.text();
}

std::string
read(const std::string & fileName, SeedUse use, bool withPipeline)
{
  switch (use)
  {
    case SeedUse::Labelmap:
      return readLabelmap(fileName, withPipeline);
    case SeedUse::Surface:
      return readTriangles(fileName, withPipeline);
    case SeedUse::Hexahedra:
      return readHexahedra(fileName);
    case SeedUse::Field:
      return readField(fileName);
    case SeedUse::Points:
      return readPointList(fileName);
  }
  return {};
}

EndToEndResult
refusal(const std::string & message)
{
  try
  {
    requireShortLine(message);
    return { Answer::Refused, message };
  }
  catch (const BadLine & error)
  {
    return { Answer::Finding, error.what() };
  }
}

} // namespace

EndToEndResult
readEndToEnd(const std::string & fileName, SeedUse use, bool withPipeline)
{
  try
  {
    return { Answer::Taken, read(fileName, use, withPipeline) };
  }
  catch (const Error & error)
  {
    return refusal(error.what());
  }
  catch (const itk::CoreError & error)
  {
    return { Answer::Refused, error.GetDescription() }; // the command makes a short line of it
  }
  catch (const std::exception & error)
  {
    return { Answer::Finding, std::string(typeid(error).name()) + ": " + error.what() };
  }
  catch (...)
  {
    return { Answer::Finding, "an exception of no known kind" };
  }
}

} // namespace moserhex::fuzz
