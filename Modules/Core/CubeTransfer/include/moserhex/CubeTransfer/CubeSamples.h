#pragma once

#include "moserhex/CubeTransfer/CubePoint.h"
#include "moserhex/LevelSet/FieldVolume.h"

#include <vector>

namespace moserhex
{

/** Options of cubeMeans and cubeVolumes. */
struct CubeMeanOptions
{
  int          samplesPerAxis{ 0 }; ///< N, 1 to 1000; 0: n - 1, the mesh's own cells
  int          pointsPerAxis{ 4 };  ///< Gauss points along each axis of every part of a box in one cell, 2 to 48 [1]
  unsigned int threads{ 0 };        ///< 0: all of the machine's
};

/** Means over the boxes of a cube, with the volumes of these boxes' images in the mesh: mean times volume is the
 * integral over the image. */
struct CubeMeans
{
  FieldVolume         image;   ///< on cubeGrid(Cells, N)
  std::vector<double> volumes; ///< N^3 [mm^3]
};

/** Mean of a function over the image of each of N^3 equal boxes of the cube:
 *
 *   (integral over the box of f det J dc) / (integral over the box of det J dc),       J = dx/dc
 *
 * A box is cut along the faces of the lattice's cells, so det J is smooth in every part, the volumes are exact and sum
 * to the mesh's. N = n - 1 gives cellMeans. Errors as there. The same for any number of threads.
 * \param components  of f, at least 1 \param f  called by several threads at once
 * \throws InvalidInput  as requireLattice(mesh) and cubeGrid; points out of range; a box without positive volume (names
 * it), or what f throws */
[[nodiscard]] CubeMeans
cubeMeans(const HexMesh & mesh, const CubeFunction & f, int components, const CubeMeanOptions & options = {});

/** The volumes of cubeMeans alone [mm^3]. \throws InvalidInput  as there */
[[nodiscard]] std::vector<double>
cubeVolumes(const HexMesh & mesh, const CubeMeanOptions & options = {});

/** A function at every node of the lattice, on cubeGrid(Nodes, n).
 * \throws InvalidInput  as requireLattice(mesh), or what f throws */
[[nodiscard]] FieldVolume
cubeNodeSamples(const HexMesh & mesh, const CubeFunction & f, int components, unsigned int threads = 0);

} // namespace moserhex
