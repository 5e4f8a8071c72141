#include "HtmlTable.h"

namespace moserhex::app
{

std::string
tableText(const std::string &                           caption,
          const std::vector<std::string> &              columns,
          const std::vector<std::vector<std::string>> & rows)
{
  std::string html = "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"" + caption +
                     "\"><table><caption>" + caption + "</caption><thead><tr>";
  for (const std::string & column : columns)
  {
    html += "<th scope=\"col\">" + column + "</th>";
  }
  html += "</tr></thead><tbody>\n";
  for (const std::vector<std::string> & row : rows)
  {
    html += "<tr>";
    for (std::size_t cell = 0; cell < row.size(); ++cell)
    {
      html += cell == 0 ? "<th scope=\"row\">" + row[cell] + "</th>" : "<td>" + row[cell] + "</td>";
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

} // namespace moserhex::app
