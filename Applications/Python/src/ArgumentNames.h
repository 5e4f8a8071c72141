#pragma once

#include <string>
#include <vector>

namespace moserhex::python
{

/** A message in the words of Python: the library's name options as the command line has them. */
[[nodiscard]] std::string
withArguments(std::string message);

/** Each of them. */
[[nodiscard]] std::vector<std::string>
withArguments(std::vector<std::string> messages);

} // namespace moserhex::python
