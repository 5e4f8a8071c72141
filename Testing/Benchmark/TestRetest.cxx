#include "CorrespondenceParts.h"

#include "moserhex/Correspondence/LandmarkErrors.h"
#include "moserhex/Correspondence/SurfaceDistance.h"
#include "moserhex/LevelSet/MarchingTetrahedra.h"

#include <algorithm>
#include <iostream>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>

namespace moserhex::correspondence
{
namespace
{
using results::fixed;

constexpr double factorOfSurfaces = 2.0; // of the bound
constexpr double slackOfNodes = 0.5;     // of the bound [mm]

/** What a way makes of the second label. */
struct WayNumbers
{
  WeightedDistribution nodes; ///< from those of A [mm]
  bool                 exact{ false };
};

/** What the table says of a study. */
struct Study
{
  double                                 volume{ 0.0 };      ///< of A [mL]
  double                                 volumeRatio{ 0.0 }; ///< B / A [1]
  WeightedDistribution                   surfaces;           ///< from each other [mm]
  std::vector<std::optional<WayNumbers>> ways;               ///< empty: refused
  std::string                            remarks;

  [[nodiscard]] double
  bound() const
  {
    return factorOfSurfaces * surfaces.median + slackOfNodes;
  }

  /** A mesh that is not exact may lie where its template was, near to it for no good reason: it does not count. */
  [[nodiscard]] bool
  isWithin(std::size_t way) const
  {
    return ways[way] && ways[way]->exact && ways[way]->nodes.median <= bound();
  }
};

/** The last number in a file's name. \throws std::runtime_error  there is none */
std::string
studyNumber(const std::filesystem::path & file)
{
  constexpr const char * digits = "0123456789";
  const std::string      name = results::caseName(file);
  const std::size_t      last = name.find_last_of(digits);
  if (last == std::string::npos)
  {
    throw std::runtime_error(file.string() + ": no study number in the name");
  }
  const std::size_t before = name.find_last_not_of(digits, last);
  const std::size_t first = before == std::string::npos ? 0 : before + 1;
  return name.substr(first, last + 1 - first);
}

std::map<std::string, std::filesystem::path>
filesByStudy(const std::filesystem::path & folder)
{
  std::map<std::string, std::filesystem::path> files;
  for (const auto & file : results::imagesIn(folder, std::numeric_limits<std::size_t>::max()))
  {
    const auto [place, isNew] = files.emplace(studyNumber(file), file);
    if (!isNew)
    {
      throw std::runtime_error(file.string() + " and " + place->second.string() + " have the same study number");
    }
  }
  return files;
}

void
addRemark(const std::string & name, const std::string & remark, std::string & remarks)
{
  if (!remark.empty())
  {
    remarks += (remarks.empty() ? "" : "; ") + name + ": " + remark;
  }
}

bool
isExact(const results::Run & run)
{
  return run.pipeline->GetResult().equalisation->exact;
}

WayNumbers
numbersOf(const results::Run & first, const results::Run & second)
{
  const std::vector<double> distances =
    pointDistances(first.pipeline->GetHexMesh().nodes, second.pipeline->GetHexMesh().nodes);
  return { *weightedDistribution(distances, std::vector<double>(distances.size(), 1.0)),
           isExact(first) && isExact(second) };
}

/** The last way: both labels anew, by what they agree on. */
void
addAgreed(const LabelImage & a, const LabelImage & b, int shells, Study & study)
{
  study.ways.emplace_back();
  std::string       remark;
  const std::string refusal = refusalOf([&] {
    const MeshedPair pair = meshByAgreement(a, b, shells);
    study.ways.back() = numbersOf(pair.first, pair.second);
    remark = remarkOn(pair.second);
  });
  addRemark(std::string("B ") + agreedName, refusal.empty() ? remark : refusal, study.remarks);
}

Study
measure(const LabelImage & a, const LabelImage & b, const std::vector<Way> & ways, int shells)
{
  const results::LabelSolid solidA = results::conditionedSolid(a, shells);
  const results::LabelSolid solidB = results::conditionedSolid(b, shells);
  Study                     study;
  study.volume = solidA.volume / 1000.0;
  study.volumeRatio = solidB.volume / solidA.volume;
  study.surfaces = symmetricSurfaceDistance(marchingTetrahedra(solidA.phi, 0.0), marchingTetrahedra(solidB.phi, 0.0));
  const results::Run first = meshAlone(a, shells);
  addRemark("A", remarkOn(first), study.remarks);
  const HexMesh & mesh = first.pipeline->GetHexMesh();
  for (const Way & way : ways)
  {
    study.ways.emplace_back();
    std::string       remark;
    const std::string refusal = refusalOf([&] {
      const results::Run second = meshBy(way, b, mesh);
      study.ways.back() = numbersOf(first, second);
      remark = remarkOn(second);
    });
    addRemark("B " + way.name, refusal.empty() ? remark : refusal, study.remarks);
  }
  addAgreed(a, b, shells, study);
  return study;
}

void
writeHeading(std::ostream & os, const std::vector<std::string> & ways)
{
  os << "| study | volume of A (mL) | B / A | surfaces, median / 95 % | bound |";
  for (const std::string & way : ways)
  {
    os << ' ' << way << ", median / 95 % | within |";
  }
  os << " remarks |\n|";
  for (std::size_t column = 0; column < 6 + 2 * ways.size(); ++column)
  {
    os << " --- |";
  }
  os << '\n';
}

void
writeStudy(std::ostream & os, const std::string & name, const Study & study)
{
  os << "| " << name << " | " << fixed(study.volume, 1) << " | " << fixed(study.volumeRatio, 3) << " | "
     << fixed(study.surfaces.median, 2) << " / " << fixed(study.surfaces.p95, 2) << " | " << fixed(study.bound(), 2)
     << " |";
  for (std::size_t way = 0; way < study.ways.size(); ++way)
  {
    if (study.ways[way])
    {
      os << ' ' << fixed(study.ways[way]->nodes.median, 2) << " / " << fixed(study.ways[way]->nodes.p95, 2);
    }
    os << " | " << (study.isWithin(way) ? "yes" : "no") << " |";
  }
  os << ' ' << study.remarks << " |" << std::endl;
}

/** Medians of the columns, then how many studies are within the bound. */
void
writeSummary(std::ostream & os, const std::vector<Study> & studies, std::size_t asked, std::size_t ways)
{
  std::vector<double> ratios;
  std::vector<double> surfaces;
  std::vector<double> bounds;
  for (const Study & study : studies)
  {
    ratios.push_back(study.volumeRatio);
    surfaces.push_back(study.surfaces.median);
    bounds.push_back(study.bound());
  }
  os << "| **median** | | " << fixed(results::medianOf(ratios), 3) << " | " << fixed(results::medianOf(surfaces), 2)
     << " | " << fixed(results::medianOf(bounds), 2) << " |";
  std::string counts;
  for (std::size_t way = 0; way < ways; ++way)
  {
    std::vector<double> medians;
    std::size_t         within = 0;
    for (const Study & study : studies)
    {
      if (study.ways[way])
      {
        medians.push_back(study.ways[way]->nodes.median);
      }
      within += study.isWithin(way) ? 1 : 0;
    }
    os << ' ' << fixed(results::medianOf(medians), 2) << " | |";
    counts += " | " + std::to_string(within) + " of " + std::to_string(asked) + " |";
  }
  os << " |\n| **within** | | | | |" << counts << " |\n";
}

} // namespace

void
writeTestRetest(std::ostream & os, const Arguments & arguments)
{
  const auto               first = filesByStudy(arguments.folders[0]);
  const auto               second = filesByStudy(arguments.folders[1]);
  const std::vector<Way>   ways = waysToCorrespond();
  std::vector<Study>       studies;
  std::size_t              asked = 0;
  std::string              alone;
  std::vector<std::string> names;
  std::transform(ways.begin(), ways.end(), std::back_inserter(names), [](const Way & way) { return way.name; });
  names.emplace_back(agreedName);
  writeHeading(os, names);
  for (const auto & [number, file] : first)
  {
    const auto partner = second.find(number);
    if (partner == second.end())
    {
      alone += " " + number;
    }
    else if (asked < arguments.cases)
    {
      ++asked;
      std::cerr << results::caseName(file) << std::endl;
      const std::string refusal = refusalOf([&] {
        studies.push_back(
          measure(readLabelImage(file.string()), readLabelImage(partner->second.string()), ways, arguments.shells));
        writeStudy(os, results::caseName(file), studies.back());
      });
      if (!refusal.empty())
      {
        os << "| " << results::caseName(file) << " | " << refusal << " |\n";
      }
    }
  }
  if (studies.empty())
  {
    throw std::runtime_error("no study of " + arguments.folders[0].string() + " is in " +
                             arguments.folders[1].string() + " and could be measured");
  }
  writeSummary(os, studies, asked, names.size());
  if (!alone.empty())
  {
    os << "\nWithout a partner:" << alone << ".\n";
  }
}

} // namespace moserhex::correspondence
