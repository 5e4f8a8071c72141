#pragma once

#include "moserhex/Common/Types.h"
#include "moserhex/Geometry/RigidAlignment.h"
#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/HexMeshIO/ReadOptions.h"

#include <string>

namespace moserhex
{

/** Whether the name ends like a transform of ITK: .tfm .txt .h5 .hdf .hdf5 .mat (any case). */
[[nodiscard]] bool
isTransformName(const std::string & fileName);

/** Points taken through the transform of a file that ITK's transform classes read: one of them, rigid to deformable, or
 * one composite of several. A registration's transform takes points of its fixed image's space to the moving one's;
 * Slicer's files hold what takes points of the parent's space to those of the node that it moves.
 *
 * \param points  LPS [mm] \param options  read in a child process or not, as with readLabelImage
 * \return as many points, LPS [mm]
 * \throws BadInput  the file is missing or damaged, has another ending, not one transform of space, is of elastix's own
 * format (Unsupported), or takes a point to one that is not finite; IOError  the file cannot be opened or read */
[[nodiscard]] Positions
transformedByFile(const std::string & fileName, const Positions & points, const ReadOptions & options = {});

/** The transform of a file that moves, turns and scales all axes alike, and does no more: judged by the corners of a
 * cube of side 200 mm around the origin, to 0.01 mm. \throws BadInput (Unsupported)  another kind, a mirroring one
 * included; BadInput, IOError  as transformedByFile */
[[nodiscard]] SimilarityTransform
similarityOfFile(const std::string & fileName, const ReadOptions & options = {});

} // namespace moserhex
