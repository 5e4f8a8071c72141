// The check of MetaImage headers: what is refused under which code, and what is read as the header says.
#include "ImageCheckErrors.h"

#include <itk_zlib.h>

using namespace moserhex;

namespace
{

std::string
zlibOf(const std::string & bytes)
{
  std::string result(compressBound(bytes.size()), '\0');
  auto        size = static_cast<unsigned long>(result.size());
  compress(reinterpret_cast<unsigned char *>(result.data()),
           &size,
           reinterpret_cast<const unsigned char *>(bytes.data()),
           bytes.size());
  result.resize(size);
  return result;
}

} // namespace

TEST(MetaCheck, BrokenHeadersAreRefusedByCode)
{
  const TestFolder           folder;
  const std::vector<Refusal> refusals{
    { "ObjectType", "Tube", "E_FORMAT" },
    { "NDims", "0", "E_HEADER" },
    { "NDims", "-1", "E_HEADER" },
    { "NDims", "99999999999", "E_HEADER" },
    { "NDims", "2", "E_HEADER" },
    { "NDims", "", "E_HEADER" },
    { "DimSize", "5 4", "E_HEADER" },
    { "DimSize", "5 4 -3", "E_HEADER" },
    { "DimSize", "65536 65536 65536", "E_TOO_BIG" },
    { "DimSize", "5 4 4", "E_TRUNCATED" },
    { "BinaryData", "False", "E_UNSUPPORTED" },
    { "BinaryData", "perhaps", "E_HEADER" },
    { "ElementByteOrderMSB", "True", "E_HEADER" },
    { "CompressedData", "True", "E_HEADER" }, // no size
    { "TransformMatrix", "1 0 0 0 1 0 0 0", "E_HEADER" },
    { "TransformMatrix", "2 0 0 0 2 0 0 0 2", "E_GEOMETRY" },
    { "TransformMatrix", "1 0 0 0.6 0.8 0 0 0 1", "E_GEOMETRY" },
    { "Position", "3 4 5", "E_HEADER" }, // contradicts Offset
    { "Offset", "nan 0 0", "E_GEOMETRY" },
    { "ElementSpacing", "1 1 0", "E_GEOMETRY" },
    { "ElementSpacing", "1 1 -1", "E_GEOMETRY" },
    { "ElementSpacing", "1 1 1 1", "E_HEADER" },
    { "ElementType", "MET_BANANA", "E_UNSUPPORTED" },
    { "ElementType", "MET_UCHAR_ARRAY", "E_PIXELTYPE" },
    { "ElementNumberOfChannels", "3", "E_PIXELTYPE" },
    { "ElementNumberOfChannels", "1000000000", "E_TOO_BIG" },
    { "ElementToIntensityFunctionSlope", "2", "E_UNSUPPORTED" },
    { "HeaderSize", "-1", "E_HEADER" },
    { "Comment", std::string(300, 'c'), "E_HEADER" },
    { std::string(300, 'k'), "1", "E_HEADER" },
    { "ElementDataFile", "LIST", "E_REFERENCE" },
    { "ElementDataFile", "%s%s%n 1 10 1", "E_REFERENCE" },
    { "ElementDataFile", "/etc/passwd", "E_REFERENCE" },
    { "ElementDataFile", "../a.raw", "E_REFERENCE" },
    { "ElementDataFile", "a.mha", "E_REFERENCE" },
    { "ElementDataFile", "", "E_HEADER" },
  };
  for (const Refusal & refusal : refusals)
  {
    const ImageText text = ImageText::meta().with(refusal.key, refusal.value);
    const bool      cut = refusal.key == "ElementDataFile" && refusal.value.empty();
    writeBytes(folder / "a.mha", cut ? text.header() : text.file());
    EXPECT_EQ(checkErrorCode(folder / "a.mha"), refusal.code) << refusal.key << " = " << refusal.value << '\n'
                                                              << checkError(folder / "a.mha");
  }
}

TEST(MetaCheck, LinesWithoutSeparatorAreRefused)
{
  const TestFolder folder;
  writeBytes(folder / "a.mha", ImageText::meta().withLine("nonsense").file());
  EXPECT_EQ(checkErrorCode(folder / "a.mha"), "E_HEADER");
  writeBytes(folder / "a.mha", ImageText::meta().withLine("NDims = 3").file());
  EXPECT_NE(checkError(folder / "a.mha").find("twice"), std::string::npos);
  writeBytes(folder / "a.mha", "ObjectType = Image\nDimSize = 5 4 3\nNDims = 3\nElementDataFile = LOCAL\n");
  EXPECT_NE(checkError(folder / "a.mha").find("before NDims"), std::string::npos);
  writeBytes(folder / "a.mha", std::string("\1\2\3\0 random", 11) + std::string(4000, '\7'));
  EXPECT_EQ(checkErrorCode(folder / "a.mha"), "E_FORMAT");
  writeBytes(folder / "a.mha", ImageText::meta().header().substr(0, 60));
  EXPECT_EQ(checkErrorCode(folder / "a.mha"), "E_TRUNCATED");
}

