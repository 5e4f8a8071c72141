#include "PageName.h"

#include "ReportAssets.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace moserhex::app
{

bool
isPageName(const std::string & fileName)
{
  std::string ending = std::filesystem::path(fileName).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending == ".html" || ending == ".htm";
}

bool
pagesAreBuilt()
{
  return reportAssets() != nullptr;
}

void
requirePagesFor(const std::string & fileName)
{
  if (!fileName.empty() && !pagesAreBuilt())
  {
    throw InvalidInput(ErrorCode::Usage,
                       fileMessage(fileName,
                                   "this program was built without HTML pages",
                                   "leave the page out (a report may be .json), or build with MoserHex_BUILD_REPORTS"));
  }
}

} // namespace moserhex::app
