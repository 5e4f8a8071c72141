// 200 cuts of each of six encodings: none may be read, and none under another code than those of a damaged file.
#include "ImageText.h"
#include "TestErrors.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"

#include <gtest/gtest.h>

#include <itkImageFileWriter.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

using namespace moserhex;

namespace
{

/** A ball that reaches the image's last voxels, so that no cut loses background alone. */
itk::Image<unsigned char, 3>::Pointer
ballImage()
{
  const auto image = itk::Image<unsigned char, 3>::New();
  image->SetRegions(itk::Size<3>{ { 24, 24, 24 } });
  image->Allocate();
  for (int n = 0; n < 24 * 24 * 24; ++n)
  {
    const int x = n % 24 - 12;
    const int y = n / 24 % 24 - 12;
    const int z = n / 576 - 12;
    image->GetBufferPointer()[n] = x * x + y * y + z * z < 144 ? static_cast<unsigned char>(1 + n % 3) : 0;
  }
  return image;
}

template <typename TImageIO>
std::string
fileBytes(const std::string & fileName, bool compress)
{
  const auto writer = itk::ImageFileWriter<itk::Image<unsigned char, 3>>::New();
  writer->SetImageIO(TImageIO::New());
  writer->SetFileName(fileName);
  writer->SetInput(ballImage());
  writer->SetUseCompression(compress);
  writer->Update();
  return readBytes(fileName);
}

void
expectEveryCutRefused(const std::string & fileName, const std::string & bytes)
{
  LabelReadOptions options;
  options.sandbox = false;
  ASSERT_EQ(errorOf([&] { (void)readLabelImage(fileName, options); }), "no error");
  for (std::size_t cut = 0; cut < 200; ++cut)
  {
    writeBytes(fileName, bytes.substr(0, bytes.size() * cut / 200));
    const std::string error = errorOf([&] { (void)readLabelImage(fileName, options); });
    const std::string code = error.substr(0, error.find(' '));
    EXPECT_TRUE(code == "E_EMPTY" || code == "E_FORMAT" || code == "E_HEADER" || code == "E_TRUNCATED" ||
                code == "E_REFERENCE") // "ElementDataFile = LO"
      << error;
  }
  writeBytes(fileName, bytes.substr(0, bytes.size() - 1));
  EXPECT_EQ(errorOf([&] { (void)readLabelImage(fileName, options); }).substr(0, 11), "E_TRUNCATED");
}

} // namespace

TEST(CutImage, NrrdIsRefused)
{
  const TestFolder folder;
  expectEveryCutRefused(folder / "a.nrrd", fileBytes<itk::NrrdImageIO>(folder / "a.nrrd", false));
}

TEST(CutImage, CompressedNrrdIsRefused)
{
  const TestFolder folder;
  expectEveryCutRefused(folder / "a.nrrd", fileBytes<itk::NrrdImageIO>(folder / "a.nrrd", true));
}

TEST(CutImage, NiftiIsRefused)
{
  const TestFolder folder;
  expectEveryCutRefused(folder / "a.nii", fileBytes<itk::NiftiImageIO>(folder / "a.nii", false));
}

TEST(CutImage, CompressedNiftiIsRefused)
{
  const TestFolder folder;
  expectEveryCutRefused(folder / "a.nii.gz", fileBytes<itk::NiftiImageIO>(folder / "a.nii.gz", true));
}

TEST(CutImage, MetaImageIsRefused)
{
  const TestFolder folder;
  expectEveryCutRefused(folder / "a.mha", fileBytes<itk::MetaImageIO>(folder / "a.mha", false));
}

TEST(CutImage, CompressedMetaImageIsRefused)
{
  const TestFolder folder;
  expectEveryCutRefused(folder / "a.mha", fileBytes<itk::MetaImageIO>(folder / "a.mha", true));
}
