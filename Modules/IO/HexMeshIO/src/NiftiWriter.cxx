#include "NiftiWriter.h"

#include "ByteSource.h"
#include "FileNames.h"
#include "ImageHeader.h"
#include "NiftiHeader.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <Eigen/Geometry>

#include <itk_zlib.h>

#include <array>
#include <cmath>
#include <limits>

namespace moserhex
{
namespace
{

constexpr const char * freeSpace = "free some space or choose another folder";
constexpr std::size_t  voxelBegin = NiftiHeader::size + 4; // no extensions

/** The bytes of a header in this machine's order, all others 0. */
class HeaderBytes
{
public:
  template <typename T>
  void
  put(std::size_t offset, T value)
  {
    std::memcpy(m_Bytes.data() + offset, &value, sizeof value);
  }

  void
  putReal(std::size_t offset, double value)
  {
    put(offset, static_cast<float>(value));
  }

  void
  putText(std::size_t offset, const std::string & text)
  {
    text.copy(m_Bytes.data() + offset, text.size());
  }

  [[nodiscard]] const std::string &
  bytes() const
  {
    return m_Bytes;
  }

private:
  std::string m_Bytes = std::string(voxelBegin, '\0');
};

void
putSizes(const FieldVolume & image, HeaderBytes & header)
{
  constexpr std::size_t sizesAt = 40;
  const bool            isMany = image.components > 1;
  const int             sizes[8] = {
                isMany ? 5 : 3, image.size[0], image.size[1], image.size[2], 1, isMany ? image.components : 1, 1, 1
  };
  for (std::size_t n = 0; n < 8; ++n)
  {
    header.put(sizesAt + 2 * n, static_cast<std::int16_t>(sizes[n]));
  }
}

void
putIntent(const FieldVolume & image, FieldValues values, ValueAxes axes, HeaderBytes & header)
{
  constexpr double rowsOfTensor = 3.0;
  if (image.components == 1)
  {
    return;
  }
  const bool isTensor = values == FieldValues::SymmetricTensors;
  header.put<std::int16_t>(68, isTensor ? NiftiIntent::symmetricMatrix : NiftiIntent::vector);
  header.putReal(56, isTensor ? rowsOfTensor : 0.0);
  if (axes != ValueAxes::Unknown)
  {
    header.putText(328, axes == ValueAxes::Cube ? niftiCubeName : niftiLpsName);
  }
}

/** qform and sform, RAS. */
void
putGeometry(const VoxelGrid & grid, HeaderBytes & header)
{
  const Vector3      toRas(-1.0, -1.0, 1.0);
  const Matrix3      axes = toRas.asDiagonal() * grid.direction;
  const Vector3      origin = toRas.cwiseProduct(grid.origin);
  const double       hand = axes.determinant() < 0.0 ? -1.0 : 1.0;
  const Matrix3      rotation = axes * Vector3(1.0, 1.0, hand).asDiagonal();
  Eigen::Quaterniond q(rotation);
  if (q.w() < 0.0)
  {
    q.coeffs() *= -1.0; // the header holds b, c, d, and a is positive
  }
  header.putReal(76, hand);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto at = static_cast<Eigen::Index>(axis);
    header.putReal(80 + 4 * axis, grid.spacing[at]);
    header.putReal(256 + 4 * axis, q.vec()[at]);
    header.putReal(268 + 4 * axis, origin[at]);
    for (std::size_t column = 0; column < 4; ++column)
    {
      const auto of = static_cast<Eigen::Index>(column);
      header.putReal(280 + 16 * axis + 4 * column, column < 3 ? axes(at, of) * grid.spacing[of] : origin[at]);
    }
  }
  for (std::size_t axis = 4; axis < 8; ++axis)
  {
    header.putReal(76 + 4 * axis, 1.0);
  }
  constexpr std::int16_t scanner = 1;
  header.put(252, scanner);
  header.put(254, scanner);
  header.put<std::uint8_t>(123, 2); // millimetres
}

std::string
headerOf(const FieldVolume & image, FieldValues values, ValueAxes axes)
{
  const bool  isLabels = values == FieldValues::Labels;
  HeaderBytes header;
  header.put<std::int32_t>(0, static_cast<std::int32_t>(NiftiHeader::size));
  putSizes(image, header);
  putIntent(image, values, axes, header);
  header.put<std::int16_t>(70, isLabels ? 8 : 64); // 32-bit integers, 64-bit real numbers
  header.put<std::int16_t>(72, isLabels ? 32 : 64);
  header.putReal(108, static_cast<double>(voxelBegin));
  header.putReal(112, 1.0); // slope
  putGeometry(image, header);
  header.putText(344, "n+1");
  return header.bytes();
}

/** First values of all voxels, then second ones, ... */
std::vector<double>
planes(const FieldVolume & image, FieldValues values)
{
  static constexpr std::array<int, 6> lowerTriangle{ { 0, 1, 3, 2, 4, 5 } };
  std::vector<double>                 result;
  result.reserve(image.values.size());
  for (int plane = 0; plane < image.components; ++plane)
  {
    const int component =
      values == FieldValues::SymmetricTensors ? lowerTriangle[static_cast<std::size_t>(plane)] : plane;
    for (std::size_t voxel = 0; voxel < image.gridVoxels(); ++voxel)
    {
      result.push_back(image.at(voxel)[component]);
    }
  }
  return result;
}

void
requireNiftiNumbers(const std::string & fileName, const FieldVolume & image)
{
  constexpr int most = std::numeric_limits<std::int16_t>::max();
  for (const int size : { image.size[0], image.size[1], image.size[2], image.components })
  {
    if (size > most)
    {
      throw BadInput(ErrorCode::Usage,
                     fileName,
                     std::to_string(size) + " is more than NIfTI-1 holds along an axis",
                     "give a .nrrd name");
    }
  }
  for (const double value : image.values)
  {
    if (!std::isfinite(value))
    {
      throw BadInput(ErrorCode::Usage,
                     fileName,
                     "values that are not finite, of which readers of NIfTI make 0",
                     "give a .nrrd name");
    }
  }
}

bool
putBytes(gzFile file, const char * bytes, std::size_t count)
{
  constexpr std::size_t most = 1 << 30; // zlib counts in 32 bits
  for (std::size_t begin = 0; begin < count; begin += most)
  {
    const auto part = static_cast<unsigned int>(std::min(most, count - begin));
    if (gzwrite(file, bytes + begin, part) != static_cast<int>(part))
    {
      return false;
    }
  }
  return true;
}

/** Whether the next decoded bytes are these. \throws BadInput  the compressed stream is damaged */
bool
holds(ByteSource & source, const char * bytes, std::size_t count)
{
  std::vector<char> chunk(std::size_t{ 1 } << 18);
  for (std::size_t begin = 0; begin < count;)
  {
    const std::size_t part = source.read(chunk.data(), std::min(chunk.size(), count - begin));
    if (part == 0 || std::memcmp(chunk.data(), bytes + begin, part) != 0)
    {
      return false;
    }
    begin += part;
  }
  return true;
}

} // namespace

