#include "MutantRun.h"

#include "EndToEnd.h"
#include "Mutator.h"
#include "SeedParts.h"
#include "moserhex/Common/Stopwatch.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace moserhex::fuzz
{
namespace
{

namespace fs = std::filesystem;

void
writeFile(const std::string & name, const std::string & bytes)
{
  std::ofstream file(name, std::ios::binary | std::ios::trunc);
  file << bytes;
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + name);
  }
}

/** The child's answer as text: its kind, then what it says. */
constexpr char refusedMark = 'R';
constexpr char takenMark = 'T';
constexpr char findingMark = 'F';

std::string
encoded(const EndToEndResult & result)
{
  const char mark = result.answer == Answer::Refused ? refusedMark
                    : result.answer == Answer::Taken ? takenMark
                                                     : findingMark;
  return mark + result.text;
}

bool
isGzip(const std::string & bytes)
{
  return bytes.compare(0, 2, "\x1F\x8B") == 0;
}

class SeedRun
{
public:
  SeedRun(const Seed & seed, const MutantOptions & options) : m_Seed(seed), m_Options(options), m_Mutator(options.seed)
  {
    m_Tally.format = seed.format;
    for (const SeedFile & companion : seed.companions)
    {
      writeFile(m_Folder / companion.name, companion.bytes);
    }
  }

  MutantTally
  run()
  {
    const Stopwatch   stopwatch;
    const std::string ofSeed = answerTo(m_Seed.file.bytes, m_Options.pipelineEvery > 0);
    if (ofSeed[0] != takenMark)
    {
      addFinding("the seed itself", ofSeed, m_Seed.file.bytes);
    }
    for (std::size_t number = 1; number <= m_Options.mutants; ++number)
    {
      const std::string bytes = mutant(number);
      const bool        pipeline = m_Options.pipelineEvery > 0 && number % m_Options.pipelineEvery == 0;
      const std::string answer = answerTo(bytes, pipeline);
      if (answer[0] == refusedMark)
      {
        ++m_Tally.refused;
      }
      else if (answer[0] == takenMark)
      {
        ++(answer == ofSeed ? m_Tally.unchanged : m_Tally.different);
      }
      else
      {
        addFinding("mutant " + std::to_string(number) + (pipeline ? ", pipeline" : ""), answer, bytes);
      }
    }
    m_Tally.seconds = stopwatch.seconds();
    return m_Tally;
  }

private:
  [[nodiscard]] std::string
  mutant(std::size_t number)
  {
    const std::string & bytes = m_Seed.file.bytes;
    return isGzip(bytes) && number % 2 == 0 ? gzipped(m_Mutator.mutant(gunzipped(bytes))) : m_Mutator.mutant(bytes);
  }

  [[nodiscard]] std::string
  answerTo(const std::string & bytes, bool pipeline) const
  {
    const std::string name = m_Folder / m_Seed.file.name;
    writeFile(name, bytes);
    const ChildResult result =
      runInChild([&] { return encoded(readEndToEnd(name, m_Seed.use, pipeline)); }, m_Options.limits);
    return result.finished ? result.text : findingMark + result.text;
  }

  void
  addFinding(const std::string & what, const std::string & answer, const std::string & bytes)
  {
    m_Tally.findings.push_back(what + ": " + answer.substr(1, 300));
    if (!m_Options.keepFolder.empty())
    {
      const fs::path folder =
        fs::path(m_Options.keepFolder) / (m_Seed.format + "-" + std::to_string(m_Tally.findings.size()));
      fs::create_directories(folder);
      writeFile((folder / m_Seed.file.name).string(), bytes);
      for (const SeedFile & companion : m_Seed.companions)
      {
        writeFile((folder / companion.name).string(), companion.bytes);
      }
    }
  }

  const Seed &          m_Seed;
  const MutantOptions & m_Options;
  Mutator               m_Mutator;
  ScratchFolder         m_Folder;
  MutantTally           m_Tally;
};

} // namespace

MutantTally
runMutants(const Seed & seed, const MutantOptions & options)
{
  return SeedRun(seed, options).run();
}

} // namespace moserhex::fuzz
