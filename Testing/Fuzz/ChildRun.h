#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace moserhex::fuzz
{

struct ChildLimits
{
  unsigned    cpuSeconds{ 10 };     ///< of the child itself
  double      wallSeconds{ 120.0 }; ///< with its own children, on a machine that is busy with other things
  std::size_t mebibytes{ 2048 };    ///< address space; not limited under the address sanitizer
};

struct ChildResult
{
  bool        finished{ false }; ///< returned in time
  std::string text;              ///< what `work` returned, else what happened: "signal 11"
};

/** Runs `work` in a child that is killed with all its own children at the limit. Its output goes nowhere. `work` must
 * not throw.
 * \throws std::runtime_error  no child can be made */
[[nodiscard]] ChildResult
runInChild(const std::function<std::string()> & work, const ChildLimits & limits);

} // namespace moserhex::fuzz
