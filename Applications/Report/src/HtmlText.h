#pragma once

#include <cstddef>
#include <string>

namespace moserhex::app
{

/** A text for the content of an element or for an attribute in quotes: & < > " ' become entities; what is not UTF-8 and
 * control characters become U+FFFD, but for tabs and line feeds. */
[[nodiscard]] std::string
escapeHtml(const std::string & text);

/** JSON for a <script> element: < > & become \u003c \u003e \u0026, which JSON reads as the same text.
 * \param json  valid JSON, in which these stand in strings only */
[[nodiscard]] std::string
escapeScriptJson(const std::string & json);

/** A relative path for the href of a link: everything but letters, digits and - . _ ~ / is %-encoded. */
[[nodiscard]] std::string
urlOfPath(const std::string & path);

/** RFC 4648, with padding. */
[[nodiscard]] std::string
base64(const void * data, std::size_t size);

/** A number for people: so many significant digits, a point whatever the locale; "n/a" when not finite. */
[[nodiscard]] std::string
shortNumber(double value, int digits = 3);

/** A number with so many digits behind the point; "n/a" when not finite. */
[[nodiscard]] std::string
fixedNumber(double value, int decimals);

/** The name of a file without its folders; what is longer than so many bytes keeps its end. */
[[nodiscard]] std::string
shortFileName(const std::string & fileName, std::size_t longest = 48);

} // namespace moserhex::app
