#include "ReportSearch.h"

#include "CaseReport.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>
#include <filesystem>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;

bool
isHidden(const fs::path & path)
{
  return path.filename().native().front() == '.';
}

std::vector<fs::path>
jsonFilesBelow(const std::string & folder)
{
  std::vector<fs::path>            files;
  std::error_code                  error;
  fs::recursive_directory_iterator entry(folder, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error))
  {
    std::error_code ignored;
    if (isHidden(entry->path()))
    {
      entry.disable_recursion_pending();
    }
    else if (entry->path().extension() == ".json" && entry->is_regular_file(ignored))
    {
      files.push_back(entry->path());
    }
  }
  if (error)
  {
    throwUnopened(folder, error.value());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/** Where the mesh is now; the report may have been written in another folder. */
std::string
meshOf(const fs::path & reportFile, const fs::path & meshFile)
{
  const fs::path sameName = fs::path(reportFile).replace_extension(meshFile.extension());
  for (const fs::path & beside : { sameName, reportFile.parent_path() / meshFile.filename() })
  {
    std::error_code ignored;
    if (fs::is_regular_file(beside, ignored))
    {
      return beside.string();
    }
  }
  return meshFile.string();
}

} // namespace

CaseList
casesOfReports(const std::string & folder, unsigned int threads)
{
  const std::vector<fs::path>            files = jsonFilesBelow(folder);
  std::vector<std::optional<CaseReport>> reports(files.size());
  parallelFor(files.size(), threads, [&](std::size_t i) { reports[i] = readCaseReport(files[i].string()); });
  CaseList list;
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    if (reports[i])
    {
      const fs::path ending = fs::path(reports[i]->meshFile).extension();
      BatchCase      batchCase;
      batchCase.name = files[i].lexically_relative(folder).replace_extension(ending).generic_string();
      batchCase.options.input.file = reports[i]->inputFile;
      batchCase.options.output = meshOf(files[i], reports[i]->meshFile);
      batchCase.options.reportFile = files[i].string();
      list.cases.push_back(batchCase);
    }
  }
  if (list.cases.empty())
  {
    throw BadInput(ErrorCode::NoInput,
                   folder,
                   "no report of moserhex mesh in the folder or below",
                   "give another folder, or the cases with --cases");
  }
  return list;
}

} // namespace moserhex::app
