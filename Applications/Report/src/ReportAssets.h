#pragma once

namespace moserhex::app
{

/** What is bundled of web/ when the program is built. */
struct ReportAssets
{
  const char * style;        ///< CSS of all pages
  const char * viewerScript; ///< JavaScript of pages with a mesh in 3-D, with three.js
  const char * groupScript;  ///< JavaScript of the page of a group without one
  const char * threeVersion;
  const char * threeLicence;
};

/** Null in a program that was built without pages (MoserHex_BUILD_REPORTS is OFF). */
[[nodiscard]] const ReportAssets *
reportAssets();

} // namespace moserhex::app
