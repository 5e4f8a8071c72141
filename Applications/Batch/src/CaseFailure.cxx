#include "CaseFailure.h"

#include "MeshReport.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <cmath>
#include <csignal>
#include <cstring>
#include <sstream>

namespace moserhex::app
{
namespace
{

/** The code whose name stands at the end of an error line. */
std::optional<ErrorCode>
codeAtEndOf(const std::string & line)
{
  for (int code = 0; code <= static_cast<int>(lastErrorCode); ++code)
  {
    const std::string end = std::string(" [") + nameOf(static_cast<ErrorCode>(code)) + "]";
    if (line.size() > end.size() && line.compare(line.size() - end.size(), end.size(), end) == 0)
    {
      return static_cast<ErrorCode>(code);
    }
  }
  return std::nullopt;
}

/** The last "error: ... [E_...]" line of what a process said. */
std::optional<Failure>
lastErrorLine(const std::string & lastWords)
{
  const std::string      begin = "error: ";
  std::optional<Failure> found;
  std::istringstream     lines(lastWords);
  for (std::string line; std::getline(lines, line);)
  {
    const std::optional<ErrorCode> code = codeAtEndOf(line);
    if (code && line.compare(0, begin.size(), begin) == 0)
    {
      const std::size_t end = line.rfind(" [");
      found = Failure{ *code, line.substr(begin.size(), end - begin.size()) };
    }
  }
  return found;
}

std::string
shortNumber(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

Failure
describeSignal(int signalNumber)
{
  const std::string name = std::to_string(signalNumber) + " (" + ::strsignal(signalNumber) + ")";
  if (signalNumber == SIGKILL)
  {
    return { ErrorCode::Crashed,
             "its process was ended by signal " + name + ", perhaps by the system for lack of memory; use fewer jobs" };
  }
  return { ErrorCode::Crashed, "its process died of signal " + name + "; please report this" };
}

} // namespace

std::optional<CaseFailure>
failureOf(const CaseEnd & end, const CaseLimits & limits)
{
  if (end.exitStatus == 0)
  {
    return std::nullopt;
  }
  if (end.wasTooSlow)
  {
    return CaseFailure{
      { ErrorCode::TimeLimit, "took more than " + shortNumber(limits.seconds) + " s; raise the time limit" }, false
    };
  }
  if (end.signalNumber != 0)
  {
    return CaseFailure{ describeSignal(end.signalNumber), false };
  }
  const std::optional<Failure> said = lastErrorLine(end.lastWords);
  if (said)
  {
    return CaseFailure{ *said, said->code != ErrorCode::Usage };
  }
  return CaseFailure{ { ErrorCode::Crashed,
                        "its process ended with status " + std::to_string(end.exitStatus) +
                          " and no reason: " + oneLine(end.lastWords, 80) },
                      false };
}

void
writeFailureReport(const BatchCase & batchCase, const Failure & failure, const CaseEnd & end, bool reproducible)
{
  RunReport report = startReport(batchCase.options);
  report.failure = RunReport::Failure{ failure.code, failure.message };
  report.reproducible = reproducible;
  report.seconds = end.seconds;
  report.peakMemory = end.peakMebibytes;
  writeRunReport(batchCase.options.reportFile, report);
}

} // namespace moserhex::app
