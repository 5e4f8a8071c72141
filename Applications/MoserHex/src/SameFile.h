#pragma once

#include <filesystem>
#include <string>

namespace moserhex::app
{

/** Whether two names, neither empty, mean one file, which need not exist. */
[[nodiscard]] inline bool
sameFile(const std::string & a, const std::string & b)
{
  namespace fs = std::filesystem;
  std::error_code ignored;
  return !a.empty() && !b.empty() &&
         fs::weakly_canonical(fs::absolute(a), ignored) == fs::weakly_canonical(fs::absolute(b), ignored);
}

} // namespace moserhex::app
