#include "ImagePicture.h"

#include "HtmlText.h"
#include "SliceFrame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace moserhex::app
{
namespace
{

constexpr double roomAround = 0.08; ///< for letters, of the longer side

constexpr unsigned char white = 254;
constexpr unsigned char ground = 255;

void
append(std::vector<unsigned char> & bytes, std::size_t number, int count)
{
  for (int byte = 0; byte < count; ++byte)
  {
    bytes.push_back(static_cast<unsigned char>(number >> (8 * byte) & 255));
  }
}

/** Blue, green, red and 0 of every grey, and of the ground. */
void
appendPalette(std::vector<unsigned char> & bytes)
{
  for (std::size_t grey = 0; grey <= white; ++grey)
  {
    const std::size_t level = grey * 255 / white;
    append(bytes, level | level << 8 | level << 16, 4);
  }
  append(bytes, 0xf8f9fb, 4);
}

/** The middle of the organ's box. */
std::array<int, 3>
middleOf(const LabelVolume & organ)
{
  std::array<int, 3> low = organ.size;
  std::array<int, 3> high{ { 0, 0, 0 } };
  std::size_t        voxel = 0;
  for (int k = 0; k < organ.size[2]; ++k)
  {
    for (int j = 0; j < organ.size[1]; ++j)
    {
      for (int i = 0; i < organ.size[0]; ++i, ++voxel)
      {
        const std::array<int, 3> index{ { i, j, k } };
        for (std::size_t axis = 0; organ.inside[voxel] != 0 && axis < 3; ++axis)
        {
          low[axis] = std::min(low[axis], index[axis]);
          high[axis] = std::max(high[axis], index[axis]);
        }
      }
    }
  }
  return { { (low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2 } };
}

std::vector<unsigned char>
pixelsOf(const FieldVolume & image, const LabelVolume & organ, const SliceFrame & frame, std::array<int, 3> index)
{
  const std::size_t          a = frame.axis == 0 ? 1 : 0;
  const std::size_t          b = frame.axis == 2 ? 1 : 2;
  const CellField::Range     range = rangeInOrgan(image, organ);
  const double               width = std::max(range.high - range.low, std::numeric_limits<double>::min());
  std::vector<unsigned char> pixels;
  for (int row = 0; row < organ.size[b]; ++row)
  {
    index[b] = frame.isTurned() ? row : organ.size[b] - 1 - row;
    for (index[a] = 0; index[a] < organ.size[a]; ++index[a])
    {
      const std::size_t voxel = organ.voxelNumber(index[0], index[1], index[2]);
      const double      part = (image.at(voxel)[0] - range.low) / width;
      pixels.push_back(organ.inside[voxel] == 0 ? ground : static_cast<unsigned char>(std::lround(white * part)));
    }
  }
  return pixels;
}

} // namespace

std::string
greyPicture(const std::vector<unsigned char> & pixels, std::size_t width)
{
  constexpr std::size_t      header = 14 + 40 + 4 * 256;
  const std::size_t          height = pixels.size() / width;
  const std::size_t          room = (4 - width % 4) % 4; // rows end at multiples of four bytes
  std::vector<unsigned char> bytes{ 'B', 'M' };
  append(bytes, header + height * (width + room), 4);
  append(bytes, 0, 4);
  append(bytes, header, 4);
  append(bytes, 40, 4);
  append(bytes, width, 4);
  append(bytes, height, 4);
  append(bytes, 1, 2); // plane
  append(bytes, 8, 2); // bits
  append(bytes, 0, 4); // not compressed
  append(bytes, 0, 4);
  append(bytes, 2835, 4); // pixels a metre
  append(bytes, 2835, 4);
  append(bytes, 256, 4);
  append(bytes, 0, 4);
  appendPalette(bytes);
  for (std::size_t row = 0; row < height; ++row)
  {
    const auto begin = pixels.begin() + static_cast<std::ptrdiff_t>(row * width);
    bytes.insert(bytes.end(), begin, begin + static_cast<std::ptrdiff_t>(width));
    bytes.insert(bytes.end(), room, 0);
  }
  return "data:image/bmp;base64," + base64(bytes.data(), bytes.size());
}

CellField::Range
rangeInOrgan(const FieldVolume & image, const LabelVolume & organ)
{
  CellField::Range range{ std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
  for (std::size_t voxel = 0; voxel < organ.inside.size(); ++voxel)
  {
    if (organ.inside[voxel] != 0)
    {
      range.low = std::min(range.low, image.at(voxel)[0]);
      range.high = std::max(range.high, image.at(voxel)[0]);
    }
  }
  return range;
}

std::string
pictureFigures(const FieldVolume & image, const LabelVolume & organ, const std::string & what, const std::string & id)
{
  const std::array<int, 3> middle = middleOf(organ);
  std::string              html;
  for (const int axis : { 2, 1, 0 })
  {
    const std::size_t across = static_cast<std::size_t>(axis);
    const std::size_t a = axis == 0 ? 1 : 0;
    const std::size_t b = axis == 2 ? 1 : 2;
    const double      width = organ.size[a] * organ.spacing[static_cast<Eigen::Index>(a)];
    const double      height = organ.size[b] * organ.spacing[static_cast<Eigen::Index>(b)];
    const double      margin = roomAround * std::max(width, height);
    const SliceFrame  frame{
      axis, organ.origin[axis] + middle[across] * organ.spacing[axis], width + 2.0 * margin, height + 2.0 * margin
    };
    const auto attribute = [&frame](const std::string & name, double millimetres) {
      return " " + name + "=\"" + shortNumber(millimetres * frame.scale(), 8) + "\"";
    };
    html += framedSlice(frame,
                        "<image href=\"" +
                          greyPicture(pixelsOf(image, organ, frame, middle), static_cast<std::size_t>(organ.size[a])) +
                          "\"" + attribute("x", margin) + attribute("y", margin) + attribute("width", width) +
                          attribute("height", height) + "/>",
                        what,
                        id + "-" + std::to_string(axis));
  }
  return html;
}

} // namespace moserhex::app
