#include "ImageHeader.h"
#include "NrrdAxes.h"
#include "NrrdWriter.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <Eigen/LU>

#include <cmath>
#include <filesystem>

namespace moserhex
{
namespace
{

namespace fs = std::filesystem;

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
    const auto vectors = spaceVectorsOf(image.fileName, "space origin", header.get("space origin"));
    if (vectors.size() != 1 || !vectors[0])
    {
      throwHeader(image.fileName, "space origin is " + quoted(header.get("space origin")));
    }
    origin = toLps.cwiseProduct(Vector3((*vectors[0])[0], (*vectors[0])[1], (*vectors[0])[2]));
  }
  setGeometry(image, columns, origin);
}

/** What takes vectors to LPS: the measurement frame, whose columns the field lists in the file's space, then that
 * space's factors. Nothing without a usable frame, unless the space is LPS. */
std::optional<Matrix3>
nrrdValuesToLps(const NrrdHeader & header, const Vector3 & toLps, const ImageDescription & image)
{
  constexpr double smallestDeterminant = 1e-6; // frames are rotations, at most of other lengths
  if (!header.has("measurement frame"))
  {
    return toLps == Vector3::Ones() ? std::optional(Matrix3(Matrix3::Identity())) : std::nullopt;
  }
  const auto columns = spaceVectorsOf(image.fileName, "measurement frame", header.get("measurement frame"));
  if (columns.size() != 3)
  {
    throwHeader(image.fileName, "the measurement frame has " + std::to_string(columns.size()) + " vectors, need 3");
  }
  Matrix3 frame;
  for (std::size_t column = 0; column < 3; ++column)
  {
    if (!columns[column])
    {
      return std::nullopt;
    }
    const std::vector<double> & vector = *columns[column];
    frame.col(static_cast<Eigen::Index>(column)) = toLps.cwiseProduct(Vector3(vector[0], vector[1], vector[2]));
  }
  const bool isUsable = frame.allFinite() && std::abs(frame.determinant()) > smallestDeterminant;
  return isUsable ? std::optional(frame) : std::nullopt;
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
  const Vector3  toLps = nrrdSpace(header, image);
  const NrrdAxes axes = nrrdAxes(header, image, content);
  image.layout = axes.layout;
  image.symmetricTensors = axes.symmetricTensors;
  image.valuesToLps = nrrdValuesToLps(header, toLps, image);
  if (const auto marked = header.keyValues.find(nrrdAxesKey); marked != header.keyValues.end())
  {
    image.valuesToLps = std::nullopt;
    image.valuesInCubeAxes = marked->second == "cube";
  }
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