bool
isNiftiName(const std::string & fileName)
{
  return endsWithAny(fileName, { ".nii", ".nii.gz" });
}

void
writeNiftiFile(const std::string &               fileName,
               const FieldVolume &               image,
               FieldValues                       values,
               ValueAxes                         axes,
               const std::vector<std::int32_t> & labels)
{
  requireNiftiNumbers(fileName, image);
  const bool                isLabels = values == FieldValues::Labels;
  const std::string         header = headerOf(image, values, axes);
  const std::vector<double> numbers = isLabels ? std::vector<double>() : planes(image, values);
  const char * const        bytes =
    isLabels ? reinterpret_cast<const char *>(labels.data()) : reinterpret_cast<const char *>(numbers.data());
  const std::size_t count = isLabels ? labels.size() * sizeof labels[0] : numbers.size() * sizeof numbers[0];

  AtomicFile   file(fileName);
  const gzFile part = gzopen(file.partName().c_str(), endsWith(fileName, ".gz") ? "wb" : "wbT");
  bool         isWritten = part != nullptr;
  if (isWritten)
  {
    isWritten = putBytes(part, header.data(), header.size()) && putBytes(part, bytes, count);
    isWritten = gzclose(part) == Z_OK && isWritten;
  }
  if (!isWritten)
  {
    throw IOError(ErrorCode::InputOutput, fileName, "cannot write the image", freeSpace);
  }
  bool isSame = false;
  try
  {
    ByteSource source(file.partName(), ByteSource::Coding::GzipOrPlain);
    isSame = holds(source, header.data(), header.size()) && holds(source, bytes, count) && source.skip(1) == 0;
  }
  catch (const BadInput &)
  {
    isSame = false; // a damaged stream
  }
  if (!isSame)
  {
    throw IOError(ErrorCode::InputOutput, fileName, "the file reads back differently", freeSpace);
  }
  file.commit();
}

} // namespace moserhex
