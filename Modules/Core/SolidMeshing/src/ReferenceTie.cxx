#include "ReferenceTie.h"

#include "FrameSearch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

namespace moserhex
{
namespace
{

struct TieWeights
{
  double reference; ///< w_r [1]
  double boundary;  ///< w_b [1]
};

/** From a lattice that is hardly bent, its boundary nodes nearest to their places, to one that is hardly held. */
constexpr std::array<TieWeights, 7> tieWeights{
  { { 10.0, 40.0 }, { 10.0, 10.0 }, { 10.0, 3.0 }, { 10.0, 0.0 }, { 2.0, 0.0 }, { 0.5, 0.0 }, { 0.1, 0.0 } }
};

/** A boundary that its places pull off the surface is to stay within this part of a mean cell's edge of it [1]. */
constexpr double closeInEdges = 0.5;

/** A boundary that is far from the surface comes to it slowly, and the lattice with it: it tangles less. */
std::vector<EqualisationStage>
slowStages()
{
  return { { 0.05, 20.0, 2.0, 60 }, { 0.05, 20.0, 10.0, 60 }, { 0.05, 20.0, 40.0, 60 }, { 0.02, 50.0, 80.0, 60 } };
}

} // namespace

ReferenceTie::ReferenceTie(const Positions &           reference,
                           double                      volume,
                           const CellMeasure &         measure,
                           const EqualisationOptions & options)
  : m_Volume(volume), m_Measure(measure), m_Options(options), m_Tolerances{ options.surfaceTolerance }
{
  m_Options.ties = {};
  m_Options.ties.reference = reference;
  const double cells = std::pow(std::cbrt(static_cast<double>(reference.size())) - 1.0, 3.0);
  const double close = closeInEdges * std::cbrt(volume / cells);
  if (close < options.surfaceTolerance)
  {
    m_Tolerances.insert(m_Tolerances.begin(), close);
  }
}

EqualisationResult
ReferenceTie::tied(const HexMesh & start, const SignedDistance & phi, const ProgressCallback & progress)
{
  EqualisationResult result;
  for (std::size_t t = 0; t < m_Tolerances.size() && !result.exact; ++t)
  {
    m_Options.surfaceTolerance = m_Tolerances[t];
    result = tiedWithinTolerance(start, phi, progressOfPart(progress, t, m_Tolerances.size()));
  }
  reportProgress(progress, 1.0);
  return result;
}

std::optional<EqualisationResult>
ReferenceTie::drawn(const HexMesh & exact, const SignedDistance & phi, const ProgressCallback & progress)
{
  std::optional<EqualisationResult> result;
  for (std::size_t t = 0; t < m_Tolerances.size() && !result; ++t)
  {
    m_Options.surfaceTolerance = m_Tolerances[t];
    result = drawnWithinTolerance(exact, phi, progressOfPart(progress, t, m_Tolerances.size()));
  }
  reportProgress(progress, 1.0);
  return result;
}

EqualisationResult
ReferenceTie::tiedWithinTolerance(const HexMesh & start, const SignedDistance & phi, const ProgressCallback & progress)
{
  const std::vector<EqualisationStage> usual = std::exchange(m_Options.directStages, slowStages());
  EqualisationResult                   best = attempt(start, phi, 0, progressOfPart(progress, 0, tieWeights.size()));
  std::size_t                          weights = 0;
  while (!best.exact && ++weights < tieWeights.size())
  {
    EqualisationResult weaker = attempt(start, phi, weights, progressOfPart(progress, weights, tieWeights.size()));
    if (isBetter(weaker, best))
    {
      best = std::move(weaker);
    }
  }
  m_Options.directStages = usual;
  for (bool isExact = best.exact; isExact && weights-- > 0;)
  {
    EqualisationResult stronger = attempt(best.mesh, phi, weights, {});
    isExact = stronger.exact;
    if (isExact)
    {
      best = std::move(stronger);
    }
  }
  return best;
}

std::optional<EqualisationResult>
ReferenceTie::drawnWithinTolerance(const HexMesh & exact, const SignedDistance & phi, const ProgressCallback & progress)
{
  std::optional<EqualisationResult> best;
  bool                              isExact = true;
  for (std::size_t weights = tieWeights.size(); isExact && weights-- > 0;)
  {
    EqualisationResult stronger = attempt(best ? best->mesh : exact,
                                          phi,
                                          weights,
                                          progressOfPart(progress, tieWeights.size() - 1 - weights, tieWeights.size()));
    isExact = stronger.exact;
    if (isExact)
    {
      best = std::move(stronger);
    }
  }
  return best;
}

EqualisationResult
ReferenceTie::attempt(const HexMesh &          start,
                      const SignedDistance &   phi,
                      std::size_t              weights,
                      const ProgressCallback & progress)
{
  m_Options.ties.referenceWeight = tieWeights[weights].reference;
  m_Options.ties.boundaryWeight = tieWeights[weights].boundary;
  EqualisationResult result = equaliseMeasures(start, phi, m_Volume, m_Measure, m_Volume, m_Options, progress);
  std::ostringstream text;
  text << "weights " << m_Options.ties.referenceWeight << ", " << m_Options.ties.boundaryWeight << ": "
       << (result.exact ? "exact" : "not exact");
  if (m_Tolerances.size() > 1)
  {
    text << " within " << m_Options.surfaceTolerance << " mm";
  }
  m_Attempts.push_back(text.str());
  return result;
}

} // namespace moserhex
