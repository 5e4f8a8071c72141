#pragma once

#include "moserhex/LevelSet/VoxelGrid.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace moserhex
{

/** The image formats, each with one reader. */
enum class ImageFormat
{
  Nrrd,
  Nifti,
  Meta
};

/** What one voxel holds in the file. */
enum class ComponentType
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  UInt64,
  Float32,
  Float64
};

/** Calls body with a zero of the C++ type. */
template <typename TBody>
auto
withComponent(ComponentType type, const TBody & body)
{
  switch (type)
  {
    case ComponentType::Int8:
      return body(std::int8_t{});
    case ComponentType::UInt8:
      return body(std::uint8_t{});
    case ComponentType::Int16:
      return body(std::int16_t{});
    case ComponentType::UInt16:
      return body(std::uint16_t{});
    case ComponentType::Int32:
      return body(std::int32_t{});
    case ComponentType::UInt32:
      return body(std::uint32_t{});
    case ComponentType::Int64:
      return body(std::int64_t{});
    case ComponentType::UInt64:
      return body(std::uint64_t{});
    case ComponentType::Float32:
      return body(float{});
    case ComponentType::Float64:
      break;
  }
  return body(double{});
}

[[nodiscard]] inline bool
isFloatingPoint(ComponentType type)
{
  return type == ComponentType::Float32 || type == ComponentType::Float64;
}

/** How the voxels are written. */
enum class VoxelEncoding
{
  Raw,
  Gzip,      ///< one or several members
  GzipOrRaw, ///< NIfTI: told from the first bytes of the file, which hold the header too
  Zlib,
  Text ///< decimal numbers
};

/** How many numbers a voxel may hold. */
enum class VoxelContent
{
  OneValue,  ///< one; of a Slicer segmentation one for each layer
  ManyValues ///< any number: vectors, tensors, lists, colours
};

/** Where the values of a voxel lie in the file, and which they are. */
struct ValueLayout
{
  bool lastAxis{ false };      ///< first values of all voxels, then all second ones, ...; else a voxel's are together
  bool masked{ false };        ///< the first value says whether the voxel has others
  bool lowerTriangle{ false }; ///< of symmetric matrices by rows: xx, yx, yy, zx, zy, zz; else xx, xy, xz, yy, yz, zz

  /** Whether voxels come out as they lie in the file. */
  [[nodiscard]] bool
  isPlain() const
  {
    return !lastAxis && !masked && !lowerTriangle;
  }
};

/** An image as its header states it, every statement checked; see checkImageHeader. */
struct ImageDescription
{
  std::string            fileName;
  ImageFormat            format{ ImageFormat::Nrrd };
  ComponentType          component{ ComponentType::UInt8 };
  std::uint64_t          bytesPerComponent{ 1 };
  bool                   swapped{ false }; ///< the file's byte order is not this machine's
  VoxelGrid              grid;             ///< LPS mm, direction orthonormal to round-off
  int                    layers{ 1 };      ///< values per voxel in the file, a mask among them
  ValueLayout            layout;
  bool                   symmetricTensors{ false };          ///< the values are one of 3 x 3 each, as the file says
  std::optional<Matrix3> valuesToLps{ Matrix3::Identity() }; ///< of vectors; nothing: the file leaves their space open
  bool                   valuesInCubeAxes{ false };          ///< see ValueAxes
  bool keepsNonFinite{ false }; ///< of NIfTI, whose numbers that are not finite ITK makes 0 of; see VoxelContent
  VoxelEncoding encoding{ VoxelEncoding::Raw };
  std::string   dataFile;           ///< holds the voxels
  std::uint64_t dataBegin{ 0 };     ///< of the voxels; in the decoded bytes for GzipOrRaw, else in the file
  std::uint64_t storedBytes{ 0 };   ///< of compressed voxels, as the header says; 0: to the end of the file
  std::uint64_t promisedBytes{ 0 }; ///< of decoded voxels
  double        slope{ 1.0 };       ///< value = slope * stored + intercept
  double        intercept{ 0.0 };
  std::map<std::string, std::string> keyValues;     ///< NRRD's "key:=value" lines
  std::uint32_t                      checksum{ 0 }; ///< CRC-32 of the decoded voxels in this machine's byte order
  std::vector<std::string>           warnings;      ///< one line each

  [[nodiscard]] bool
  scaled() const
  {
    return slope != 1.0 || intercept != 0.0;
  }
};

} // namespace moserhex
