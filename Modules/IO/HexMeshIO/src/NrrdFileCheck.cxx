#include "ImageHeader.h"
#include "NrrdHeader.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <optional>

namespace moserhex
{
namespace
{

namespace fs = std::filesystem;

using SpaceVector = std::optional<std::vector<double>>;

/** "(a,b,c) none (d,e,f)". \throws BadInput (Header) */
std::vector<SpaceVector>
vectorsOf(const std::string & file, const std::string & field, const std::string & text)
{
  std::vector<SpaceVector> vectors;
  std::size_t              at = 0;
  while ((at = text.find_first_not_of(" \t", at)) != std::string::npos)
  {
    if (text.compare(at, 4, "none") == 0)
    {
      vectors.emplace_back(std::nullopt);
      at += 4;
      continue;
    }
    const auto end = text.find(')', at);
    if (text[at] != '(' || end == std::string::npos)
    {
      throwHeader(file, field + " is " + quoted(text.substr(at)) + ", need (x,y,z) or none");
    }
    std::string inside = text.substr(at + 1, end - at - 1);
    const auto  commas = static_cast<std::size_t>(std::count(inside.begin(), inside.end(), ','));
    std::replace(inside.begin(), inside.end(), ',', ' ');
    vectors.emplace_back(numbersOf(file, field, inside, commas + 1));
    if (commas != 2)
    {
      throwHeader(file, field + " holds a vector of " + std::to_string(commas + 1) + " components, need 3");
    }
    at = end + 1;
  }
  return vectors;
}

/** The factors that turn a space into LPS. */
Vector3
nrrdSpace(const NrrdHeader & header, ImageDescription & image)
{
  const std::string space = lowerCase(header.get("space"));
  if (header.has("space") && header.has("space dimension"))
  {
    throwHeader(image.fileName, "both 'space' and 'space dimension' are given");
  }
  if (header.has("space dimension") && header.get("space dimension") != "3")
  {
    throw BadInput(ErrorCode::Dimension,
                   image.fileName,
                   "space dimension " + quoted(header.get("space dimension")) + ", need a 3-D image",
                   exportScalarVolume);
  }
  if (space == "left-posterior-superior" || space == "lps")
  {
    return Vector3(1.0, 1.0, 1.0);
  }
  if (space == "right-anterior-superior" || space == "ras")
  {
    return Vector3(-1.0, -1.0, 1.0);
  }
  if (space == "left-anterior-superior" || space == "las")
  {
    return Vector3(1.0, -1.0, 1.0);
  }
  if (space.empty())
  {
    image.warnings.push_back(image.fileName + ": the header names no anatomical space: axes taken as LPS");
  }
  else if (space == "scanner-xyz" || space == "3d-right-handed" || space == "3d-left-handed")
  {
    image.warnings.push_back(image.fileName + ": the space " + space + " is not anatomical: axes taken as LPS");
  }
  else
  {
    const bool timed = space.find("time") != std::string::npos || space.size() == 4;
    throw BadInput(timed ? ErrorCode::Dimension : ErrorCode::Header,
                   image.fileName,
                   "space " + quoted(space) + ", need that of a 3-D image",
                   exportScalarVolume);
  }
  return Vector3::Ones();
}

/** How the axes of the file are used. */
struct NrrdAxes
{
  std::vector<std::uint64_t> sizes;
  std::vector<std::string>   kinds;      ///< lower case; "" unknown
  std::vector<SpaceVector>   directions; ///< empty without the field
  std::vector<std::size_t>   spatial;    ///< the three axes
  std::uint64_t              layers{ 1 };
};

bool
isSpatialKind(const std::string & kind)
{
  return kind.empty() || kind == "domain" || kind == "space" || kind == "???" || kind == "none";
}

[[noreturn]] void
throwExtraAxis(const ImageDescription & image, const NrrdAxes & axes, std::size_t axis)
{
  const std::string & kind = axes.kinds[axis];
  const std::string   count = std::to_string(axes.sizes[axis]);
  if (kind.empty() || isSpatialKind(kind) || kind == "list" || kind == "time")
  {
    throw BadInput(ErrorCode::Dimension,
                   image.fileName,
                   "a " + std::to_string(axes.sizes.size()) + "-D image of " + count + " volumes, need a 3-D image",
                   "export one 3-D volume");
  }
  throw BadInput(ErrorCode::PixelType,
                 image.fileName,
                 count + " values per voxel (" + quoted(kind) + "), need one",
                 exportScalarVolume);
}

NrrdAxes
nrrdAxes(const NrrdHeader & header, const ImageDescription & image)
{
  constexpr std::uint64_t mostDimensions = 16;
  const auto              dimension = countsOf(image.fileName, "dimension", header.get("dimension"));
  if (dimension.size() != 1 || dimension[0] == 0 || dimension[0] > mostDimensions)
  {
    throwHeader(image.fileName, "dimension " + quoted(header.get("dimension")) + ", need 3");
  }
  const std::size_t axisCount = dimension[0];
  const auto        requireCount = [&](const char * field, std::size_t count) {
    if (count != axisCount)
    {
      throwHeader(image.fileName,
                  std::string(field) + " are " + std::to_string(count) + " for dimension " + std::to_string(axisCount));
    }
  };
  NrrdAxes axes;
  axes.sizes = countsOf(image.fileName, "sizes", header.get("sizes"));
  requireCount("sizes", axes.sizes.size());
  axes.kinds.resize(axisCount);
  if (header.has("kinds"))
  {
    axes.kinds = wordsOf(lowerCase(header.get("kinds")));
    requireCount("kinds", axes.kinds.size());
  }
  if (header.has("space directions"))
  {
    axes.directions = vectorsOf(image.fileName, "space directions", header.get("space directions"));
    requireCount("space directions", axes.directions.size());
  }
  return axes;
}

/** Whether the first axis of a file may be one of values. Of masked tensors ITK leaves out the mask. */
bool
mayHoldValues(const std::string & kind, std::uint64_t size)
{
  return !isSpatialKind(kind) && kind != "time" && kind != "3d-masked-symmetric-matrix" && size <= mostValuesPerVoxel;
}

/** Sorts the axes into three of space and others. \throws BadInput (Dimension, PixelType, Geometry) */
void
findSpatialAxes(const ImageDescription & image, bool segmentation, VoxelContent content, NrrdAxes & axes)
{
  const std::size_t axisCount = axes.sizes.size();
  if (axisCount < 3)
  {
    throw BadInput(ErrorCode::Dimension,
                   image.fileName,
                   "a " + std::to_string(axisCount) + "-D image, need a 3-D image",
                   exportScalarVolume);
  }
  const auto & directions = axes.directions;
  if (!directions.empty() && std::none_of(directions.begin(), directions.end(), [](const auto & v) { return v; }))
  {
    throw BadInput(ErrorCode::Geometry, image.fileName, "no axis has a direction in space", correctHeader);
  }
  for (std::size_t axis = 0; axis < axisCount; ++axis)
  {
    const bool directed = directions.empty() || directions[axis];
    if (directed && isSpatialKind(axes.kinds[axis]) && axes.spatial.size() < 3)
    {
      axes.spatial.push_back(axis);
    }
    else if (axis == 0 && ((segmentation && axes.kinds[0] != "rgb-color") ||
                           (content == VoxelContent::ManyValues && mayHoldValues(axes.kinds[0], axes.sizes[0]))))
    {
      axes.layers = axes.sizes[0];
    }
    else if (axes.sizes[axis] != 1)
    {
      throwExtraAxis(image, axes, axis);
    }
  }
  if (axes.spatial.size() != 3)
  {
    throw BadInput(ErrorCode::Dimension,
                   image.fileName,
                   std::to_string(axes.spatial.size()) + " axes of space, need a 3-D image",
                   exportScalarVolume);
  }
}

void
requireMillimetres(const NrrdHeader & header, const ImageDescription & image)
{
  for (const char * field : { "space units", "units" })
  {
    for (const std::string & unit : wordsOf(lowerCase(header.get(field))))
    {
      if (unit != "\"mm\"" && unit != "\"\"" && unit.rfind("\"millimet", 0) != 0 && unit != "\"???\"")
      {
        throw BadInput(ErrorCode::Geometry,
                       image.fileName,
                       std::string(field) + ' ' + quoted(unit),
                       "convert the image to millimetres");
      }
    }
  }
}

void
setNrrdGeometry(const NrrdHeader & header, const NrrdAxes & axes, const Vector3 & toLps, ImageDescription & image)
{
  requireMillimetres(header, image);
  if (header.has("axis mins") || header.has("axis maxs"))
  {
    throw BadInput(ErrorCode::Unsupported,
                   image.fileName,
                   "the image's place is given by axis mins or maxs",
                   "save it with space directions");
  }
  if (header.has("spacings") && (header.has("space directions") || header.has("space")))
  {
    throwHeader(image.fileName, "spacings are given in a space, which needs space directions alone");
  }
  Matrix3             columns = Matrix3::Identity();
  std::vector<double> spacings(axes.sizes.size(), 1.0);
  if (header.has("spacings"))
  {
    spacings = numbersOf(image.fileName, "spacings", header.get("spacings"), axes.sizes.size());
  }
  else if (axes.directions.empty())
  {
    image.warnings.push_back(image.fileName + ": the header gives no voxel size: 1 mm assumed");
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t  own = axes.spatial[axis];
    const Eigen::Index column = static_cast<Eigen::Index>(axis);
    columns.col(column) *= spacings[own];
    if (!axes.directions.empty())
    {
      const std::vector<double> & vector = *axes.directions[own];
      columns.col(column) = toLps.cwiseProduct(Vector3(vector[0], vector[1], vector[2]));
    }
  }
  Vector3 origin = Vector3::Zero();
  if (header.has("space origin"))
  {
    const auto vectors = vectorsOf(image.fileName, "space origin", header.get("space origin"));
    if (vectors.size() != 1 || !vectors[0])
    {
      throwHeader(image.fileName, "space origin is " + quoted(header.get("space origin")));
    }
    origin = toLps.cwiseProduct(Vector3((*vectors[0])[0], (*vectors[0])[1], (*vectors[0])[2]));
  }
  setGeometry(image, columns, origin);
}

VoxelEncoding
nrrdEncoding(const NrrdHeader & header, const ImageDescription & image)
{
  static const std::map<std::string, VoxelEncoding> encodings{
    { "raw", VoxelEncoding::Raw },    { "gzip", VoxelEncoding::Gzip }, { "gz", VoxelEncoding::Gzip },
    { "ascii", VoxelEncoding::Text }, { "text", VoxelEncoding::Text }, { "txt", VoxelEncoding::Text }
  };
  const std::string encoding = lowerCase(header.get("encoding"));
  const auto        entry = encodings.find(encoding);
  if (entry == encodings.end())
  {
    const bool known = encoding == "hex" || encoding == "bzip2" || encoding == "bz2";
    throw BadInput(known ? ErrorCode::Unsupported : ErrorCode::Header,
                   image.fileName,
                   "encoding " + quoted(encoding),
                   "save the image as raw or gzip NRRD");
  }
  return entry->second;
}

/** \throws BadInput (Header)  unknown where it is needed */
void
setNrrdByteOrder(const NrrdHeader & header, ImageDescription & image)
{
  const std::string endian = lowerCase(header.get("endian"));
  if (!(endian == "little" || endian == "big" || endian.empty()))
  {
    throwHeader(image.fileName, "endian is " + quoted(endian) + ", need little or big");
  }
  if (endian.empty() && image.bytesPerComponent > 1 && image.encoding != VoxelEncoding::Text)
  {
    throwHeader(image.fileName,
                std::to_string(8 * image.bytesPerComponent) +
                  "-bit voxels without 'endian': the byte order is unknown");
  }
  image.swapped = endian == "big" && image.encoding != VoxelEncoding::Text;
}

/** Honours 'byte skip' of raw data, -1 included: they are then the end of the file. */
void
skipBytes(const NrrdHeader & header, ImageDescription & image)
{
  const std::uint64_t size = fs::file_size(image.dataFile);
  const auto          skipOf = [&](const char * field) {
    const std::string value = header.get(field);
    const auto        counts = countsOf(image.fileName, field, value.empty() ? "0" : value);
    if (counts.size() != 1 || counts[0] > size)
    {
      throwHeader(image.fileName, std::string(field) + ' ' + quoted(value) + " is more than the file holds");
    }
    return counts[0];
  };
  const bool          fromEnd = header.get("byte skip") == "-1";
  const std::uint64_t lines = skipOf("line skip");
  const std::uint64_t bytes = fromEnd ? 0 : skipOf("byte skip");
  if (lines > 0 || ((bytes > 0 || fromEnd) && image.encoding != VoxelEncoding::Raw))
  {
    throw BadInput(ErrorCode::Unsupported,
                   image.fileName,
                   "lines, or bytes of compressed data, are to be skipped",
                   "save the image as plain .nrrd");
  }
  const std::uint64_t begin = image.dataBegin + bytes;
  image.dataBegin = fromEnd && size > image.dataBegin + image.promisedBytes ? size - image.promisedBytes : begin;
}

} // namespace

ImageDescription
checkNrrdHeader(const std::string & file, VoxelContent content)
{
  const std::string text = beginningOf(file, longestNrrdHeader);
  const NrrdHeader  header = parseNrrdHeader(file, text);
  for (const char * field : { "type", "dimension", "sizes", "encoding" })
  {
    if (!header.has(field))
    {
      throwHeader(file, std::string("the header has no field '") + field + "'");
    }
  }
  ImageDescription image;
  image.fileName = file;
  image.format = ImageFormat::Nrrd;
  image.keyValues = header.keyValues;
  image.encoding = nrrdEncoding(header, image);
  const Vector3 toLps = nrrdSpace(header, image);
  NrrdAxes      axes = nrrdAxes(header, image);
  const bool    isSegmentation = header.keyValues.count("Segment0_ID") + header.keyValues.count("Segment0_Name") > 0;
  findSpatialAxes(image, isSegmentation, content, axes);
  image.valuesInLps = toLps == Vector3::Ones() && !header.has("measurement frame");
  setVoxels(image,
            { axes.sizes[axes.spatial[0]], axes.sizes[axes.spatial[1]], axes.sizes[axes.spatial[2]] },
            nrrdComponentType(file, header.get("type")),
            axes.layers);
  image.dataFile = file;
  image.dataBegin = header.bytes;
  if (header.has("data file"))
  {
    setDataFile(image, header.get("data file"));
    image.dataBegin = 0;
  }
  setNrrdByteOrder(header, image);
  skipBytes(header, image);
  setNrrdGeometry(header, axes, toLps, image);
  requirePlausibleSize(image);
  return image;
}

} // namespace moserhex
