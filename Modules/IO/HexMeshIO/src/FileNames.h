#pragma once

#include <initializer_list>
#include <string>

namespace moserhex
{

/** Whether the name ends with `ending` (lower case, ASCII), upper and lower case alike. */
[[nodiscard]] inline bool
endsWith(const std::string & name, const std::string & ending)
{
  if (name.size() < ending.size())
  {
    return false;
  }
  const std::size_t begin = name.size() - ending.size();
  for (std::size_t i = 0; i < ending.size(); ++i)
  {
    const char c = name[begin + i];
    if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) != ending[i])
    {
      return false;
    }
  }
  return true;
}

[[nodiscard]] inline bool
endsWithAny(const std::string & name, std::initializer_list<const char *> endings)
{
  for (const char * ending : endings)
  {
    if (endsWith(name, ending))
    {
      return true;
    }
  }
  return false;
}

} // namespace moserhex
