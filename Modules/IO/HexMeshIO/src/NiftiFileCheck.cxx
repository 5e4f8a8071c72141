#include "ByteSource.h"
#include "ImageHeader.h"
#include "NiftiGeometry.h"
#include "NiftiHeader.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <cmath>
#include <limits>
#include <map>

namespace moserhex
{
namespace
{

constexpr double mostExtensionBytes = 1e7;

constexpr std::size_t valueAxis = 4; ///< of dim[5]
constexpr int         tensorValues = 6;

/** Sizes of the first three axes and, of images with several values per voxel, the number of these.
 * \throws BadInput  see checkImageHeader */
std::vector<std::uint64_t>
niftiSizes(const std::string & file, const NiftiHeader & header, VoxelContent content)
{
  const int dimensions = header.dimension(0);
  if (dimensions < 1 || dimensions > 7)
  {
    throwHeader(file, "dim[0] is " + std::to_string(dimensions) + ", need 3");
  }
  std::vector<std::uint64_t> sizes;
  double                     voxels = 1.0;
  for (int axis = 1; axis <= dimensions; ++axis)
  {
    const int count = header.dimension(static_cast<std::size_t>(axis));
    if (count < 1)
    {
      throwHeader(file, "dim[" + std::to_string(axis) + "] is " + std::to_string(count));
    }
    sizes.push_back(static_cast<std::uint64_t>(count));
    voxels *= count;
  }
  if (dimensions < 3)
  {
    throw BadInput(
      ErrorCode::Dimension, file, "a " + std::to_string(dimensions) + "-D image, need a 3-D image", exportScalarVolume);
  }
  for (std::size_t axis = 3; axis < sizes.size() && voxels < 1e15; ++axis)
  {
    const bool isOfValues = axis == valueAxis && content == VoxelContent::ManyValues;
    if (sizes[axis] == 1 || (isOfValues && sizes[axis] <= mostValuesPerVoxel))
    {
      continue;
    }
    const std::string count = std::to_string(sizes[axis]);
    throw BadInput(axis == valueAxis ? ErrorCode::PixelType : ErrorCode::Dimension,
                   file,
                   axis == valueAxis
                     ? count + " values per voxel (dim[5]), need one"
                     : "a " + std::to_string(dimensions) + "-D image of " + count + " volumes, need a 3-D image",
                   exportScalarVolume);
  }
  if (voxels >= 1e15)
  {
    throw BadInput(
      ErrorCode::TooBig, file, "the sizes multiply to more than 1e15 voxels", "crop the image around the label");
  }
  const std::uint64_t values = sizes.size() > valueAxis ? sizes[valueAxis] : 1;
  sizes.resize(3);
  sizes.push_back(values);
  return sizes;
}

/** Sets how several values of a voxel lie in the file. \throws BadInput (Header)  not as many as a matrix has */
void
setNiftiLayout(const NiftiHeader & header, ImageDescription & image)
{
  if (image.layers == 1)
  {
    return;
  }
  const double rows = header.intentParameter(1);
  const bool   isSymmetric = header.intent() == NiftiIntent::symmetricMatrix;
  const bool   isMatrix = header.intent() == NiftiIntent::matrix;
  const double needed = isSymmetric ? 0.5 * rows * (rows + 1.0) : rows * header.intentParameter(2);
  if ((isSymmetric || isMatrix) && needed != image.layers)
  {
    throwHeader(image.fileName,
                std::to_string(image.layers) +
                  " values per voxel (dim[5]), which the rows of the matrix (intent_p1) do not give");
  }
  image.layout.lastAxis = true;
  image.layout.lowerTriangle = isSymmetric;
  image.symmetricTensors = isSymmetric && image.layers == tensorValues;
  if (header.intentName() != niftiLpsName)
  {
    image.valuesToLps = std::nullopt;
    image.valuesInCubeAxes = header.intentName() == niftiCubeName;
  }
}

ComponentType
niftiComponentType(const std::string & file, const NiftiHeader & header)
{
  struct Type
  {
    ComponentType component;
    int           bits;
  };
  static const std::map<int, Type> types{
    { 2, { ComponentType::UInt8, 8 } },     { 4, { ComponentType::Int16, 16 } },
    { 8, { ComponentType::Int32, 32 } },    { 16, { ComponentType::Float32, 32 } },
    { 64, { ComponentType::Float64, 64 } }, { 256, { ComponentType::Int8, 8 } },
    { 512, { ComponentType::UInt16, 16 } }, { 768, { ComponentType::UInt32, 32 } },
    { 1024, { ComponentType::Int64, 64 } }, { 1280, { ComponentType::UInt64, 64 } }
  };
  static const std::map<int, const char *> others{ { 32, "complex" },
                                                   { 128, "RGB" },
                                                   { 1792, "complex" },
                                                   { 2304, "RGBA" },
                                                   { 1, "1 bit" },
                                                   { 1536, "128-bit real" },
                                                   { 2048, "complex of 256 bits" } };
  const auto                               entry = types.find(header.dataType());
  if (entry != types.end())
  {
    if (header.bitsPerVoxel() != entry->second.bits)
    {
      throwHeader(file,
                  "bitpix is " + std::to_string(header.bitsPerVoxel()) + " for datatype " +
                    std::to_string(header.dataType()));
    }
    return entry->second.component;
  }
  const auto other = others.find(header.dataType());
  if (other == others.end())
  {
    throwHeader(file, "datatype " + std::to_string(header.dataType()) + " is unknown");
  }
  const bool rare = header.dataType() == 1 || header.dataType() == 1536 || header.dataType() == 2048;
  throw BadInput(rare ? ErrorCode::Unsupported : ErrorCode::PixelType,
                 file,
                 std::string("datatype ") + other->second + ", need one number per voxel",
                 exportScalarVolume);
}

/** Walks through the extensions between header and voxels. */
void
requireExtensions(const std::string & file, const NiftiHeader & header, std::uint64_t end, ByteSource & source)
{
  std::uint64_t at = NiftiHeader::size + 4;
  while (header.hasExtensions() && at + 8 <= end)
  {
    char sizeAndCode[8];
    if (source.read(sizeAndCode, sizeof sizeAndCode) != sizeof sizeAndCode)
    {
      throw BadInput(ErrorCode::Truncated, file, "the file ends within its header", copyAgain);
    }
    if (header.swapped())
    {
      std::reverse(sizeAndCode, sizeAndCode + 4);
    }
    std::int32_t size = 0;
    std::memcpy(&size, sizeAndCode, sizeof size);
    if (size == 0)
    {
      return; // zeros up to the voxels
    }
    if (size < 8 || static_cast<std::uint64_t>(size) > end - at)
    {
      throwHeader(file,
                  "an extension of " + std::to_string(size) + " bytes where " + std::to_string(end - at) +
                    " are left before the voxels");
    }
    (void)source.skip(static_cast<std::uint64_t>(size) - sizeof sizeAndCode);
    at += static_cast<std::uint64_t>(size);
  }
}

void
setScale(const NiftiHeader & header, ImageDescription & image)
{
  const double slope = header.slope();
  const double intercept = header.intercept();
  if (!std::isfinite(slope) || !std::isfinite(intercept))
  {
    // As the NIfTI library does.
    image.warnings.push_back(image.fileName + ": scl_slope or scl_inter is not finite: values taken unscaled");
    return;
  }
  if (slope == 0.0 && intercept != 0.0)
  {
    // By the standard it counts for nothing; ITK adds it.
    throwHeader(image.fileName, "scl_slope is 0 while scl_inter is not");
  }
  if (slope == 0.0)
  {
    return;
  }
  if (std::abs(slope) < std::numeric_limits<double>::epsilon() || std::abs(slope) > 1e9 || std::abs(intercept) > 1e9)
  {
    throwHeader(image.fileName, "scl_slope or scl_inter is not plausible");
  }
  constexpr double nothing = std::numeric_limits<double>::epsilon(); // ITK's measure of what needs no scaling
  if (std::abs(slope - 1.0) > nothing || std::abs(intercept) > nothing)
  {
    image.slope = slope;
    image.intercept = intercept;
  }
}

} // namespace

NiftiHeader::NiftiHeader(const std::string & file, const std::string & bytes) : m_Bytes(bytes)
{
  m_Swap = read<std::int32_t>(0) != 348;
  const std::string magic(m_Bytes, 344, 4);
  m_Swap = m_Swap && read<std::int32_t>(0) == 348;
  if (read<std::int32_t>(0) != 348)
  {
    const bool two = m_Bytes.compare(4, 3, "n+2") == 0 || m_Bytes.compare(4, 3, "ni2") == 0;
    throw BadInput(two ? ErrorCode::Unsupported : ErrorCode::Format,
                   file,
                   two ? "the content is NIfTI-2" : "the content is not NIfTI-1",
                   "export the image as NIfTI-1 (.nii.gz) or .nrrd");
  }
  if (magic == std::string("ni1\0", 4))
  {
    throw BadInput(ErrorCode::Reference, file, "the voxels are in another file (.img)", "convert to .nii.gz");
  }
  if (magic != std::string("n+1\0", 4))
  {
    throw BadInput(ErrorCode::Format,
                   file,
                   "no NIfTI-1 magic: an ANALYZE image has no orientation",
                   "export the image as .nii.gz or .nrrd");
  }
}

ImageDescription
checkNiftiHeader(const std::string & file, VoxelContent content)
{
  ByteSource  source(file, ByteSource::Coding::GzipOrPlain);
  std::string bytes(NiftiHeader::size + 4, '\0');
  bytes.resize(source.read(bytes.data(), bytes.size()));
  const bool begins = bytes.size() >= 4 && (bytes.compare(0, 4, std::string("\x5c\1\0\0", 4)) == 0 ||
                                            bytes.compare(0, 4, std::string("\0\0\1\x5c", 4)) == 0);
  if (bytes.size() < NiftiHeader::size + 4)
  {
    throw BadInput(begins ? ErrorCode::Truncated : ErrorCode::Format,
                   file,
                   begins ? "the file ends within its header" : "the content is not NIfTI-1",
                   begins ? copyAgain : "check that the name's ending fits the format");
  }
  const NiftiHeader header(file, bytes);
  ImageDescription  image;
  image.fileName = file;
  image.dataFile = file;
  image.format = ImageFormat::Nifti;
  image.encoding = VoxelEncoding::GzipOrRaw;
  image.swapped = header.swapped();
  const auto sizes = niftiSizes(file, header, content);
  setVoxels(image, sizes, niftiComponentType(file, header), sizes.back());
  setNiftiLayout(header, image);
  const double offset = header.voxelOffset();
  if (!(offset >= 352.0 && offset <= mostExtensionBytes && offset == std::floor(offset)))
  {
    throwHeader(file, "vox_offset is " + std::to_string(offset) + ", need a whole number from 352 to 1e7");
  }
  image.dataBegin = static_cast<std::uint64_t>(offset);
  setNiftiGeometry(header, image);
  setScale(header, image);
  requireExtensions(file, header, image.dataBegin, source);
  requirePlausibleSize(image);
  return image;
}

} // namespace moserhex
