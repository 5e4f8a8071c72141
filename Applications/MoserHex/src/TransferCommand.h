#pragma once

#include "TransferOptions.h"

#include <CLI/CLI.hpp>

namespace moserhex::app
{

/** Adds `transfer` to the program. */
CLI::App *
addTransferCommand(CLI::App & program, TransferOptions & options);

} // namespace moserhex::app
