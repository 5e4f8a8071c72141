#pragma once

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/Geometry/UnstructuredHexMesh.h"
#include "moserhex/Quality/JacobianBounds.h"

#include <cstddef>
#include <vector>

namespace moserhex
{

/** Quality of one hexahedron, Verdict's definitions (Stimpson et al., "The Verdict library reference manual", 2007), so
 * that the numbers equal vtkMeshQuality's. Principal axes: X1 = sum of the four edges along the first reference axis,
 * X2 and X3 likewise; X12, X13, X23 = the cross derivatives. */
struct HexCellQuality
{
  double volume{ 0.0 };          ///< exact volume of the trilinear hexahedron [mm^3]
  double minimumJacobian{ 0.0 }; ///< smallest det J at the 8 corners and (over 64) of X1 X2 X3 [mm^3]
  double scaledJacobian{ 0.0 };  ///< same with unit edge vectors, in [-1,1] [1]
  double edgeRatio{ 0.0 };       ///< longest / shortest of the 12 edges [1]
  double aspectRatio{ 0.0 }; ///< max over axis pairs of |Xi| / |Xj|: CUBIT's aspect ratio, Verdict's max edge ratio [1]
  double taper{ 0.0 };       ///< max over axis pairs of |Xij| / min(|Xi|,|Xj|) [1]
  double skew{ 0.0 };        ///< largest |cosine| between two principal axes [1]
  double shape{ 0.0 };       ///< smallest 3 (det J)^(2/3) / |J|^2 of the 8 corners; 0 when one is inverted [1]
  bool   concave{ false };   ///< det J <= 0 at one of the 8 corners
};

/** Quality of one cell. A ratio to an edge or axis without length is the largest finite number. */
[[nodiscard]] HexCellQuality
hexCellQuality(const HexCorners & corners);

/** Distribution of one number over a set of cells. Percentiles: linear between order statistics. */
struct Distribution
{
  double minimum{ 0.0 }; ///< the smallest value
  double p01{ 0.0 };     ///< 1st percentile
  double p05{ 0.0 };     ///< 5th percentile
  double median{ 0.0 };  ///< 50th percentile
  double mean{ 0.0 };    ///< arithmetic
  double p95{ 0.0 };     ///< 95th percentile
  double p99{ 0.0 };     ///< 99th percentile
  double maximum{ 0.0 }; ///< the largest value
};

/** \throws InvalidInput  empty set */
[[nodiscard]] Distribution
distributionOf(std::vector<double> values);

/** Cells by their place in the cube: those that touch two of its faces (along an edge), three (at a corner), or fewer.
 * The corners of the first two lie on the organ's smooth surface, where the cube's right angle opens to nearly 180
 * degrees, so their quality has a ceiling of its own. */
struct HexClassQuality
{
  std::size_t cells{ 0 };                  ///< of the class; 0: all other numbers are 0, too
  std::size_t concaveCells{ 0 };           ///< with det J <= 0 at a corner
  double      volumeVariance{ 0.0 };       ///< about the mesh's mean ratio 1 [1]
  double      scaledJacobianMin{ 0.0 };    ///< smallest of its cells [1]
  double      scaledJacobianMedian{ 0.0 }; ///< of its cells [1]
};

/** Ratios to the mean volume are NaN where the cells have no volume, up to rounding, in sum. */
struct HexQualitySummary
{
  std::size_t       cells{ 0 };            ///< of the mesh, padding included
  double            volume{ 0.0 };         ///< sum of the cell volumes [mm^3]
  double            volumeVariance{ 0.0 }; ///< population variance of volume / mean volume [1]
  double            ratioMin{ 0.0 };       ///< smallest volume / mean [1]
  double            ratioMax{ 0.0 };       ///< largest volume / mean [1]
  std::size_t       concaveCells{ 0 };     ///< with det J <= 0 at a corner
  double            concavePercent{ 0.0 }; ///< of the cells [%]
  CertificateCounts certified; ///< cells by the sign of det J in the whole cell; notPositive + undecided >= concave
  Distribution      scaledJacobian;     ///< of the cells, see HexCellQuality [1]
  Distribution      minimumJacobian;    ///< of volume-normalised cells: minimum Jacobian / mean volume [1]
  Distribution      aspectRatio;        ///< of the cells, see HexCellQuality [1]
  Distribution      taper;              ///< of the cells, see HexCellQuality [1]
  Distribution      skew;               ///< of the cells, see HexCellQuality [1]
  int               paddingLayers{ 0 }; ///< of a lattice
  bool              isLattice{ false }; ///< without padding: the three classes below are filled in
  HexClassQuality   corners;            ///< the 8 cells at the cube's corners
  HexClassQuality   edges;              ///< the 12 (n-3) cells along its edges
  HexClassQuality   rest;               ///< all other cells
};

/** Results do not depend on the number of threads (as in parallelFor; 0: all of the machine's). A lattice without
 * padding gets the classes.
 * \throws InvalidInput  as requireValid(mesh) */
[[nodiscard]] HexQualitySummary
summarizeQuality(const HexMesh & mesh, unsigned int threads = 1);

/** Any hexahedral mesh. One that is a lattice without padding (asLattice) gets the classes, too.
 * \throws InvalidInput  as requireValid(mesh) */
[[nodiscard]] HexQualitySummary
summarizeQuality(const UnstructuredHexMesh & mesh, unsigned int threads = 1);

/** The two numbers the flow watches, cheaper than the whole summary. */
struct VolumeQuality
{
  double      volumeVariance{ 0.0 }; ///< population variance of volume / mean volume [1]
  std::size_t concaveCells{ 0 };     ///< with det J <= 0 at a corner
  double      concavePercent{ 0.0 }; ///< of the cells [%]
};
/** Of all cells, padding included. */
[[nodiscard]] VolumeQuality
volumeQuality(const HexMesh & mesh);

} // namespace moserhex
