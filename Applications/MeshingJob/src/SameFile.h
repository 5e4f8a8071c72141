#pragma once

#include <filesystem>
#include <string>

namespace moserhex::app
{

/** Whether two names, neither empty, mean one file, which need not exist; hard links too. */
[[nodiscard]] inline bool
sameFile(const std::string & a, const std::string & b)
{
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (a.empty() || b.empty())
  {
    return false;
  }
  return fs::weakly_canonical(fs::absolute(a), ignored) == fs::weakly_canonical(fs::absolute(b), ignored) ||
         fs::equivalent(a, b, ignored); // hard links
}

} // namespace moserhex::app
