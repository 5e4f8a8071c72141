// Exact: the bytes of a bitmap, and which voxels are in which picture.
#include "HtmlText.h"
#include "ImagePicture.h"
#include "ReportTest.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

/** On the voxels of boxLabel(): i + 100 j + 10000 k, and something else as the second component. */
FieldVolume
numbersOfVoxels(const LabelVolume & organ)
{
  FieldVolume image;
  static_cast<VoxelGrid &>(image) = organ;
  image.components = 2;
  for (int k = 0; k < organ.size[2]; ++k)
  {
    for (int j = 0; j < organ.size[1]; ++j)
    {
      for (int i = 0; i < organ.size[0]; ++i)
      {
        image.values.insert(image.values.end(), { i + 100.0 * j + 10000.0 * k, -1e9 });
      }
    }
  }
  return image;
}

bool
holdsPicture(const std::string & html, const std::vector<unsigned char> & pixels, std::size_t width)
{
  return html.find(greyPicture(pixels, width)) != std::string::npos;
}

} // namespace

TEST(GreyPicture, IsABitmapOfEightBitsWithRowsOfWholeWords)
{
  const std::string text = greyPicture({ 1, 2, 3, 4, 5, 255 }, 3);
  const std::string begin = "data:image/bmp;base64,";
  ASSERT_EQ(text.substr(0, begin.size()), begin);
  // 1078 bytes of header and palette, then two rows of three pixels and a byte of room.
  EXPECT_EQ(text.size() - begin.size(), (1078u + 8u + 2u) / 3u * 4u);
  const std::vector<unsigned char> head{ 'B', 'M', 0x3e, 0x04, 0, 0, 0, 0, 0, 0, 0x36, 0x04, 0, 0, 40, 0, 0, 0,
                                         3,   0,   0,    0,    2, 0, 0, 0, 1, 0, 8,    0,    0, 0, 0,  0, 0, 0 };
  EXPECT_EQ(text.substr(begin.size(), 48), base64(head.data(), head.size()));
  // 1077 bytes are 359 whole groups of base64; the last byte of the palette (0) is one with the first two pixels.
  const std::vector<unsigned char> tail{ 0, 1, 2, 3, 0, 4, 5, 255, 0 };
  EXPECT_EQ(text.substr(begin.size() + 359 * 4), base64(tail.data(), tail.size()));
}

TEST(PictureFigures, ShowTheMiddleOfTheOrganAsRadiologistsDo)
{
  const LabelVolume organ = boxLabel(); // voxels 3..6, 3..8, 3..10
  const FieldVolume image = numbersOfVoxels(organ);
  const auto        range = rangeInOrgan(image, organ);
  EXPECT_EQ(range.low, 30303.0);
  EXPECT_EQ(range.high, 100806.0);
  const std::string html = pictureFigures(image, organ, "the mean image", "mean");
  EXPECT_EQ(timesIn(html, "<svg class=\"slice\""), 3u);
  for (const char * text :
       { "Axial slice at z = 112.0 mm: the mean image", "y = 15.0 mm", "x = -1.0 mm", "id=\"mean-0\"" })
  {
    EXPECT_NE(html.find(text), std::string::npos) << text;
  }
  const auto pixels = [&](int axis) {
    std::vector<unsigned char> all;
    for (int row = 0; row < 12; ++row)
    {
      for (int column = 0; column < 12; ++column)
      {
        const int    i = axis == 0 ? 4 : column;
        const int    j = axis == 0 ? column : axis == 1 ? 5 : 11 - row; // axial pictures begin behind, at the bottom
        const int    k = axis == 2 ? 6 : row;
        const auto   voxel = organ.voxelNumber(i, j, k);
        const double part = (image.at(voxel)[0] - 30303.0) / 70503.0;
        all.push_back(organ.inside[voxel] == 0 ? 255 : static_cast<unsigned char>(std::lround(254.0 * part)));
      }
    }
    return all;
  };
  for (const int axis : { 0, 1, 2 })
  {
    EXPECT_TRUE(holdsPicture(html, pixels(axis), 12)) << axis;
  }
}

TEST(PictureFigures, OfAConstantImageAreBlackNotDividedByZero)
{
  const LabelVolume organ = boxLabel();
  FieldVolume       image = numbersOfVoxels(organ);
  image.values.assign(image.values.size(), 7.0);
  std::vector<unsigned char> pixels;
  for (int row = 0; row < 12; ++row)
  {
    for (int column = 0; column < 12; ++column)
    {
      pixels.push_back(organ.inside[organ.voxelNumber(column, 11 - row, 6)] == 0 ? 255 : 0);
    }
  }
  EXPECT_TRUE(holdsPicture(pictureFigures(image, organ, "", "a"), pixels, 12));
}
