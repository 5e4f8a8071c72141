#pragma once

#include <string>

namespace moserhex::app
{

/** What all pages have around their content. */
struct PageFrame
{
  std::string title; ///< in the browser's tab
  std::string heading;
  std::string subtitle; ///< a line below the heading
  std::string body;     ///< HTML: sections
  std::string script;   ///< JavaScript, "</script" not in it
  std::string footer;   ///< HTML
};

/** A whole HTML document that loads nothing, and whose policy (CSP) forbids to. \throws InvalidInput (Usage)  a program
 * without pages */
[[nodiscard]] std::string
pageText(const PageFrame & frame);

/** A <script> element that is not run but read by others. \param json  valid JSON */
[[nodiscard]] std::string
dataElement(const std::string & id, const std::string & json);

/** <section> with a heading of the second rank. */
[[nodiscard]] std::string
section(const std::string & id, const std::string & heading, const std::string & content);

/** The licence of the library of the 3-D view, to unfold. */
[[nodiscard]] std::string
licenceDetails();

} // namespace moserhex::app
