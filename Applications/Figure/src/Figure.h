#pragma once

#include "CellColours.h"
#include "FigureOptions.h"

#include <cstddef>
#include <string>
#include <vector>

namespace moserhex::app
{

/** A finished picture. */
struct Figure
{
  std::string bytes;    ///< of the file
  std::size_t polygons; ///< of cells that are drawn
};

/** Draws a mesh.
 *
 *   surface   the boundary of the mesh
 *   shells    cells of some shells without the eighth nearest the viewer, one shell beside the other or all in their
 * places slice     what a plane cuts out of every cell, or one layer of the lattice
 *
 * Parallel projection, faces behind others are covered (drawingOrder), with the colours' legend, a scale in millimetres
 * and the patient's directions. The same mesh and options give the same bytes with the same Cairo and fonts. \throws
 * UsageError    options that contradict each other, or a name that ends neither with .png nor .svg \throws BadInput a
 * lattice is needed and the mesh is none; as colourCells \throws InvalidInput  no such shell or layer, or a plane
 * beside the mesh */
[[nodiscard]] Figure
drawFigure(const DrawnMesh & mesh, const FigureOptions & options);

/** What is said of a picture that has been written. */
struct WrittenFigure
{
  std::size_t              polygons;
  std::vector<std::string> warnings; ///< what of the mesh file was ignored, one line each
};

/** Reads the mesh, draws it and writes the picture, complete or not at all.
 * \throws as drawFigure and readHexCells; UsageError  the picture would overwrite an input; IOError */
[[nodiscard]] WrittenFigure
writeFigure(const FigureOptions & options);

} // namespace moserhex::app
