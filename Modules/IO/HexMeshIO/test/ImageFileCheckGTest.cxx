// What a file is, by its name and its content, and whether it may be read at all.
#include "ImageCheckErrors.h"
#include "WithoutPrivileges.h"
#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/HexMeshIO/Sha256.h"

#include <sys/stat.h>
#include <unistd.h>

using namespace moserhex;

TEST(ImageFormatOf, ContentDecidesWhereTheNameHasNoEnding)
{
  const TestFolder folder;
  writeBytes(folder / "nrrd", ImageText::nrrd().file());
  writeBytes(folder / "meta", ImageText::meta().file());
  writeBytes(folder / "text", "hello");
  EXPECT_TRUE(isLabelImageName(folder / "nrrd"));
  EXPECT_TRUE(isLabelImageName(folder / "meta"));
  EXPECT_FALSE(isLabelImageName(folder / "text"));
  EXPECT_FALSE(isLabelImageName(folder / "missing"));
  EXPECT_FALSE(isLabelImageName(folder / ".")); // a folder
  EXPECT_TRUE(isLabelImageName("anything.NRRD"));
  EXPECT_FALSE(isLabelImageName("anything.stl"));
  expectTestVoxels(readHere(folder / "nrrd"));
  expectTestVoxels(readHere(folder / "meta"));
  EXPECT_EQ(errorOf([&] { (void)imageFormatOf(folder / "text"); }).substr(0, 8), "E_FORMAT");
}

TEST(ImageFormatOf, OtherKindsOfFilesAreNamed)
{
  const TestFolder folder;
  for (const auto & [bytes, kind] : { std::pair("PK\x03\x04", "ZIP"),
                                      std::pair("<html>", "HTML"),
                                      std::pair("\x89PNG", "PNG"),
                                      std::pair("BZh9", "bzip2") })
  {
    writeBytes(folder / "a.nrrd", bytes + std::string(200, ' '));
    const std::string error = checkError(folder / "a.nrrd");
    EXPECT_EQ(error.substr(0, 8), "E_FORMAT") << error;
    EXPECT_NE(error.find(kind), std::string::npos) << error;
  }
}

TEST(ImageFormatOf, OddNamesAreRead)
{
  const TestFolder folder;
  for (const std::string & name : { std::string("100%s%n%d"),
                                    std::string("line1\nline2"),
                                    std::string("a'b\"c;$(touch pwned)*"),
                                    std::string(" lead"),
                                    std::string(250, 'x'),
                                    std::string("\xE9") })
  {
    writeBytes(folder / (name + ".nrrd"), ImageText::nrrd().file());
    writeBytes(folder / (name + ".mha"), ImageText::meta().file());
    expectTestVoxels(readHere(folder / (name + ".nrrd")));
    expectTestVoxels(readHere(folder / (name + ".mha")));
  }
}

TEST(ImageFormatOf, EmptyMissingAndIrregularFilesAreTold)
{
  const TestFolder folder;
  writeBytes(folder / "empty.nrrd", "");
  ASSERT_EQ(::mkfifo((folder / "pipe.nrrd").c_str(), 0600), 0);
  ASSERT_EQ(::symlink("nowhere", (folder / "link.nrrd").c_str()), 0);
  EXPECT_EQ(checkErrorCode(folder / "empty.nrrd"), "E_EMPTY");
  EXPECT_EQ(checkErrorCode(folder / "pipe.nrrd"), "E_NOINPUT");
  EXPECT_EQ(checkErrorCode(folder / "link.nrrd"), "E_NOINPUT");
  EXPECT_EQ(checkErrorCode(folder / "missing.nrrd"), "E_NOINPUT");
}

TEST(ImageFormatOf, FilesThatMayNotBeReadAreNoInput)
{
  const TestFolder folder;
  writeBytes(folder / "a.nrrd", ImageText::nrrd().file());
  ASSERT_EQ(::chmod((folder / "a.nrrd").c_str(), 0), 0);
  for (const mode_t mode : { 0700, 0755 }) // root's folder may not be entered by others, or its file not be read
  {
    ASSERT_EQ(::chmod((folder / "").c_str(), mode), 0);
    const WithoutPrivileges nobody;
    EXPECT_EQ(checkErrorCode(folder / "a.nrrd"), "E_NOINPUT") << checkError(folder / "a.nrrd");
    EXPECT_EQ(codeThrownBy([&] { (void)sha256OfFile(folder / "a.nrrd"); }), ErrorCode::NoInput);
  }
}

TEST(DeliveredVoxels, FileThatChangesAfterItsCheckIsTheReadersFailure)
{
  const TestFolder folder;
  writeBytes(folder / "a.nrrd", ImageText::nrrd().file());
  const ImageDescription image = checkImageFile(folder / "a.nrrd", ImageFormat::Nrrd);
  std::string            changed = ImageText::nrrd().file();
  changed.back() = '\1';
  writeBytes(folder / "a.nrrd", changed);
  std::string buffer(60, '\0');
  readByItk(image, image.fileName, buffer.data());
  EXPECT_EQ(errorOf([&] { requireDelivered(image, buffer.data()); }).substr(0, 8), "E_READER");
  writeBytes(folder / "a.nrrd", ImageText::nrrd().with("sizes", "4 5 3").file());
  EXPECT_EQ(errorOf([&] { readByItk(image, image.fileName, buffer.data()); }).substr(0, 8), "E_READER");
  writeBytes(folder / "a.nrrd", "gone");
  EXPECT_EQ(errorOf([&] {
              withImageErrors(image.fileName, [&] { readByItk(image, image.fileName, buffer.data()); });
            }).substr(0, 8),
            "E_READER");
}
