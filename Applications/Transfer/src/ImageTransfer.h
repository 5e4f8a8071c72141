#pragma once

#include "TransferLog.h"
#include "TransferOptions.h"

namespace moserhex::app
{

/** The part of runTransfer for images. \throws UsageError, BadInput, InvalidInput, IOError */
void
transferImage(const TransferOptions & options, const TransferLog & log);

} // namespace moserhex::app
