#pragma once

#include "RegionChoice.h"
#include "TimeComparison.h"
#include "moserhex/Deformation/WeightedDistribution.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** What the values of a measure lie on, which is what they are weighted by. */
enum class MeasuredOver
{
  Volume,          ///< of the baseline's cells
  BaselineSurface, ///< its boundary quadrilaterals
  FollowUpSurface  ///< aligned; of what is measured at the follow-up's own nodes
};

/** A number for every cell or for every boundary quadrilateral. */
struct Measure
{
  std::string         name;
  std::string         unit; ///< mm; 1
  MeasuredOver        over{ MeasuredOver::Volume };
  std::vector<double> values; ///< (n-1)^3, or 6 (n-1)^2 of the surface; NaN: no value
};

/** displacement, volumetric, strain_1, strain_2, strain_3, deviatoric_strain and largest_stretch of cells;
 * normal_motion, signed_distance, baseline_signed_distance, thickness_change and area_ratio of the surface: of its
 * nodes the mean around a quadrilateral, of the thickness that along the axis that leads through it, over the lines
 * that cross the organ. */
[[nodiscard]] std::vector<Measure>
measuresOf(const TimeComparison & comparison);

/** A measure in a region at one time. */
struct RegionRow
{
  std::string          set;
  std::string          region;
  std::string          measure;
  std::string          unit;
  WeightedDistribution values;        ///< weights: Measure::over [mm^3 or mm^2]
  double               volume{ 0.0 }; ///< of the region at that time, lattice as it was read [mm^3]
};

/** Every measure of the whole lattice (set "organ") and of each region; those of the surface only where the region has
 * some. \throws InvalidInput  as cellFractions */
[[nodiscard]] std::vector<RegionRow>
regionRows(const HexMesh & baseline, const TimeComparison & comparison, const std::vector<RegionSet> & sets);

} // namespace moserhex::app
