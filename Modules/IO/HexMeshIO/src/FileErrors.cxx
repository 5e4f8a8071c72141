#include "moserhex/HexMeshIO/FileErrors.h"

namespace moserhex
{
namespace
{

// Ten characters less than a line of 200, for the "error: " a command puts before it.
constexpr std::size_t longestMessage = 190;
constexpr std::size_t longestName = 60;

/** Bytes 10xxxxxx continue a UTF-8 character: never cut before one. */
bool
continuesCharacter(char c)
{
  return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u;
}

std::string
withoutControlCharacters(std::string text)
{
  for (char & c : text)
  {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F)
    {
      c = '?';
    }
  }
  return text;
}

std::string
keepEnd(const std::string & text, std::size_t length)
{
  if (text.size() <= length)
  {
    return text;
  }
  std::size_t begin = text.size() - (length - 3);
  while (begin < text.size() && continuesCharacter(text[begin]))
  {
    ++begin;
  }
  return "..." + text.substr(begin);
}

std::string
keepBegin(const std::string & text, std::size_t length)
{
  if (text.size() <= length)
  {
    return text;
  }
  std::size_t end = length > 3 ? length - 3 : 0;
  while (end > 0 && continuesCharacter(text[end]))
  {
    --end;
  }
  return text.substr(0, end) + "...";
}

} // namespace

std::string
fileMessage(const std::string & file, const std::string & cause, const std::string & remedy)
{
  const std::string name = keepEnd(withoutControlCharacters(file), longestName);
  const std::string cure = keepBegin(withoutControlCharacters(remedy), 80);
  const std::size_t rest = longestMessage - name.size() - cure.size() - 4;
  return name + ": " + keepBegin(withoutControlCharacters(cause), rest) + "; " + cure;
}

BadInput::BadInput(const std::string & file, const std::string & cause, const std::string & remedy)
  : Error(fileMessage(file, cause, remedy))
{}

IOError::IOError(const std::string & file, const std::string & cause, const std::string & remedy)
  : Error(fileMessage(file, cause, remedy))
{}

} // namespace moserhex
