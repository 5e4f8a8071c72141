// fuzz_seeds DIR: writes the seeds of every libFuzzer target into DIR/<reader>/.
#include "FuzzedReaders.h"
#include "Seeds.h"

#include <cstdio>
#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;
using namespace moserhex::fuzz;

namespace
{

bool
endsWith(const std::string & text, const std::string & ending)
{
  return text.size() >= ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

} // namespace

int
main(int argc, char ** argv)
{
  if (argc != 2)
  {
    std::fprintf(stderr, "usage: fuzz_seeds DIR\n");
    return 2;
  }
  const std::vector<Seed> seeds = makeSeeds();
  for (const FuzzedReader & reader : fuzzedReaders())
  {
    const fs::path folder = fs::path(argv[1]) / reader.name;
    fs::create_directories(folder);
    for (const Seed & seed : seeds)
    {
      if (endsWith(seed.file.name, reader.ending))
      {
        std::ofstream(folder / (seed.format + "-" + seed.file.name), std::ios::binary) << seed.file.bytes;
      }
    }
  }
  return 0;
}
