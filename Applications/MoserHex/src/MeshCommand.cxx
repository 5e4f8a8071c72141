#include "MeshCommand.h"

#include "Console.h"
#include "MeshFile.h"
#include "MeshReport.h"

namespace moserhex::app
{

void
runMeshCommand(const MeshCommandOptions & options)
{
  MeshedFile meshed;
  {
    ProgressPrinter progress(options.quiet);
    meshed = meshFile(options, [&progress](double fraction) {
      progress.show(fraction);
      return true;
    });
  }
  for (const std::string & warning : meshed.report.warnings)
  {
    printWarning(warning);
  }
  if (!options.quiet)
  {
    printSummary(meshed.report, meshed.solid, options);
  }
}

} // namespace moserhex::app
