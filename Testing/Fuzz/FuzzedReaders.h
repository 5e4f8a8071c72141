#pragma once

#include <string>
#include <vector>

namespace moserhex::fuzz
{

/** One piece of code that looks at the bytes of a file nobody vouches for. */
struct FuzzedReader
{
  std::string name;                           ///< "nrrd": target fuzz_nrrd
  std::string ending;                         ///< of the file's name
  void (*read)(const std::string & fileName); ///< throws moserhex::Error or returns
};

/** All there are, each with a libFuzzer target of its own. */
[[nodiscard]] const std::vector<FuzzedReader> &
fuzzedReaders();

/** \throws std::out_of_range  there is none of this name */
[[nodiscard]] const FuzzedReader &
fuzzedReader(const std::string & name);

} // namespace moserhex::fuzz
