#pragma once

#include "TransferLog.h"
#include "TransferOptions.h"

namespace moserhex::app
{

/** Takes an image or a list of points from a subject to the cube, from the cube to a subject, or from one subject to
 * another, and writes it.
 * \throws UsageError, BadInput, InvalidInput, IOError */
void
runTransfer(const TransferOptions & options, const TransferLog & log);

} // namespace moserhex::app
