#pragma once

#include "moserhex/Common/Types.h"

#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace moserhex
{

/** Text of a mesh file. Numbers are written in the C locale; doubles with as many digits as they need to come back to
 * the last bit, 17 at most. */
class MeshText
{
public:
  MeshText &
  operator<<(std::string_view text)
  {
    m_Text += text;
    return *this;
  }

  MeshText &
  operator<<(char c)
  {
    m_Text += c;
    return *this;
  }

  template <typename T, typename = std::enable_if_t<std::is_arithmetic_v<T>>>
  MeshText &
  operator<<(T number)
  {
    std::array<char, 32> digits{};
    const auto           end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    m_Text.append(digits.data(), end);
    return *this;
  }

  /** The numbers with `separator` between them. */
  template <typename TNumbers>
  MeshText &
  list(const TNumbers & numbers, std::string_view separator)
  {
    bool first = true;
    for (const auto & number : numbers)
    {
      *this << (first ? std::string_view() : separator) << number;
      first = false;
    }
    return *this;
  }

  /** Three coordinates [mm]. */
  MeshText &
  position(const Vector3 & p, std::string_view separator)
  {
    return *this << p.x() << separator << p.y() << separator << p.z();
  }

  [[nodiscard]] std::string
  take()
  {
    return std::move(m_Text);
  }

private:
  std::string m_Text;
};

/** Numbers from 0 as numbers from 1. */
template <typename TNumbers>
[[nodiscard]] TNumbers
fromOne(TNumbers numbers)
{
  for (auto & number : numbers)
  {
    ++number;
  }
  return numbers;
}

} // namespace moserhex
