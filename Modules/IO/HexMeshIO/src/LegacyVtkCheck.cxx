#include "LegacyVtkCheck.h"

#include "FileText.h"
#include "ImageHeader.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>

namespace moserhex
{
namespace
{

/** Every number takes two bytes at least. */
void
requireHonestKeywords(const std::string & fileName)
{
  std::ifstream     file(fileName, std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  for (const char * keyword : { "POINTS ",
                                "VERTICES ",
                                "LINES ",
                                "POLYGONS ",
                                "TRIANGLE_STRIPS ",
                                "CELLS ",
                                "CELL_TYPES ",
                                "POINT_DATA ",
                                "CELL_DATA " })
  {
    const std::size_t found = bytes.find(std::string("\n") + keyword);
    if (found == std::string::npos)
    {
      continue;
    }
    const std::string line = bytes.substr(found + 1, std::min<std::size_t>(bytes.find('\n', found + 1) - found, 200));
    const auto        words = wordsOf(line);
    for (std::size_t word = 1; word < words.size() && std::isdigit(static_cast<unsigned char>(words[word][0])); ++word)
    {
      if (words[word].size() > 12 || std::stoull(words[word]) > bytes.size() / 2)
      {
        throw BadInput(ErrorCode::Truncated,
                       fileName,
                       "the header promises more than the file holds: " + line.substr(0, 60),
                       copyAgain);
      }
    }
  }
}

std::uint64_t
nextCellNumber(FileText & text, bool binary)
{
  if (!binary)
  {
    return text.nextNumber<std::uint64_t>("a number of the cells");
  }
  std::uint64_t value = 0;
  for (int byte = 0; byte < 4; ++byte)
  {
    value = 256 * value + text.nextBinary<std::uint8_t>("a number of the cells"); // big-endian
  }
  return value;
}

/** Files before version 5 list every cell as its number of points and these points. VTK takes a version that it cannot
 * read for an old one, whatever follows. */
void
requireHonestCells(const std::string & fileName)
{
  FileText          text(fileName, copyAgain);
  const std::string version(text.nextLine());
  int               major = 0;
  int               minor = 0;
  if (std::sscanf(version.c_str(), "# vtk DataFile Version %d.%d", &major, &minor) != 2)
  {
    text.refuse("not a readable VTK mesh or surface (no version in the first line)");
  }
  (void)text.nextLine(); // the title
  const bool             binary = lowerCase(std::string(text.peekWord())) == "binary";
  constexpr const char * cellsKeyword = "\nCELLS ";
  if (major >= 5 || !text.contains(cellsKeyword))
  {
    return;
  }
  text.skipBehind(cellsKeyword);
  const auto cells = text.nextNumber<std::uint64_t>("the number of cells");
  auto       left = text.nextNumber<std::uint64_t>("the size of the list of cells");
  (void)text.nextLine();
  for (std::uint64_t cell = 0; cell < cells; ++cell)
  {
    const std::uint64_t points = left > 0 ? nextCellNumber(text, binary) : 0;
    if (left == 0 || points > left - 1)
    {
      text.refuse("cell " + std::to_string(cell) + " goes beyond the list of cells");
    }
    for (std::uint64_t point = 0; point < points; ++point)
    {
      (void)nextCellNumber(text, binary);
    }
    left -= points + 1;
  }
  if (left > 0)
  {
    text.refuse(std::to_string(left) + " numbers too many in the list of cells");
  }
}

} // namespace

void
requireHonestCounts(const std::string & fileName)
{
  requireHonestKeywords(fileName);
  requireHonestCells(fileName);
}

} // namespace moserhex
