#include "moserhex/Deformation/LatticeAlignment.h"

#include "moserhex/Common/Errors.h"

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace moserhex
{
namespace
{

double
volumeOf(const HexMesh & mesh)
{
  const std::vector<double> volumes = cellVolumes(mesh);
  return std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

Vector3
mean(const Positions & points)
{
  return std::accumulate(points.begin(), points.end(), Vector3(Vector3::Zero())) / static_cast<double>(points.size());
}

} // namespace

void
requireComparable(const HexMesh & baseline, const HexMesh & followUp)
{
  requireLattice(baseline);
  requireLattice(followUp);
  if (baseline.nodesPerSide != followUp.nodesPerSide)
  {
    throw InvalidInput("lattices of " + std::to_string(baseline.nodesPerSide) + " and " +
                       std::to_string(followUp.nodesPerSide) + " nodes a side, must have as many");
  }
}

SimilarityTransform
latticeAlignment(const HexMesh & followUp, const HexMesh & baseline, AlignmentKind kind)
{
  requireComparable(baseline, followUp);
  switch (kind)
  {
    case AlignmentKind::None:
      return {};
    case AlignmentKind::Rigid:
      return rigidAlignment(followUp.nodes, baseline.nodes);
    case AlignmentKind::Similarity:
    {
      SimilarityTransform motion = rigidAlignment(followUp.nodes, baseline.nodes);
      const Vector3       from = mean(followUp.nodes);
      const Vector3       to = motion(from); // the mean of the baseline's nodes
      motion.scale = std::cbrt(volumeOf(baseline) / volumeOf(followUp));
      motion.translation = to - motion.scale * (motion.rotation * from);
      return motion;
    }
  }
  return {};
}

HexMesh
transformed(const HexMesh & mesh, const SimilarityTransform & transform)
{
  return { mesh.nodesPerSide, transformed(mesh.nodes, transform), mesh.paddingLayers };
}

Positions
displacements(const HexMesh & baseline, const HexMesh & followUp)
{
  requireComparable(baseline, followUp);
  Positions result;
  result.reserve(baseline.nodes.size());
  for (std::size_t node = 0; node < baseline.nodes.size(); ++node)
  {
    result.push_back(followUp.nodes[node] - baseline.nodes[node]);
  }
  return result;
}

} // namespace moserhex
