#pragma once

#include "DrawnMesh.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** The number of every cell by an array of the mesh's file; of an array at nodes the mean of those of a cell's eight
 * corners that have a number: of one that is known at the surface only, the mean over the cell's part of it. NaN where
 * the file has no number at all.
 *
 *   NAME     an array of one component; of several the norm, sqrt(sum of squares); of six, a symmetric tensor xx yy zz
 *            xy yz xz, with xy, yz and xz counted twice, as if it had nine
 *   NAME:K   component K alone, from 0
 *
 * An array of the cells comes before one of the nodes with the same name. Components are averaged before the norm.
 * \throws UsageError    there is no such array or component; says which there are
 * \throws InvalidInput  no cell has a number */
[[nodiscard]] std::vector<double>
valuesOfArray(const DrawnMesh & mesh, const std::string & name);

} // namespace moserhex::app
