#pragma once

#include "CaseList.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace moserhex::app
{

enum class CaseStatus
{
  Done,   ///< the mesh and its report are there
  Failed, ///< the report says why there is no mesh
  Missing ///< no report, or one that does not fit: not run, or its process was killed before it could write one
};

/** "done", "failed", "missing". */
[[nodiscard]] const char *
nameOf(CaseStatus status);

/** One case, as its report tells. Numbers that the report does not have are NaN. */
struct SummaryRow
{
  std::string                   name; ///< of the case
  CaseStatus                    status{ CaseStatus::Missing };
  std::string                   code;    ///< E_TOPOLOGY and so on; empty where done or missing
  std::string                   message; ///< of a failure, or why the report does not count
  std::string                   input;
  std::string                   labels; ///< "3", "1 2"
  std::string                   labelName;
  std::map<std::string, double> figures; ///< by the name of the column; see summaryFigures
  std::string                   outline; ///< of the mesh, see RunReport; empty: not known
  std::string                   page;    ///< its own page, a path as this process can open it; empty: there is none
  std::vector<std::string>      kept;
};

/** The names of the columns with numbers, in their order: nodes, cells, label_volume_mm3, mesh_volume_mm3,
 * volume_variance, concave_percent, sj_min, sj_median, sj_mean, exact (1 or 0), certified (1 or 0), surface_rms_mm,
 * surface_max_mm, repair_percent, dice, warnings, seconds, peak_memory_mib. */
[[nodiscard]] const std::vector<std::string> &
summaryFigures();

/** Reads the reports of cases, in parallel; rows in the order of the cases.
 * A report counts only if it names the case's input (as it was given, or another name of the same file) and, when done,
 * the mesh is there. One that is damaged, larger than 16 MiB or not a report of `mesh` does not count. */
[[nodiscard]] std::vector<SummaryRow>
summarise(const CaseList & list, unsigned int threads);

/** How many of what, and quantiles of the figures over the cases that are done. */
struct GroupFigures
{
  struct Distribution
  {
    std::size_t count{ 0 };
    double      minimum{ 0.0 };
    double      p05{ 0.0 };
    double      median{ 0.0 };
    double      p95{ 0.0 };
    double      maximum{ 0.0 };
    double      mean{ 0.0 };
  };
  std::size_t                         done{ 0 };
  std::size_t                         failed{ 0 };
  std::size_t                         missing{ 0 };
  std::map<std::string, std::size_t>  failures;            ///< by code
  std::map<std::string, Distribution> figures;             ///< by the name of the column
  double                              totalSeconds{ 0.0 }; ///< of all cases, failed ones too
};

[[nodiscard]] GroupFigures
groupFigures(const std::vector<SummaryRow> & rows);

/** Writes the table, one row a case: case, status, code, message, input, labels, label_name, the figures, the kept
 * columns, which have `list_` before their names where these are taken. Numbers have as many digits as it takes to read
 * them back, and a point whatever the locale; those that are not known are empty cells. Seconds and memory are left out
 * where no report has them. Complete or not at all. \throws IOError */
void
writeSummaryTable(const std::string &              fileName,
                  const std::vector<SummaryRow> &  rows,
                  const std::vector<std::string> & keptColumns);

/** Writes the group's figures as JSON; those that no case has are left out. Complete or not at all. \throws IOError */
void
writeGroupFigures(const std::string & fileName, const GroupFigures & figures);

} // namespace moserhex::app
