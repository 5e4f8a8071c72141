#pragma once

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/ShapeStatistics/Procrustes.h"
#include "moserhex/ShapeStatistics/ShapeModel.h"

#include <string>

namespace moserhex::app
{

/** A shape model and what a new subject must be brought to before it is projected. */
struct AtlasModel
{
  ShapeModel    shape;
  int           nodesPerSide{ 0 };
  int           paddingLayers{ 0 };
  AlignmentKind alignment{ AlignmentKind::Rigid };
  double        size{ 0.0 }; ///< centroid size of the aligned subjects, for AlignmentKind::Similarity [mm]
  std::size_t   subjects{ 0 };
};

[[nodiscard]] const char *
nameOf(AlignmentKind kind);

/** Writes NAME.json (text: format, sizes, variances, SHA-256 of the numbers) and NAME.f64 beside it: little-endian
 * doubles, D of the mean, then D for each of the K modes, D = 3 x nodes, in the order of the nodes [mm].
 * \param fileName  ends with .json \throws IOError */
void
writeAtlasModel(const std::string & fileName, const AtlasModel & model);

/** \throws BadInput  missing; not such a file; sizes that contradict each other; the numbers are missing, damaged or
 * not finite; IOError */
[[nodiscard]] AtlasModel
readAtlasModel(const std::string & fileName);

/** The model's coordinates as a mesh. */
[[nodiscard]] HexMesh
meshOf(const AtlasModel & model, const Eigen::VectorXd & coordinates);

} // namespace moserhex::app
