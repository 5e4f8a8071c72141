#include "BatchCommand.h"

#include "BatchPlan.h"
#include "BatchProgress.h"
#include "BatchRun.h"
#include "CaseNames.h"
#include "CommandErrors.h"
#include "Console.h"
#include "Journal.h"
#include "MeshArguments.h"
#include "OutputLock.h"
#include "PageName.h"
#include "Shard.h"
#include "Summary.h"
#include "SummaryPage.h"
#include "TextTable.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;

/** For a run that was killed, whose cases end a moment later [s]. */
constexpr double patienceWithEndingRun = 5.0;

constexpr int someFailed = 1;

void
printWarnings(const CaseList & list)
{
  for (const std::string & warning : list.warnings)
  {
    printWarning(warning);
  }
}

/** Cases and reasons, most frequent first within what is to be done. */
void
printPlan(const std::vector<PlannedCase> & plan)
{
  using Action = PlannedCase::Action;
  static const std::map<Action, const char *>           names{ { Action::Run, "to run" },
                                                     { Action::Done, "done" },
                                                     { Action::Failed, "failed" } };
  std::map<std::pair<Action, std::string>, std::size_t> counts;
  for (const PlannedCase & planned : plan)
  {
    ++counts[{ planned.action, planned.reason }];
  }
  for (const auto & [what, count] : counts)
  {
    const std::string & reason = what.second;
    std::printf("%8zu  %-7s%s%s\n", count, names.at(what.first), reason.empty() ? "" : "  ", reason.c_str());
  }
  std::printf("%8zu  cases\n", plan.size());
}

std::string
shellQuoted(const std::vector<std::string> & words)
{
  std::string line;
  for (const std::string & word : words)
  {
    const std::string harmless = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./=+:,@%";
    std::string       quoted = word;
    if (word.empty() || word.find_first_not_of(harmless) != std::string::npos)
    {
      quoted = "'";
      for (const char letter : word)
      {
        quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
      }
      quoted += "'";
    }
    line += (line.empty() ? "" : " ") + quoted;
  }
  return line;
}

