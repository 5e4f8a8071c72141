#include "AgreementCommand.h"

#include "Console.h"
#include "MeshArguments.h"
#include "OutputName.h"
#include "moserhex/HexMeshIO/FieldImageWriter.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <utility>

namespace moserhex::app
{
namespace
{

constexpr double usualOverlap = 0.5; ///< of what all hold and what one holds; below: a warning

FieldVolume
fieldOf(ScalarVolume && image)
{
  FieldVolume field;
  static_cast<VoxelGrid &>(field) = image;
  field.values = std::move(image.values);
  return field;
}

LabelVolume
readLabel(const AgreementCommandOptions & options, const std::string & file)
{
  InputOptions input = options.solid;
  input.file = file;
  const ChosenSolid solid = readSolid(input);
  for (const std::string & warning : solid.image.warnings)
  {
    printWarning(file + ": " + warning);
  }
  LabelVolume label = labelVolumeOf(*solid.mask, solid.value);
  if (!options.quiet)
  {
    const double volume = static_cast<double>(voxelCount(label)) * label.voxelVolume();
    std::printf("%s, %s: %.3f mL\n", file.c_str(), solid.name().c_str(), volume / 1000.0);
  }
  return label;
}

} // namespace

CLI::App *
addAgreementCommand(CLI::App & program, AgreementCommandOptions & options)
{
  CLI::App * command = program.add_subcommand(
    "agreement", "Write a density that counts what all segmentations of an organ hold, and hardly what only some do");
  command
    ->add_option("LABELMAP",
                 options.labelmaps,
                 "Two or more labelmaps or surfaces of one organ in one space (.nrrd .nii .nii.gz .mha .vtp .stl ...)")
    ->required()
    ->expected(-2); // at least
  command->add_option("--output", options.output, "Image to write (.nrrd .nii .nii.gz), for mesh --density")
    ->required();
  addSolidOptions(*command, options.solid);
  command->add_option("--disputed", options.agreement.disputed, "Density of what only some hold, against 1")
    ->check(CLI::Range(1e-3, 1.0))
    ->capture_default_str();
  command->add_option("--smoothing", options.agreement.smoothing, "Standard deviation of the smoothing in mm; 0: none")
    ->check(CLI::Range(0.0, 100.0))
    ->capture_default_str();
  command->add_flag("--quiet", options.quiet, "Print warnings and errors only");
  return command;
}

void
runAgreementCommand(const AgreementCommandOptions & options)
{
  std::vector<LabelVolume> labels;
  for (const std::string & file : options.labelmaps)
  {
    requireKept(file, options.output);
    labels.push_back(readLabel(options, file));
  }
  AgreementDensity agreement = agreementDensity(labels, options.agreement);
  writeFieldImage(options.output, fieldOf(std::move(agreement.density)));
  const double overlap = agreement.agreedVolume / (agreement.agreedVolume + agreement.disputedVolume);
  if (overlap < usualOverlap)
  {
    printWarning("all labelmaps together hold only " + std::to_string(std::lround(100.0 * overlap)) +
                 " % of what one of them holds: are they of one organ, in one space?");
  }
  if (!options.quiet)
  {
    std::printf("all hold %.3f mL, only some %.3f mL (overlap %.3f)\ndensity  %s\n",
                agreement.agreedVolume / 1000.0,
                agreement.disputedVolume / 1000.0,
                overlap,
                options.output.c_str());
  }
}

} // namespace moserhex::app
