// moserhex_mutants: damaged files of every format through all that the commands do with an input. See
// Documentation/Fuzzing.md.
#include "MutantRun.h"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

using namespace moserhex::fuzz;

namespace
{

constexpr const char * usage =
  "usage: moserhex_mutants [--mutants 1000] [--seed 1] [--format NAME] [--pipeline-every 100] [--cpu-seconds 10]\n"
  "                        [--mebibytes 2048] [--keep DIR]\n"
  "Runs mutants of every seed, or of those of one format. Exit status 1: there are findings.\n";

struct Arguments
{
  MutantOptions options;
  std::string   format; ///< empty: all
};

Arguments
parse(int argc, char ** argv)
{
  Arguments arguments;
  if (argc % 2 == 0)
  {
    throw std::invalid_argument("every option has a value");
  }
  for (int i = 1; i + 1 < argc; i += 2)
  {
    const std::string name = argv[i];
    const std::string value = argv[i + 1];
    if (name == "--format")
    {
      arguments.format = value;
    }
    else if (name == "--keep")
    {
      arguments.options.keepFolder = value;
    }
    else if (name == "--mutants")
    {
      arguments.options.mutants = std::stoul(value);
    }
    else if (name == "--seed")
    {
      arguments.options.seed = std::stoul(value);
    }
    else if (name == "--pipeline-every")
    {
      arguments.options.pipelineEvery = std::stoul(value);
    }
    else if (name == "--cpu-seconds")
    {
      arguments.options.limits.cpuSeconds = static_cast<unsigned>(std::stoul(value));
    }
    else if (name == "--mebibytes")
    {
      arguments.options.limits.mebibytes = std::stoul(value);
    }
    else
    {
      throw std::invalid_argument("unknown option " + name);
    }
  }
  return arguments;
}

void
print(const MutantTally & tally, std::size_t mutants)
{
  std::printf("%-12s %8zu %8zu %10zu %10zu %9zu %8.0f\n",
              tally.format.c_str(),
              mutants,
              tally.refused,
              tally.unchanged,
              tally.different,
              tally.findings.size(),
              static_cast<double>(mutants) / tally.seconds);
  for (const std::string & finding : tally.findings)
  {
    std::printf("    %s\n", finding.c_str());
  }
  std::fflush(stdout); // before the next fork
}

int
run(const Arguments & arguments)
{
  std::printf(
    "%-12s %8s %8s %10s %10s %9s %8s\n", "format", "mutants", "refused", "unchanged", "different", "findings", "per s");
  std::fflush(stdout);
  std::size_t findings = 0;
  std::size_t formats = 0;
  for (const Seed & seed : makeSeeds())
  {
    if (arguments.format.empty() || arguments.format == seed.format)
    {
      const MutantTally tally = runMutants(seed, arguments.options);
      print(tally, arguments.options.mutants);
      findings += tally.findings.size();
      ++formats;
    }
  }
  if (formats == 0)
  {
    throw std::invalid_argument("no format " + arguments.format);
  }
  std::printf("%zu formats, %zu findings\n", formats, findings);
  return findings == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace

int
main(int argc, char ** argv)
{
  try
  {
    return run(parse(argc, argv));
  }
  catch (const std::exception & error)
  {
    std::fprintf(stderr, "%s\n%s", error.what(), usage);
    return 2;
  }
}
