#include "SampleCommand.h"

#include "SampleProstate.h"
#include "moserhex/HexMeshIO/LabelImageWriter.h"

#include <cstdio>
#include <filesystem>

namespace moserhex::app
{
namespace
{

void
makeFolder(const std::string & folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder))
  {
    throw IOError(
      ErrorCode::CannotCreate, folder, "cannot make the folder (" + error.message() + ")", "choose another place");
  }
}

} // namespace

void
runSampleCommand(const std::string & folder, bool quiet)
{
  makeFolder(folder);
  const SampleProstate sample = makeSampleProstate();
  const auto           write = [&folder, quiet](const char * name, const LabelVolume & labels, const char * what) {
    const std::string path = (std::filesystem::path(folder) / name).string();
    writeLabelImage(path, labels);
    if (!quiet)
    {
      const double millilitres = static_cast<double>(voxelCount(labels)) * labels.voxelVolume() / 1000.0;
      std::printf("%s  %.1f mL  %s\n", path.c_str(), millilitres, what);
    }
  };
  write("prostate.nrrd", sample.gland, "label 1: gland");
  write("prostate_zones.nrrd", sample.zones, "label 1: peripheral zone, label 2: transition zone");
  write("prostate_followup.nrrd", sample.followUp, "label 1: gland, later visit");
}

} // namespace moserhex::app
