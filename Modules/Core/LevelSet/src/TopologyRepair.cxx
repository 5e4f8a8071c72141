#include "moserhex/LevelSet/TopologyRepair.h"

#include "TopologyPatches.h"
#include "VoxelFront.h"
#include "VoxelParts.h"
#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>

namespace moserhex
{
namespace
{

constexpr std::array<TopologyChangeKind, 5> allKinds{ { TopologyChangeKind::ComponentRemoved,
                                                        TopologyChangeKind::ComponentsJoined,
                                                        TopologyChangeKind::CavityFilled,
                                                        TopologyChangeKind::HandleCut,
                                                        TopologyChangeKind::TunnelFilled } };

bool
countsHandles(TopologyChangeKind kind)
{
  return kind == TopologyChangeKind::HandleCut || kind == TopologyChangeKind::TunnelFilled;
}

TopologyChangeKind
kindOf(const detail::TopologyPatch & patch)
{
  if (patch.fills)
  {
    return patch.components > 0 ? TopologyChangeKind::ComponentsJoined : TopologyChangeKind::TunnelFilled;
  }
  return patch.handles > 0 ? TopologyChangeKind::HandleCut : TopologyChangeKind::ComponentRemoved;
}

/** Of all changes; not less than what is different in the end. */
std::size_t
changedVoxels(const TopologyRepairReport & report)
{
  std::size_t voxels = 0;
  for (const TopologyChange & change : report.changes)
  {
    voxels += change.voxels;
  }
  return voxels;
}

Vector3
meanPoint(const VoxelGrid & grid, const std::vector<std::size_t> & voxels)
{
  const auto nx = static_cast<std::size_t>(grid.size[0]);
  const auto ny = static_cast<std::size_t>(grid.size[1]);
  Vector3    sum = Vector3::Zero();
  for (const std::size_t voxel : voxels)
  {
    sum += Vector3(
      static_cast<double>(voxel % nx), static_cast<double>(voxel / nx % ny), static_cast<double>(voxel / (nx * ny)));
  }
  const Vector3 index = sum / static_cast<double>(voxels.size());
  return grid.origin + grid.direction * grid.spacing.cwiseProduct(index);
}

/** Fills the cavities and adds one change for each. */
void
fillCavities(LabelVolume & label, TopologyRepairReport & report)
{
  const detail::Parts             parts = detail::connectedParts(label, false, detail::Adjacency::FacesEdgesAndCorners);
  const std::vector<std::uint8_t> open = detail::partsAtBorder(label, parts);
  std::vector<std::vector<std::size_t>> cavities(open.size());
  for (const detail::Run & run : parts.runs)
  {
    const auto part = static_cast<std::size_t>(run.part);
    for (std::size_t voxel = run.begin; open[part] == 0 && voxel < run.end; ++voxel)
    {
      cavities[part].push_back(voxel);
      label.inside[voxel] = 1;
    }
  }
  for (const std::vector<std::size_t> & cavity : cavities)
  {
    if (!cavity.empty())
    {
      report.changes.push_back({ TopologyChangeKind::CavityFilled, 1, 0, cavity.size(), meanPoint(label, cavity) });
    }
  }
}

/** More would have to change than is allowed: at least this many voxels. */
struct TooMuch
{
  std::size_t voxels;
};

/** What can be said before any work: a voxel that is flipped joins or parts at most 6 components of the inside and 8 of
 * the outside around it, so the sum of components, cavities and handles changes by no more than 5 + 7. */
std::optional<TooMuch>
lowerBound(const VoxelTopology & topology, std::size_t most)
{
  constexpr std::size_t largestStep = 12;
  const std::size_t steps = topology.components - 1 + topology.cavities + static_cast<std::size_t>(topology.handles());
  const std::size_t voxels = (steps + largestStep - 1) / largestStep;
  return voxels > most ? std::optional<TooMuch>({ voxels }) : std::nullopt;
}

/** Makes the patches of one round that do not touch each other. \return TooMuch when not even the smallest may be made
 */
std::optional<TooMuch>
repairRound(LabelVolume & label, detail::PatchThickener & thickener, std::size_t most, TopologyRepairReport & report)
{
  detail::TopologyRound round(label, thickener);
  bool                  any = false;
  for (detail::TopologyPatch & patch : round.patches())
  {
    const std::size_t voxels = changedVoxels(report) + patch.voxels.size();
    if (voxels > most)
    {
      return any ? std::nullopt : std::optional<TooMuch>({ voxels });
    }
    if (!round.mustWait(patch) && round.make(patch))
    {
      any = true;
      report.changes.push_back({ kindOf(patch),
                                 static_cast<std::size_t>(patch.components),
                                 static_cast<std::size_t>(patch.handles),
                                 patch.voxels.size(),
                                 meanPoint(label, patch.voxels) });
    }
  }
  if (!any)
  {
    throw Error(ErrorCode::Internal, "topology repair: no patch makes the topology simpler"); // against (A1b)
  }
  return std::nullopt;
}

/** Repairs with one radius. */
std::optional<TooMuch>
repairInPlace(LabelVolume & label, double radius, std::size_t most, TopologyRepairReport & report)
{
  detail::PatchThickener thickener(label, radius);
  for (;;)
  {
    fillCavities(label, report);
    if (changedVoxels(report) > most)
    {
      return TooMuch{ changedVoxels(report) };
    }
    if (voxelTopology(label).isBall())
    {
      return std::nullopt;
    }
    if (const std::optional<TooMuch> tooMuch = repairRound(label, thickener, most, report))
    {
      return tooMuch;
    }
  }
}

void
requireValid(const TopologyRepairOptions & options)
{
  const auto require = [&](bool good, const std::string & name, double value, const std::string & range) {
    if (!good)
    {
      std::ostringstream message;
      message << options.labelName << ": " << name << " is " << value << ", need " << range;
      throw InvalidInput(message.str());
    }
  };
  require(options.maximumChange >= 0.0 && options.maximumChange <= 1.0,
          "largest repair",
          options.maximumChange,
          "0 to 1 (of the label's volume)");
  require(options.radius >= 0.0 && std::isfinite(options.radius), "radius of the repair [mm]", options.radius, ">= 0");
}

[[noreturn]] void
refuse(const TopologyRepairReport & report, const TooMuch & tooMuch, const TopologyRepairOptions & options)
{
  std::ostringstream message;
  message << std::setprecision(3) << options.labelName << ": " << describe(report.before) << "; a repair changes >= "
          << 100.0 * static_cast<double>(tooMuch.voxels) / static_cast<double>(report.labelVoxels) << " % of it, limit "
          << 100.0 * options.maximumChange << " %";
  throw InvalidInput(ErrorCode::Topology, message.str());
}

void
countDifference(const LabelVolume & before, const LabelVolume & after, TopologyRepairReport & report)
{
  for (std::size_t voxel = 0; voxel < before.inside.size(); ++voxel)
  {
    report.voxelsAdded += before.inside[voxel] < after.inside[voxel] ? 1 : 0;
    report.voxelsRemoved += before.inside[voxel] > after.inside[voxel] ? 1 : 0;
  }
}

/** Copies the box of `source` without its margin to where it was cut out of `target`. */
void
pasteBox(const LabelVolume & source, LabelVolume & target)
{
  const Vector3 first = target.continuousIndex(source.origin);
  const auto    at = [&](int index, int axis) { return index + static_cast<int>(std::lround(first[axis])); };
  for (int k = detail::frontMargin; k < source.size[2] - detail::frontMargin; ++k)
  {
    for (int j = detail::frontMargin; j < source.size[1] - detail::frontMargin; ++j)
    {
      const auto row = source.inside.begin() + static_cast<std::ptrdiff_t>(source.voxelNumber(0, j, k));
      std::copy(row + detail::frontMargin,
                row + source.size[0] - detail::frontMargin,
                target.inside.begin() +
                  static_cast<std::ptrdiff_t>(target.voxelNumber(at(detail::frontMargin, 0), at(j, 1), at(k, 2))));
    }
  }
}

std::string
describe(const TopologyRepairReport & report, TopologyChangeKind kind)
{
  std::size_t            count = 0;
  std::size_t            voxels = 0;
  const TopologyChange * largest = nullptr;
  for (const TopologyChange & change : report.changes)
  {
    if (change.kind == kind)
    {
      count += countsHandles(kind) ? change.handles : change.parts;
      voxels += change.voxels;
      largest = largest == nullptr || change.voxels > largest->voxels ? &change : largest;
    }
  }
  if (largest == nullptr)
  {
    return {};
  }
  const double       volume = static_cast<double>(voxels) * report.voxelVolume;
  const double       percent = 100.0 * static_cast<double>(voxels) / static_cast<double>(report.labelVoxels);
  std::ostringstream text;
  text << count << ' ' << nameOf(kind, count) << ": " << voxels << (voxels == 1 ? " voxel " : " voxels ")
       << (largest->adds() ? "added" : "removed") << std::setprecision(3) << ", " << volume << " mm^3, " << percent
       << " % of the label" << (largest->voxels < voxels ? ", the largest" : "") << " at ";
  text << std::fixed << std::setprecision(1) << largest->centre.x() << ", " << largest->centre.y() << ", "
       << largest->centre.z() << " mm LPS";
  return text.str();
}

} // namespace

std::string
nameOf(TopologyChangeKind kind, std::size_t count)
{
  const bool one = count == 1;
  switch (kind)
  {
    case TopologyChangeKind::ComponentRemoved:
      return one ? "separate part left out" : "separate parts left out";
    case TopologyChangeKind::ComponentsJoined:
      return one ? "separate part joined to the rest" : "separate parts joined to the rest";
    case TopologyChangeKind::CavityFilled:
      return one ? "cavity filled" : "cavities filled";
    case TopologyChangeKind::HandleCut:
      return one ? "handle cut" : "handles cut";
    case TopologyChangeKind::TunnelFilled:
      return one ? "tunnel filled" : "tunnels filled";
  }
  return {};
}

double
TopologyRepairReport::changedFraction() const
{
  return changes.empty() ? 0.0 : static_cast<double>(voxelsAdded + voxelsRemoved) / static_cast<double>(labelVoxels);
}

std::vector<std::string>
describe(const TopologyRepairReport & report)
{
  std::vector<std::string> lines;
  for (const TopologyChangeKind kind : allKinds)
  {
    std::string line = describe(report, kind);
    if (!line.empty())
    {
      lines.push_back(std::move(line));
    }
  }
  return lines;
}

TopologyRepairResult
repairTopology(const LabelVolume & label, const TopologyRepairOptions & options)
{
  requireValid(options);
  requireValid(label, options.labelName);
  TopologyRepairResult result{ label, {} };
  const int            margin = detail::frontMargin;
  const LabelVolume    box = cropAndPad(label, { { margin, margin, margin } });
  result.report.before = voxelTopology(box);
  result.report.labelVoxels = voxelCount(box);
  result.report.voxelVolume = label.voxelVolume();
  if (result.report.before.isBall())
  {
    return result;
  }
  const auto most = static_cast<std::size_t>(options.maximumChange * static_cast<double>(result.report.labelVoxels));
  std::optional<TooMuch> tooMuch = lowerBound(result.report.before, most);
  if (tooMuch)
  {
    refuse(result.report, *tooMuch, options);
  }
  for (const double radius : { options.radius, 0.5 * options.radius, 0.0 })
  {
    LabelVolume          repaired = box;
    TopologyRepairReport report = result.report;
    tooMuch = repairInPlace(repaired, radius, most, report);
    if (!tooMuch)
    {
      pasteBox(repaired, result.label);
      result.report = report;
      countDifference(box, repaired, result.report);
      return result;
    }
    if (options.radius == 0.0)
    {
      break;
    }
  }
  refuse(result.report, *tooMuch, options);
}

std::string
describe(const VoxelTopology & topology)
{
  std::ostringstream text;
  const auto         add = [&](long count, long expected, const char * one, const char * many) {
    if (count != expected)
    {
      text << count << (count == 1 ? one : many) << ", ";
    }
  };
  add(static_cast<long>(topology.components), 1, " component", " components");
  add(static_cast<long>(topology.cavities), 0, " cavity", " cavities");
  add(topology.handles(), 0, " handle", " handles");
  text << "V-E+F = " << topology.surfaceEulerCharacteristic() << ", need 2 (genus 0)";
  return text.str();
}

} // namespace moserhex
