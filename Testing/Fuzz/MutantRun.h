#pragma once

#include "ChildRun.h"
#include "Seeds.h"

#include <cstdint>
#include <string>
#include <vector>

namespace moserhex::fuzz
{

struct MutantOptions
{
  std::size_t   mutants{ 1000 }; ///< of every seed
  std::uint64_t seed{ 1 };
  std::size_t   pipelineEvery{ 100 }; ///< so many mutants apart the whole pipeline runs; 0: never
  ChildLimits   limits;
  std::string   keepFolder; ///< for files that make a finding; empty: not kept
};

/** A row of the table. */
struct MutantTally
{
  std::string              format;
  std::size_t              refused{ 0 };
  std::size_t              unchanged{ 0 }; ///< taken, and the same was read as from the seed
  std::size_t              different{ 0 };
  std::vector<std::string> findings; ///< "mutant 17: signal 11"
  double                   seconds{ 0.0 };
};

/** Makes and runs the mutants of one seed, each in a child. A seed that is not taken itself is a finding. Every other
 * mutant of a gzip seed is changed before it is packed.
 * \throws std::runtime_error  the scratch folder cannot be used */
[[nodiscard]] MutantTally
runMutants(const Seed & seed, const MutantOptions & options);

} // namespace moserhex::fuzz
