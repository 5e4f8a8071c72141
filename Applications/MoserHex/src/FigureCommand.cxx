#include "FigureCommand.h"

#include "Console.h"
#include "Figure.h"

#include <CLI/CLI.hpp>

#include <cstdio>

namespace moserhex::app
{
namespace
{

void
addColourOptions(CLI::App & command, FigureOptions & options)
{
  command
    .add_option("--colour",
                options.colour,
                "What the cells are coloured by: " + CLI::detail::join(figureColours, ", ") +
                  ", or an array of a .vtu or .vtk file by its name, NAME:K for component K from 0")
    ->capture_default_str();
  command.add_option("--label-image", options.labelImage, "Labelmap of --colour label");
  command
    .add_option("--range", options.range, "Lowest and highest number of the colours, separated by a comma [the data's]")
    ->delimiter(',')
    ->expected(2);
  command.add_flag("!--no-edges", options.edges, "Leave out the lines around cells");
}

void
addPictureOptions(CLI::App & command, FigureOptions & options)
{
  command.add_option("--width", options.width, "Pixels from left to right")
    ->check(CLI::Range(smallestPicture, largestPicture))
    ->capture_default_str();
  command.add_option("--height", options.height, "Pixels from top to bottom")
    ->check(CLI::Range(smallestPicture, largestPicture))
    ->capture_default_str();
  command
    .add_option("--azimuth",
                options.azimuth,
                "Where the viewer stands in degrees: 0 anterior, 90 at the patient's left [30; a slice from in front]")
    ->check(CLI::Range(-360.0, 360.0));
  command.add_option("--elevation", options.elevation, "How high the viewer stands in degrees: 90 above the head [25]")
    ->check(CLI::Range(-90.0, 90.0));
  command.add_option("--title", options.title, "Words above the picture");
  command.add_option("--background", options.background, "white, black, none or RRGGBB")->capture_default_str();
}

} // namespace

CLI::App *
addFigureCommand(CLI::App & program, FigureCommandOptions & figure)
{
  FigureOptions & options = figure.figure;
  CLI::App * command = program.add_subcommand("figure", "Draw a mesh to a file: its surface, its shells, or a slice");
  command->add_option("MESH", options.mesh, "Hexahedra (.vtu .vtk .msh .mesh .inp), LPS millimetres")->required();
  command->add_option("OUTPUT", options.output, "Picture to write (.png .svg)")->required();
  command->add_option("--kind", options.kind, "What is drawn")
    ->check(CLI::IsMember(figureKinds))
    ->capture_default_str();
  command
    ->add_option("--shells", options.shells, "Shells to draw, 1 in the middle, separated by commas [up to four of all]")
    ->delimiter(',')
    ->allow_extra_args(false);
  command->add_option("--layout", options.layout, "Shells side by side, or all in their places")
    ->check(CLI::IsMember(figureLayouts))
    ->capture_default_str();
  command
    ->add_option("--plane",
                 options.plane,
                 "Where a slice is: axial, coronal or sagittal, with :MM for a place in LPS, or layer i:K j:K k:K")
    ->capture_default_str();
  addColourOptions(*command, options);
  addPictureOptions(*command, options);
  command->add_flag(
    "!--no-sandbox", options.sandbox, "Read files in this process instead of a child with limits of memory and time");
  command->add_option("--threads", options.threads, "Threads to use; the result does not depend on it [all]")
    ->check(CLI::Range(1, 1024));
  command->add_flag("--quiet", figure.quiet, "Print warnings and errors only");
  return command;
}

void
runFigureCommand(const FigureCommandOptions & options)
{
  const WrittenFigure written = writeFigure(options.figure);
  for (const std::string & warning : written.warnings)
  {
    printWarning(warning);
  }
  if (!options.quiet)
  {
    std::printf("%s: %zu polygons\n", options.figure.output.c_str(), written.polygons);
  }
}

} // namespace moserhex::app
