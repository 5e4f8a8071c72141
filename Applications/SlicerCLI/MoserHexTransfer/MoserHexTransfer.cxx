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

app::TransferOptions
optionsOf(const ModuleArguments & arguments)
{
  const std::string    direction = arguments.text("direction");
  app::TransferOptions options;
  options.input = arguments.text("inputImage");
  options.mesh = arguments.text("mesh");
  (direction == "to-cube" ? options.toCube : options.toImage) = arguments.text("outputImage");
  if ((direction == "to-subject") != arguments.has("otherMesh"))
  {
    throw app::UsageError("the mesh of the other subject belongs to the direction to-subject, which needs it");
  }
  options.toMesh = arguments.text("otherMesh");
  options.like = arguments.text("reference");
  options.labels = arguments.flag("labels");
  options.conserve = arguments.flag("conserve");
  options.rotate = arguments.flag("rotate");
  options.sampling = arguments.text("sampling");
  options.background = arguments.real("background");
  options.threads = static_cast<unsigned int>(arguments.integer("threads"));
  return options;
}

SimpleOutputs
run(const ModuleArguments & arguments, ModuleProgress & progress)
{
  constexpr std::size_t longest = 190;
  app::TransferLog      log;
  log.warning = [](const std::string & text) { std::printf("warning: %s\n", oneLine(text, longest).c_str()); };
  log.result = [&progress](const std::string & text) { progress.comment(text); };
  app::runTransfer(optionsOf(arguments), log);
  return {};
}

} // namespace

int
main(int argc, char ** argv)
{
  return runModule(argc, argv, moserHexTransferXml, run);
}
