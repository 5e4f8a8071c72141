#pragma once

#include "moserhex/Common/Types.h"
#include "moserhex/HexMeshIO/NamedArray.h"
#include "moserhex/HexMeshIO/RunReport.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace moserhex::app
{

// What is on record of how a mesh was made: in its file, as an array of the mesh, or in the report beside it (its name
// with the ending .json).

/** Larger files are not reports. */
inline constexpr std::size_t largestReport = std::size_t{ 16 } << 20;

/** How a lattice is turned against the patient's axes, so that indices are not the same places as in other meshes. */
struct LatticeTurn
{
  std::string description; ///< "the lattice is turned by 45 degrees about (0 0 1)"
  /** Axis times angle of latticeTurn(), LPS [degree]; empty: of an older report, which has it in words. */
  std::optional<Vector3> rotation;
};

/** Axis times angle of a rotation [degree]. */
[[nodiscard]] Vector3
rotationVector(const Matrix3 & rotation);

/** The array LatticeTurn of a mesh's file. \param rotation  axis times angle [degree]; zero: no array */
[[nodiscard]] std::vector<NamedArray>
latticeTurnArrays(const Vector3 & rotation);

/** The turn of a mesh by the array LatticeTurn of its file, or else by the report beside it; nothing where neither
 * tells of one. \param meshArrays  of that file */
[[nodiscard]] std::optional<LatticeTurn>
turnOfLattice(const std::string & meshFile, const std::vector<NamedArray> & meshArrays);

/** A mesh file and how its lattice is turned. */
struct TurnOfFile
{
  std::string                file;
  std::optional<LatticeTurn> turn; ///< as turnOfLattice
};

/** A warning of every turned lattice, unless all are turned by the same rotation, as meshes that are tied to one
 * template are: then indices are the same places in all. \param consequence  what that means to the user */
[[nodiscard]] std::vector<std::string>
turnWarnings(const std::vector<TurnOfFile> & meshes, const std::string & consequence);

/** The arrays SmallestGrowth and LargestGrowth of a mesh's file: its cells were free to grow differently.
 * \param smallest, largest  growth of a cell, in parts of the organ's [1] */
[[nodiscard]] std::vector<NamedArray>
localGrowthArrays(double smallest, double largest);

/** What the volumes of a mesh's cells mean. */
struct CellRecord
{
  bool hasLocalGrowth{ false }; ///< they were free to grow differently: SmallestGrowth, LargestGrowth
  bool hasDensity{ false };     ///< they hold equal masses, not equal volumes: MeanDensity
  bool isInexact{ false };      ///< not made equal and valid, by another last stage or as stage J fell short: NotExact
};

/** The array NotExact of a mesh's file. */
[[nodiscard]] std::vector<NamedArray>
notExactArrays();

/** By the arrays of a mesh's file, and by the report beside it. \param meshArrays  of that file */
[[nodiscard]] CellRecord
cellRecordOf(const std::string & meshFile, const std::vector<NamedArray> & meshArrays);

/** The arrays LatticeTurn, SmallestGrowth, LargestGrowth, MeanDensity and NotExact of a mesh, those that apply. */
[[nodiscard]] std::vector<NamedArray>
recordOf(const RunReport & report);

/** What of this is in a mesh's file, or else in the report beside it, for another file of the same mesh. */
[[nodiscard]] std::vector<NamedArray>
recordOf(const std::string & meshFile, const std::vector<NamedArray> & meshArrays);

} // namespace moserhex::app
