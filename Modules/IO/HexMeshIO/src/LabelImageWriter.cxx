#include "moserhex/HexMeshIO/LabelImageWriter.h"

#include "FileNames.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"

#include <itkNrrdImageIO.h>

#include <algorithm>

namespace moserhex
{
namespace
{

void
writeNrrd(const std::string & fileName, const LabelVolume & labels)
{
  const auto         writer = itk::NrrdImageIO::New();
  itk::ImageIORegion region(3);
  writer->SetNumberOfDimensions(3);
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const Vector3 column = labels.direction.col(axis);
    writer->SetDimensions(axis, static_cast<itk::SizeValueType>(labels.size[axis]));
    writer->SetSpacing(axis, labels.spacing[axis]);
    writer->SetOrigin(axis, labels.origin[axis]);
    writer->SetDirection(axis, std::vector<double>(column.data(), column.data() + 3));
    region.SetSize(axis, static_cast<itk::SizeValueType>(labels.size[axis]));
  }
  writer->SetNumberOfComponents(1);
  writer->SetPixelType(itk::IOPixelEnum::SCALAR);
  writer->SetComponentType(itk::IOComponentEnum::UCHAR);
  writer->SetIORegion(region);
  writer->SetUseCompression(true);
  writer->SetFileName(fileName);
  writer->WriteImageInformation();
  writer->Write(labels.inside.data());
}

void
requireSame(const std::string & fileName, const std::string & partName, const LabelVolume & labels)
{
  LabelReadOptions options;
  options.sandbox = false; // a file of our own, in a program that may be busy with threads
  const LabelImage  read = readLabelImage(partName, options);
  const LabelVolume frame = labelVolumeOf(*read.image, 1);
  const bool        samePlace = frame.size == labels.size && frame.spacing.isApprox(labels.spacing, 1e-9) &&
                         (frame.origin - labels.origin).norm() <= 1e-6 &&
                         frame.direction.isApprox(labels.direction, 1e-6);
  if (!samePlace || !std::equal(labels.inside.begin(), labels.inside.end(), read.image->GetBufferPointer()))
  {
    throw IOError(
      ErrorCode::InputOutput, fileName, "the file reads back differently", "free some space or choose another folder");
  }
}

} // namespace

void
writeLabelImage(const std::string & fileName, const LabelVolume & labels)
{
  if (!endsWith(fileName, ".nrrd"))
  {
    throw BadInput(ErrorCode::Usage, fileName, "labelmaps are written as NRRD", "give a name that ends with .nrrd");
  }
  AtomicFile file(fileName);
  try
  {
    writeNrrd(file.partName(), labels);
    requireSame(fileName, file.partName(), labels);
  }
  catch (const IOError &)
  {
    throw;
  }
  catch (const std::exception & error)
  {
    throw IOError(ErrorCode::InputOutput,
                  fileName,
                  std::string("cannot write the labelmap (") + error.what() + ")",
                  "free some space or choose another folder");
  }
  file.commit();
}

} // namespace moserhex
