#pragma once

#include <string>
#include <vector>

namespace moserhex::app
{

/** A table that scrolls by itself where it is wider than the page, also by the keyboard.
 * \param caption, columns  HTML \param rows  HTML of the cells; the first of each is the row's heading */
[[nodiscard]] std::string
tableText(const std::string &                           caption,
          const std::vector<std::string> &              columns,
          const std::vector<std::vector<std::string>> & rows);

} // namespace moserhex::app
