#pragma once

#include "CaseList.h"

#include <string>

namespace moserhex::app
{

/** Drops cases that repeat an earlier one, with a warning, and checks that no two of the others write one file.
 * \throws UsageError  a mesh or a report of two cases, or one that the batch itself writes; a mesh that is a folder of
 * another case */
void
keepDistinctCases(CaseList & list);

/** \throws UsageError  a mesh that would replace the labelmap or density of any case; hard and other links, too */
void
requireInputsKept(const CaseList & list);

/** Warns of inputs that do not exist. */
void
warnOfMissingInputs(CaseList & list);

} // namespace moserhex::app
