#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace moserhex
{
namespace
{

/** What is left of a line of 200 characters when a command has put "error: " before a message and its code behind it.
 */
std::size_t
longestMessage(ErrorCode code)
{
  return 200 - std::strlen("error:  []") - std::strlen(nameOf(code));
}

constexpr std::size_t longestName = 60;
constexpr std::size_t shortestName = 24;
constexpr std::size_t longestRemedy = 80;
constexpr std::size_t longestWord = 32; // a longer one may be cut

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

} // namespace

std::string
oneLine(const std::string & text, std::size_t length)
{
  if (text.size() <= length)
  {
    return withoutControlCharacters(text);
  }
  std::size_t end = length > 3 ? length - 3 : 0;
  while (end > 0 && continuesCharacter(text[end]))
  {
    --end;
  }
  const std::size_t space = text.rfind(' ', end);
  if (space != std::string::npos && space + longestWord > end)
  {
    end = space;
  }
  return withoutControlCharacters(text.substr(0, end) + "...");
}

std::string
fileMessage(const std::string & file, const std::string & cause, const std::string & remedy, std::size_t longest)
{
  const std::string cure = oneLine(remedy, longestRemedy);
  const std::size_t rest = longest - cure.size() - 4; // of name and cause
  const std::size_t left = rest > cause.size() ? rest - cause.size() : 0;
  const std::string name = keepEnd(withoutControlCharacters(file), std::min(longestName, std::max(shortestName, left)));
  return name + ": " + oneLine(cause, rest - name.size()) + "; " + cure;
}

FileError::FileError(ErrorCode code, const std::string & file, const std::string & cause, const std::string & remedy)
  : Error(code, fileMessage(file, cause, remedy, longestMessage(code)))
{}

void
throwUnopened(const std::string & fileName, int cause)
{
  const std::string what = std::string("cannot open (") + std::strerror(cause) + ")";
  const std::string remedy = "check name and permissions";
  if (cause == EACCES || cause == EPERM)
  {
    throw BadInput(ErrorCode::NoInput, fileName, what, remedy);
  }
  throw IOError(ErrorCode::InputOutput, fileName, what, remedy);
}

} // namespace moserhex
