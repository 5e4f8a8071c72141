#pragma once

#include "Comparison.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** "time-000.vtu", "time-001.vtu", ... */
[[nodiscard]] std::string
meshFileOfTime(std::size_t time);

/** Names of all files that are written to the folder. */
[[nodiscard]] std::vector<std::string>
filesOf(const TimeSeries & series, const std::string & folder);

/** The number of each cell's region, from 1 in its set, 0 where none has more than half of it: Octants, Boxes; of
 * halves, which overlap, one array for each axis, HalvesRightLeft (1, 2), HalvesAnteriorPosterior (3, 4) and
 * HalvesInferiorSuperior (5, 6). Of shells none: files have the array Shell already. */
[[nodiscard]] std::vector<NamedArray>
regionArrays(const std::vector<RegionSet> & sets, int nodesPerSide);

/** Writes the lattice at one time, aligned, with what is measured on it, as .vtu or .vtk.
 *
 * Point data: Displacement (3) [mm], Thickness (3) and ThicknessChange (3) along i, j, k [mm], NaN along the surface;
 * on the boundary, NaN inside: NormalMotion, SignedDistance, BaselineSignedDistance (at the node that was the
 * baseline's) [mm], AreaRatio of the quadrilaterals around the node [1]. Cell data: DetF, Volumetric,
 * DeformationGradient (9, by rows), Strain (6: xx yy zz xy yz xz), PrincipalStrain (3), PrincipalDirection1, 2, 3 (3
 * each), DeviatoricStrain, LargestStretch [1]; regionArrays. \throws IOError; InvalidInput, BadInput  as writeHexMesh,
 * of the name */
void
writeTimeMesh(const std::string & fileName, const Comparison & comparison, std::size_t time);

/** All of them in a folder, and series.pvd, which ParaView opens as a series in time (months, or numbers where months
 * are not known). \throws IOError */
void
writeTimeMeshes(const std::string & folder, const Comparison & comparison);

/** A line with the names of the columns, and one for each time, region and measure. \param separator  ',' or '\t' */
[[nodiscard]] std::string
regionTable(const Comparison & comparison, char separator);

} // namespace moserhex::app
