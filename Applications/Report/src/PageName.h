#pragma once

#include <string>

namespace moserhex::app
{

/** Whether the name is that of a page: .html or .htm in any case. */
[[nodiscard]] bool
isPageName(const std::string & fileName);

/** Whether this program can write pages. */
[[nodiscard]] bool
pagesAreBuilt();

/** \throws InvalidInput (Usage)  a page is asked for, and this program was built without them; an empty name asks for
 * none */
void
requirePagesFor(const std::string & fileName);

} // namespace moserhex::app
