#pragma once

#include "moserhex/Common/Types.h"

#include <optional>
#include <string>
#include <vector>

namespace moserhex
{

/** An axis-aligned box in cube coordinates [0,1]^3. */
struct CubeBox
{
  Vector3 lower{ Vector3::Zero() }; ///< [1]
  Vector3 upper{ Vector3::Ones() }; ///< [1]
};

/** A part of the cube, the same place in every subject and at every time: a box, or one without another inside it. */
struct CubeRegion
{
  std::string            name;    ///< for people and tables, as "shell-3"
  CubeBox                box;     ///< the region, but for `without`
  std::optional<CubeBox> without; ///< within box
};

/** \throws InvalidInput  unless 0 <= lower < upper <= 1 along every axis, of the box and of what is taken out of it,
 * and this lies within the box; names the region */
void
requireValid(const CubeRegion & region);

/** The whole organ. */
[[nodiscard]] CubeRegion
wholeRegion();

/** Eight, named by the sides of the patient that indices lead to: right-anterior-inferior, left-anterior-inferior,
 * right-posterior-inferior, ... left-posterior-superior; i fastest. They fill the cube. */
[[nodiscard]] std::vector<CubeRegion>
octantRegions();

/** Six, each half of the cube at one of its faces: right, left, anterior, posterior, inferior, superior. */
[[nodiscard]] std::vector<CubeRegion>
halfRegions();

/** shell-1 in the middle to shell-N, one cell thick, N = n/2; they fill the cube.
 * \throws InvalidInput  n < 2 */
[[nodiscard]] std::vector<CubeRegion>
shellRegions(int nodesPerSide);

/** How much of each cell lies in the region, by volume in the cube: 1 inside, 0 outside, between where it is cut.
 * As in an exact mesh all cells have one volume, the sum over a cell's own volume is the region's, and regions that
 * fill the cube add up to the organ for every n, also where a plane of theirs goes through cells. \return (n-1)^3 in
 * the order of the cells, in [0,1] [1] \throws InvalidInput  as requireValid, n < 2 */
[[nodiscard]] std::vector<double>
cellFractions(const CubeRegion & region, int nodesPerSide);

/** How much of each boundary quadrilateral lies in the region, by area in the cube: 0 unless the region reaches that
 * face of the cube. \return 6 (n-1)^2 in the order of boundaryQuads, in [0,1] [1]
 * \throws InvalidInput  as requireValid, n < 2 */
[[nodiscard]] std::vector<double>
quadFractions(const CubeRegion & region, int nodesPerSide);

/** Number, from 1, of the first region that holds more than half of each cell; 0 where none does.
 * \return (n-1)^3 \throws InvalidInput  as cellFractions */
[[nodiscard]] std::vector<int>
regionOfCells(const std::vector<CubeRegion> & regions, int nodesPerSide);

} // namespace moserhex
