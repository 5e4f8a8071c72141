#include "EarlierAtlas.h"

#include "CommandErrors.h"
#include "SameFile.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

#include <filesystem>
#include <fstream>
#include <regex>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;

/** The summary of an atlas that is not complete. */
constexpr const char * begun = "{ \"status\": \"unfinished\" }\n";

bool
isBegun(const fs::path & summary)
{
  std::ifstream file(summary, std::ios::binary);
  std::string   line;
  return std::getline(file, line) && line + "\n" == begun;
}

bool
isAtlasFile(const std::string & name)
{
  const std::regex names(
    R"((mean|(group|regression)(_image)?|mode-\d+-(plus|minus)3)\.vtu|(scores|(group|regression)(_image)?|model_quality)\.csv|)"
    R"((atlas|model)\.json|model\.f64|atlas\.html|(template|mean_image|mean_image_cube|sd_image_cube)\.nrrd)");
  return std::regex_match(name, names);
}

} // namespace

bool
holdsAtlas(const std::string & folder)
{
  std::error_code ignored;
  const fs::path  summary = fs::path(folder) / "atlas.json";
  return fs::exists(summary, ignored) && (fs::exists(fs::path(folder) / "model.json", ignored) || isBegun(summary));
}

void
markAtlasBegun(const std::string & folder)
{
  writeTextFile((fs::path(folder) / "atlas.json").string(), begun);
}

void
requireNoAtlas(const std::string & folder)
{
  if (holdsAtlas(folder))
  {
    throw UsageError(fileMessage(folder, "holds an atlas, whose files would be replaced", "write to another folder"));
  }
}

void
removeEarlierAtlas(const std::string & folder)
{
  if (!holdsAtlas(folder))
  {
    return;
  }
  std::error_code       error;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error))
  {
    if (isAtlasFile(entry->path().filename().string()))
    {
      files.push_back(entry->path());
    }
  }
  for (std::size_t i = 0; !error && i < files.size(); ++i)
  {
    fs::remove(files[i], error);
  }
  if (error)
  {
    throw IOError(ErrorCode::InputOutput,
                  folder,
                  "cannot remove the atlas that is there (" + error.message() + ")",
                  "remove it, or write to another folder");
  }
}

void
requireNotOverwritten(const std::vector<std::string> & files, const std::string & outputFolder)
{
  for (const std::string & file : files)
  {
    const fs::path path = fs::absolute(file);
    if (isAtlasFile(path.filename().string()) && sameFile(path.parent_path().string(), outputFolder))
    {
      throw UsageError(fileMessage(file, "an input that the output would replace", "write to another folder"));
    }
  }
}

} // namespace moserhex::app
