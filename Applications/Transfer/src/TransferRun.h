#pragma once

#include "TransferOptions.h"

namespace moserhex::app
{

/** Takes an image or a list of points from a subject to the cube, from the cube to a subject, or from one subject to
 * another, writes it and says so on the standard output.
 * \throws UsageError, BadInput, InvalidInput, IOError */
void
runTransfer(const TransferOptions & options);

} // namespace moserhex::app
