#pragma once

#include "moserhex/Common/Types.h"
#include "moserhex/LevelSet/VoxelGrid.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace moserhex
{

/** Values put into a string of bytes one after the other, for another process of the same program. */
class ParcelWriter
{
public:
  /** Continues `bytes`. */
  explicit ParcelWriter(std::string bytes) : m_Bytes(std::move(bytes))
  {}

  template <typename T>
  std::enable_if_t<std::is_arithmetic_v<T>>
  put(T value)
  {
    m_Bytes.append(reinterpret_cast<const char *>(&value), sizeof value);
  }

  void
  put(const std::string & text)
  {
    put(static_cast<std::uint64_t>(text.size()));
    m_Bytes += text;
  }

  void
  put(const std::vector<std::string> & texts)
  {
    put(static_cast<std::uint64_t>(texts.size()));
    for (const std::string & text : texts)
    {
      put(text);
    }
  }

  void
  put(const VoxelGrid & grid);

  void
  put(const std::optional<Matrix3> & matrix);

  void
  put(const Positions & points);

  template <typename T, std::size_t width>
  std::enable_if_t<std::is_arithmetic_v<T>>
  put(const std::vector<std::array<T, width>> & rows)
  {
    put(static_cast<std::uint64_t>(rows.size()));
    m_Bytes.append(reinterpret_cast<const char *>(rows.data()), rows.size() * sizeof(rows[0]));
  }

  void
  put(const std::vector<double> & numbers)
  {
    put(static_cast<std::uint64_t>(numbers.size()));
    m_Bytes.append(reinterpret_cast<const char *>(numbers.data()), numbers.size() * sizeof(double));
  }

  [[nodiscard]] std::string
  take()
  {
    return std::move(m_Bytes);
  }

private:
  std::string m_Bytes;
};

/** Takes them out in the same order. */
class ParcelReader
{
public:
  ParcelReader(const std::string & bytes, std::size_t begin) : m_Bytes(bytes), m_Position(begin)
  {}

  /** \throws std::out_of_range  the parcel is shorter, here and below */
  template <typename T>
  [[nodiscard]] T
  number()
  {
    T value{};
    m_Bytes.copy(reinterpret_cast<char *>(&value), sizeof value, advance(sizeof value));
    return value;
  }

  [[nodiscard]] std::string
  text()
  {
    const auto size = static_cast<std::size_t>(number<std::uint64_t>());
    return m_Bytes.substr(advance(size), size);
  }

  [[nodiscard]] std::vector<std::string>
  texts()
  {
    std::vector<std::string> result;
    for (auto count = number<std::uint64_t>(); count > 0; --count)
    {
      result.push_back(text());
    }
    return result;
  }

  [[nodiscard]] VoxelGrid
  grid();

  [[nodiscard]] std::optional<Matrix3>
  matrix();

  [[nodiscard]] Positions
  positions();

  /** \tparam TRow  a number, or std::array of numbers */
  template <typename TRow>
  [[nodiscard]] std::vector<TRow>
  rows()
  {
    std::vector<TRow> result(itemCount(sizeof(TRow)));
    const std::size_t bytes = result.size() * sizeof(TRow);
    m_Bytes.copy(reinterpret_cast<char *>(result.data()), bytes, advance(bytes));
    return result;
  }

  [[nodiscard]] bool
  atEnd() const
  {
    return m_Position == m_Bytes.size();
  }

private:
  std::size_t
  advance(std::size_t count);

  /** The number of items of so many bytes each that follow it. */
  std::size_t
  itemCount(std::size_t itemBytes);

  const std::string & m_Bytes;
  std::size_t         m_Position;
};

} // namespace moserhex
