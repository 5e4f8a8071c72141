// The check of NIfTI-1 headers. Places to 1e-6 mm: the header holds single precision.
#include "ImageCheckErrors.h"
#include "NiftiText.h"
#include "moserhex/HexMeshIO/ScalarImageReader.h"

#include <Eigen/LU>

#include <itk_zlib.h>

#include <cmath>
#include <cstdlib>
#include <limits>

using namespace moserhex;

namespace
{

constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();

std::string
gzipOf(const std::string & bytes)
{
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::string result(deflateBound(&stream, bytes.size()), '\0');
  std::string input = bytes;
  stream.next_in = reinterpret_cast<unsigned char *>(input.data());
  stream.avail_in = static_cast<unsigned int>(input.size());
  stream.next_out = reinterpret_cast<unsigned char *>(result.data());
  stream.avail_out = static_cast<unsigned int>(result.size());
  deflate(&stream, Z_FINISH);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

std::string
errorOfFile(const std::string & fileName)
{
  return errorOf([&] { (void)checkImageFile(fileName, ImageFormat::Nifti); });
}

std::string
errorOfText(const TestFolder & folder, const NiftiText & text)
{
  writeBytes(folder / "a.nii", text.file());
  return errorOfFile(folder / "a.nii");
}

ImageDescription
described(const TestFolder & folder, const NiftiText & text)
{
  writeBytes(folder / "a.nii", text.file());
  return checkImageFile(folder / "a.nii", ImageFormat::Nifti);
}

} // namespace

TEST(NiftiCheck, BrokenFieldsAreRefusedByCode)
{
  const TestFolder folder;
  const auto       expectCode = [&](NiftiText & text, const char * code, const char * what) {
    const std::string error = errorOfText(folder, text);
    EXPECT_EQ(error.substr(0, error.find(' ')), code) << what << ": " << error;
  };
  const auto shortValue = [&](std::size_t offset, int value, const char * code, const char * what) {
    NiftiText text;
    expectCode(text.set<std::int16_t>(offset, static_cast<std::int16_t>(value)), code, what);
  };
  const auto real = [&](std::size_t offset, float value, const char * code, const char * what) {
    NiftiText text;
    expectCode(text.set<float>(offset, value), code, what);
  };
  shortValue(40, 0, "E_HEADER", "dim[0] 0");
  shortValue(40, 8, "E_HEADER", "dim[0] 8");
  shortValue(40, 2, "E_DIMENSION", "dim[0] 2");
  shortValue(42, 0, "E_HEADER", "dim[1] 0");
  shortValue(42, -10, "E_HEADER", "dim[1] -10");
  shortValue(42, 6, "E_TRUNCATED", "dim[1] 6");
  shortValue(70, 0, "E_HEADER", "datatype 0");
  shortValue(70, 1, "E_UNSUPPORTED", "datatype bit");
  shortValue(70, 32, "E_PIXELTYPE", "datatype complex");
  shortValue(70, 128, "E_PIXELTYPE", "datatype RGB");
  shortValue(70, 2048, "E_UNSUPPORTED", "datatype complex256");
  shortValue(72, 16, "E_HEADER", "bitpix");
  real(76, notANumber, "E_GEOMETRY", "pixdim[0] NaN");
  real(80, 0.0F, "E_GEOMETRY", "pixdim[1] 0");
  real(80, -0.5F, "E_GEOMETRY", "pixdim[1] negative");
  real(80, 0.6F, "E_GEOMETRY", "pixdim[1] is not the sform's");
  real(108, notANumber, "E_HEADER", "vox_offset NaN");
  real(108, 1e30F, "E_HEADER", "vox_offset huge");
  real(108, 0.0F, "E_HEADER", "vox_offset 0");
  real(108, 352.5F, "E_HEADER", "vox_offset fraction");
  real(108, 1000.0F, "E_TRUNCATED", "vox_offset behind the end");
  real(112, 1e20F, "E_HEADER", "scl_slope huge");
  real(256, notANumber, "E_GEOMETRY", "quaternion NaN");
  real(280, std::numeric_limits<float>::infinity(), "E_GEOMETRY", "sform infinite");
  real(280, 1.7e38F, "E_GEOMETRY", "sform huge");
  real(280, 0.0F, "E_GEOMETRY", "sform singular");
  real(284, 0.2F, "E_GEOMETRY", "sform sheared");
  real(292, 2e6F, "E_GEOMETRY", "origin");
}

TEST(NiftiCheck, FourAndFiveDimensionsAreRefusedByName)
{
  const TestFolder folder;
  NiftiText        four;
  four.set<std::int16_t>(40, 4).set<std::int16_t>(48, 5);
  EXPECT_NE(errorOfText(folder, four).find("E_DIMENSION"), std::string::npos);
  NiftiText vector;
  vector.set<std::int16_t>(40, 5).set<std::int16_t>(50, 3);
  EXPECT_NE(errorOfText(folder, vector).find("E_PIXELTYPE"), std::string::npos);
  NiftiText huge;
  huge.set<std::int16_t>(40, 7);
  for (std::size_t offset = 42; offset < 56; offset += 2)
  {
    huge.set<std::int16_t>(offset, 32767);
  }
  EXPECT_NE(errorOfText(folder, huge).find("E_TOO_BIG"), std::string::npos);
  NiftiText one;
  writeBytes(folder / "a.nii", one.set<std::int16_t>(40, 4).file());
  expectTestVoxels(readHere(folder / "a.nii"));
}

TEST(NiftiCheck, OtherFormatsAreTold)
{
  const TestFolder folder;
  NiftiText        text;
  EXPECT_NE(errorOfText(folder, text.setMagic(std::string("ni1\0", 4))).find("E_REFERENCE"), std::string::npos);
  EXPECT_NE(errorOfText(folder, text.setMagic(std::string(4, '\0'))).find("ANALYZE"), std::string::npos);
  NiftiText other;
  EXPECT_NE(errorOfText(folder, other.set<std::int32_t>(0, 1234)).find("E_FORMAT"), std::string::npos);
  std::string two = NiftiText().file();
  two.replace(0, 8, std::string("\x1C\x02\0\0n+2\0", 8));
  writeBytes(folder / "a.nii", two);
  EXPECT_NE(errorOfFile(folder / "a.nii").find("E_UNSUPPORTED"), std::string::npos);
  writeBytes(folder / "a.nii", "short");
  EXPECT_NE(errorOfFile(folder / "a.nii").find("E_FORMAT"), std::string::npos);
  writeBytes(folder / "a.nii", NiftiText().file().substr(0, 200));
  EXPECT_NE(errorOfFile(folder / "a.nii").find("E_TRUNCATED"), std::string::npos);
}

TEST(NiftiCheck, BothByteOrdersAreRead)
{
  const TestFolder folder;
  for (const bool swapped : { false, true })
  {
    NiftiText text(swapped);
    text.set<std::int16_t>(70, 4).set<std::int16_t>(72, 16);
    writeBytes(folder / "a.nii", text.header() + voxelsAs<short>(swapped));
    expectTestVoxels(readHere(folder / "a.nii"));
  }
}

TEST(NiftiCheck, CompressionIsToldFromTheContent)
{
  const TestFolder  folder;
  const std::string plain = NiftiText().file();
  for (const char * name : { "a.nii", "a.nii.gz", "A.NII", "Mixed.Nii.Gz", "none" })
  {
    writeBytes(folder / name, plain);
    expectTestVoxels(readHere(folder / name));
    writeBytes(folder / name, gzipOf(plain));
    expectTestVoxels(readHere(folder / name));
    writeBytes(folder / name, gzipOf(plain.substr(0, 380)) + gzipOf(plain.substr(380))); // two members
    expectTestVoxels(readHere(folder / name));
  }
}

TEST(NiftiCheck, VoxelsComeFromTheFileThatIsNamed)
{
  // The NIfTI library would take those of a.nii.
  const TestFolder folder;
  writeBytes(folder / "a.nii", NiftiText().header() + std::string(60, '\7'));
  writeBytes(folder / "a.nii.gz", gzipOf(NiftiText().file()));
  expectTestVoxels(readHere(folder / "a.nii.gz"));
}

TEST(NiftiCheck, NoLinkIsLeftBehind)
{
  const TestFolder  folder;
  const TestFolder  temporary;
  const char *      before = std::getenv("TMPDIR");
  const std::string kept = before ? before : "";
  ::setenv("TMPDIR", (temporary / "").c_str(), 1);
  writeBytes(folder / "a.nii", NiftiText().file());
  expectTestVoxels(readLabelImage(folder / "a.nii"));
  EXPECT_EQ(temporary.fileCount(), 0u);
  ::setenv("TMPDIR", (temporary / "missing").c_str(), 1);
  EXPECT_EQ(errorOf([&] { (void)readLabelImage(folder / "a.nii"); }).substr(0, 4), "E_IO");
  before ? ::setenv("TMPDIR", kept.c_str(), 1) : ::unsetenv("TMPDIR");
}

TEST(NiftiCheck, StreamThatGoesOnIsNotDecodedToItsEnd)
{
  const TestFolder folder;
  writeBytes(folder / "a.nii.gz", gzipOf(NiftiText().file() + std::string(20'000'000, 'x')));
  const LabelImage image = readHere(folder / "a.nii.gz");
  ASSERT_EQ(image.warnings.size(), 1u);
  EXPECT_NE(image.warnings[0].find("more than 16777216 bytes after the voxels"), std::string::npos);
}

TEST(NiftiCheck, DamagedStreamIsAChecksumError)
{
  const TestFolder folder;
  std::string      bytes = gzipOf(NiftiText().file());
  bytes[bytes.size() - 6] = static_cast<char>(bytes[bytes.size() - 6] ^ 1);
  writeBytes(folder / "a.nii.gz", bytes);
  EXPECT_NE(errorOfFile(folder / "a.nii.gz").find("E_CHECKSUM"), std::string::npos);
}

TEST(NiftiCheck, ExtensionsMustEndBeforeTheVoxels)
{
  const TestFolder folder;
  const auto       errorFor = [&](std::int32_t size, std::size_t room) {
    NiftiText text;
    text.set<float>(108, static_cast<float>(352 + room)).set<char>(348, 1);
    std::string extension(room, '\0');
    std::memcpy(extension.data(), &size, sizeof size);
    writeBytes(folder / "a.nii", text.header() + extension + ImageText::voxels());
    return errorOfFile(folder / "a.nii");
  };
  EXPECT_EQ(errorFor(32, 32), "no error");
  expectTestVoxels(readHere(folder / "a.nii"));
  EXPECT_EQ(errorFor(32, 48), "no error"); // zeros behind it
  EXPECT_NE(errorFor(64, 32).find("E_HEADER"), std::string::npos);
  EXPECT_NE(errorFor(2147483632, 16).find("E_HEADER"), std::string::npos);
  EXPECT_NE(errorFor(-16, 16).find("E_HEADER"), std::string::npos);
}

TEST(NiftiCheck, QformAloneGivesThePlace)
{
  const TestFolder folder;
  NiftiText        text;
  text.set<std::int16_t>(254, 0).setQform(1.0F, -1.0F);
  const VoxelGrid grid = described(folder, text).grid;
  EXPECT_LT((grid.point(1, 1, 1) - Vector3(1.5, 2.75, 5.0)).norm(), 1e-6);
  // A real file's: 1 - |v|^2 is 4e-8, a float's rounding. Half a turn all the same (symmetric), not 2e-4 rad beside it.
  NiftiText rounded;
  rounded.set<std::int16_t>(254, 0).setQform(0.99848908F, -1.0F).set<float>(260, -0.05495018F);
  Matrix3 rotation = described(folder, rounded).grid.direction;
  rotation.topRows(2) *= -1.0; // RAS
  EXPECT_LT((rotation - rotation.transpose()).norm(), 1e-12);
  // qfac: the third axis backwards.
  EXPECT_LT(described(folder, text.set<float>(76, -1.0F)).grid.direction.determinant(), 0.0);
  EXPECT_NE(errorOfText(folder, text.set<float>(256, 1.2F)).find("not a rotation"), std::string::npos);
}

TEST(NiftiCheck, GeneralRotationIsThatOfTheStandard)
{
  // A third of a turn about (1,1,1): x to y, y to z, z to x.
  const TestFolder folder;
  NiftiText        text;
  text.set<std::int16_t>(254, 0).setQform(0.5F, 0.0F).set<float>(256, 0.5F).set<float>(260, 0.5F);
  const Matrix3 direction = described(folder, text).grid.direction;
  EXPECT_LT((direction.col(0) - Vector3(0.0, -1.0, 0.0)).norm(), 1e-6); // RAS +y is LPS -y
  EXPECT_LT((direction.col(1) - Vector3(0.0, 0.0, 1.0)).norm(), 1e-6);
  EXPECT_LT((direction.col(2) - Vector3(-1.0, 0.0, 0.0)).norm(), 1e-6);
}

TEST(NiftiCheck, QformAndSformMustAgree)
{
  const TestFolder folder;
  NiftiText        text;
  EXPECT_TRUE(described(folder, text.setQform(1.0F, -1.0F)).warnings.empty());
  const auto warnings = described(folder, text.setQform(1.0F, -1.1F)).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("the sform is taken"), std::string::npos);
  EXPECT_NE(errorOfText(folder, text.setQform(1.0F, -3.0F)).find("E_GEOMETRY"), std::string::npos);
  EXPECT_NE(errorOfText(folder, text.setQform(0.9F, -1.0F)).find("qform and sform disagree"), std::string::npos);
}

