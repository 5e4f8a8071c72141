#include "CorrespondenceParts.h"

#include "moserhex/Analytic/KnownDeformations.h"
#include "moserhex/Correspondence/LandmarkErrors.h"
#include "moserhex/Deformation/WeightedDistribution.h"

#include <algorithm>
#include <iostream>

namespace moserhex::correspondence
{
namespace
{
using results::fixed;

void
writeHeading(std::ostream & os, const std::vector<Way> & ways)
{
  os << "| deformation |";
  for (const Way & way : ways)
  {
    os << ' ' << way.name << ", nodes, median / 95 % (edges) | " << way.name << ", affine part |";
  }
  os << "\n|";
  for (std::size_t column = 0; column < 1 + 2 * ways.size(); ++column)
  {
    os << " --- |";
  }
  os << '\n';
}

/** Largest entry of the difference between the affine parts of what a mesh and a deformation do. */
double
affineError(const HexMesh & baseline, const HexMesh & followUp, const analytic::KnownDeformation & deformation)
{
  Positions expected = baseline.nodes;
  std::transform(expected.begin(), expected.end(), expected.begin(), deformation.forward);
  return (affinePart(baseline.nodes, followUp.nodes) - affinePart(baseline.nodes, expected)).cwiseAbs().maxCoeff();
}

} // namespace

void
writeDeformations(std::ostream & os, const Arguments & arguments)
{
  const std::vector<Way> ways = waysToCorrespond();
  const analytic::Solid  solid = analytic::pearShapedSolid();
  const results::Run     first = meshAlone(results::labelImageOf(solid), arguments.shells);
  const HexMesh &        baseline = first.pipeline->GetHexMesh();
  writeHeading(os, ways);
  for (const analytic::KnownDeformation & deformation : analytic::knownDeformations())
  {
    std::cerr << deformation.name << std::endl;
    const LabelImage label = results::labelImageOf(analytic::deformed(solid, deformation));
    os << "| " << deformation.name << " |";
    for (const Way & way : ways)
    {
      const results::Run         run = meshBy(way, label, baseline);
      const HexMesh &            mesh = run.pipeline->GetHexMesh();
      const std::vector<double>  errors = innerLandmarkErrors(baseline, mesh, deformation.forward);
      const WeightedDistribution spread = *weightedDistribution(errors, std::vector<double>(errors.size(), 1.0));
      const std::string          remark = remarkOn(run);
      os << ' ' << fixed(spread.median, 2) << " / " << fixed(spread.p95, 2)
         << (remark.empty() ? "" : " (" + remark + ")") << " | " << fixed(affineError(baseline, mesh, deformation), 3)
         << " |" << std::flush;
    }
    os << '\n';
  }
}

} // namespace moserhex::correspondence
