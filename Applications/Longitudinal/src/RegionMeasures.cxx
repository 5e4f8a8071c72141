#include "RegionMeasures.h"

#include "moserhex/Geometry/HexMeshNumbering.h"

#include <cmath>
#include <functional>

namespace moserhex::app
{
namespace
{

using OfCell = std::function<double(std::size_t)>;

std::vector<double>
forEachCell(const TimeComparison & comparison, const OfCell & value)
{
  std::vector<double> values(comparison.cells.strain.size());
  for (std::size_t cell = 0; cell < values.size(); ++cell)
  {
    values[cell] = value(cell);
  }
  return values;
}

/** Length of the displacement of a cell's centre. */
double
displacementOfCell(const TimeComparison & comparison, std::size_t cell)
{
  Vector3 sum = Vector3::Zero();
  for (const std::size_t node : comparison.mesh.cellNodes(cell))
  {
    sum += comparison.displacement[node];
  }
  return (sum / 8.0).norm();
}

/** Mean of the values of its nodes that have one for each boundary quadrilateral, NaN where none has; value(node, axis
 * across the quadrilateral). */
std::vector<double>
meansAroundQuads(const HexMesh & mesh, const std::function<double(std::size_t, Eigen::Index)> & value)
{
  const std::vector<Quadrilateral> quads = boundaryQuads(mesh);
  const std::size_t                anAxis = quads.size() / 3;
  std::vector<double>              means(quads.size());
  for (std::size_t quad = 0; quad < quads.size(); ++quad)
  {
    double sum = 0.0;
    int    count = 0;
    for (const std::size_t node : quads[quad])
    {
      const double ofNode = value(node, static_cast<Eigen::Index>(quad / anAxis));
      sum += std::isnan(ofNode) ? 0.0 : ofNode;
      count += std::isnan(ofNode) ? 0 : 1;
    }
    means[quad] = sum / count; // 0 / 0 where none has a value
  }
  return means;
}

/** Values of boundary nodes at the places of all nodes. */
std::vector<double>
spread(const SurfaceMotion & surface, const std::vector<double> & values, std::size_t nodes)
{
  std::vector<double> result(nodes, 0.0);
  for (std::size_t b = 0; b < values.size(); ++b)
  {
    result[surface.nodes[b]] = values[b];
  }
  return result;
}

double
weightedSum(const std::vector<double> & weights, const std::vector<double> & values)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    sum += weights[i] * values[i];
  }
  return sum;
}

std::vector<double>
products(const std::vector<double> & a, const std::vector<double> & b)
{
  std::vector<double> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    result[i] = a[i] * b[i];
  }
  return result;
}

/** Weights of what has a value. */
std::vector<double>
weightsOf(const Measure & measure, const std::vector<double> & weights)
{
  std::vector<double> result = weights;
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    result[i] = std::isnan(measure.values[i]) ? 0.0 : result[i];
  }
  return result;
}

} // namespace

std::vector<Measure>
measuresOf(const TimeComparison & comparison)
{
  const auto strain = [&comparison](std::size_t cell) -> const CellStrain & { return comparison.cells.strain[cell]; };
  const auto ofCells = [&comparison](const char * name, const char * unit, const OfCell & value) {
    return Measure{ name, unit, MeasuredOver::Volume, forEachCell(comparison, value) };
  };
  const auto ofNodes = [&comparison](const char * name, MeasuredOver over, const std::vector<double> & values) {
    const std::vector<double> all = spread(comparison.surface, values, comparison.mesh.nodes.size());
    return Measure{ name, "mm", over, meansAroundQuads(comparison.mesh, [&all](std::size_t node, Eigen::Index) {
                      return all[node];
                    }) };
  };
  const auto thickness = [&comparison](std::size_t node, Eigen::Index axis) {
    return comparison.thicknessChange[node][axis];
  };
  return {
    ofCells("displacement", "mm", [&](std::size_t cell) { return displacementOfCell(comparison, cell); }),
    ofCells("volumetric", "1", [&](std::size_t cell) { return comparison.cells.volumetric[cell]; }),
    ofCells("strain_1", "1", [&](std::size_t cell) { return strain(cell).principal[0]; }),
    ofCells("strain_2", "1", [&](std::size_t cell) { return strain(cell).principal[1]; }),
    ofCells("strain_3", "1", [&](std::size_t cell) { return strain(cell).principal[2]; }),
    ofCells("deviatoric_strain", "1", [&](std::size_t cell) { return strain(cell).deviatoric; }),
    ofCells("largest_stretch", "1", [&](std::size_t cell) { return strain(cell).largestStretch; }),
    ofNodes("normal_motion", MeasuredOver::BaselineSurface, comparison.surface.normalMotion),
    ofNodes("signed_distance", MeasuredOver::FollowUpSurface, comparison.surface.signedDistance),
    ofNodes("baseline_signed_distance", MeasuredOver::BaselineSurface, comparison.surface.baselineSignedDistance),
    { "thickness_change", "mm", MeasuredOver::BaselineSurface, meansAroundQuads(comparison.mesh, thickness) },
    { "area_ratio", "1", MeasuredOver::BaselineSurface, comparison.surface.areaRatio },
  };
}

std::vector<RegionRow>
regionRows(const HexMesh & baseline, const TimeComparison & comparison, const std::vector<RegionSet> & sets)
{
  const std::vector<Measure> measures = measuresOf(comparison);
  const std::vector<double>  before = cellVolumes(baseline);
  const double               sizeTakenAway = std::pow(comparison.alignment.scale, 3);
  std::vector<RegionSet>     all{ { "organ", { wholeRegion() }, {} } };
  all.insert(all.end(), sets.begin(), sets.end());
  std::vector<RegionRow> rows;
  for (const RegionSet & set : all)
  {
    for (const CubeRegion & region : set.regions)
    {
      const auto volumes = products(cellFractions(region, baseline.nodesPerSide), before);
      const auto areas = products(quadFractions(region, baseline.nodesPerSide), comparison.surface.area);
      const auto areasAfter = products(areas, comparison.surface.areaRatio);
      const auto weights = [&](MeasuredOver over) -> const std::vector<double> & {
        return over == MeasuredOver::Volume ? volumes : over == MeasuredOver::BaselineSurface ? areas : areasAfter;
      };
      const double volume = weightedSum(volumes, comparison.cells.volumeRatio) / sizeTakenAway;
      for (const Measure & measure : measures)
      {
        if (const auto values = weightedDistribution(measure.values, weightsOf(measure, weights(measure.over))))
        {
          rows.push_back({ set.name, region.name, measure.name, measure.unit, *values, volume });
        }
      }
    }
  }
  return rows;
}

} // namespace moserhex::app
