#include "ImageHeader.h"

#include "FileText.h"
#include "ImageFileCheck.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace moserhex
{
namespace
{

namespace fs = std::filesystem;

constexpr std::uint64_t mostVoxels = 500'000'000;

} // namespace

std::string
trimmed(const std::string & text)
{
  const auto begin = text.find_first_not_of(" \t\r\n");
  const auto end = text.find_last_not_of(" \t\r\n");
  return begin == std::string::npos ? std::string() : text.substr(begin, end - begin + 1);
}

std::string
lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  });
  return text;
}

std::vector<std::string>
wordsOf(const std::string & text)
{
  std::istringstream       stream(text);
  std::vector<std::string> result;
  for (std::string word; stream >> word;)
  {
    result.push_back(word);
  }
  return result;
}

std::string
quoted(const std::string & text)
{
  return "'" + oneLine(text, 30) + "'";
}

void
throwHeader(const std::string & file, const std::string & cause)
{
  throw BadInput(ErrorCode::Header, file, cause, correctHeader);
}

std::string
beginningOf(const std::string & file, std::size_t bytes)
{
  std::ifstream   stream(file, std::ios::binary);
  std::error_code unknownSize;
  const auto      present = fs::file_size(file, unknownSize);
  std::string     result(unknownSize ? bytes : std::min<std::uintmax_t>(bytes, present), '\0');
  stream.read(result.data(), static_cast<std::streamsize>(result.size()));
  if (stream.bad() || !stream.is_open())
  {
    throw IOError(ErrorCode::InputOutput,
                  file,
                  std::string("cannot be read (") + std::strerror(errno) + ")",
                  "check the file's permissions");
  }
  result.resize(static_cast<std::size_t>(stream.gcount()));
  return result;
}

std::vector<std::uint64_t>
countsOf(const std::string & file, const std::string & what, const std::string & text)
{
  std::vector<std::uint64_t> counts;
  for (const std::string & word : wordsOf(text))
  {
    constexpr std::size_t longestCount = 20; // digits of 2^64
    std::uint64_t         count = 0;
    if (word.size() > longestCount || word.find_first_not_of("0123456789") != std::string::npos)
    {
      throwHeader(file, what + " holds " + quoted(word) + ", which is not a whole number");
    }
    if (!parseNumber(word, count))
    {
      throw BadInput(ErrorCode::TooBig, file, what + " holds " + quoted(word), exportScalarVolume);
    }
    counts.push_back(count);
  }
  return counts;
}

std::vector<double>
numbersOf(const std::string & file, const std::string & what, const std::string & text, std::size_t count)
{
  // Longer than any number that a program writes, shorter than the libraries' buffers.
  constexpr std::size_t longestNumber = 64;
  const auto            words = wordsOf(text);
  if (words.size() != count)
  {
    throwHeader(file, what + " holds " + std::to_string(words.size()) + " numbers, need " + std::to_string(count));
  }
  std::vector<double> numbers;
  for (const std::string & word : words)
  {
    double value = 0.0;
    if (word.size() > longestNumber || !parseNumber(word, value))
    {
      throwHeader(file, what + " holds " + quoted(word) + ", which is not a number");
    }
    numbers.push_back(value);
  }
  return numbers;
}

void
setVoxels(ImageDescription & image, const std::vector<std::uint64_t> & sizes, ComponentType type, std::uint64_t layers)
{
  std::uint64_t voxels = 1;
  for (std::size_t axis = 0; axis < 4; ++axis)
  {
    const std::uint64_t size = axis < 3 ? sizes.at(axis) : layers;
    if (size == 0)
    {
      throwHeader(image.fileName, "the image has size 0 along an axis");
    }
    if (size > mostVoxels || voxels > mostVoxels / size)
    {
      throw BadInput(ErrorCode::TooBig,
                     image.fileName,
                     "sizes " + std::to_string(sizes[0]) + " x " + std::to_string(sizes[1]) + " x " +
                       std::to_string(sizes[2]) + (layers > 1 ? " x " + std::to_string(layers) : "") + ", at most " +
                       std::to_string(mostVoxels) + " voxels",
                     "crop the image around the label");
    }
    voxels *= size;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    image.grid.size[axis] = static_cast<int>(sizes[axis]);
  }
  image.layers = static_cast<int>(layers);
  image.component = type;
  image.bytesPerComponent = withComponent(type, [](auto zero) { return std::uint64_t{ sizeof(zero) }; });
  image.promisedBytes = voxels * image.bytesPerComponent;
}

void
setDataFile(ImageDescription & image, const std::string & name)
{
  const auto refuse = [&](const std::string & cause) {
    throw BadInput(ErrorCode::Reference,
                   image.fileName,
                   "the voxels' file " + quoted(name) + ' ' + cause,
                   "convert to .nrrd or .mha");
  };
  const auto words = wordsOf(name);
  if (name.empty() || words[0] == "LIST" || name.size() > 250 || name[0] == '.' ||
      name.find_first_of("/\\%:") != std::string::npos)
  {
    refuse("is not one plain name of a file beside the header");
  }
  const fs::path  folder = fs::path(image.fileName).parent_path();
  const fs::path  path = folder / name;
  std::error_code error;
  const auto      status = fs::status(path, error);
  if (!fs::exists(status))
  {
    refuse("is not there");
  }
  if (!fs::is_regular_file(status))
  {
    refuse("is not a regular file");
  }
  if (fs::equivalent(path, image.fileName, error))
  {
    refuse("is the header itself");
  }
  const fs::path target = fs::canonical(path, error).parent_path();
  if (target != fs::canonical(folder.empty() ? fs::path(".") : folder, error) &&
      target != fs::canonical(image.fileName, error).parent_path())
  {
    refuse("is a link that leads out of the header's folder");
  }
  image.dataFile = path.string();
  requireReadableFile(image.dataFile);
}

void
requirePlausibleSize(const ImageDescription & image)
{
  const bool          compressed = image.encoding != VoxelEncoding::Raw && image.encoding != VoxelEncoding::Text;
  const std::uint64_t stored = fs::file_size(image.dataFile);
  const std::uint64_t most = compressed ? deflateLimit * stored : stored;
  if (image.promisedBytes > most)
  {
    throw BadInput(ErrorCode::Truncated,
                   image.fileName,
                   "the header promises " + std::to_string(image.promisedBytes) + " bytes of voxels, which " +
                     std::to_string(stored) + " bytes of file cannot hold",
                   copyAgain);
  }
}

} // namespace moserhex
