#pragma once

#include "TransferOptions.h"

#include <CLI/CLI.hpp>

namespace moserhex::app
{

struct TransferCommandOptions
{
  TransferOptions transfer;
  bool            quiet{ false };
};

/** Adds `transfer` to the program. */
CLI::App *
addTransferCommand(CLI::App & program, TransferCommandOptions & transfer);

/** Does it, with its results on the standard output. \throws UsageError, BadInput, InvalidInput, IOError */
void
runTransferCommand(const TransferCommandOptions & command);

} // namespace moserhex::app
