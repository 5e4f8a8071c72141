#include "TransferCommand.h"

#include "Console.h"
#include "TransferRun.h"

#include <cstdio>

namespace moserhex::app
{

CLI::App *
addTransferCommand(CLI::App & program, TransferCommandOptions & transfer)
{
  TransferOptions & options = transfer.transfer;
  CLI::App *        command = program.add_subcommand(
    "transfer", "Take an image or points from a subject to the cube, back, or to another subject");
  command
    ->add_option("INPUT",
                 options.input,
                 "Image (.nrrd .nhdr .nii .nii.gz .mha .mhd) or points (.fcsv .mrk.json .csv .tsv), LPS millimetres")
    ->required();
  command->add_option("--mesh", options.mesh, "The subject's mesh (.vtu .vtk .msh .mesh .inp), without padding")
    ->required();
  command->add_option("--to-mesh", options.toMesh, "Mesh of another subject, to go on to");
  command->add_option(
    "--to-cube", options.toCube, "Image of the cube (.nrrd .nii .nii.gz) or table of cube coordinates to write");
  command->add_option("--to-image", options.toImage, "Image of a subject to write (.nrrd .nii .nii.gz)");
  command->add_option("--to-points", options.toPoints, "Points of a subject to write (.fcsv .mrk.json .csv .tsv)");
  CLI::Option * like = command->add_option("--like", options.like, "Image whose voxels --to-image gets");
  command->add_option("--spacing", options.spacing, "Sides of new voxels in mm, one or three numbers")
    ->expected(1, 3)
    ->check(CLI::Range(0.001, 1000.0))
    ->excludes(like);
  command
    ->add_option(
      "--sampling", options.sampling, "Of the cube: cells (means), nodes (values), or means of N boxes per axis")
    ->capture_default_str();
  command->add_flag("--labels", options.labels, "The image is a labelmap: nearest voxel, the label of most of a cell");
  command->add_option("--segment", options.segment, "With --labels, one segment of a .seg.nrrd: name, ID or number");
  command->add_flag("--fractions", options.fractions, "The part of each cell in each label instead of the label");
  command->add_flag(
    "--conserve", options.conserve, "The image is a density: its integral over the organ stays the same");
  command->add_flag("--rotate", options.rotate, "Turn vectors and tensors with the organ's local axes");
  command
    ->add_option(
      "--values-in", options.valuesIn, "Space of the vectors or tensors to rotate: LPS or RAS [as the file says]")
    ->check(CLI::IsMember({ "LPS", "RAS" }));
  command->add_flag("--nearest", options.nearest, "Value of the nearest voxel instead of linear interpolation");
  command->add_option("--background", options.background, "Value of voxels outside of the organ; with --labels a label")
    ->capture_default_str();
  command->add_option("--points", options.pointsPerAxis, "Gauss points along a cell to start with [two for each voxel]")
    ->check(CLI::Range(2, 48));
  command->add_flag(
    "!--no-sandbox", options.sandbox, "Read files in this process instead of a child with limits of memory and time");
  command->add_option("--threads", options.threads, "Threads to use; the result does not depend on it [all]")
    ->check(CLI::Range(1, 1024));
  command->add_flag("--quiet", transfer.quiet, "Print warnings and errors only");
  return command;
}

void
runTransferCommand(const TransferCommandOptions & command)
{
  TransferLog log;
  log.warning = [](const std::string & text) { printWarning(text); };
  if (!command.quiet)
  {
    log.result = [](const std::string & text) { std::printf("%s\n", text.c_str()); };
  }
  runTransfer(command.transfer, log);
}

} // namespace moserhex::app
