#include "MeshOptions.h"

#include "CommandErrors.h"
#include "moserhex/HexMeshIO/TransformFile.h"
#include "moserhex/HexMeshIO/TransformWriter.h"
#include "moserhex/SolidMeshing/SolidMeshing.h"

#include <algorithm>

namespace moserhex::app
{
namespace
{

void
requireOneOf(const std::string & option, const std::string & value, const std::vector<std::string> & names)
{
  if (std::find(names.begin(), names.end(), value) != names.end())
  {
    return;
  }
  std::string list;
  for (const std::string & name : names)
  {
    list += (list.empty() ? "" : ", ") + name;
  }
  throw UsageError(option + ": " + oneLine(value, 40) + " is none of " + list);
}

void
requireUsableTemplate(const MeshCommandOptions & options)
{
  if (!isTransformName(options.align))
  {
    requireOneOf("--align", options.align, alignNames);
  }
  if (options.landmarks.empty() != options.templateLandmarks.empty())
  {
    throw UsageError("--landmarks and --template-landmarks need each other");
  }
  if (options.image.empty() != options.templateImage.empty())
  {
    throw UsageError("--image and --template-image need each other");
  }
  if (options.localGrowth && options.landmarks.empty() && options.image.empty())
  {
    throw UsageError("--local-growth needs --image or --landmarks: shapes do not show it");
  }
  if (options.templateMesh.empty())
  {
    if (!options.landmarks.empty() || !options.image.empty() || isTransformName(options.align))
    {
      throw UsageError("--landmarks, --image and a transform as --align need --template");
    }
    return;
  }
  if (options.stage != "exact" || options.padding > 0 || options.way || options.frame != "anatomical")
  {
    throw UsageError("--template needs --stage exact, and takes no --padding, --way or --frame");
  }
  if (!options.density.empty() && (!options.landmarks.empty() || !options.image.empty()))
  {
    throw UsageError("--landmarks and --image take no --density: they refine meshes of equal volumes");
  }
}

} // namespace

void
requireUsable(const MeshCommandOptions & options)
{
  requireOneOf("--stage", options.stage, stageNames);
  requireOneOf("--way", wayOf(options), wayNames);
  requireOneOf("--frame", options.frame, frameNames);
  requireOneOf("--topology", options.topology, topologyNames);
  requireOneOf("--shell-method", options.shellMethod, shellMethodNames);
  if (options.shells < fewestShells || options.shells > mostShells)
  {
    throw UsageError("--shells: " + std::to_string(options.shells) + ", need " + std::to_string(fewestShells) + " to " +
                     std::to_string(mostShells));
  }
  if (options.padding < 0 || options.padding > largestPadding)
  {
    throw UsageError("--padding: " + std::to_string(options.padding) + ", need 0 to " + std::to_string(largestPadding));
  }
  if (options.padding > 0 && options.stage != "exact")
  {
    throw UsageError("--padding needs --stage exact");
  }
  if (!(options.maximumRepairPercent >= 0.0 && options.maximumRepairPercent <= 100.0))
  {
    throw UsageError("--max-repair: " + std::to_string(options.maximumRepairPercent) + ", need 0 to 100 per cent");
  }
  if (!options.density.empty() && options.stage != "exact")
  {
    throw UsageError("--density needs --stage exact");
  }
  requireUsableTemplate(options);
  if (options.way && options.stage != "exact")
  {
    throw UsageError("--way needs --stage exact; the other stages are always made the faithful way");
  }
}

void
requireUsed(const MeshCommandOptions & options)
{
  if (options.templateMesh.empty() && options.align != MeshCommandOptions{}.align)
  {
    throw UsageError("--align needs --template: it says how a template is brought to the label");
  }
  if (options.transformFile.empty())
  {
    return;
  }
  if (!isWrittenTransformName(options.transformFile))
  {
    throw UsageError(
      fileMessage(options.transformFile, "not the name of a transform's text", "give a .tfm or .txt file"));
  }
  if (options.templateMesh.empty() || (options.align != "rigid" && options.align != "affine"))
  {
    throw UsageError("--write-transform needs --template and --align rigid or affine, which find the transform");
  }
}

std::string
wayOf(const MeshCommandOptions & options)
{
  return options.way.value_or("fast");
}

} // namespace moserhex::app
