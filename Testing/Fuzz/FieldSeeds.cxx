#include "SeedParts.h"
#include "moserhex/HexMeshIO/FieldImageWriter.h"

#include <itkImageFileWriter.h>
#include <itkMetaImageIO.h>

#include <cstdint>

namespace moserhex::fuzz
{
namespace
{

constexpr int side = 5;
constexpr int voxels = side * side * side;

/** A smooth image of several components, the last fastest. */
FieldVolume
fieldOf(int components)
{
  FieldVolume image{ VoxelGrid{ { { side, side, side } }, { 1.0, 1.5, 2.0 }, { -3.0, 4.0, 5.0 } }, components, {} };
  for (int value = 0; value < voxels * components; ++value)
  {
    image.values.push_back(0.25 * (value % 37));
  }
  return image;
}

std::string
nrrdText(const std::string & sizes,
         const std::string & kinds,
         const std::string & directions,
         const std::string & encoding,
         const std::string & voxelBytes)
{
  return "NRRD0004\ntype: uint8\ndimension: 4\nspace: left-posterior-superior\nsizes: " + sizes +
         "\nspace directions: " + directions + "\nkinds: " + kinds + "\nencoding: " + encoding +
         "\nspace origin: (-3,4,5)\n\n" + voxelBytes;
}

/** A mask before the six numbers of every voxel. */
std::string
maskedTensors()
{
  std::string bytes;
  for (int voxel = 0; voxel < voxels; ++voxel)
  {
    bytes += static_cast<char>(voxel % 3 == 0 ? 0 : 1);
    for (int component = 0; component < 6; ++component)
    {
      bytes += static_cast<char>(voxel % 11 + component);
    }
  }
  return nrrdText(
    "7 5 5 5", "3D-masked-symmetric-matrix domain domain domain", "none (1,0,0) (0,1.5,0) (0,0,2)", "raw", bytes);
}

/** All first components, then all second ones, as text. */
std::string
vectorsOnTheLastAxis()
{
  std::string text;
  for (int value = 0; value < 2 * voxels; ++value)
  {
    text += std::to_string(value % 41) + (value % 10 == 9 ? '\n' : ' ');
  }
  return nrrdText("5 5 5 2", "domain domain domain vector", "(1,0,0) (0,1.5,0) (0,0,2) none", "ascii", text);
}

/** ITK's own file of two channels. */
void
writeMetaVectors(const std::string & fileName)
{
  using ImageType = itk::Image<itk::Vector<float, 2>, 3>;
  const auto          image = ImageType::New();
  ImageType::SizeType size;
  size.Fill(side);
  image->SetRegions(size);
  image->Allocate();
  for (int voxel = 0; voxel < voxels; ++voxel)
  {
    image->GetBufferPointer()[voxel][0] = static_cast<float>(voxel);
    image->GetBufferPointer()[voxel][1] = 0.5F;
  }
  const auto writer = itk::ImageFileWriter<ImageType>::New();
  writer->SetInput(image);
  writer->SetImageIO(itk::MetaImageIO::New());
  writer->SetFileName(fileName);
  writer->Update();
}

} // namespace

void
addFields(std::vector<Seed> & seeds)
{
  const ScratchFolder folder;
  const auto          add = [&seeds](const char * format, const SeedFile & file) {
    seeds.push_back({ SeedUse::Field, format, file, {} });
  };
  writeFieldImage(folder / "vector.nrrd", fieldOf(3));
  add("nrrd-vector", folder.take("vector.nrrd"));
  add("nrrd-last", { "last.nrrd", vectorsOnTheLastAxis() });
  add("nrrd-masked", { "masked.nrrd", maskedTensors() });
  writeFieldImage(folder / "vector.nii", fieldOf(3));
  add("nii-vector", folder.take("vector.nii"));
  writeFieldImage(folder / "tensor.nii.gz", fieldOf(6), FieldValues::SymmetricTensors);
  add("nii-tensor", folder.take("tensor.nii.gz"));
  writeMetaVectors(folder / "vector.mha");
  add("mha-vector", folder.take("vector.mha"));
}

} // namespace moserhex::fuzz
