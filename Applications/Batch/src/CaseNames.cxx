#include "CaseNames.h"

#include <algorithm>
#include <sstream>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;

[[nodiscard]] bool
startsWith(const std::string & text, const std::string & beginning)
{
  return text.compare(0, beginning.size(), beginning) == 0;
}

/** Whether it ends so and is longer; `ending` in lower case. */
[[nodiscard]] bool
hasEnding(const std::string & name, const std::string & ending)
{
  return name.size() > ending.size() && lowerCase(name.substr(name.size() - ending.size())) == ending;
}

[[nodiscard]] bool
isAlphanumeric(char c)
{
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/** KEY-VALUE */
[[nodiscard]] bool
isEntity(const std::string & part)
{
  const std::size_t dash = part.find('-');
  return dash != std::string::npos && dash > 0 && dash + 1 < part.size() &&
         std::all_of(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(dash), isAlphanumeric) &&
         std::all_of(part.begin() + static_cast<std::ptrdiff_t>(dash) + 1, part.end(), [](char c) {
           return isAlphanumeric(c) || c == '+';
         });
}

/** Entities, of which the first is the subject, and a suffix. */
[[nodiscard]] bool
isBidsStem(const std::string & stem)
{
  const std::size_t last = stem.rfind('_');
  if (!startsWith(stem, "sub-") || last == std::string::npos || last + 1 == stem.size() ||
      !std::all_of(stem.begin() + static_cast<std::ptrdiff_t>(last) + 1, stem.end(), isAlphanumeric))
  {
    return false;
  }
  std::istringstream entities(stem.substr(0, last + 1));
  for (std::string part; std::getline(entities, part, '_');)
  {
    if (!isEntity(part))
    {
      return false;
    }
  }
  return true;
}

[[nodiscard]] std::string
labelledBidsStem(const std::string & stem, const std::string & text)
{
  const std::size_t label = stem.find("_label-");
  if (label != std::string::npos)
  {
    const std::size_t end = stem.find('_', label + 1);
    return stem.substr(0, end) + "+" + text + stem.substr(end);
  }
  const std::size_t place = std::min(stem.find("_desc-"), stem.rfind('_'));
  return stem.substr(0, place) + "_label-" + text + stem.substr(place);
}

} // namespace

fs::path
normalPath(const std::string & path)
{
  const fs::path normal = (fs::current_path() / path).lexically_normal();
  return normal.has_filename() || normal == normal.root_path() ? normal : normal.parent_path();
}

fs::path
commonFolder(const std::vector<std::string> & files)
{
  fs::path common = normalPath(files.front()).parent_path();
  for (const std::string & file : files)
  {
    const fs::path folder = normalPath(file).parent_path();
    const auto     end = std::mismatch(common.begin(), common.end(), folder.begin(), folder.end()).first;
    if (end != common.end())
    {
      fs::path shared;
      for (auto part = common.begin(); part != end; ++part)
      {
        shared /= *part;
      }
      common = shared;
    }
  }
  return common;
}

bool
staysBelow(const fs::path & relative)
{
  return !relative.empty() && relative.is_relative() && *relative.begin() != "..";
}

std::string
stemOf(const std::string & inputName)
{
  for (const char * ending : { ".nii.gz",
                               ".seg.nrrd",
                               ".seg.nhdr",
                               ".nrrd",
                               ".nhdr",
                               ".nii",
                               ".mha",
                               ".mhd",
                               ".vtk",
                               ".vtp",
                               ".stl",
                               ".obj",
                               ".ply",
                               ".off" })
  {
    if (hasEnding(inputName, ending))
    {
      return inputName.substr(0, inputName.size() - std::string(ending).size());
    }
  }
  return inputName;
}

std::string
reportNameOf(const std::string & meshName)
{
  return meshName.substr(0, meshName.rfind('.')) + ".json";
}

std::string
pageNameOf(const std::string & reportName)
{
  return reportName.substr(0, reportName.rfind('.')) + ".html";
}

std::string
labelledName(const std::string & meshName, const std::string & text)
{
  const std::size_t begin = meshName.rfind('/') + 1; // 0 where there is none
  const std::size_t end = meshName.rfind('.');
  const std::string stem = meshName.substr(begin, end - begin);
  return meshName.substr(0, begin) + (isBidsStem(stem) ? labelledBidsStem(stem, text) : stem + "_label-" + text) +
         meshName.substr(end);
}

bool
isNameOfBatch(const std::string & name)
{
  const std::string lower = lowerCase(name);
  return lower == "summary.csv" || lower == "summary.json" || lower == "summary.html" || startsWith(lower, ".lock") ||
         (startsWith(lower, "journal") && hasEnding(lower, ".jsonl"));
}

std::string
lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

} // namespace moserhex::app
