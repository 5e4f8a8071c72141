#include "ImageHeader.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <array>
#include <filesystem>
#include <map>
#include <optional>

namespace moserhex
{
namespace
{

namespace fs = std::filesystem;

// Below the 255 characters of MetaIO's buffers.
constexpr std::size_t longestMetaLine = 250;
constexpr std::size_t longestMetaHeader = 1 << 16;

struct MetaHeader
{
  std::map<std::string, std::string> fields;
  std::uint64_t                      bytes{ 0 }; ///< length of the header

  [[nodiscard]] std::string
  get(const std::string & key) const
  {
    const auto entry = fields.find(key);
    return entry == fields.end() ? std::string() : entry->second;
  }

  [[nodiscard]] bool
  has(const std::string & key) const
  {
    return fields.count(key) > 0;
  }
};

MetaHeader
parseMetaHeader(const std::string & file, const std::string & text)
{
  MetaHeader header;
  while (header.bytes < text.size())
  {
    const auto        end = std::min(text.find('\n', header.bytes), text.size());
    const std::string line = text.substr(header.bytes, end - header.bytes);
    const auto        separator = line.find_first_of("=:"); // MetaIO takes either
    const bool        first = header.fields.empty();
    if (first && (separator == std::string::npos || line.find('\0') != std::string::npos || line[0] == '<'))
    {
      throw BadInput(
        ErrorCode::Format, file, "the content is not a MetaImage header", "check that this is a .mha or .mhd file");
    }
    if (line.size() > longestMetaLine)
    {
      throwHeader(file,
                  "a header line of " + std::to_string(line.size()) + " characters, at most " +
                    std::to_string(longestMetaLine));
    }
    if (separator == std::string::npos && end == text.size())
    {
      break;
    }
    if (separator == std::string::npos || line.find('\0') != std::string::npos)
    {
      throwHeader(file, "header line " + quoted(line) + " has no '='");
    }
    header.bytes = std::min<std::uint64_t>(end + 1, text.size());
    const std::string key = trimmed(line.substr(0, separator));
    if (!header.fields.emplace(key, trimmed(line.substr(separator + 1))).second)
    {
      throwHeader(file, "the header gives " + quoted(key) + " twice");
    }
    if (key == "DimSize" && !header.has("NDims"))
    {
      throwHeader(file, "DimSize stands before NDims");
    }
    if (key == "ElementDataFile")
    {
      return header;
    }
  }
  throw BadInput(text.back() == '\n' ? ErrorCode::Header : ErrorCode::Truncated,
                 file,
                 "the header ends early (no ElementDataFile)",
                 copyAgain);
}

ComponentType
metaComponentType(const std::string & file, const std::string & type)
{
  // MetaIO's long has 4 bytes.
  static const std::map<std::string, ComponentType> types{
    { "MET_CHAR", ComponentType::Int8 },       { "MET_UCHAR", ComponentType::UInt8 },
    { "MET_SHORT", ComponentType::Int16 },     { "MET_USHORT", ComponentType::UInt16 },
    { "MET_INT", ComponentType::Int32 },       { "MET_UINT", ComponentType::UInt32 },
    { "MET_LONG", ComponentType::Int32 },      { "MET_ULONG", ComponentType::UInt32 },
    { "MET_LONG_LONG", ComponentType::Int64 }, { "MET_ULONG_LONG", ComponentType::UInt64 },
    { "MET_FLOAT", ComponentType::Float32 },   { "MET_DOUBLE", ComponentType::Float64 }
  };
  const auto entry = types.find(type);
  if (entry == types.end())
  {
    const bool array = type.find("_ARRAY") != std::string::npos;
    throw BadInput(array ? ErrorCode::PixelType : ErrorCode::Unsupported,
                   file,
                   "ElementType is " + quoted(type),
                   "export integer labels, one per voxel");
  }
  return entry->second;
}

/** Of keys that mean the same the one that is given, with its numbers.
 * \throws BadInput (Header)  two of them contradict each other */
std::optional<std::vector<double>>
oneOf(const std::string &                         file,
      const MetaHeader &                          header,
      const std::initializer_list<const char *> & keys,
      std::size_t                                 count)
{
  std::optional<std::vector<double>> result;
  for (const char * key : keys)
  {
    if (header.has(key))
    {
      const auto numbers = numbersOf(file, key, header.get(key), count);
      if (result && *result != numbers)
      {
        throwHeader(file, std::string(key) + " contradicts another field of the same meaning");
      }
      result = numbers;
    }
  }
  return result;
}

/** "True" or "False", as MetaIO understands them. */
bool
metaFlag(const std::string & file, const MetaHeader & header, const char * key, bool otherwise)
{
  const std::string value = lowerCase(header.get(key));
  if (value.empty())
  {
    return otherwise;
  }
  if (value != "true" && value != "false" && value != "1" && value != "0")
  {
    throwHeader(file, std::string(key) + " is " + quoted(value) + ", need True or False");
  }
  return value == "true" || value == "1";
}

/** Number of axes: 3, or 4 when the last has size 1. \throws BadInput (Header, Dimension) */
std::vector<std::uint64_t>
metaSizes(const std::string & file, const MetaHeader & header)
{
  const auto dimensions = countsOf(file, "NDims", header.get("NDims"));
  if (dimensions.size() != 1 || dimensions[0] == 0 || dimensions[0] > 10)
  {
    throwHeader(file, "NDims is " + quoted(header.get("NDims")) + ", need 3");
  }
  auto sizes = countsOf(file, "DimSize", header.get("DimSize"));
  if (sizes.size() != dimensions[0])
  {
    throwHeader(file, "DimSize holds " + std::to_string(sizes.size()) + " sizes, NDims is " + header.get("NDims"));
  }
  if (sizes.size() < 3 || sizes.size() > 4 || (sizes.size() == 4 && sizes[3] != 1))
  {
    throw BadInput(ErrorCode::Dimension,
                   file,
                   "a " + std::to_string(sizes.size()) + "-D image (DimSize " + header.get("DimSize") +
                     "), need a 3-D image",
                   exportScalarVolume);
  }
  return sizes;
}

void
setMetaGeometry(const MetaHeader & header, std::size_t axes, ImageDescription & image)
{
  const std::string & file = image.fileName;
  const auto          matrix = oneOf(file, header, { "TransformMatrix", "Rotation", "Orientation" }, axes * axes);
  const auto          offset = oneOf(file, header, { "Offset", "Position", "Origin" }, axes);
  const auto          elementSize = oneOf(file, header, { "ElementSize" }, axes);
  auto                spacing = oneOf(file, header, { "ElementSpacing" }, axes);
  (void)oneOf(file, header, { "CenterOfRotation" }, axes);
  if (!spacing)
  {
    image.warnings.push_back(file + (elementSize ? ": ElementSpacing is missing, ElementSize taken instead"
                                                 : ": the header gives no voxel size: 1 mm assumed"));
    spacing = elementSize ? elementSize : std::vector<double>(axes, 1.0);
  }
  Matrix3 columns = Matrix3::Identity();
  Vector3 origin = Vector3::Zero();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto column = static_cast<Eigen::Index>(axis);
    for (std::size_t row = 0; matrix && row < 3; ++row)
    {
      columns(static_cast<Eigen::Index>(row), column) = (*matrix)[axis * axes + row];
    }
    if (!((*spacing)[axis] > 0.0))
    {
      throw BadInput(ErrorCode::Geometry,
                     file,
                     "voxel size " + std::to_string((*spacing)[axis]) + " along axis " + std::to_string(axis + 1),
                     "correct ElementSpacing");
    }
    // MetaImage takes the axes apart from the voxel sizes, so a column that is no unit vector is an error.
    const double length = columns.col(column).stableNorm();
    if (!(std::abs(length - 1.0) <= 1e-3))
    {
      throw BadInput(ErrorCode::Geometry,
                     file,
                     "axis " + std::to_string(axis + 1) + " of TransformMatrix has length " + std::to_string(length),
                     "correct the header's geometry");
    }
    columns.col(column) *= (*spacing)[axis] / length;
    origin[column] = offset ? (*offset)[axis] : 0.0;
  }
  setGeometry(image, columns, origin);
}

void
requireNoScale(const std::string & file, const MetaHeader & header)
{
  for (const auto & [key, neutral] :
       { std::pair("ElementToIntensityFunctionSlope", 1.0), std::pair("ElementToIntensityFunctionOffset", 0.0) })
  {
    if (header.has(key) && numbersOf(file, key, header.get(key), 1)[0] != neutral)
    {
      throw BadInput(ErrorCode::Unsupported,
                     file,
                     std::string(key) + " is " + quoted(header.get(key)),
                     "export the image with the scale applied");
    }
  }
}

/** Where the voxels are: in the file itself or in a plain one beside it. */
void
setMetaDataFile(const MetaHeader & header, ImageDescription & image)
{
  const std::string name = header.get("ElementDataFile");
  const std::string headerSize = header.get("HeaderSize");
  const bool        local = name == "LOCAL" || name == "Local" || name == "local";
  if (!headerSize.empty() && headerSize != "0")
  {
    throw BadInput(local ? ErrorCode::Header : ErrorCode::Unsupported,
                   image.fileName,
                   "HeaderSize is " + quoted(headerSize) + ", need none",
                   "convert the image to .mha");
  }
  image.dataFile = image.fileName;
  image.dataBegin = header.bytes;
  if (!local)
  {
    setDataFile(image, name);
    image.dataBegin = 0;
  }
}

void
setMetaEncoding(const MetaHeader & header, ImageDescription & image)
{
  const std::string & file = image.fileName;
  if (!metaFlag(file, header, "BinaryData", true))
  {
    throw BadInput(
      ErrorCode::Unsupported, file, "the voxels are written as text", "save the image as binary .mha or .nrrd");
  }
  const bool element = metaFlag(file, header, "ElementByteOrderMSB", false);
  const bool big = metaFlag(file, header, "BinaryDataByteOrderMSB", element);
  if (header.has("ElementByteOrderMSB") && element != big)
  {
    throwHeader(file, "ElementByteOrderMSB contradicts BinaryDataByteOrderMSB");
  }
  image.swapped = big && image.bytesPerComponent > 1;
  if (image.bytesPerComponent > 1 && !header.has("BinaryDataByteOrderMSB") && !header.has("ElementByteOrderMSB"))
  {
    image.warnings.push_back(file + ": the header does not give the byte order: little-endian assumed");
  }
  if (!metaFlag(file, header, "CompressedData", false))
  {
    return;
  }
  image.encoding = VoxelEncoding::Zlib;
  const auto stored = countsOf(file, "CompressedDataSize", header.get("CompressedDataSize"));
  if (stored.size() != 1 || stored[0] == 0)
  {
    throwHeader(file, "CompressedDataSize is missing or 0: the reader would decode the header");
  }
  const std::uint64_t present = fs::file_size(image.dataFile) - image.dataBegin;
  if (stored[0] > present)
  {
    throw BadInput(ErrorCode::Truncated,
                   file,
                   "CompressedDataSize is " + std::to_string(stored[0]) + ", the file holds " + std::to_string(present),
                   copyAgain);
  }
  image.storedBytes = stored[0];
}

} // namespace

