#include "ChosenSolid.h"

#include "CommandErrors.h"
#include "moserhex/HexMeshIO/SurfaceReader.h"
#include "moserhex/HexMeshIO/SurfaceVoxelisation.h"

namespace moserhex::app
{
namespace
{

constexpr std::size_t mostNamedLabels = 8;
constexpr std::size_t mostLabelsTogether = 16; ///< zones of an organ, not a parcellation

/** A closed surface voxelised as label 1. */
LabelImage
readVoxelisedSurface(const InputOptions & options)
{
  if (options.segment || options.threshold)
  {
    throw UsageError(fileMessage(options.file, "is a surface", "--segment and --threshold are for images"));
  }
  SurfaceFile surface = readSurface(options.file, { options.sandbox });
  try
  {
    const LabelVolume voxels = voxelise(surface.mesh);
    LabelImage        image;
    image.fileName = options.file;
    image.image = labelImageOf(voxels);
    image.labels = { { 1, voxelCount(voxels), "" } };
    image.warnings = std::move(surface.warnings);
    return image;
  }
  catch (const InvalidInput & error)
  {
    throw BadInput(error.code(), options.file, error.what(), "give a surface of a compact solid");
  }
}

} // namespace

std::vector<std::int64_t>
ChosenSolid::labelValues() const
{
  std::vector<std::int64_t> values;
  for (const LabelEntry & entry : labels)
  {
    values.push_back(entry.value);
  }
  return values;
}

std::string
ChosenSolid::name() const
{
  const auto nameOfEntry = [](const LabelEntry & entry) {
    return std::to_string(entry.value) + (entry.name.empty() ? "" : " (" + entry.name + ")");
  };
  if (labels.size() == 1)
  {
    return "label " + nameOfEntry(labels.front());
  }
  if (labels.size() > mostNamedLabels)
  {
    return "all " + std::to_string(labels.size()) + " labels together";
  }
  std::string list;
  for (const LabelEntry & entry : labels)
  {
    list += (list.empty() ? "" : ", ") + nameOfEntry(entry);
  }
  return "labels " + list + " together";
}

bool
isInputName(const std::string & fileName)
{
  return isLabelImageName(fileName) || isSurfaceName(fileName);
}

ChosenSolid
chooseSolid(LabelImage image, const std::optional<LabelValue> & label)
{
  ChosenSolid solid;
  solid.image = std::move(image);
  if (label || solid.image.labels.size() == 1 || solid.image.labels.size() > mostLabelsTogether)
  {
    solid.labels = { chooseLabel(solid.image, label) };
    solid.mask = solid.image.image;
    solid.value = solid.labels.front().value;
  }
  else
  {
    solid.labels = solid.image.labels;
    solid.mask = labelImageOf(labelVolumeOfAll(*solid.image.image));
  }
  for (const LabelEntry & entry : solid.labels)
  {
    solid.voxels += entry.voxels;
  }
  return solid;
}

ChosenSolid
readSolid(const InputOptions & options)
{
  return chooseSolid(isSurfaceName(options.file)
                       ? readVoxelisedSurface(options)
                       : readLabelImage(options.file, { options.threshold, options.segment, options.sandbox }),
                     options.label);
}

} // namespace moserhex::app
