#pragma once

#include "Colours.h"
#include "DrawnMesh.h"
#include "FigureOptions.h"

#include <string>
#include <vector>

namespace moserhex::app
{

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
  std::vector<double>      values;  ///< of every cell; not finite: no number, drawn in noNumberColour
  std::vector<ColourClass> classes; ///< ascending; empty: along the scale
  ColourScale              scale{ sequentialScale() };
  double                   low{ 0.0 };  ///< value at the lower end of the scale
  double                   high{ 1.0 }; ///< at its upper end, > low

  [[nodiscard]] Colour
  of(std::size_t cell) const;

  [[nodiscard]] bool
  hasNumber(std::size_t cell) const;
};

inline constexpr Colour noNumberColour{ 0.6, 0.6, 0.6, 1.0 };

/** The values of every cell and their colours: Verdict's scaled Jacobian, aspect ratio and taper as in HexCellQuality,
 * the volume over the mean volume, the shell, the label that most of a cell lies in, or an array of the file
 * (valuesOfArray).
 *
 * Without options.range the ends are 0 and 1 for the scaled Jacobian (lower where a cell is), 1 and the largest for the
 * aspect ratio, 0 and the largest for the taper, and as far below 1 as above for the volume, at least 0.1; of an array
 * the least and the largest number, widened where these are the same.
 * \throws UsageError  the range does not ascend, or is given for classes; a label without label image, or the reverse;
 *                     no such array
 * \throws BadInput    as requireLatticeFor for shells and labels; as readLabelImage
 * \throws InvalidInput  ratios to a mean volume that is not positive; an array without numbers */
[[nodiscard]] CellColours
colourCells(const DrawnMesh & mesh, const FigureOptions & options);

} // namespace moserhex::app
