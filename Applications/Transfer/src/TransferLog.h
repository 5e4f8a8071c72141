#pragma once

#include <functional>
#include <string>

namespace moserhex::app
{

/** What is told while work is done, one line each without its end. Either may be empty. */
struct TransferLog
{
  std::function<void(const std::string &)> warning;
  std::function<void(const std::string &)> result;

  void
  warn(const std::string & text) const
  {
    if (warning)
    {
      warning(text);
    }
  }

  void
  say(const std::string & text) const
  {
    if (result)
    {
      result(text);
    }
  }
};

} // namespace moserhex::app
