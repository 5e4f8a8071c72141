#include "FileSearch.h"

#include "CaseRequest.h"
#include "ChosenSolid.h"
#include "CommandErrors.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <new>

#include <fnmatch.h>
#include <glob.h>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;

/** By the ending alone: files of a folder that have none are not opened. */
[[nodiscard]] bool
hasInputEnding(const fs::path & path)
{
  return path.has_extension() && isInputName(path.string());
}

[[nodiscard]] bool
fitsOneOf(const std::vector<std::string> & patterns, const fs::path & relative)
{
  return std::any_of(patterns.begin(), patterns.end(), [&relative](const std::string & pattern) {
    return ::fnmatch(pattern.c_str(), relative.c_str(), 0) == 0 ||
           ::fnmatch(pattern.c_str(), relative.filename().c_str(), 0) == 0;
  });
}

[[nodiscard]] bool
passes(const SearchFilter & filter, const fs::path & relative)
{
  return (filter.include.empty() || fitsOneOf(filter.include, relative)) && !fitsOneOf(filter.exclude, relative);
}

[[nodiscard]] fs::path
resolved(const std::string & path)
{
  std::error_code ignored;
  return fs::weakly_canonical(fs::current_path() / path, ignored);
}

/** What one folder holds, relative to the folder that is searched. */
struct FolderContent
{
  std::vector<fs::path> folders;
  std::vector<fs::path> labelmaps;
};

[[nodiscard]] FolderContent
contentOf(const fs::path & root, const fs::path & relative)
{
  FolderContent          content;
  std::error_code        error;
  fs::directory_iterator entry(root / relative, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
  {
    const fs::path  name = entry->path().filename();
    std::error_code dangling;
    if (name.native().front() == '.')
    {
      continue;
    }
    if (entry->is_directory(dangling))
    {
      if (!entry->is_symlink(dangling))
      {
        content.folders.push_back(relative / name);
      }
    }
    else if (name.has_extension() && isLabelImageName(name.string()))
    {
      content.labelmaps.push_back(relative / name);
    }
  }
  if (error)
  {
    throwUnopened((root / relative).string(), error.value());
  }
  return content;
}

} // namespace

std::vector<std::string>
labelmapsBelow(const std::string & folder, const SearchFilter & filter, const std::string & outputFolder)
{
  const fs::path        root = resolved(folder);
  const fs::path        left = resolved(outputFolder);
  std::size_t           count = 0;
  std::vector<fs::path> found;
  for (std::vector<fs::path> pending{ "" }; !pending.empty();)
  {
    FolderContent content = contentOf(folder, pending.back());
    pending.pop_back();
    for (fs::path & below : content.folders)
    {
      if (root / below != left) // no link was followed
      {
        pending.push_back(std::move(below));
      }
    }
    count += content.labelmaps.size();
    for (fs::path & labelmap : content.labelmaps)
    {
      if (passes(filter, labelmap))
      {
        found.push_back(std::move(labelmap));
      }
    }
  }
  if (count == 0)
  {
    throw UsageError(usageMessage(folder,
                                  "no labelmap in the folder or below (.nrrd .nhdr .nii .nii.gz .mha .mhd)",
                                  "give surfaces by a pattern or a list"));
  }
  if (found.empty())
  {
    throw UsageError(usageMessage(
      folder, "none of its " + std::to_string(count) + " labelmaps passes --include and --exclude", "change these"));
  }
  std::vector<std::string> files;
  files.reserve(found.size());
  for (const fs::path & labelmap : found)
  {
    files.push_back((fs::path(folder) / labelmap).string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool
isPattern(const std::string & name)
{
  return name.find_first_of("*?[") != std::string::npos;
}

std::vector<std::string>
filesMatching(const std::string & pattern)
{
  glob_t                   matches{};
  const int                status = ::glob(pattern.c_str(), GLOB_ERR | GLOB_NOSORT, nullptr, &matches);
  const int                cause = errno;
  std::vector<std::string> files;
  for (std::size_t n = 0; n < matches.gl_pathc; ++n)
  {
    std::error_code   ignored;
    const std::string match = matches.gl_pathv[n];
    if (hasInputEnding(match) && !fs::is_directory(match, ignored))
    {
      files.push_back(match);
    }
  }
  ::globfree(&matches);
  if (status == GLOB_ABORTED)
  {
    throwUnopened(pattern, cause);
  }
  if (status == GLOB_NOSPACE)
  {
    throw std::bad_alloc();
  }
  if (files.empty())
  {
    throw UsageError(usageMessage(pattern,
                                  "the pattern fits no labelmap and no surface",
                                  "check it; folders are searched when they are given by name"));
  }
  std::sort(files.begin(), files.end()); // by bytes, whatever the locale
  return files;
}

} // namespace moserhex::app
