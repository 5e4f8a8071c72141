#pragma once

#include "FigureOptions.h"

namespace CLI
{
class App;
}

namespace moserhex::app
{

struct FigureCommandOptions
{
  FigureOptions figure;
  bool          quiet{ false };
};

CLI::App *
addFigureCommand(CLI::App & program, FigureCommandOptions & options);

/** Draws a mesh to a file. \throws UsageError, BadInput, InvalidInput, IOError */
void
runFigureCommand(const FigureCommandOptions & options);

} // namespace moserhex::app
