#pragma once

#include "moserhex/HexMeshIO/FieldImageReader.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"
#include "moserhex/HexMeshIO/ScalarImageReader.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace moserhex
{

/** What a file says in its header, for voxels that are in memory already. */
struct ArrayHeader
{
  std::string                  name;                           ///< of the array, in messages
  std::array<std::uint64_t, 3> size{ { 0, 0, 0 } };            ///< voxels along each axis
  Matrix3                      columns{ Matrix3::Identity() }; ///< steps of the three indices [mm, LPS]
  Vector3                      origin{ Vector3::Zero() };      ///< centre of voxel (0,0,0) [mm, LPS]
};

/** \throws BadInput  Empty, TooBig, Geometry: the limits that files have */
void
requireValid(const ArrayHeader & header);

/** The header's voxels; axes that are at right angles but for rounding are made so. \throws BadInput  as requireValid
 */
[[nodiscard]] VoxelGrid
voxelGridFrom(const ArrayHeader & header);

/** A labelmap in memory, judged as readLabelImage judges one in a file: which values are labels, how many there may
 * be, the same limits of size and geometry, the same warnings.
 *
 * \param voxels  in the order of the voxel numbers, i fastest. TVoxel: the integers of 8 to 64 bits, float, double
 * \throws BadInput      as requireValid(header); Labels, EmptyLabel
 * \throws InvalidInput  the number of voxels is not the product of the sizes */
template <typename TVoxel>
[[nodiscard]] LabelImage
labelImageFrom(const ArrayHeader & header, const std::vector<TVoxel> & voxels);

/** A scalar image in memory, judged as readScalarImage judges one in a file.
 * \throws BadInput      as requireValid(header)
 * \throws InvalidInput  the number of values is not the product of the sizes */
[[nodiscard]] ScalarImage
scalarImageFrom(const ArrayHeader & header, const std::vector<double> & values);

/** An image of several values per voxel in memory, judged as readFieldImage judges one in a file. Its values are taken
 * to be in LPS.
 * \param components  1 to 4096 \param values  a voxel's together
 * \throws BadInput      as requireValid(header), also with `components` values per voxel; PixelType: too many
 * \throws InvalidInput  the number of values is not the product of sizes and components */
[[nodiscard]] FieldImage
fieldImageFrom(const ArrayHeader & header, int components, std::vector<double> values);

} // namespace moserhex
