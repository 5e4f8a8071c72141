#pragma once

#include <optional>
#include <string>

namespace moserhex::app
{

/** Where a mesh is cut: a plane across a patient's axis, or a layer of the lattice. */
struct SlicePlane
{
  int                   axis{ 2 }; ///< 0 sagittal or i, 1 coronal or j, 2 axial or k
  std::optional<double> position;  ///< of a patient's plane, LPS; nothing: through the middle of the mesh's box [mm]
  std::optional<int>    layer;     ///< of cells of the lattice, from 0
};

/** "axial", "coronal", "sagittal", with ":MM" for a position, or "i:K", "j:K", "k:K" for layer K of the lattice.
 * \throws UsageError  anything else */
[[nodiscard]] SlicePlane
parsePlane(const std::string & text);

} // namespace moserhex::app
