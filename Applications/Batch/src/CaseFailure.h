#pragma once

#include "CaseList.h"
#include "CaseProcess.h"
#include "Guard.h"

#include <optional>

namespace moserhex::app
{

/** What ended a case, as far as its process could tell or its end tells. */
struct CaseFailure
{
  Failure failure;
  bool    isReported{ false }; ///< by the process itself, in its report
};

/** Nothing when the process says that the mesh is made. */
[[nodiscard]] std::optional<CaseFailure>
failureOf(const CaseEnd & end, const CaseLimits & limits);

/** Writes the report of a case whose process could not. \throws IOError */
void
writeFailureReport(const BatchCase & batchCase, const Failure & failure, const CaseEnd & end, bool reproducible);

} // namespace moserhex::app
