#pragma once

#include "TransferLog.h"
#include "TransferOptions.h"

namespace moserhex::app
{

/** The part of runTransfer for lists of points. A point that is not in the mesh, or has no coordinates, is named in a
 * warning and comes out without them. \throws UsageError, BadInput, InvalidInput, IOError */
void
transferPoints(const TransferOptions & options, const TransferLog & log);

} // namespace moserhex::app
