#include "CaseChecks.h"

#include "CaseNames.h"
#include "CaseRequest.h"
#include "CommandErrors.h"
#include "MeshArguments.h"
#include "TemplateInputs.h"

#include <optional>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include <sys/stat.h>

namespace moserhex::app
{
namespace
{

constexpr std::size_t longestOfWarning = 100;

/** The first of what a check finds, and how many there are. */
struct Finding
{
  std::string first;
  std::size_t count{ 0 };

  void
  add(const std::string & what)
  {
    first = count == 0 ? what : first;
    ++count;
  }

  /** " (and 3 more)" */
  [[nodiscard]] std::string
  others() const
  {
    return count > 1 ? " (and " + std::to_string(count - 1) + " more)" : "";
  }
};

[[nodiscard]] bool
sameWork(const BatchCase & a, const BatchCase & b)
{
  return normalPath(a.options.input.file) == normalPath(b.options.input.file) &&
         meshingArguments(a.options) == meshingArguments(b.options);
}

/** Which case writes a file, by the file's name in the output folder. */
using Writers = std::unordered_map<std::string, std::size_t>;

void
requireFreeNames(const BatchCase & one)
{
  const std::string report = reportNameOf(one.name);
  for (const std::string & name : { one.name, report })
  {
    if (isNameOfBatch(name.substr(0, name.find('/'))))
    {
      throw UsageError(usageMessage(one.options.input.file,
                                    "its " + std::string(name == report ? "report" : "mesh") + " would be " +
                                      shortName(name) + ", a name that the batch keeps for itself",
                                    "rename the input, or give an output column"));
    }
  }
}

[[noreturn]] void
refuseCollision(const std::string & name, const BatchCase & a, const BatchCase & b, std::size_t count)
{
  const bool        sameInput = a.options.input.file == b.options.input.file;
  const std::string what = name == b.name ? "the mesh" : "the report";
  const std::string inputs = sameInput ? "two cases of " + shortName(a.options.input.file)
                                       : shortName(a.options.input.file) + " and " + shortName(b.options.input.file);
  throw UsageError(usageMessage(name,
                                what + " of " + inputs + ", one of " + std::to_string(count) + " such collisions",
                                "give an output column, or --base"));
}

/** \throws UsageError  a mesh or report that is a folder of another case */
void
requireNoFolders(const std::vector<BatchCase> & cases, const Writers & writers)
{
  for (const BatchCase & one : cases)
  {
    for (std::size_t slash = one.name.find('/'); slash != std::string::npos; slash = one.name.find('/', slash + 1))
    {
      const auto writer = writers.find(one.name.substr(0, slash));
      if (writer != writers.end())
      {
        throw UsageError(usageMessage(writer->first,
                                      "a file of " + shortName(cases[writer->second].options.input.file) +
                                        ", and the folder of " + shortName(one.name),
                                      "give other outputs"));
      }
    }
  }
}

/** Of cases whose reports have different names. */
void
warnOfSimilarNames(CaseList & list)
{
  std::unordered_map<std::string, std::string> meshes; // by their reports' names in lower case
  Finding                                      similar;
  for (const BatchCase & one : list.cases)
  {
    const auto [known, isNew] = meshes.emplace(lowerCase(reportNameOf(one.name)), one.name);
    if (!isNew)
    {
      similar.add(shortName(known->second) + " and " + shortName(one.name));
    }
  }
  if (similar.count > 0)
  {
    list.warnings.push_back(similar.first + " differ in upper and lower case only" + similar.others() +
                            ": one file where the file system takes these for the same");
  }
}

/** A file that exists: device and number. */
using FileId = std::pair<dev_t, ino_t>;

[[nodiscard]] std::optional<FileId>
fileIdOf(const std::string & fileName)
{
  struct stat status;
  if (::stat(fileName.c_str(), &status) != 0)
  {
    return std::nullopt;
  }
  return FileId{ status.st_dev, status.st_ino };
}

} // namespace

void
keepDistinctCases(CaseList & list)
{
  Writers                writers;
  std::vector<BatchCase> distinct;
  distinct.reserve(list.cases.size());
  Finding repeated;
  struct
  {
    std::string name;
    BatchCase   a;
    BatchCase   b;
    std::size_t count{ 0 };
  } collisions;
  for (BatchCase & one : list.cases)
  {
    requireFreeNames(one);
    const auto mesh = writers.find(one.name);
    if (mesh != writers.end() && sameWork(distinct[mesh->second], one))
    {
      repeated.add(one.options.input.file);
      continue;
    }
    const std::string report = reportNameOf(one.name);
    for (const std::string & name : { one.name, report })
    {
      const auto [writer, isNew] = writers.emplace(name, distinct.size());
      if (!isNew)
      {
        if (collisions.count == 0)
        {
          collisions = { name, distinct[writer->second], one, 0 };
        }
        ++collisions.count;
        break;
      }
    }
    distinct.push_back(std::move(one));
  }
  if (collisions.count > 0)
  {
    refuseCollision(collisions.name, collisions.a, collisions.b, collisions.count);
  }
  list.cases = std::move(distinct);
  requireNoFolders(list.cases, writers);
  if (repeated.count > 0)
  {
    list.warnings.push_back(shortName(repeated.first, longestOfWarning) + " is given twice with the same options" +
                            repeated.others() + ": made once");
  }
  warnOfSimilarNames(list);
}

void
requireInputsKept(const CaseList & list)
{
  std::unordered_set<std::string> names;
  std::set<FileId>                files;
  for (const BatchCase & one : list.cases)
  {
    for (const std::string & input : inputFiles(one.options))
    {
      names.insert(normalPath(input).string());
      if (const auto file = fileIdOf(input))
      {
        files.insert(*file);
      }
    }
  }
  for (const BatchCase & one : list.cases)
  {
    const auto file = fileIdOf(one.options.output);
    if (names.count(normalPath(one.options.output).string()) > 0 || (file && files.count(*file) > 0))
    {
      throw UsageError(usageMessage(one.options.output,
                                    "an input, and the mesh of " + shortName(one.options.input.file),
                                    "give another output folder or format"));
    }
  }
}

void
warnOfMissingInputs(CaseList & list)
{
  Finding missing;
  for (const BatchCase & one : list.cases)
  {
    for (const std::string & input : inputFiles(one.options))
    {
      if (!fileIdOf(input))
      {
        missing.add(input);
      }
    }
  }
  if (missing.count > 0)
  {
    list.warnings.push_back(shortName(missing.first, longestOfWarning) + " does not exist" + missing.others() +
                            ": the case will fail");
  }
}

} // namespace moserhex::app
