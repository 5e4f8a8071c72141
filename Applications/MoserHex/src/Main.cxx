#include "AgreementCommand.h"
#include "AtlasCommand.h"
#include "BatchCommand.h"
#include "CaseListArguments.h"
#include "CheckCommand.h"
#include "CollectCommand.h"
#include "CommandTree.h"
#include "CompareCommand.h"
#include "Console.h"
#include "ConvertCommand.h"
#include "FigureCommand.h"
#include "Guard.h"
#include "MeshArguments.h"
#include "MeshCommand.h"
#include "PageName.h"
#include "QualityCommand.h"
#include "SampleCommand.h"
#include "Signals.h"
#include "TransferCommand.h"
#include "Version.h"
#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"
#include "moserhex/HexMeshIO/RunReport.h"

#include <CLI/CLI.hpp>

#include <clocale>
#include <cstdio>
#include <cstdlib>

#ifdef __linux__
#include <sys/prctl.h>
#endif

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

void
addInput(CLI::App & command, InputOptions & options)
{
  command
    .add_option(
      "INPUT", options.file, "Labelmap (.nrrd .nhdr .nii .nii.gz .mha .mhd) or surface (.vtk .vtp .stl .obj .ply .off)")
    ->required();
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

/** \throws CLI::ValidationError  two names for one kind of report */
void
takeReportNames(const std::vector<std::string> & names, MeshCommandOptions & options)
{
  for (const std::string & name : names)
  {
    std::string & file = isPageName(name) ? options.pageFile : options.reportFile;
    if (!file.empty())
    {
      throw CLI::ValidationError("--report", "at most one page (.html) and one JSON file");
    }
    file = name;
  }
}

void
addMeshCommand(CLI::App & program, MeshCommandOptions & options)
{
  CLI::App * command =
    program.add_subcommand("mesh", "Mesh a label of a labelmap, all its labels together, or the inside of a surface");
  addInput(*command, options.input);
  addOutput(*command, options.output);
  addMeshingOptions(*command, options);
  command
    ->add_option_function<std::vector<std::string>>(
      "--report",
      [&options](const std::vector<std::string> & names) { takeReportNames(names, options); },
      "Write a report of the run, also when it fails: .html a page to look at, else JSON; may be given once for each")
    ->allow_extra_args(false);
  command->add_flag("--reproducible",
                    options.reproducible,
                    "Leave times, threads and memory out of the report: two runs write the same bytes");
  command->add_option("--write-transform",
                      options.transformFile,
                      "Write the motion that --align found, from the template's space to the label's (.tfm .txt): for "
                      "--align of another run, and for --transforms of compare");
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

const CLI::App *
addBatchCommand(CLI::App & program, BatchCommandOptions & options)
{
  CLI::App * command = program.add_subcommand(
    "batch", "Mesh many files, each in a process of its own; an interrupted run goes on where it ended");
  command
    ->add_option("INPUT",
                 options.list.inputs,
                 "Folders, labelmaps, surfaces, patterns, or lists: .csv .tsv with columns input, output, label and "
                 "other options of mesh, .txt with a file a line")
    ->required();
  command->add_option("--output", options.list.outputFolder, "Folder of the meshes")->required();
  addCaseListOptions(*command, options.list);
  addMeshingOptions(*command, options.list.defaults);
  command->add_option("--jobs", options.jobs, "Cases at once [one for each processor]")->check(CLI::Range(1, 1024));
  command->add_option("--threads", options.threads, "Threads of each case [the processors, shared by the jobs]")
    ->check(CLI::Range(1, 1024));
  command->add_option("--time-limit", options.limits.seconds, "Wall time of a case in seconds")
    ->check(CLI::Range(0.1, 1e7))
    ->capture_default_str();
  command
    ->add_option("--memory-limit", options.limits.mebibytes, "Address space of a case in MiB; 0: as much as there is")
    ->check(CLI::Range(0.0, 1e7))
    ->capture_default_str();
  command->add_option("--shard", options.shard, "K/M: every M-th case from the K-th, for one of M machines");
  command->add_flag("--retry-failed", options.retryFailed, "Run cases again that failed before");
  CLI::Option * dryRun = command->add_flag("--dry-run", options.dryRun, "Say what would be done, and why");
  CLI::Option * verify =
    command->add_flag("--verify", options.verify, "Check finished meshes against the journal; run nothing");
  CLI::Option * list = command->add_option(
    "--list-cases", options.listCasesFile, "Write the cases and the options of each as a table; run nothing");
  dryRun->excludes(verify)->excludes(list);
  verify->excludes(list);
  command->add_flag("--case-pages", options.casePages, "Write a page (HTML) for each case beside its report, too");
  command->add_option("--program", options.program, "Run this instead of the program itself")->group("");
  command->add_flag("--reproducible",
                    options.reproducible,
                    "Leave times, threads and memory out of reports and summary: the same files for the same run");
  command->add_flag("--quiet", options.quiet, "Print warnings and errors only");
  return command;
}

CLI::App *
addCollectCommand(CLI::App & program, CollectCommandOptions & options)
{
  CLI::App * command =
    program.add_subcommand("collect", "Put the reports of many runs of mesh into one table with the group's figures");
  command->add_option("DIR", options.cases.outputFolder, "Folder that holds the reports, at its bottom or below")
    ->required();
  command->add_option("--cases",
                      options.cases.inputs,
                      "What should have been meshed: folders, labelmaps, surfaces, patterns or lists (.csv .tsv .txt); "
                      "without it what has a report");
  addCaseListOptions(*command, options.cases);
  command->add_option("--csv", options.csvFile, "Table to write, a row for each case [DIR/summary.csv]");
  command->add_option("--json", options.jsonFile, "Figures of the group to write [DIR/summary.json]");
  command->add_option("--html", options.pageFile, "Page to look at to write [DIR/summary.html]");
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
    std::string names;
    for (const CLI::App * command : program.get_subcommands([](const CLI::App *) { return true; }))
    {
      names += (names.empty() ? "" : ", ") + command->get_name();
    }
    printError(ErrorCode::Usage, "no command " + unknown.front() + ", there are " + names + "; see moserhex --help");
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
  program.footer("Exit codes: 0 done, 1 some cases are not done, 2 wrong usage, 3 bad input, 4 no valid mesh, 70 a "
                 "fault of the program, 74 input or output failed, 75 another run works on the folder.");

  MeshCommandOptions meshOptions;
  addMeshCommand(program, meshOptions);
  BatchCommandOptions     batchOptions;
  const CLI::App *        batch = addBatchCommand(program, batchOptions);
  AgreementCommandOptions agreementOptions;
  const CLI::App *        agreement = addAgreementCommand(program, agreementOptions);
  CollectCommandOptions   collectOptions;
  const CLI::App *        collect = addCollectCommand(program, collectOptions);
  CheckCommandOptions     checkOptions;
  const CLI::App *        check = addCheckCommand(program, checkOptions);
  CompareCommandOptions   compareOptions;
  const CLI::App *        compare = addCompareCommand(program, compareOptions);
  ConvertCommandOptions   convertOptions;
  const CLI::App *        convert = addConvertCommand(program, convertOptions);
  QualityCommandOptions   qualityOptions;
  const CLI::App *        quality = addQualityCommand(program, qualityOptions);
  TransferCommandOptions  transferOptions;
  const CLI::App *        transfer = addTransferCommand(program, transferOptions);
  AtlasCommandOptions     atlasOptions;
  const CLI::App *        atlas = addAtlasCommand(program, atlasOptions);
  FigureCommandOptions    figureOptions;
  const CLI::App *        figure = addFigureCommand(program, figureOptions);
  std::string             sampleFolder;
  bool                    sampleQuiet = false;
  CLI::App *              sample =
    program.add_subcommand("sample", "Write a made-up prostate, its zones and a follow-up as labelmaps");
  sample->add_option("DIR", sampleFolder, "Folder to write to")->required();
  sample->add_flag("--quiet", sampleQuiet, "Print errors only");

  program
    .add_flag_callback("--describe-commands",
                       [&program] {
                         std::fputs(describeCommands(program).c_str(), stdout);
                         throw CLI::Success();
                       })
    ->group("");

  try
  {
    program.parse(argc, argv);
  }
  catch (const CLI::ParseError & error)
  {
    return reportUsage(program, error);
  }
  if (batch->parsed())
  {
    return runGuardedForStatus([&] { return runBatchCommand(batchOptions); });
  }
  if (collect->parsed())
  {
    return runGuardedForStatus([&] { return runCollectCommand(collectOptions); });
  }
  if (agreement->parsed())
  {
    return runGuarded([&] { runAgreementCommand(agreementOptions); });
  }
  if (atlas->parsed())
  {
    return runGuarded([&] { runAtlasCommand(atlasOptions); });
  }
  if (sample->parsed())
  {
    return runGuarded([&] { runSampleCommand(sampleFolder, sampleQuiet); });
  }
  if (check->parsed())
  {
    return runGuarded([&] { runCheckCommand(checkOptions); });
  }
  if (compare->parsed())
  {
    return runGuarded([&] { runCompareCommand(compareOptions); });
  }
  if (convert->parsed())
  {
    return runGuarded([&] { runConvertCommand(convertOptions); });
  }
  if (figure->parsed())
  {
    return runGuarded([&] { runFigureCommand(figureOptions); });
  }
  if (quality->parsed())
  {
    return runGuarded([&] { runQualityCommand(qualityOptions); });
  }
  if (transfer->parsed())
  {
    return runGuarded([&] { runTransferCommand(transferOptions); });
  }
  return runGuarded([&] { runMeshCommand(meshOptions); });
}

} // namespace
} // namespace moserhex::app

int
main(int argc, char ** argv)
{
#ifdef __linux__
  (void)::prctl(PR_SET_NAME, "moserhex"); // a case of a batch is started by another name of the program
#endif
  moserhex::app::openMissingStreams();
  moserhex::app::installSignalHandlers();
  return moserhex::app::flushOutput(moserhex::app::run(argc, argv));
}
