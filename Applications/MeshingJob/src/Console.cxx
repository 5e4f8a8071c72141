#include "Console.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace moserhex::app
{
namespace
{

constexpr std::size_t lineLength = 200;

void
printWithCode(const std::string & begin, ErrorCode code, const std::string & text)
{
  const std::string end = std::string(" [") + nameOf(code) + "]";
  std::fprintf(stderr, "%s\n", (begin + oneLine(text, lineLength - begin.size() - end.size()) + end).c_str());
}

} // namespace

ProgressPrinter::ProgressPrinter(bool quiet) : m_Quiet(quiet), m_Terminal(::isatty(STDOUT_FILENO) == 1)
{}

ProgressPrinter::~ProgressPrinter()
{
  clearBar();
}

void
ProgressPrinter::show(double fraction)
{
  const int steps = m_Terminal ? 50 : 10;
  const int step = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * steps);
  if (m_Quiet || step <= m_LastStep)
  {
    return;
  }
  m_LastStep = step;
  if (m_Terminal)
  {
    const auto done = static_cast<std::size_t>(step);
    std::printf("\r[%s%s] %3d %%", std::string(done, '=').c_str(), std::string(50 - done, ' ').c_str(), 2 * step);
  }
  else if (step > 0)
  {
    std::printf("%d %%\n", 10 * step);
  }
  std::fflush(stdout);
}

void
ProgressPrinter::clearBar()
{
  if (!m_Quiet && m_Terminal && m_LastStep >= 0)
  {
    std::printf("\r%*s\r", 60, "");
    std::fflush(stdout);
  }
}

void
printWarning(const std::string & text)
{
  const std::string begin = "warning: ";
  std::fprintf(stderr, "%s\n", (begin + oneLine(text, lineLength - begin.size())).c_str());
}

void
printWarning(ErrorCode code, const std::string & text)
{
  printWithCode("warning: ", code, text);
}

void
printError(ErrorCode code, const std::string & text)
{
  printWithCode("error: ", code, text);
}

void
printQualityTable(const RunReport & report)
{
  std::printf("%-22s %8s %12s %10s %8s %10s\n", "stage", "seconds", "vol. var.", "concave %", "SJ min", "SJ median");
  for (const StageRecord & stage : report.stages)
  {
    if (stage.quality)
    {
      std::printf("%-22s %8.2f %12.3g %10.2f %8.3f %10.3f\n",
                  stage.name.c_str(),
                  stage.seconds,
                  stage.quality->volumeVariance,
                  stage.quality->concavePercent,
                  stage.quality->scaledJacobianMinimum,
                  stage.quality->scaledJacobianMedian);
    }
    else
    {
      std::printf("%-22s %8.2f %12s %10s %8s %10s\n", stage.name.c_str(), stage.seconds, "-", "-", "-", "-");
    }
  }
  std::printf("%-22s %8.2f\n", "whole run", report.seconds);
}

} // namespace moserhex::app
