#include "TransferRun.h"

#include "CommandErrors.h"
#include "ImageTransfer.h"
#include "OutputName.h"
#include "PointTransfer.h"
#include "TransferUsage.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

namespace moserhex::app
{
namespace
{

/** The one output there is. \throws UsageError  none or several */
const std::string &
outputOf(const TransferOptions & options)
{
  const std::string * output = nullptr;
  for (const std::string * file : { &options.toCube, &options.toImage, &options.toPoints })
  {
    if (output != nullptr && !file->empty())
    {
      throw UsageError("give one of --to-cube, --to-image and --to-points");
    }
    output = file->empty() ? output : file;
  }
  if (output == nullptr)
  {
    throw UsageError("where to? give --to-cube, --to-image or --to-points");
  }
  return *output;
}

void
requireUsableOptions(const TransferOptions & options, const std::string & output)
{
  for (const std::string & input : { options.input, options.mesh, options.toMesh, options.like })
  {
    requireKept(input, output);
  }
  if (!options.toMesh.empty() && !options.toCube.empty())
  {
    throw UsageError("--to-mesh leads to another subject; --to-cube needs --mesh alone");
  }
  requirePartOfEveryOption(options);
  const AtomicFile probe(output);
}

} // namespace

void
runTransfer(const TransferOptions & options, const TransferLog & log)
{
  const std::string & output = outputOf(options);
  requireUsableOptions(options, output);
  isOfPoints(options) ? transferPoints(options, log) : transferImage(options, log);
}

} // namespace moserhex::app
