// The Slicer module MoserHexTransfer: options only; the work is runTransfer().
#include "CommandErrors.h"
#include "ModuleProgram.h"
#include "MoserHexTransferXml.h"
#include "TransferRun.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <cstdio>

namespace
{

using namespace moserhex;
using namespace moserhex::slicer;

app::TransferLog
logOf(ModuleProgress & progress)
{
  constexpr std::size_t longest = 190;
  app::TransferLog      log;
  log.warning = [](const std::string & text) { std::printf("warning: %s\n", oneLine(text, longest).c_str()); };
  log.result = [&progress](const std::string & text) { progress.comment(text); };
  return log;
}

/** Puts a value that has no part in the run back to its default, with a warning: Slicer keeps what was chosen before.
 */
template <typename TValue>
void
leaveOut(bool hasPart, const char * name, const TValue & none, const app::TransferLog & log, TValue & value)
{
  if (!hasPart && value != none)
  {
    log.warn(std::string(name) + " has no part in this, and is left out");
    value = none;
  }
}

void
leaveOthersOut(const std::string & direction, const app::TransferLog & log, app::TransferOptions & options)
{
  const app::TransferOptions defaults;
  const bool                 isToCube = direction == "to-cube";
  const bool                 hasBoxes = isToCube || (direction == "to-subject" && options.conserve);
  leaveOut(!isToCube, "the reference image", defaults.like, log, options.like);
  leaveOut(hasBoxes, "the sampling of the cube", defaults.sampling, log, options.sampling);
  leaveOut(options.labels, "the segment", defaults.segment, log, options.segment);
  leaveOut(options.rotate, "the space of vectors and tensors", defaults.valuesIn, log, options.valuesIn);
}

app::TransferOptions
optionsOf(const ModuleArguments & arguments, const app::TransferLog & log)
{
  const std::string    direction = arguments.text("direction");
  const std::string    valuesIn = arguments.text("valuesIn");
  app::TransferOptions options;
  options.input = arguments.text("inputImage");
  options.mesh = arguments.text("mesh");
  (direction == "to-cube" ? options.toCube : options.toImage) = arguments.text("outputImage");
  if ((direction == "to-subject") != arguments.has("otherMesh"))
  {
    throw app::UsageError("the mesh of the other subject belongs to the direction to-subject, which needs it");
  }
  if (direction != "to-cube" && !arguments.has("reference"))
  {
    throw app::UsageError("a reference image is needed: its voxels are those of the transferred image");
  }
  options.toMesh = arguments.text("otherMesh");
  options.like = arguments.text("reference");
  options.labels = arguments.flag("labels");
  options.segment = arguments.text("segment");
  options.conserve = arguments.flag("conserve");
  options.rotate = arguments.flag("rotate");
  options.valuesIn = valuesIn == "file" ? "" : valuesIn;
  options.sampling = arguments.text("sampling");
  options.background = arguments.real("background");
  options.threads = static_cast<unsigned int>(arguments.integer("threads"));
  leaveOthersOut(direction, log, options);
  return options;
}

SimpleOutputs
run(const ModuleArguments & arguments, ModuleProgress & progress)
{
  const app::TransferLog log = logOf(progress);
  app::runTransfer(optionsOf(arguments, log), log);
  return {};
}

} // namespace

int
main(int argc, char ** argv)
{
  return runModule(argc, argv, moserHexTransferXml, run);
}
