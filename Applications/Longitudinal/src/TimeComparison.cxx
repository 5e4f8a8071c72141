#include "TimeComparison.h"

#include "moserhex/Deformation/LatticeLines.h"

#include <algorithm>

namespace moserhex::app
{
namespace
{

double
volumeOf(const HexMesh & mesh)
{
  double sum = 0.0;
  for (const double volume : cellVolumes(mesh))
  {
    sum += volume;
  }
  return sum;
}

Positions
differences(const Positions & after, const Positions & before)
{
  Positions result;
  result.reserve(after.size());
  for (std::size_t node = 0; node < after.size(); ++node)
  {
    result.push_back(after[node] - before[node]);
  }
  return result;
}

} // namespace

TimeComparison
compareWithBaseline(const HexMesh & baseline, const HexMesh & followUp, AlignmentKind align, unsigned int threads)
{
  return compareWithBaseline(baseline, followUp, latticeAlignment(followUp, baseline, align), threads);
}

TimeComparison
compareWithBaseline(const HexMesh &             baseline,
                    const HexMesh &             followUp,
                    const SimilarityTransform & alignment,
                    unsigned int                threads)
{
  TimeComparison result;
  result.alignment = alignment;
  result.mesh = transformed(followUp, result.alignment);
  result.displacement = displacements(baseline, result.mesh);
  result.cells = cellDeformation(baseline, result.mesh, threads);
  result.surface = surfaceMotion(baseline, result.mesh, threads);
  result.thickness = latticeLineLengths(result.mesh);
  result.thicknessChange = differences(result.thickness, latticeLineLengths(baseline));
  result.latticeVolume = volumeOf(followUp);
  result.latticeVolumeChange = 100.0 * (result.latticeVolume / volumeOf(baseline) - 1.0);
  return result;
}

TimeComparison
unchanged(const HexMesh & baseline, unsigned int threads)
{
  TimeComparison    result = compareWithBaseline(baseline, baseline, AlignmentKind::None, threads);
  CellDeformation & cells = result.cells;
  std::fill(cells.gradient.begin(), cells.gradient.end(), Matrix3::Identity());
  std::fill(cells.strain.begin(), cells.strain.end(), CellStrain{});
  return result;
}

} // namespace moserhex::app
