#pragma once

#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace moserhex
{

/** The whole of `word` as a number, in the C locale; a leading '+' and Fortran's exponents (1.5D+02) are understood. */
template <typename T>
[[nodiscard]] bool
parseNumber(std::string_view word, T & value)
{
  if constexpr (std::is_floating_point_v<T>)
  {
    const std::size_t exponent = word.find_first_of("dD");
    if (exponent != std::string_view::npos)
    {
      std::string copy(word);
      copy[exponent] = 'e';
      return copy.find_first_of("dD") == std::string::npos && parseNumber(copy, value);
    }
  }
  word.remove_prefix(!word.empty() && word.front() == '+' ? 1 : 0);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

/** A file in memory, handed out in words, lines, numbers or binary values. Whatever is not as expected throws BadInput
 * with the remedy given: ErrorCode::Truncated where the file ends too early, else the code given. */
class FileText
{
public:
  /** \param comment  starts a comment that ends with the line; '\0': there are none
   * \param code     of refusals about what is there
   * \throws IOError  the file cannot be read */
  FileText(const std::string & fileName,
           std::string         remedy,
           char                comment = '\0',
           ErrorCode           code = ErrorCode::NotHexahedra);

  /** Up to the next white space; empty at the end. */
  [[nodiscard]] std::string_view
  nextWord();

  /** The same without going on. */
  [[nodiscard]] std::string_view
  peekWord();

  /** Up to the end of the line, which is passed. */
  std::string_view
  nextLine();

  /** The words of the next line that has any, comments apart. \return false at the end of the file */
  [[nodiscard]] bool
  nextWords(std::vector<std::string_view> & words);

  /** Number of the line that nextLine or nextWords handed out last, from 1. O(bytes before it). */
  [[nodiscard]] std::size_t
  lineNumber() const;

  /** The next so many bytes without going on; fewer at the end. */
  [[nodiscard]] std::string_view
  peekBytes(std::size_t count) const
  {
    return std::string_view(m_Text).substr(m_Position, count);
  }

  /** Goes on by so many bytes. \throws BadInput  there are fewer */
  void
  skipBytes(std::size_t count, const char * what);

  void
  rewind()
  {
    m_Position = 0;
  }

  /** Goes behind the next occurrence of `mark`. \throws BadInput  there is none */
  void
  skipBehind(const std::string & mark);

  /** Whether `mark` comes later on. */
  [[nodiscard]] bool
  contains(const std::string & mark) const
  {
    return m_Text.find(mark, m_Position) != std::string::npos;
  }

  [[nodiscard]] bool
  atEnd() const
  {
    return m_Position >= m_Text.size();
  }

  [[nodiscard]] bool
  endsWithNewLine() const
  {
    return !m_Text.empty() && m_Text.back() == '\n';
  }

  [[nodiscard]] std::size_t
  remaining() const
  {
    return m_Text.size() - m_Position;
  }

  template <typename T>
  [[nodiscard]] T
  nextNumber(const char * what)
  {
    const std::string_view word = nextWord();
    if (word.empty())
    {
      refuseEnd(what);
    }
    return numberOf<T>(word, what);
  }

  /** \throws BadInput  the word is not a number of the type */
  template <typename T>
  [[nodiscard]] T
  numberOf(std::string_view word, const char * what) const
  {
    T value{};
    if (!parseNumber(word, value))
    {
      refuseWord(word, what);
    }
    return value;
  }

  /** Little-endian, as in memory. */
  template <typename T>
  [[nodiscard]] T
  nextBinary(const char * what)
  {
    T value{};
    if (remaining() < sizeof value)
    {
      refuseEnd(what);
    }
    std::memcpy(&value, m_Text.data() + m_Position, sizeof value);
    m_Position += sizeof value;
    return value;
  }

  template <typename T>
  [[nodiscard]] T
  nextBigEndian(const char * what)
  {
    T            value = nextBinary<T>(what);
    auto * const bytes = reinterpret_cast<unsigned char *>(&value);
    std::reverse(bytes, bytes + sizeof value);
    return value;
  }

  /** \throws BadInput  `count` things of `bytesEach` bytes at least do not fit into the rest of the file: found before
   *                   memory is asked for */
  void
  requireRoom(std::size_t count, std::size_t bytesEach, const char * what) const;

  [[noreturn]] void
  refuse(const std::string & cause) const;

  [[noreturn]] void
  refuse(ErrorCode code, const std::string & cause) const;

  /** Refuses because there is this word "where `what` is expected". */
  [[noreturn]] void
  refuseWord(std::string_view word, const char * what) const;

  /** Refuses because "the file ends before `what`". */
  [[noreturn]] void
  refuseEnd(const char * what) const;

private:
  void
  skipSpace();

  std::string m_FileName;
  std::string m_Remedy;
  std::string m_Text;
  std::size_t m_Position{ 0 };
  char        m_Comment;
  ErrorCode   m_Code;
};

} // namespace moserhex
