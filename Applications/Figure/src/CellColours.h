#pragma once

#include "Colours.h"
#include "FigureOptions.h"
#include "moserhex/Geometry/UnstructuredHexMesh.h"

#include <optional>
#include <string>
#include <vector>

namespace moserhex::app
{

/** A mesh that is drawn. */
struct DrawnMesh
{
  UnstructuredHexMesh    cells;
  std::optional<HexMesh> lattice; ///< the same, where it is one
  std::string            fileName;
};

/** \throws BadInput (NotHexahedra)  the mesh is no lattice, which `what` needs */
[[nodiscard]] const HexMesh &
requireLatticeFor(const DrawnMesh & mesh, const std::string & what);

/** One colour for one value in the legend. */
struct ColourClass
{
  int         value;
  std::string name;
  Colour      colour;
};

/** How cells are coloured. */
struct CellColours
{
  std::string              title;   ///< of the legend
  std::vector<double>      values;  ///< of every cell
  std::vector<ColourClass> classes; ///< ascending; empty: along the scale
  ColourScale              scale{ sequentialScale() };
  double                   low{ 0.0 };  ///< value at the lower end of the scale
  double                   high{ 1.0 }; ///< at its upper end, > low

  [[nodiscard]] Colour
  of(std::size_t cell) const;
};

/** The values of every cell and their colours: Verdict's scaled Jacobian, aspect ratio and taper as in HexCellQuality,
 * the volume over the mean volume, the shell, or the label that most of a cell lies in.
 *
 * Without options.range the ends are 0 and 1 for the scaled Jacobian (lower where a cell is), 1 and the largest for the
 * aspect ratio, 0 and the largest for the taper, and as far below 1 as above for the volume, at least 0.1.
 * \throws UsageError  the range does not ascend, or is given for classes; a label without label image, or the reverse
 * \throws BadInput    as requireLatticeFor for shells and labels; as readSolid
 * \throws InvalidInput  ratios to a mean volume that is not positive */
[[nodiscard]] CellColours
colourCells(const DrawnMesh & mesh, const FigureOptions & options);

} // namespace moserhex::app
