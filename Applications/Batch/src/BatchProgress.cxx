#include "BatchProgress.h"

#include "Console.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace moserhex::app
{
namespace
{

constexpr int    barLength = 30;
constexpr double secondsBetweenBars = 0.2;

} // namespace

BatchProgress::BatchProgress(std::size_t cases, bool quiet)
  : m_Cases(cases), m_Quiet(quiet), m_Terminal(::isatty(STDOUT_FILENO) == 1)
{}

BatchProgress::~BatchProgress()
{
  clearBar();
}

void
BatchProgress::show(std::size_t ended, std::size_t failed)
{
  if (m_Quiet || m_Cases == 0)
  {
    return;
  }
  const double now = m_SinceStart.seconds();
  const double part = static_cast<double>(ended) / static_cast<double>(m_Cases);
  char         figures[160];
  const double perMinute = now > 0.0 ? 60.0 * static_cast<double>(ended) / now : 0.0;
  const double left = ended > 0 ? now * (1.0 - part) / part : 0.0;
  std::snprintf(figures,
                sizeof figures,
                "%zu of %zu, %.1f a minute, %s left, %zu failed",
                ended,
                m_Cases,
                perMinute,
                ended > 0 ? hoursMinutesSeconds(left).c_str() : "?",
                failed);
  if (!m_Terminal)
  {
    const std::size_t tenth = 10 * ended / m_Cases;
    if (tenth > m_LastTenth)
    {
      std::printf("%s\n", figures);
      std::fflush(stdout);
    }
    m_LastTenth = tenth;
    return;
  }
  if (now - m_LastShown < secondsBetweenBars && ended < m_Cases)
  {
    return;
  }
  m_LastShown = now;
  clearBar();
  const auto done = static_cast<std::size_t>(part * barLength);
  m_Bar = "[" + std::string(done, '=') + std::string(barLength - done, ' ') + "] " + figures;
  std::printf("%s", m_Bar.c_str());
  std::fflush(stdout);
}

void
BatchProgress::warn(const std::string & text)
{
  clearBar();
  printWarning(text);
}

void
BatchProgress::warn(ErrorCode code, const std::string & text)
{
  clearBar();
  printWarning(code, text);
}

void
BatchProgress::clearBar()
{
  if (!m_Bar.empty())
  {
    std::printf("\r%*s\r", static_cast<int>(m_Bar.size()), "");
    std::fflush(stdout);
    m_Bar.clear();
  }
}

std::string
hoursMinutesSeconds(double seconds)
{
  const auto whole = static_cast<long long>(std::llround(std::max(seconds, 0.0)));
  char       text[32];
  std::snprintf(text, sizeof text, "%lld:%02lld:%02lld", whole / 3600, whole / 60 % 60, whole % 60);
  return text;
}

} // namespace moserhex::app
