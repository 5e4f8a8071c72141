#include "BatchFolder.h"

#include "moserhex/HexMeshIO/LabelImageWriter.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;

LabelVolume
ellipsoid(int number)
{
  constexpr int size = 16;
  LabelVolume   label;
  label.size = { { size, size, size } };
  label.spacing.x() = 1.0 + 0.001 * number; // no two are alike
  const double a = 5.0 + 0.2 * (number % 10);
  const double b = 5.0 + 0.2 * (number / 10 % 10);
  const double c = 6.0;
  for (int voxel = 0; voxel < size * size * size; ++voxel)
  {
    const double x = (voxel % size - 7.5) / a;
    const double y = (voxel / size % size - 7.5) / b;
    const double z = (voxel / size / size - 7.5) / c;
    label.inside.push_back(x * x + y * y + z * z <= 1.0 ? 1 : 0);
  }
  return label;
}

std::string
threeDigits(int number)
{
  const std::string digits = std::to_string(number);
  return std::string(3 - std::min<std::size_t>(digits.size(), 3), '0') + digits;
}

} // namespace

void
BatchFolder::SetUp()
{
  CommandTest::SetUp();
  fs::create_directory(path("in"));
}

void
BatchFolder::writeSolids(int count) const
{
  for (int number = 1; number <= count; ++number)
  {
    writeLabelImage(path("in/case-" + threeDigits(number) + ".nrrd"), ellipsoid(number));
  }
}

void
BatchFolder::writeBadFile(const std::string & name) const
{
  std::ofstream(path("in/" + name)) << "NRRD0004\nno header\n";
}

void
BatchFolder::writeFaultyProgram(const std::map<std::string, std::string> & faults) const
{
  const std::string name = path("faulty.sh");
  {
    std::ofstream script(name);
    script << "#!/bin/sh\ncase \"$*\" in\n";
    for (const auto & [piece, commands] : faults)
    {
      script << "*" << piece << "*) " << commands << " ;;\n";
    }
    script << "esac\nexec " << MOSERHEX_EXECUTABLE << " \"$@\"\n";
  }
  fs::permissions(name, fs::perms::owner_all);
}

std::vector<std::string>
BatchFolder::batchArguments(const std::vector<std::string> & more, const std::string & out) const
{
  std::vector<std::string> arguments{ "batch",    path("in"), "--output",       path(out),
                                      "--shells", "2",        "--reproducible", "--quiet" };
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

Outcome
BatchFolder::batch(const std::vector<std::string> & more, const std::string & out) const
{
  return run(batchArguments(more, out));
}

std::map<std::string, std::string>
BatchFolder::treeOf(const std::string & out) const
{
  std::map<std::string, std::string> tree;
  for (const fs::directory_entry & entry : fs::recursive_directory_iterator(path(out)))
  {
    const std::string name = fs::relative(entry.path(), path(out)).string();
    const bool        isOwn = name.compare(0, 8, "journal.") == 0 || name.compare(0, 5, ".lock") == 0;
    if (entry.is_regular_file() && !isOwn)
    {
      std::string text = contentOf(entry.path());
      // Reports name the folder that they were written to.
      for (std::size_t at = 0; (at = text.find(path(out) + "/", at)) != std::string::npos;)
      {
        text.erase(at, path(out).size() + 1);
      }
      tree[name] = text;
    }
  }
  return tree;
}

testing::AssertionResult
sameTree(const std::map<std::string, std::string> & tree, const std::map<std::string, std::string> & other)
{
  for (const auto & [name, bytes] : tree)
  {
    if (other.count(name) == 0)
    {
      return testing::AssertionFailure() << name << " is in the first only";
    }
    const std::string & others = other.at(name);
    if (bytes != others)
    {
      const auto at = static_cast<std::size_t>(
        std::mismatch(bytes.begin(), bytes.end(), others.begin(), others.end()).first - bytes.begin());
      const std::size_t from = at < 40 ? 0 : at - 40;
      return testing::AssertionFailure() << name << " differs at byte " << at << ": ..." << bytes.substr(from, 80)
                                         << "... and ..." << others.substr(from, 80) << "...";
    }
  }
  return tree.size() == other.size() ? testing::AssertionSuccess()
                                     : testing::AssertionFailure() << "the second has more files";
}

std::map<std::string, int>
BatchFolder::doneEntries(const std::string & out) const
{
  std::map<std::string, int> entries;
  std::istringstream         lines(contentOf(path(out) + "/journal.jsonl"));
  for (std::string line; std::getline(lines, line);)
  {
    const std::string begin = "{\"case\":\"";
    const std::size_t at = line.find(begin);
    if (at != std::string::npos && line.find("\"status\":\"done\"") != std::string::npos && line.back() == '}')
    {
      const std::size_t name = at + begin.size();
      ++entries[line.substr(name, line.find('"', name) - name)];
    }
  }
  return entries;
}

std::size_t
BatchFolder::filesWithEnding(const std::string & out, const std::string & ending) const
{
  std::size_t     count = 0;
  std::error_code ignored;
  for (const fs::directory_entry & entry : fs::recursive_directory_iterator(path(out), ignored))
  {
    const std::string name = entry.path().filename().string();
    count += name.size() >= ending.size() && name.compare(name.size() - ending.size(), ending.size(), ending) == 0 &&
                 name.front() != '.'
               ? 1
               : 0;
  }
  return count;
}

} // namespace moserhex::app
