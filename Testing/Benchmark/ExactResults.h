#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace moserhex::results
{

/** A labelmap and the number of shells it is meshed with. */
struct ExactCase
{
  std::string           name;
  std::filesystem::path file;
  int                   shells{ 10 };
};

/** The default run (exact, fast way) of every case. */
void
writeExact(std::ostream & os, const std::vector<ExactCase> & cases);

/** What the chain reaches when it ends after each stage, and by the two ways to the exact mesh. */
void
writeAblation(std::ostream & os, const std::vector<ExactCase> & cases);

/** The all-hexahedral mesh that gmsh makes of the same surfaces with about as many cells; says "not measured" when
 * there is no executable of that name. */
void
writeGmsh(std::ostream & os, const std::vector<ExactCase> & cases);

/** Seconds and memory over N = 10, 15, 20, 32 on one labelmap, with the fitted exponent. Memory is the largest that the
 * process has had so far: to be called first. */
void
writeGrowth(std::ostream & os, const std::filesystem::path & file);

} // namespace moserhex::results
