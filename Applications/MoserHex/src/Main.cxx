#include "CheckCommand.h"
#include "Console.h"
#include "ConvertCommand.h"
#include "Guard.h"
#include "MeshCommand.h"
#include "QualityCommand.h"
#include "SampleCommand.h"
#include "Signals.h"
#include "Version.h"
#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"
#include "moserhex/HexMeshIO/RunReport.h"
#include "moserhex/SolidMeshing/SolidMeshing.h"

#include <CLI/CLI.hpp>

#include <clocale>
#include <cstdlib>

namespace moserhex::app
{
namespace
{

std::string
versionText()
{
  const RunReport::Versions versions = libraryVersions();
  return std::string("moserhex ") + version + " (" + gitDescription + "), ITK " + versions.itk + ", VTK " +
         versions.vtk + ", Eigen " + versions.eigen;
}

/** Which solid of which file: the same for all commands. */
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
addInput(CLI::App & command, InputOptions & options)
{
  command
    .add_option(
      "INPUT", options.file, "Labelmap (.nrrd .nhdr .nii .nii.gz .mha .mhd) or surface (.vtk .vtp .stl .obj .ply .off)")
    ->required();
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
addThreadsAndQuiet(CLI::App & command, unsigned int & threads, bool & quiet)
{
  command.add_option("--threads", threads, "Threads to use; the result does not depend on it [all]")
    ->check(CLI::Range(1, 1024));
  command.add_flag("--quiet", quiet, "Print warnings and errors only");
}

void
addOutput(CLI::App & command, std::string & output)
{
  command.add_option("OUTPUT", output, std::string("Mesh to write (") + hexMeshEndings + "), LPS millimetres")
    ->required();
}

void
addMeshCommand(CLI::App & program, MeshCommandOptions & options)
{
  CLI::App * command =
    program.add_subcommand("mesh", "Mesh a label of a labelmap, all its labels together, or the inside of a surface");
  addInput(*command, options.input);
  addOutput(*command, options.output);
  command->add_option("--shells", options.shells, "Number of shells N: (2N)^3 nodes")
    ->check(CLI::Range(fewestShells, mostShells))
    ->capture_default_str();
  command
    ->add_option("--padding",
                 options.padding,
                 "Layers of pillow cells around the lattice, for finite elements: better corners; needs --stage exact")
    ->check(CLI::Range(0, largestPadding))
    ->capture_default_str();
  addSolidOptions(*command, options.input);
  command
    ->add_option(
      "--topology", options.topology, "What to do with a label that is not one solid without cavities and handles")
    ->check(CLI::IsMember(topologyNames))
    ->capture_default_str();
  addMaximumRepair(*command, options.maximumRepairPercent);
  command->add_option("--stage", options.stage, "Last stage to run")
    ->check(CLI::IsMember(stageNames))
    ->capture_default_str();
  command
    ->add_option("--way",
                 options.way,
                 "Where the exact mesh starts from: three shells, or all stages with all shells; needs --stage exact")
    ->check(CLI::IsMember(wayNames))
    ->default_str("fast");
  command
    ->add_option("--frame",
                 options.frame,
                 "How the cube is turned against the body: along the patient's axes, or up to 10 degrees from "
                 "them so that its edges leave hollows")
    ->check(CLI::IsMember(frameNames))
    ->capture_default_str();
  command->add_option("--density",
                      options.density,
                      "Positive image: every cell gets the same mass, not volume; around the label it does not count; "
                      "needs --stage exact");
  command->add_flag("--allow-partial", options.allowPartial, "Write a mesh that is not exact, with a warning");
  command
    ->add_option(
      "--shell-method", options.shellMethod, "How the shells are found; auto: eikonal for the fast way, else chan-vese")
    ->check(CLI::IsMember(shellMethodNames))
    ->capture_default_str();
  command->add_option("--report", options.reportFile, "Write a report of the run as JSON");
  addThreadsAndQuiet(*command, options.threads, options.quiet);
}

CLI::App *
addQualityCommand(CLI::App & program, QualityCommandOptions & options)
{
  CLI::App * command = program.add_subcommand("quality", "Measure the quality of a hexahedral mesh of any tool");
  command->add_option("MESH", options.mesh, "Hexahedra (.vtu .vtk .msh .mesh .inp), LPS millimetres")->required();
  command->add_option("--label-image", options.labelImage.file, "Labelmap to compare the mesh with");
  addSolidOptions(*command, options.labelImage);
  command->add_option("--json", options.jsonFile, "Write the numbers as JSON");
  addThreadsAndQuiet(*command, options.threads, options.quiet);
  return command;
}

CLI::App *
addCheckCommand(CLI::App & program, CheckCommandOptions & options)
{
  CLI::App * command =
    program.add_subcommand("check", "Say what is wrong with a label, and what a repair would change");
  addInput(*command, options.input);
  addSolidOptions(*command, options.input);
  command->add_flag("--all-labels", options.allLabels, "A table of all labels");
  addMaximumRepair(*command, options.maximumRepairPercent);
  command->add_option("--json", options.jsonFile, "Write the diagnosis as JSON");
  addThreadsAndQuiet(*command, options.threads, options.quiet);
  return command;
}

CLI::App *
addConvertCommand(CLI::App & program, ConvertCommandOptions & options)
{
  CLI::App * command = program.add_subcommand(
    "convert", "Write a lattice mesh in another format, with named sets for finite-element programs");
  command
    ->add_option("INPUT",
                 options.input,
                 "Lattice of hexahedra (.vtu .vtk .msh .mesh .inp), LPS millimetres; its arrays are not taken over")
    ->required();
  addOutput(*command, options.output);
  command->add_option("--gmsh-version", options.gmshVersion, "Version of an OUTPUT .msh")
    ->check(CLI::IsMember({ "2.2", "4.1" }))
    ->capture_default_str();
  command->add_flag(
    "!--no-sandbox", options.sandbox, "Read files in this process instead of a child with limits of memory and time");
  command->add_flag("--quiet", options.quiet, "Print warnings and errors only");
  return command;
}

int
reportUsage(const CLI::App & program, const CLI::ParseError & error)
{
  if (error.get_exit_code() == 0)
  {
    return program.exit(error); // --help, --version
  }
  const auto parsed = program.get_subcommands();
  const auto unknown = program.remaining();
  if (parsed.empty() && !unknown.empty() && unknown.front().front() != '-')
  {
    printError(ErrorCode::Usage,
               "no command " + unknown.front() +
                 ", there are mesh, check, convert, quality and sample; see moserhex --help");
    return exitStatusOf(ErrorCode::Usage);
  }
  const std::string command = parsed.empty() ? "" : parsed.front()->get_name() + " ";
  printError(ErrorCode::Usage, std::string(error.what()) + "; see moserhex " + command + "--help");
  return exitStatusOf(ErrorCode::Usage);
}

int
run(int argc, char ** argv)
{
  CLI::App program("Volume-preserving structured hexahedral meshes of genus-zero organs", "moserhex");
  program.set_version_flag("--version", versionText());
  program.require_subcommand(1);
  program.footer(
    "Exit codes: 0 done, 2 wrong usage, 3 bad input, 4 no valid mesh, 70 a fault of the program, 74 input or "
    "output failed.");

  MeshCommandOptions meshOptions;
  addMeshCommand(program, meshOptions);
  CheckCommandOptions   checkOptions;
  const CLI::App *      check = addCheckCommand(program, checkOptions);
  ConvertCommandOptions convertOptions;
  const CLI::App *      convert = addConvertCommand(program, convertOptions);
  QualityCommandOptions qualityOptions;
  const CLI::App *      quality = addQualityCommand(program, qualityOptions);
  std::string           sampleFolder;
  bool                  sampleQuiet = false;
  CLI::App *            sample =
    program.add_subcommand("sample", "Write a made-up prostate, its zones and a follow-up as labelmaps");
  sample->add_option("DIR", sampleFolder, "Folder to write to")->required();
  sample->add_flag("--quiet", sampleQuiet, "Print errors only");

  try
  {
    program.parse(argc, argv);
  }
  catch (const CLI::ParseError & error)
  {
    return reportUsage(program, error);
  }
  if (sample->parsed())
  {
    return runGuarded([&] { runSampleCommand(sampleFolder, sampleQuiet); });
  }
  if (check->parsed())
  {
    return runGuarded([&] { runCheckCommand(checkOptions); });
  }
  if (convert->parsed())
  {
    return runGuarded([&] { runConvertCommand(convertOptions); });
  }
  if (quality->parsed())
  {
    return runGuarded([&] { runQualityCommand(qualityOptions); });
  }
  return runGuarded([&] { runMeshCommand(meshOptions); });
}

} // namespace
} // namespace moserhex::app

int
main(int argc, char ** argv)
{
  moserhex::app::openMissingStreams();
  moserhex::app::installSignalHandlers();
  return moserhex::app::flushOutput(moserhex::app::run(argc, argv));
}
