#include "Console.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace moserhex::app
{
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
  std::fprintf(stderr, "warning: %s\n", oneLine(text, 190).c_str());
}

void
printError(const std::string & text)
{
  std::fprintf(stderr, "error: %s\n", oneLine(text, 193).c_str());
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
