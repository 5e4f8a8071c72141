#pragma once

#include "moserhex/Geometry/TriangleMesh.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace moserhex
{

/** Corresponding points of a subject, and its surface, in the frame of the model. */
struct SubjectSurface
{
  Positions    points;  ///< as many for every subject [mm]
  TriangleMesh surface; ///< as it is, whatever the points span [mm]
};

/** The surface that points span: their connectivity is the same for all subjects. */
using SpannedSurface = std::function<TriangleMesh(const Positions & points)>;

struct SurfaceModelQualityOptions
{
  std::size_t   pairs{ 200 }; ///< of random shapes of the model, on either side of its mean, for specificity
  std::uint64_t seed{ 1 };
  double        spacing{ 1.0 }; ///< as SurfaceDistanceOptions [mm]
  unsigned int  threads{ 0 };   ///< 0: all; the result does not depend on it
};

/** An entry for each number of modes asked for. */
struct SurfaceModelQuality
{
  std::vector<double> generalisation;      ///< [mm]
  std::vector<double> generalisationError; ///< standard error of that mean over the subjects [mm]
  std::vector<double> specificity;         ///< [mm]
  std::vector<double> specificityError;    ///< standard error of that mean over the pairs [mm]
};

/** Generalisation and specificity of a model of points, measured on surfaces.
 *
 * modelQuality compares points with points. Points that leave a part of the shape out, all in the same way, are good
 * points then, and no measure says that they do not stand for the shape [munsell2008]. Here a shape is the surface that
 * its points span, and its distance is the mean of symmetricSurfaceDistance to a real surface:
 *
 *   generalisation  of the subject left out, as the modes of the others reconstruct it, to its own surface
 *   specificity     of a random shape to the surface of the subject whose points are nearest
 *
 * Random shapes come in pairs, with scores b (randomScores) and -b: the sign of a mode means nothing, and with unpaired
 * shapes it changes the mean by more than ways differ.
 *
 * \param modes  numbers of modes; more than there are count as all
 * \throws InvalidInput  fewer than three subjects, no pairs, or as fitShapeModel and symmetricSurfaceDistance
 * \note Deterministic for any number of threads. */
[[nodiscard]] SurfaceModelQuality
surfaceModelQuality(const std::vector<SubjectSurface> & subjects,
                    const SpannedSurface &              span,
                    const std::vector<std::size_t> &    modes,
                    const SurfaceModelQualityOptions &  options = {});

} // namespace moserhex