TEST(NiftiCheck, WithoutQformAndSformThereIsAWarning)
{
  const TestFolder       folder;
  NiftiText              text;
  const ImageDescription image = described(folder, text.set<std::int16_t>(254, 0));
  EXPECT_EQ(image.warnings.size(), 1u);
  EXPECT_EQ(image.grid.direction, Matrix3(Matrix3::Identity()));
}

TEST(NiftiCheck, UnitsBecomeMillimetres)
{
  const TestFolder folder;
  NiftiText        micron;
  micron.set<char>(123, 3).set<std::int16_t>(254, 0).setQform(1.0F, -1000.0F);
  for (const std::size_t offset : { 80u, 84u, 88u })
  {
    micron.set<float>(offset, 500.0F);
  }
  const VoxelGrid grid = described(folder, micron).grid;
  EXPECT_LT((grid.spacing - Vector3::Constant(0.5)).norm(), 1e-9);
  EXPECT_NEAR(grid.origin[0], 1.0, 1e-9);
  NiftiText metre;
  EXPECT_NE(errorOfText(folder, metre.set<char>(123, 1)).find("E_UNSUPPORTED"), std::string::npos);
  NiftiText unknown;
  EXPECT_NE(errorOfText(folder, unknown.set<char>(123, 7)).find("unit of length"), std::string::npos);
}

