#pragma once

#include "CaseList.h"
#include "CaseProcess.h"
#include "Journal.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** What is to be done about a case, and why. */
struct PlannedCase
{
  enum class Action
  {
    Run,
    Done,  ///< the mesh and its report are those that the journal knows
    Failed ///< it failed before, and would fail again
  };

  Action      action{ Action::Run };
  std::string reason;    ///< "new", "input changed", "page missing", ...; the code of what failed
  CaseKey     key;       ///< as of now
  std::string staleMesh; ///< SHA-256 of a mesh that an earlier run made there; empty: none
};

struct PlanOptions
{
  CaseLimits   limits;
  bool         retryFailed{ false };
  unsigned int threads{ 0 };
};

/** SHA-256 over all bytes that a case reads: of the input, of the file of its voxels where that is another, of the
 * density. Empty where one of them cannot be read. */
[[nodiscard]] std::string
sha256OfInputs(const MeshCommandOptions & options);

/** What a case depends on, now. Reads its inputs. */
[[nodiscard]] CaseKey
caseKey(const MeshCommandOptions & options);

/** Compares the cases with the journal and with the files. Inputs and finished meshes are read, in parallel.
 *
 * A case is done when its last journal entry says so with the same inputs, options and version, and the mesh and the
 * report have the checksums in it. One that failed is not run again unless something of this changed, retryFailed is
 * set, the limits that it exceeded were raised, or the fault was the machine's (input and output, interruption). */
[[nodiscard]] std::vector<PlannedCase>
planCases(const std::vector<BatchCase> & cases, const JournalContent & journal, const PlanOptions & options);

/** Cases whose finished mesh or report is missing or not what the journal says, and in what way: "NAME: mesh
 * missing". */
[[nodiscard]] std::vector<std::string>
damagedCases(const std::vector<BatchCase> & cases, const JournalContent & journal, unsigned int threads);

} // namespace moserhex::app
