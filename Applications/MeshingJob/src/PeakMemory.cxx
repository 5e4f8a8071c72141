#include "PeakMemory.h"

#include <sys/resource.h>

#include <fstream>
#include <string>

namespace moserhex::app
{

#if defined(__linux__)

// Not getrusage: on Linux its ru_maxrss begins with that of the program that started this one, whatever its size.
std::optional<double>
peakMemory()
{
  std::ifstream status("/proc/self/status");
  std::string   word;
  double        kibibytes = 0.0;
  while (status >> word)
  {
    if (word == "VmHWM:" && status >> kibibytes)
    {
      return kibibytes / 1024.0;
    }
  }
  return std::nullopt;
}

#else

std::optional<double>
peakMemory()
{
#if defined(__APPLE__)
  constexpr double unit = 1.0; // [byte]
#else
  constexpr double unit = 1024.0;
#endif
  rusage           usage{};
  if (::getrusage(RUSAGE_SELF, &usage) != 0)
  {
    return std::nullopt;
  }
  return unit * static_cast<double>(usage.ru_maxrss) / (1024.0 * 1024.0);
}

#endif

} // namespace moserhex::app
