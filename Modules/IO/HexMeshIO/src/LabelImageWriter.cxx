#include "moserhex/HexMeshIO/LabelImageWriter.h"

#include "NrrdWriter.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"

#include <algorithm>

namespace moserhex
{

void
writeLabelImage(const std::string & fileName, const LabelVolume & labels)
{
  const auto isSame = [&labels](const std::string & partName) {
    LabelReadOptions options;
    options.sandbox = false; // a file of our own, in a program that may be busy with threads
    const LabelImage read = readLabelImage(partName, options);
    return isSamePlace(labelVolumeOf(*read.image, 1), labels) &&
           std::equal(labels.inside.begin(), labels.inside.end(), read.image->GetBufferPointer());
  };
  NrrdVoxels voxels;
  voxels.values = labels.inside.data();
  writeNrrdFile(fileName, "labelmap", labels, voxels, isSame);
}

} // namespace moserhex
