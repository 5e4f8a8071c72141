#include "CollectCommand.h"

#include "CommandErrors.h"
#include "Console.h"
#include "PageName.h"
#include "ReportSearch.h"
#include "SameFile.h"
#include "Summary.h"
#include "SummaryPage.h"
#include "SummaryText.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;

void
requireFolder(const std::string & folder)
{
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
  {
    throw BadInput(ErrorCode::NoInput, folder, "no such folder", "give the folder that holds the reports");
  }
}

/** The options of lists do nothing without one. */
void
requireCasesForTheirOptions(const CaseListOptions & cases)
{
  if (cases.inputs.empty() && (cases.allLabels || !cases.include.empty() || !cases.exclude.empty() ||
                               !cases.base.empty() || !cases.keepColumns.empty()))
  {
    throw UsageError("--all-labels, --include, --exclude, --base and --keep-columns need --cases");
  }
}

/** \throws UsageError  the summary would overwrite what it is made of */
void
requireFilesKept(const CaseListOptions & options, const CaseList & list, const fs::path & summary)
{
  std::vector<std::string> files = options.inputs;
  for (const BatchCase & batchCase : list.cases)
  {
    const MeshCommandOptions & mesh = batchCase.options;
    for (const std::string & file : { mesh.input.file, mesh.density, mesh.output, mesh.reportFile })
    {
      if (fs::path(file).filename() == summary.filename())
      {
        files.push_back(file);
      }
    }
  }
  for (const std::string & file : files)
  {
    if (sameFile(file, summary.string()))
    {
      throw UsageError(fileMessage(file, "would be overwritten", "give another name for the summary"));
    }
  }
}

CaseList
casesOf(const CollectCommandOptions & options)
{
  return options.cases.inputs.empty() ? casesOfReports(options.cases.outputFolder, 0) : listCases(options.cases);
}

} // namespace

int
runCollectCommand(const CollectCommandOptions & options)
{
  const fs::path    folder = options.cases.outputFolder;
  const std::string csvFile = options.csvFile.empty() ? (folder / "summary.csv").string() : options.csvFile;
  const std::string jsonFile = options.jsonFile.empty() ? (folder / "summary.json").string() : options.jsonFile;
  const std::string defaultPage = pagesAreBuilt() ? (folder / "summary.html").string() : "";
  const std::string pageFile = options.pageFile.empty() ? defaultPage : options.pageFile;
  requirePagesFor(pageFile);
  requireCasesForTheirOptions(options.cases);
  requireFolder(options.cases.outputFolder);
  if (sameFile(csvFile, jsonFile))
  {
    throw UsageError(fileMessage(csvFile, "is both table and figures", "give one of them another name"));
  }
  if (sameFile(pageFile, csvFile) || sameFile(pageFile, jsonFile))
  {
    throw UsageError(fileMessage(pageFile, "is both page and table or figures", "give one of them another name"));
  }
  const CaseList list = casesOf(options);
  requireFilesKept(options.cases, list, csvFile);
  requireFilesKept(options.cases, list, jsonFile);
  requireFilesKept(options.cases, list, pageFile);

  const std::vector<SummaryRow> rows = summarise(list, 0);
  const GroupFigures            group = groupFigures(rows);
  writeSummaryTable(csvFile, rows, list.keptColumns);
  writeGroupFigures(jsonFile, group);
  if (!pageFile.empty())
  {
    writeSummaryPage(pageFile, rows);
  }
  for (const std::string & warning : list.warnings)
  {
    printWarning(warning);
  }
  if (!options.quiet)
  {
    std::printf("%s\ntable    %s\nfigures  %s\n", describe(group).c_str(), csvFile.c_str(), jsonFile.c_str());
    if (!pageFile.empty())
    {
      std::printf("page     %s\n", pageFile.c_str());
    }
  }
  return group.failed + group.missing == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace moserhex::app
