#include "Summary.h"

#include "CaseNames.h"
#include "CaseReport.h"
#include "SameFile.h"
#include "moserhex/Common/Parallel.h"

#include <filesystem>
#include <limits>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;

std::string
labelChosenBy(const InputOptions & input)
{
  return input.label ? std::to_string(*input.label) : "";
}

/** What is known of a case without its report. */
SummaryRow
rowWithoutReport(const BatchCase & batchCase)
{
  SummaryRow row;
  row.name = batchCase.name;
  row.input = batchCase.options.input.file;
  row.labels = labelChosenBy(batchCase.options.input);
  row.labelName = batchCase.labelName;
  row.kept = batchCase.kept;
  for (const std::string & figure : summaryFigures())
  {
    row.figures[figure] = std::numeric_limits<double>::quiet_NaN();
  }
  return row;
}

bool
isOfInput(const CaseReport & report, const std::string & input)
{
  return report.inputFile == input || report.inputFile == asInReport(input) || sameFile(report.inputFile, input);
}

/** Why a report does not count; empty: it does. */
std::string
objectionTo(const std::optional<CaseReport> & report, const MeshCommandOptions & options)
{
  std::error_code ignored;
  if (!report)
  {
    return fs::exists(options.reportFile, ignored) ? "the report is damaged, or not one of mesh" : "no report";
  }
  if (!isOfInput(*report, options.input.file))
  {
    return "the report is of another input, " + report->inputFile;
  }
  if (report->meshed && !fs::is_regular_file(options.output, ignored))
  {
    return "the mesh of the report is not there";
  }
  return "";
}

SummaryRow
rowOf(const BatchCase & batchCase)
{
  SummaryRow                      row = rowWithoutReport(batchCase);
  const std::optional<CaseReport> report = readCaseReport(batchCase.options.reportFile);
  row.message = objectionTo(report, batchCase.options);
  if (!row.message.empty())
  {
    return row;
  }
  row.status = report->meshed ? CaseStatus::Done : CaseStatus::Failed;
  row.code = report->code;
  row.message = report->message;
  row.labels = report->labels.empty() ? row.labels : report->labels;
  row.labelName = row.labelName.empty() ? report->labelName : row.labelName;
  row.figures = report->figures;
  row.outline = report->outline;
  const std::string page = pageNameOf(batchCase.options.reportFile);
  std::error_code   ignored;
  row.page = fs::is_regular_file(page, ignored) ? page : "";
  return row;
}

} // namespace

const char *
nameOf(CaseStatus status)
{
  switch (status)
  {
    case CaseStatus::Done:
      return "done";
    case CaseStatus::Failed:
      return "failed";
    case CaseStatus::Missing:
      return "missing";
  }
  return "";
}

std::vector<SummaryRow>
summarise(const CaseList & list, unsigned int threads)
{
  std::vector<SummaryRow> rows(list.cases.size());
  parallelFor(rows.size(), threads, [&](std::size_t i) { rows[i] = rowOf(list.cases[i]); });
  return rows;
}

} // namespace moserhex::app
