#pragma once

#include "moserhex/Common/Types.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

namespace moserhex
{

/** Codes of what the values along dim[5] are. */
struct NiftiIntent
{
  static constexpr int none = 0;
  static constexpr int matrix = 1004;          ///< intent_p1 rows of intent_p2 numbers
  static constexpr int symmetricMatrix = 1005; ///< intent_p1 rows; the lower triangle by rows
  static constexpr int displacement = 1006;
  static constexpr int vector = 1007;
};

/** The intent_name by which files of writeFieldImage say in which space vectors and tensors are. */
constexpr const char * niftiLpsName = "LPS";
constexpr const char * niftiCubeName = "CUBE";

/** The 348 bytes of a NIfTI-1 header in either byte order, and the 4 after them. */
class NiftiHeader
{
public:
  static constexpr std::size_t size = 348;

  /** \param bytes  at least 352
   * \throws BadInput (Format)  not NIfTI-1; (Unsupported)  NIfTI-2; (Reference)  voxels in another file */
  NiftiHeader(const std::string & file, const std::string & bytes);

  [[nodiscard]] bool
  swapped() const
  {
    return m_Swap;
  }

  [[nodiscard]] int
  dimension(std::size_t n) const
  {
    return read<std::int16_t>(40 + 2 * n);
  }
  /** What the values of a voxel are; \see NiftiIntent. */
  [[nodiscard]] int
  intent() const
  {
    return read<std::int16_t>(68);
  }
  /** intent_p1, p2 and p3. \param n  from 1 */
  [[nodiscard]] double
  intentParameter(std::size_t n) const
  {
    return real(52 + 4 * n);
  }
  [[nodiscard]] std::string
  intentName() const
  {
    constexpr std::size_t longest = 16;
    const std::string     name(m_Bytes, 328, longest);
    return name.substr(0, name.find('\0'));
  }
  [[nodiscard]] int
  dataType() const
  {
    return read<std::int16_t>(70);
  }
  [[nodiscard]] int
  bitsPerVoxel() const
  {
    return read<std::int16_t>(72);
  }
  [[nodiscard]] double
  pixdim(std::size_t n) const
  {
    return real(76 + 4 * n);
  }
  [[nodiscard]] double
  voxelOffset() const
  {
    return real(108);
  }
  [[nodiscard]] double
  slope() const
  {
    return real(112);
  }
  [[nodiscard]] double
  intercept() const
  {
    return real(116);
  }
  /** Of space: 1 metre, 2 mm, 3 micrometre, 0 unknown. */
  [[nodiscard]] int
  lengthUnit() const
  {
    return read<std::uint8_t>(123) & 7;
  }
  [[nodiscard]] int
  qformCode() const
  {
    return read<std::int16_t>(252);
  }
  [[nodiscard]] int
  sformCode() const
  {
    return read<std::int16_t>(254);
  }
  /** b, c, d of the quaternion. */
  [[nodiscard]] Vector3
  quaternion() const
  {
    return Vector3(real(256), real(260), real(264));
  }
  [[nodiscard]] Vector3
  qformOffset() const
  {
    return Vector3(real(268), real(272), real(276));
  }
  /** Rows x, y, z; three columns of the matrix, then the offset. */
  [[nodiscard]] double
  sform(int row, int column) const
  {
    return real(280 + 16 * static_cast<std::size_t>(row) + 4 * static_cast<std::size_t>(column));
  }
  [[nodiscard]] bool
  hasExtensions() const
  {
    return m_Bytes[size] != 0;
  }

private:
  template <typename T>
  [[nodiscard]] T
  read(std::size_t offset) const
  {
    char bytes[sizeof(T)];
    std::copy_n(m_Bytes.begin() + static_cast<std::ptrdiff_t>(offset), sizeof(T), bytes);
    if (m_Swap)
    {
      std::reverse(bytes, bytes + sizeof(T));
    }
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
  }

  [[nodiscard]] double
  real(std::size_t offset) const
  {
    return static_cast<double>(read<float>(offset));
  }

  std::string m_Bytes;
  bool        m_Swap{ false };
};

} // namespace moserhex
