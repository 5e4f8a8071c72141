// Exact: voxels, counts, labels, messages. Geometry to round-off: 1e-12.
#include "moserhex/HexMeshIO/ImageArray.h"

#include "TestErrors.h"
#include "moserhex/Analytic/SolidShapes.h"

#include <gtest/gtest.h>

#include <limits>

using namespace moserhex;

namespace
{

ArrayHeader
smallHeader()
{
  ArrayHeader header;
  header.name = "labels";
  header.size = { { 4, 3, 2 } };
  return header;
}

template <typename TVoxel>
std::vector<TVoxel>
smallVoxels()
{
  std::vector<TVoxel> voxels(24, TVoxel{ 0 });
  voxels[5] = TVoxel{ 1 };
  voxels[6] = TVoxel{ 100 };
  voxels[7] = TVoxel{ 100 };
  return voxels;
}

bool
beginsWith(const std::string & text, const std::string & beginning)
{
  return text.rfind(beginning, 0) == 0;
}

template <typename TVoxel>
class LabelArrays : public testing::Test
{};
using VoxelTypes = testing::Types<std::int8_t,
                                  std::uint8_t,
                                  std::int16_t,
                                  std::uint16_t,
                                  std::int32_t,
                                  std::uint32_t,
                                  std::int64_t,
                                  std::uint64_t,
                                  float,
                                  double>;
TYPED_TEST_SUITE(LabelArrays, VoxelTypes);

} // namespace

TYPED_TEST(LabelArrays, KeepVoxelsAndCountLabels)
{
  const LabelImage image = labelImageFrom(smallHeader(), smallVoxels<TypeParam>());
  ASSERT_EQ(image.labels.size(), 2u);
  EXPECT_EQ(image.labels[0].value, 1);
  EXPECT_EQ(image.labels[0].voxels, 1u);
  EXPECT_EQ(image.labels[1].value, 100);
  EXPECT_EQ(image.labels[1].voxels, 2u);
  EXPECT_TRUE(image.warnings.empty());
  EXPECT_EQ(image.image->GetPixel({ { 1, 1, 0 } }), 1);
  EXPECT_EQ(image.image->GetPixel({ { 3, 1, 0 } }), 100);
}

TEST(ImageArray, GeometryIsThatOfTheColumns)
{
  ArrayHeader   header = smallHeader();
  const Matrix3 direction = analytic::obliqueDirection();
  header.columns = direction * Vector3(0.5, 0.75, 3.0).asDiagonal();
  header.origin = { 10.0, -20.0, 300.0 };
  const auto image = scalarImageFrom(header, std::vector<double>(24, 1.0)).image;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(image->GetSpacing()[axis], Vector3(0.5, 0.75, 3.0)[axis], 1e-12);
    EXPECT_EQ(image->GetOrigin()[axis], header.origin[axis]);
    for (unsigned int row = 0; row < 3; ++row)
    {
      EXPECT_NEAR(image->GetDirection()(row, axis), direction(row, axis), 1e-12);
    }
  }
}

TEST(ImageArray, ValuesAreNotJudged)
{
  std::vector<double> values(24, 2.5);
  values[3] = std::numeric_limits<double>::quiet_NaN();
  const ScalarImage image = scalarImageFrom(smallHeader(), values);
  EXPECT_EQ(image.image->GetPixel({ { 2, 0, 0 } }), 2.5);
  EXPECT_TRUE(std::isnan(image.image->GetPixel({ { 3, 0, 0 } })));
}

TEST(ImageArray, ShearedAxesAreRefused)
{
  ArrayHeader header = smallHeader();
  header.columns(0, 1) = 0.1;
  EXPECT_TRUE(beginsWith(errorOf([&] { (void)labelImageFrom(header, smallVoxels<int>()); }),
                         "E_GEOMETRY labels: the image axes are not at right angles"));
}

TEST(ImageArray, SingularAndInfiniteGeometryIsRefused)
{
  ArrayHeader parallel = smallHeader();
  parallel.columns.col(1) = parallel.columns.col(0);
  ArrayHeader flat = smallHeader();
  flat.columns.col(2).setZero();
  ArrayHeader noNumber = smallHeader();
  noNumber.columns(1, 1) = std::numeric_limits<double>::quiet_NaN();
  ArrayHeader far = smallHeader();
  far.origin[2] = 1e7;
  for (const ArrayHeader & header : { parallel, flat, noNumber, far })
  {
    EXPECT_TRUE(beginsWith(errorOf([&] { (void)labelImageFrom(header, smallVoxels<int>()); }), "E_GEOMETRY labels: "));
  }
}

TEST(ImageArray, ValuesThatAreNoLabelsAreRefused)
{
  for (const double value : { -1.0, 0.5, 3e9, std::numeric_limits<double>::quiet_NaN() })
  {
    std::vector<double> voxels = smallVoxels<double>();
    voxels[23] = value;
    EXPECT_TRUE(beginsWith(errorOf([&] { (void)labelImageFrom(smallHeader(), voxels); }),
                           "E_LABELS labels: voxel (3, 2, 1) holds "));
  }
}

TEST(ImageArray, NothingLabelledIsRefused)
{
  EXPECT_TRUE(beginsWith(errorOf([&] { (void)labelImageFrom(smallHeader(), std::vector<std::uint8_t>(24, 0)); }),
                         "E_EMPTY_LABEL labels: no voxel differs from 0"));
}

TEST(ImageArray, AnArrayWithoutVoxelsIsRefused)
{
  ArrayHeader header = smallHeader();
  header.size[1] = 0;
  EXPECT_TRUE(
    beginsWith(errorOf([&] { (void)scalarImageFrom(header, {}); }), "E_EMPTY labels: an array without voxels"));
}

TEST(ImageArray, ManyVoxelsAreRefusedBeforeTheyAreAskedFor)
{
  ArrayHeader header = smallHeader();
  header.size = { { 1u << 20, 1u << 20, 1u << 20 } };
  EXPECT_TRUE(beginsWith(errorOf([&] { (void)scalarImageFrom(header, {}); }), "E_TOO_BIG labels: sizes "));
}

TEST(ImageArray, AnotherNumberOfValuesThanVoxelsIsRefused)
{
  EXPECT_THROW((void)scalarImageFrom(smallHeader(), std::vector<double>(23)), InvalidInput);
}
