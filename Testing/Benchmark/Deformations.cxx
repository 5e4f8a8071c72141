#include "CorrespondenceParts.h"

#include "moserhex/Analytic/KnownDeformations.h"
#include "moserhex/Correspondence/BoundaryLandmarks.h"
#include "moserhex/Correspondence/LandmarkErrors.h"
#include "moserhex/Deformation/WeightedDistribution.h"

#include <algorithm>
#include <iostream>
#include <iterator>

namespace moserhex::correspondence
{
namespace
{
using results::fixed;

void
writeHeading(std::ostream & os, const std::vector<std::string> & ways)
{
  os << "| deformation |";
  for (const std::string & way : ways)
  {
    os << ' ' << way << ", nodes, median / 95 % (edges) | " << way << ", affine part |";
  }
  os << "\n|";
  for (std::size_t column = 0; column < 1 + 2 * ways.size(); ++column)
  {
    os << " --- |";
  }
  os << '\n';
}

/** One way's cells of a row. */
void
writeWay(std::ostream &                     os,
         const results::Run &               run,
         const HexMesh &                    baseline,
         const analytic::KnownDeformation & deformation)
{
  const HexMesh &            mesh = run.pipeline->GetHexMesh();
  const std::vector<double>  errors = innerLandmarkErrors(baseline, mesh, deformation.forward);
  const WeightedDistribution spread = *weightedDistribution(errors, std::vector<double>(errors.size(), 1.0));
  const std::string          remark = remarkOn(run);
  os << ' ' << fixed(spread.median, 2) << " / " << fixed(spread.p95, 2) << (remark.empty() ? "" : " (" + remark + ")")
     << " | " << fixed(affinePartError(baseline, mesh, deformation.forward), 3) << " |";
}

} // namespace

void
writeDeformations(std::ostream & os, const Arguments & arguments)
{
  std::vector<Way> ways = waysToCorrespond();
  ways.push_back({ "tied, landmarks", true, {} });
  ways.back().options.templateAlignment = TemplateAlignment::None;
  const analytic::Solid    solid = analytic::pearShapedSolid();
  const results::Run       first = meshAlone(results::labelImageOf(solid), arguments.shells);
  const HexMesh &          baseline = first.pipeline->GetHexMesh();
  std::vector<std::string> names;
  std::transform(ways.begin(), ways.end(), std::back_inserter(names), [](const Way & way) { return way.name; });
  names.emplace_back(agreedName);
  writeHeading(os, names);
  for (const analytic::KnownDeformation & deformation : analytic::knownDeformations())
  {
    std::cerr << deformation.name << std::endl;
    const LabelImage label = results::labelImageOf(analytic::deformed(solid, deformation));
    ways.back().options.refinement.landmarks = boundaryLandmarks(baseline, deformation.forward);
    os << "| " << deformation.name << " |";
    const auto writeOrSay = [&os](const std::function<void()> & write) {
      const std::string refusal = refusalOf(write);
      if (!refusal.empty())
      {
        os << ' ' << refusal << " | |";
      }
    };
    for (const Way & way : ways)
    {
      writeOrSay([&] { writeWay(os, meshBy(way, label, baseline), baseline, deformation); });
    }
    writeOrSay([&] {
      const MeshedPair pair = meshByAgreement(results::labelImageOf(solid), label, arguments.shells);
      writeWay(os, pair.second, pair.first.pipeline->GetHexMesh(), deformation);
    });
    os << std::endl;
  }
}

} // namespace moserhex::correspondence
