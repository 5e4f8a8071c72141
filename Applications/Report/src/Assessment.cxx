#include "Assessment.h"

#include "HtmlText.h"

#include <algorithm>
#include <cmath>

namespace moserhex::app
{
namespace
{

using Reasons = std::vector<Assessment::Reason>;

const StageQuality *
lastQuality(const RunReport & report)
{
  const StageQuality * last = nullptr;
  for (const StageRecord & stage : report.stages)
  {
    last = stage.quality ? &*stage.quality : last;
  }
  return last;
}

void
judgeExactness(const RunReport & report, Reasons & reasons)
{
  if (!report.exact)
  {
    const StageQuality * quality = lastQuality(report);
    const bool           hasConcave = quality && quality->concavePercent > 0.0;
    reasons.push_back(
      { hasConcave ? Trust::DoNotUse : Trust::LookAtIt,
        "The run ended on purpose before the exact stage (--stage " + report.parameters.stage +
          "): cells differ in volume and are not certified" +
          (hasConcave ? ", and " + shortNumber(quality->concavePercent) + " % of them are concave." : ".") });
    return;
  }
  if (report.exact->certified)
  {
    reasons.push_back({ Trust::Trust, "No cell is turned inside out anywhere: certified in whole cells." });
  }
  else
  {
    reasons.push_back({ Trust::DoNotUse,
                        std::to_string(report.exact->uncertifiedCells) +
                          " cells are not certified: they may be turned inside out somewhere." });
  }
  if (report.exact->reached)
  {
    reasons.push_back({ Trust::Trust,
                        std::string("Every cell has the same ") + equalMeasureOf(report).singular + " (variance " +
                          shortNumber(report.exact->variance, 2) + ")." });
  }
  for (const std::string & shortcoming : report.exact->shortcomings)
  {
    reasons.push_back({ Trust::LookAtIt, "Not exact: " + shortcoming + "." });
  }
}

void
judgeConditioning(const RunReport & report, Reasons & reasons)
{
  if (!report.conditioning)
  {
    return;
  }
  const RunReport::Conditioning & conditioning = *report.conditioning;
  const std::string               changed = shortNumber(conditioning.changedPercent, 2) + " % of its voxels";
  if (conditioning.changes.empty())
  {
    reasons.push_back({ Trust::Trust, "The label was one solid without cavities and handles: nothing was repaired." });
  }
  else if (conditioning.changedPercent > muchRepair)
  {
    reasons.push_back({ Trust::LookAtIt, "The repair of the label changed " + changed + ": see where, below." });
  }
  else
  {
    reasons.push_back({ Trust::Trust, "The repair of the label changed little, " + changed + "." });
  }
  const bool isFar = conditioning.dice < littleDice;
  reasons.push_back({ isFar ? Trust::LookAtIt : Trust::Trust,
                      "The smoothed solid overlaps the label with a Dice coefficient of " +
                        fixedNumber(conditioning.dice, 4) +
                        (isFar ? ", less than " + shortNumber(littleDice) + "." : ".") });
}

void
judgeShape(const RunReport & report, Reasons & reasons)
{
  if (report.conditioning && report.input.volume > 0.0)
  {
    const RunReport::Conditioning & conditioning = *report.conditioning;
    const double                    change =
      (static_cast<double>(conditioning.voxelsAdded) - static_cast<double>(conditioning.voxelsRemoved)) *
      conditioning.voxelVolume;
    const double error = 100.0 * (report.mesh.volume / (report.input.volume + change) - 1.0);
    const bool   isLarge = std::abs(error) > muchVolumeError;
    reasons.push_back({ isLarge ? Trust::LookAtIt : Trust::Trust,
                        "The mesh has " + fixedNumber(report.mesh.volume / 1000.0, 3) + " mL, the label as meshed " +
                          fixedNumber((report.input.volume + change) / 1000.0, 3) + " mL" +
                          (isLarge ? ": " + shortNumber(error) + " % off." : ".") });
  }
  if (report.surface)
  {
    const bool isFar = report.surface->maximum > report.input.spacing.maxCoeff();
    reasons.push_back({ isFar ? Trust::LookAtIt : Trust::Trust,
                        "The surface of the mesh is within " + fixedNumber(report.surface->maximum, 2) +
                          " mm of the smoothed label's" + (isFar ? ", more than the longest side of a voxel." : ".") });
  }
}

} // namespace

Assessment
assess(const RunReport & report)
{
  Assessment assessment;
  if (report.failure)
  {
    assessment.reasons.push_back(
      { Trust::DoNotUse,
        std::string("There is no mesh: ") + report.failure->message + " [" + nameOf(report.failure->code) + "]" });
  }
  else
  {
    judgeExactness(report, assessment.reasons);
    judgeConditioning(report, assessment.reasons);
    judgeShape(report, assessment.reasons);
  }
  for (const std::string & warning : report.warnings)
  {
    assessment.reasons.push_back({ Trust::LookAtIt, "Warning: " + warning });
  }
  std::stable_sort(assessment.reasons.begin(),
                   assessment.reasons.end(),
                   [](const Assessment::Reason & a, const Assessment::Reason & b) { return a.trust > b.trust; });
  assessment.trust = assessment.reasons.empty() ? Trust::Trust : assessment.reasons.front().trust;
  return assessment;
}

const char *
nameOf(Trust trust)
{
  switch (trust)
  {
    case Trust::Trust:
      return "Trust";
    case Trust::LookAtIt:
      return "Look at it";
    case Trust::DoNotUse:
      return "Do not use";
  }
  return "";
}

} // namespace moserhex::app
