#include "CaseRequest.h"

#include "CommandErrors.h"

namespace moserhex::app
{

void
refuse(const CaseRequest & request, const std::string & cause, const std::string & remedy)
{
  throw UsageError(request.list.empty()
                     ? usageMessage(request.options.input.file, cause, remedy)
                     : usageMessage(request.list, "line " + std::to_string(request.line) + ": " + cause, remedy));
}

std::string
usageMessage(const std::string & file, const std::string & cause, const std::string & remedy)
{
  constexpr std::size_t longest = 183; // 200 with "error: " before it and " [E_USAGE]" behind
  return fileMessage(file, cause, remedy, longest);
}

std::string
shortName(const std::string & name, std::size_t longest)
{
  if (name.size() <= longest)
  {
    return name;
  }
  std::size_t begin = name.size() - longest + 3;
  while (begin < name.size() && (static_cast<unsigned char>(name[begin]) & 0xC0u) == 0x80u) // within a character
  {
    ++begin;
  }
  return "..." + name.substr(begin);
}

} // namespace moserhex::app
