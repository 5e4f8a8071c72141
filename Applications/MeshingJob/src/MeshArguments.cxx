#include "MeshArguments.h"

#include "moserhex/SolidMeshing/SolidMeshing.h"

#include <CLI/CLI.hpp>

namespace moserhex::app
{

void
addSolidOptions(CLI::App & command, InputOptions & options)
{
  command.add_option("--label", options.label, "Label to take; without it all labels together");
  command.add_option("--segment", options.segment, "Segment of a .seg.nrrd, by name, ID or number from 1");
  command.add_option("--threshold", options.threshold, "Take the voxels of a probability map at or above this value");
  command.add_flag(
    "!--no-sandbox", options.sandbox, "Read files in this process instead of a child with limits of memory and time");
}

void
addMaximumRepair(CLI::App & command, double & percent)
{
  command
    .add_option("--max-repair", percent, "Refuse labels whose topology needs more than so many per cent of the volume")
    ->check(CLI::Range(0.0, 100.0))
    ->capture_default_str();
}

void
addMeshingOptions(CLI::App & command, MeshCommandOptions & options)
{
  command.add_option("--shells", options.shells, "Number of shells N: (2N)^3 nodes")
    ->check(CLI::Range(fewestShells, mostShells))
    ->capture_default_str();
  command
    .add_option("--padding",
                options.padding,
                "Layers of pillow cells around the lattice, for finite elements: better corners; needs --stage exact")
    ->check(CLI::Range(0, largestPadding))
    ->capture_default_str();
  addSolidOptions(command, options.input);
  command
    .add_option(
      "--topology", options.topology, "What to do with a label that is not one solid without cavities and handles")
    ->check(CLI::IsMember(topologyNames))
    ->capture_default_str();
  addMaximumRepair(command, options.maximumRepairPercent);
  command.add_option("--stage", options.stage, "Last stage to run")
    ->check(CLI::IsMember(stageNames))
    ->capture_default_str();
  command
    .add_option("--way",
                options.way,
                "Where the exact mesh starts from: three shells, or all stages with all shells; needs --stage exact")
    ->check(CLI::IsMember(wayNames))
    ->default_str("fast");
  command
    .add_option("--frame",
                options.frame,
                "How the cube is turned against the body: along the patient's axes, or up to 10 degrees from "
                "them so that its edges leave hollows")
    ->check(CLI::IsMember(frameNames))
    ->capture_default_str();
  command.add_option("--density",
                     options.density,
                     "Positive image: every cell gets the same mass, not volume; around the label it does not count; "
                     "needs --stage exact");
  command.add_flag("--allow-partial", options.allowPartial, "Write a mesh that is not exact, with a warning");
  command
    .add_option(
      "--shell-method", options.shellMethod, "How the shells are found; auto: eikonal for the fast way, else chan-vese")
    ->check(CLI::IsMember(shellMethodNames))
    ->capture_default_str();
}

} // namespace moserhex::app