ImageDescription
checkMetaHeader(const std::string & file, VoxelContent content)
{
  const MetaHeader  header = parseMetaHeader(file, beginningOf(file, longestMetaHeader));
  const std::string objectType = header.get("ObjectType");
  if (!objectType.empty() && objectType != "Image")
  {
    throw BadInput(ErrorCode::Format, file, "ObjectType is " + quoted(objectType) + ", need Image", exportScalarVolume);
  }
  ImageDescription image;
  image.fileName = file;
  image.format = ImageFormat::Meta;
  const auto sizes = metaSizes(file, header);
  const auto channels = header.has("ElementNumberOfChannels")
                          ? countsOf(file, "ElementNumberOfChannels", header.get("ElementNumberOfChannels"))
                          : std::vector<std::uint64_t>{ 1 };
  const bool isMany = content == VoxelContent::ManyValues && channels.size() == 1 && channels[0] <= mostValuesPerVoxel;
  if (channels.size() != 1 || (channels[0] != 1 && !isMany))
  {
    throw BadInput(!channels.empty() && channels[0] > 1'000'000 ? ErrorCode::TooBig : ErrorCode::PixelType,
                   file,
                   header.get("ElementNumberOfChannels").substr(0, 10) + " values per voxel, need a scalar image",
                   exportScalarVolume);
  }
  setVoxels(image, { sizes[0], sizes[1], sizes[2] }, metaComponentType(file, header.get("ElementType")), channels[0]);
  setMetaDataFile(header, image);
  setMetaEncoding(header, image);
  setMetaGeometry(header, sizes.size(), image);
  requireNoScale(file, header);
  requirePlausibleSize(image);
  return image;
}

} // namespace moserhex
