#pragma once

#include "TransferOptions.h"

namespace moserhex::app
{

/** Whether the input is a list of points, by its name. */
[[nodiscard]] bool
isOfPoints(const TransferOptions & options);

/** Finds, before any work is done, options that have no part in what is to be done or contradict others: nothing that
 * is given is ignored. \throws UsageError */
void
requirePartOfEveryOption(const TransferOptions & options);

} // namespace moserhex::app
