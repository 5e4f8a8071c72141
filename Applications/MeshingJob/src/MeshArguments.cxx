#include "MeshArguments.h"

#include "CommandErrors.h"
#include "moserhex/SolidMeshing/SolidMeshing.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iomanip>
#include <limits>
#include <sstream>

namespace moserhex::app
{
namespace
{

/** With as many digits as it takes to read the same number. */
std::string
exactText(double value)
{
  std::ostringstream text;
  text << std::setprecision(std::numeric_limits<double>::max_digits10) << value;
  return text.str();
}

} // namespace

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
  command.add_option(
    "--template",
    options.templateMesh,
    "Mesh of as many shells that this one is to be like: the same place of the organ at the same lattice "
    "index; needs --stage exact");
  command
    .add_option("--align",
                options.align,
                "How the template is brought to the label before it is bent: rigid, affine, none, or a file with a "
                "transform of ITK from the template's space to the label's")
    ->capture_default_str();
  command.add_option(
    "--landmarks",
    options.landmarks,
    "Points on the label (.fcsv .mrk.json .csv .tsv) that belong to the same places as --template-landmarks");
  command.add_option("--template-landmarks", options.templateLandmarks, "The same points on the template, same labels");
  command.add_option(
    "--image", options.image, "Image of the label's subject: the mesh is drawn to where it is like --template-image");
  command.add_option("--template-image", options.templateImage, "Image of the template's subject, of the same kind");
  command.add_flag("--local-growth",
                   options.localGrowth,
                   "Every cell grows or shrinks as --image or --landmarks show, in place of all cells alike");
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

const std::vector<std::string> &
meshingOptionNames()
{
  static const std::vector<std::string> names = [] {
    CLI::App           command;
    MeshCommandOptions options;
    addMeshingOptions(command, options);
    std::vector<std::string> all;
    for (const CLI::Option * option : command.get_options([](const CLI::Option *) { return true; }))
    {
      const std::vector<std::string> & ofOption = option->get_lnames();
      if (!ofOption.empty() && ofOption.front() != "help")
      {
        all.push_back(ofOption.front());
      }
    }
    return all;
  }();
  return names;
}

void
setMeshingOptions(const std::vector<std::pair<std::string, std::string>> & values, MeshCommandOptions & options)
{
  const std::vector<std::string> & names = meshingOptionNames();
  std::vector<std::string>         arguments;
  for (const auto & [name, value] : values)
  {
    if (std::find(names.begin(), names.end(), name) == names.end())
    {
      throw UsageError("no option of mesh is called " + oneLine(name, 60));
    }
    arguments.push_back("--" + name + "=" + value);
  }
  std::reverse(arguments.begin(), arguments.end()); // CLI11 takes them from the end
  CLI::App command;
  addMeshingOptions(command, options);
  try
  {
    command.parse(arguments);
  }
  catch (const CLI::ParseError & error)
  {
    throw UsageError(oneLine(error.what(), 120));
  }
  requireUsable(options);
}

bool
isFileOption(const std::string & name, const std::string & value)
{
  static const std::vector<std::string> names{ "density", "template",      "landmarks", "template-landmarks",
                                               "image",   "template-image" };
  const bool isAlignName = std::find(alignNames.begin(), alignNames.end(), value) != alignNames.end();
  return std::find(names.begin(), names.end(), name) != names.end() || (name == "align" && !isAlignName);
}

std::vector<std::string>
meshingArguments(const MeshCommandOptions & options)
{
  std::vector<std::string> arguments;
  const auto               add = [&arguments](const std::string & name, const std::string & value) {
    arguments.push_back("--" + name + "=" + value);
  };
  add("shells", std::to_string(options.shells));
  add("padding", std::to_string(options.padding));
  if (options.input.label)
  {
    add("label", std::to_string(*options.input.label));
  }
  if (options.input.segment)
  {
    add("segment", *options.input.segment);
  }
  if (options.input.threshold)
  {
    add("threshold", exactText(*options.input.threshold));
  }
  add("no-sandbox", options.input.sandbox ? "false" : "true");
  add("topology", options.topology);
  add("max-repair", exactText(options.maximumRepairPercent));
  add("stage", options.stage);
  if (options.way)
  {
    add("way", *options.way);
  }
  add("frame", options.frame);
  if (!options.templateMesh.empty())
  {
    add("template", options.templateMesh);
    add("align", options.align);
  }
  for (const auto & [name, file] : { std::pair("landmarks", options.landmarks),
                                     std::pair("template-landmarks", options.templateLandmarks),
                                     std::pair("image", options.image),
                                     std::pair("template-image", options.templateImage) })
  {
    if (!file.empty())
    {
      add(name, file);
    }
  }
  if (options.localGrowth)
  {
    add("local-growth", "true");
  }
  if (!options.density.empty())
  {
    add("density", options.density);
  }
  add("allow-partial", options.allowPartial ? "true" : "false");
  add("shell-method", options.shellMethod);
  return arguments;
}

} // namespace moserhex::app