TEST(MetaCheck, OtherNamesOfTheGeometryAreRead)
{
  const TestFolder folder;
  for (const auto & [oldKey, newKey] : { std::pair("TransformMatrix", "Rotation"),
                                         std::pair("TransformMatrix", "Orientation"),
                                         std::pair("Offset", "Position"),
                                         std::pair("Offset", "Origin") })
  {
    const std::string value = oldKey == std::string("Offset") ? "7 8 9" : "0 1 0 -1 0 0 0 0 1";
    writeBytes(folder / "a.mha", ImageText::meta().with(oldKey, "").with(newKey, value).file());
    const VoxelGrid grid = checkImageFile(folder / "a.mha", ImageFormat::Meta).grid;
    if (oldKey == std::string("Offset"))
    {
      EXPECT_EQ(grid.origin, Vector3(7.0, 8.0, 9.0));
    }
    else
    {
      EXPECT_EQ(Vector3(grid.direction.col(0)), Vector3(0.0, 1.0, 0.0)) << newKey;
    }
  }
}

TEST(MetaCheck, WhatIsAssumedIsSaid)
{
  const TestFolder folder;
  const auto       warningOf = [&](const ImageText & text, const std::string & voxels) {
    writeBytes(folder / "a.mha", text.header() + voxels);
    const auto warnings = checkImageFile(folder / "a.mha", ImageFormat::Meta).warnings;
    return warnings.size() == 1 ? warnings[0] : std::to_string(warnings.size()) + " warnings";
  };
  const ImageText text = ImageText::meta();
  EXPECT_NE(warningOf(text.with("ElementSpacing", ""), text.voxels()).find("1 mm assumed"), std::string::npos);
  EXPECT_NE(warningOf(text.with("ElementSpacing", "").with("ElementSize", "1 1 2"), text.voxels()).find("ElementSize"),
            std::string::npos);
  EXPECT_NE(warningOf(text.with("BinaryDataByteOrderMSB", "").with("ElementType", "MET_SHORT"), voxelsAs<short>())
              .find("little-endian"),
            std::string::npos);
  EXPECT_NE(warningOf(text, text.voxels() + "123").find("3 bytes after"), std::string::npos);
}

TEST(MetaCheck, EveryNumberTypeAndByteOrderIsRead)
{
  const TestFolder folder;
  const auto       expectRead = [&](const char * type, const std::string & voxels, const char * key, bool big) {
    const ImageText text = ImageText::meta().with("BinaryDataByteOrderMSB", "").with(key, big ? "True" : "0");
    writeBytes(folder / "a.mha", text.with("ElementType", type).header() + voxels);
    SCOPED_TRACE(type);
    expectTestVoxels(readHere(folder / "a.mha"));
  };
  for (const bool big : { false, true })
  {
    expectRead("MET_CHAR", voxelsAs<std::int8_t>(big), "BinaryDataByteOrderMSB", big);
    expectRead("MET_USHORT", voxelsAs<std::uint16_t>(big), "ElementByteOrderMSB", big);
    expectRead("MET_LONG", voxelsAs<std::int32_t>(big), "BinaryDataByteOrderMSB", big);
    expectRead("MET_ULONG_LONG", voxelsAs<std::uint64_t>(big), "BinaryDataByteOrderMSB", big);
    expectRead("MET_FLOAT", voxelsAs<float>(big), "ElementByteOrderMSB", big);
    expectRead("MET_DOUBLE", voxelsAs<double>(big), "BinaryDataByteOrderMSB", big);
  }
}

TEST(MetaCheck, CompressedSizeMustFitTheStream)
{
  const TestFolder  folder;
  const std::string stream = zlibOf(ImageText::voxels());
  const auto        write = [&](std::size_t size) {
    const ImageText text = ImageText::meta().with("CompressedData", "True");
    writeBytes(folder / "a.mha", text.with("CompressedDataSize", std::to_string(size)).header() + stream);
  };
  write(stream.size());
  expectTestVoxels(readHere(folder / "a.mha"));
  write(stream.size() - 2);
  EXPECT_EQ(checkErrorCode(folder / "a.mha"), "E_TRUNCATED");
  write(1'000'000'000'000);
  EXPECT_EQ(checkErrorCode(folder / "a.mha"), "E_TRUNCATED");
}

TEST(MetaCheck, FourthAxisOfSizeOneIsNoMatter)
{
  const TestFolder folder;
  const ImageText  text = ImageText::meta()
                           .with("NDims", "4")
                           .with("TransformMatrix", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1")
                           .with("Offset", "1 2 3 0")
                           .with("ElementSpacing", "0.5 0.75 2 1");
  writeBytes(folder / "a.mha", text.with("DimSize", "5 4 3 1").file());
  expectTestVoxels(readHere(folder / "a.mha"));
  writeBytes(folder / "a.mha", text.with("DimSize", "5 4 1 3").file());
  EXPECT_EQ(checkErrorCode(folder / "a.mha"), "E_DIMENSION");
}

TEST(MetaCheck, DataBesideTheHeaderAreRead)
{
  const TestFolder folder;
  writeBytes(folder / "a.raw", ImageText::voxels());
  writeBytes(folder / "a.mhd", ImageText::meta().with("ElementDataFile", "a.raw").header());
  expectTestVoxels(readHere(folder / "a.mhd"));
  writeBytes(folder / "a.mhd", ImageText::meta().with("HeaderSize", "4").with("ElementDataFile", "a.raw").header());
  EXPECT_EQ(checkErrorCode(folder / "a.mhd"), "E_UNSUPPORTED");
}