TEST(NiftiCheck, SlopeAndInterceptAreAppliedToLabels)
{
  const TestFolder folder;
  NiftiText        text;
  text.set<float>(112, 0.5F);
  writeBytes(folder / "a.nii", text.header() + voxelsAs<std::uint8_t>(false, 2.0));
  expectTestVoxels(readHere(folder / "a.nii"));
  writeBytes(folder / "a.nii", text.set<float>(112, 0.1F).header() + voxelsAs<std::uint8_t>(false, 10.0));
  expectTestVoxels(readHere(folder / "a.nii"));
  writeBytes(folder / "a.nii", text.set<float>(112, 0.3F).file());
  EXPECT_NE(errorOf([&] { (void)readHere(folder / "a.nii"); }).find("E_LABELS"), std::string::npos);
  text.set<float>(112, 0.5F).set<std::int16_t>(70, 64).set<std::int16_t>(72, 64);
  writeBytes(folder / "a.nii", text.header() + voxelsAs<double>(false, 2.0));
  expectTestVoxels(readHere(folder / "a.nii"));
}

TEST(NiftiCheck, InterceptOfNothingScalesNothing)
{
  const TestFolder folder;
  NiftiText        text;
  writeBytes(folder / "a.nii", text.set<float>(116, 1.8e-43F).file());
  expectTestVoxels(readHere(folder / "a.nii"));
}

TEST(NiftiCheck, SlopeThatIsNoNumberIsLeftAside)
{
  const TestFolder folder;
  NiftiText        text;
  EXPECT_TRUE(described(folder, text.set<float>(112, 0.0F)).warnings.empty());
  EXPECT_NE(errorOfText(folder, text.set<float>(116, 5.0F)).find("scl_slope is 0"), std::string::npos);
  writeBytes(folder / "a.nii", text.set<float>(112, notANumber).set<float>(116, 0.0F).file());
  const LabelImage image = readHere(folder / "a.nii");
  expectTestVoxels(image);
  EXPECT_EQ(image.warnings.size(), 1u);
}