/** For programs that run the cases themselves. A file that would not change keeps its time. */
void
writeCases(const std::string & fileName, const CaseList & list)
{
  std::string text = "case\tinput\toutput\treport\targuments\n";
  for (const BatchCase & batchCase : list.cases)
  {
    const MeshCommandOptions &     options = batchCase.options;
    const std::vector<std::string> cells{
      batchCase.name, options.input.file, options.output, options.reportFile, shellQuoted(meshingArguments(options))
    };
    for (const std::string & cell : cells)
    {
      if (cell.find_first_of("\t\n\r") != std::string::npos)
      {
        throw UsageError(fileMessage(options.input.file, "a name with a tab or a line's end", "rename the file"));
      }
      text += cell + '\t';
    }
    text.back() = '\n';
  }
  std::ifstream     file(fileName, std::ios::binary);
  const std::string present{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  if (!file || present != text)
  {
    writeTextFile(fileName, text);
  }
}

int
verifyMeshes(const CaseList & list, const JournalContent & journal)
{
  const std::vector<std::string> damages = damagedCases(list.cases, journal, 0);
  for (const std::string & damage : damages)
  {
    printWarning(damage);
  }
  const auto known = std::count_if(list.cases.begin(), list.cases.end(), [&journal](const BatchCase & batchCase) {
    const auto found = journal.last.find(batchCase.name);
    return found != journal.last.end() && found->second.done;
  });
  std::printf("%zu of %zu cases are in the journal as done, %zu of them missing or changed\n",
              static_cast<std::size_t>(known),
              list.cases.size(),
              damages.size());
  return damages.empty() ? EXIT_SUCCESS : someFailed;
}

/** \throws InvalidInput (Usage)  a program without pages */
void
addPages(CaseList & list)
{
  for (BatchCase & batchCase : list.cases)
  {
    batchCase.options.pageFile = pageNameOf(batchCase.options.reportFile);
    requirePagesFor(batchCase.options.pageFile);
  }
}

BatchRunOptions
runOptions(const BatchCommandOptions & options, const Shard & shard)
{
  BatchRunOptions run;
  run.program = options.program;
  if (run.program.empty())
  {
    run.program = { "/proc/self/exe" };
  }
  run.program.emplace_back("mesh");
  run.outputFolder = options.list.outputFolder;
  run.journal = journalName(options.list.outputFolder, shard.name());
  run.jobs = options.jobs == 0 ? defaultThreadCount() : options.jobs;
  run.threadsOfCase = options.threads == 0 ? std::max(defaultThreadCount() / run.jobs, 1u) : options.threads;
  run.limits = options.limits;
  run.reproducible = options.reproducible;
  run.quiet = options.quiet;
  return run;
}

std::size_t
countOf(const std::vector<PlannedCase> & plan, PlannedCase::Action action)
{
  return static_cast<std::size_t>(std::count_if(
    plan.begin(), plan.end(), [action](const PlannedCase & planned) { return planned.action == action; }));
}

std::string
summaryTableName(const BatchCommandOptions & options)
{
  return (fs::path(options.list.outputFolder) / "summary.csv").string();
}

std::string
groupFiguresName(const BatchCommandOptions & options)
{
  return (fs::path(options.list.outputFolder) / "summary.json").string();
}

std::string
summaryPageName(const BatchCommandOptions & options)
{
  return (fs::path(options.list.outputFolder) / "summary.html").string();
}

/** Of a run of all cases; a shard knows only its own. */
void
writeSummary(const CaseList & list, const BatchCommandOptions & options)
{
  const std::vector<SummaryRow> rows = summarise(list, 0);
  writeSummaryTable(summaryTableName(options), rows, list.keptColumns);
  writeGroupFigures(groupFiguresName(options), groupFigures(rows));
  if (pagesAreBuilt())
  {
    writeSummaryPage(summaryPageName(options), rows);
  }
  if (!options.quiet)
  {
    std::printf("summary %s\n", summaryTableName(options).c_str());
    if (pagesAreBuilt())
    {
      std::printf("page    %s\n", summaryPageName(options).c_str());
    }
  }
}

void
printResult(const std::vector<PlannedCase> & plan, const BatchRunResult & result, double seconds)
{
  const std::size_t doneBefore = countOf(plan, PlannedCase::Action::Done);
  const std::size_t failedBefore = countOf(plan, PlannedCase::Action::Failed);
  std::printf("%zu cases: %zu done (%zu in this run), %zu failed (%zu in this run), %zu not run; %s\n",
              plan.size(),
              doneBefore + result.done,
              result.done,
              failedBefore + result.failed,
              result.failed,
              result.notRun,
              hoursMinutesSeconds(seconds).c_str());
}

int
exitStatusOf(const std::vector<PlannedCase> & plan, const BatchRunResult & result)
{
  switch (result.stop)
  {
    case BatchStop::Signal:
      return 128 + result.signalNumber;
    case BatchStop::NoRoom:
      return moserhex::exitStatusOf(ErrorCode::InputOutput);
    case BatchStop::None:
      break;
  }
  const bool allDone = countOf(plan, PlannedCase::Action::Failed) + result.failed + result.notRun == 0;
  return allDone ? EXIT_SUCCESS : someFailed;
}

/** With the folder locked. */
int
runLocked(const CaseList & list, const Shard & shard, const BatchCommandOptions & options)
{
  const Stopwatch          stopwatch;
  std::vector<std::string> files{ summaryTableName(options), groupFiguresName(options), summaryPageName(options) };
  for (const BatchCase & batchCase : list.cases)
  {
    files.push_back(batchCase.options.output);
    files.push_back(batchCase.options.reportFile);
    files.push_back(pageNameOf(batchCase.options.reportFile));
  }
  removeAbandonedParts(files);
  const JournalContent journal = readJournals(options.list.outputFolder);
  if (journal.damaged > 0)
  {
    printWarning("journal: " + std::to_string(journal.damaged) + " damaged lines do not count; their cases run again");
  }
  if (options.verify)
  {
    return verifyMeshes(list, journal);
  }
  const std::vector<PlannedCase> plan = planCases(list.cases, journal, { options.limits, options.retryFailed, 0 });
  const BatchRunResult           result = runCases(list.cases, plan, runOptions(options, shard));
  if (!result.stopReason.empty())
  {
    printWarning(result.stopReason);
  }
  if (!options.quiet)
  {
    printResult(plan, result, stopwatch.seconds());
  }
  if (shard.isAll() && result.stop != BatchStop::NoRoom)
  {
    writeSummary(list, options);
  }
  return exitStatusOf(plan, result);
}

} // namespace

int
runBatchCommand(const BatchCommandOptions & options)
{
  const Shard shard = parseShard(options.shard);
  CaseList    list = listCases(options.list);
  shard.keepOwn(list.cases);
  if (options.casePages)
  {
    addPages(list);
  }
  printWarnings(list);
  if (!options.listCasesFile.empty())
  {
    writeCases(options.listCasesFile, list);
    return EXIT_SUCCESS;
  }
  if (options.dryRun)
  {
    printPlan(
      planCases(list.cases, readJournals(options.list.outputFolder), { options.limits, options.retryFailed, 0 }));
    return EXIT_SUCCESS;
  }
  makeFolder(options.list.outputFolder);
  const OutputLock lock(options.list.outputFolder, shard.name(), patienceWithEndingRun);
  return runLocked(list, shard, options);
}

} // namespace moserhex::app
