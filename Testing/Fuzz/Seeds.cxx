#include "Seeds.h"

#include "SeedParts.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"

#include <itkImageFileWriter.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <unistd.h>

namespace moserhex::fuzz
{

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder()
{
  std::string name = (fs::temp_directory_path() / "moserhex-seeds-XXXXXX").string();
  if (!::mkdtemp(name.data()))
  {
    throw std::runtime_error("cannot make a temporary folder");
  }
  m_Path = name;
}

ScratchFolder::~ScratchFolder()
{
  std::error_code ignored;
  fs::remove_all(m_Path, ignored);
}

SeedFile
ScratchFolder::take(const std::string & name) const
{
  std::ifstream file(m_Path + "/" + name, std::ios::binary);
  SeedFile      seed{ name, { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() } };
  if (seed.bytes.empty())
  {
    throw std::runtime_error("no seed " + name);
  }
  return seed;
}

namespace
{

/** A ball in a box of 12 x 11 x 10 voxels: label 1 with a cap of label 2. */
template <typename TPixel>
typename itk::Image<TPixel, 3>::Pointer
labelledBall()
{
  using ImageType = itk::Image<TPixel, 3>;
  const auto                   image = ImageType::New();
  typename ImageType::SizeType size{ { 12, 11, 10 } };
  image->SetRegions(size);
  const std::array<double, 3> spacing{ { 1.0, 1.1, 1.2 } };
  image->SetSpacing(spacing.data());
  image->Allocate();
  auto * voxel = image->GetBufferPointer();
  for (int k = 0; k < 10; ++k)
  {
    for (int j = 0; j < 11; ++j)
    {
      for (int i = 0; i < 12; ++i)
      {
        const double x = i - 5.5;
        const double y = 1.1 * (j - 5.0);
        const double z = 1.2 * (k - 4.5);
        const double squared = x * x + y * y + z * z;
        *voxel++ = static_cast<TPixel>(squared >= 18.0 ? 0 : z > 2.0 ? 2 : 1);
      }
    }
  }
  return image;
}

template <typename TPixel, typename TImageIO>
void
writeImage(const std::string & fileName, bool compressed)
{
  const auto writer = itk::ImageFileWriter<itk::Image<TPixel, 3>>::New();
  writer->SetInput(labelledBall<TPixel>());
  writer->SetImageIO(TImageIO::New());
  writer->SetFileName(fileName);
  writer->SetUseCompression(compressed);
  writer->Update();
}

void
addImages(std::vector<Seed> & seeds)
{
  const ScratchFolder folder;
  const auto          add = [&](const char * format, const std::string & name) {
    seeds.push_back({ SeedUse::Labelmap, format, folder.take(name), {} });
  };
  writeImage<short, itk::NrrdImageIO>(folder / "raw.nrrd", false);
  add("nrrd-raw", "raw.nrrd");
  writeImage<unsigned char, itk::NrrdImageIO>(folder / "gzip.nrrd", true);
  add("nrrd-gzip", "gzip.nrrd");
  writeImage<short, itk::NiftiImageIO>(folder / "raw.nii", false);
  add("nii", "raw.nii");
  writeImage<float, itk::NiftiImageIO>(folder / "gzip.nii.gz", true);
  add("nii.gz", "gzip.nii.gz");
  writeImage<unsigned char, itk::MetaImageIO>(folder / "raw.mha", false);
  add("mha", "raw.mha");
  writeImage<int, itk::MetaImageIO>(folder / "zlib.mha", true);
  add("mha-zlib", "zlib.mha");
  writeImage<unsigned short, itk::MetaImageIO>(folder / "pair.mhd", false);
  add("mhd-raw", "pair.mhd");
  seeds.back().companions.push_back(folder.take("pair.raw"));
}

} // namespace

std::vector<Seed>
makeSeeds()
{
  std::vector<Seed> seeds;
  addImages(seeds);
  addSurfaces(seeds);
  addMeshes(seeds);
  addFields(seeds);
  addPoints(seeds);
  return seeds;
}

} // namespace moserhex::fuzz
