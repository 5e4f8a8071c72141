#pragma once

#include <string>
#include <vector>

namespace moserhex::app
{

/** Which files of a folder count: those that a pattern of `include` fits, if there is any, and none of `exclude`. A
 * pattern (fnmatch; * fits a slash, too) fits the path below the folder or the file's name. */
struct SearchFilter
{
  std::vector<std::string> include;
  std::vector<std::string> exclude;
};

/** The labelmaps of a folder and of those below it, known by their endings, sorted by their paths, which begin with
 * `folder`. Hidden files and folders are left out, links to folders, and `outputFolder` where it lies below the folder.
 * \throws UsageError  none; BadInput, IOError  a folder cannot be read */
[[nodiscard]] std::vector<std::string>
labelmapsBelow(const std::string & folder, const SearchFilter & filter, const std::string & outputFolder);

/** Whether a name holds * ? or [ */
[[nodiscard]] bool
isPattern(const std::string & name);

/** The labelmaps and surfaces, by their endings, that a pattern (POSIX glob) fits, sorted by their paths.
 * \throws UsageError  none; BadInput, IOError  a folder cannot be read */
[[nodiscard]] std::vector<std::string>
filesMatching(const std::string & pattern);

} // namespace moserhex::app
