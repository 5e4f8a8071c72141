#pragma once

#include "moserhex/LevelSet/DensityImage.h"

#include <optional>
#include <string>
#include <vector>

namespace moserhex
{

/** The same place of the organ in two subjects. */
struct CorrespondingPoints
{
  Vector3     onTemplate{ Vector3::Zero() }; ///< in the template's own space [mm]
  Vector3     onSolid{ Vector3::Zero() };    ///< [mm]
  std::string name{};                        ///< as messages call it; empty: its number
};

/** One image of each subject, of the same kind. */
struct CorrespondingImages
{
  ScalarVolume ofTemplate; ///< in the template's own space
  ScalarVolume ofSolid;    ///< in the solid's space
};

/** What says more than the shapes do about where the places of a template are in a solid. */
struct TemplateRefinement
{
  std::vector<CorrespondingPoints>   landmarks; ///< empty: none
  std::optional<CorrespondingImages> images;    ///< empty: none

  /** There are landmarks or images. */
  [[nodiscard]] bool
  any() const
  {
    return !landmarks.empty() || images.has_value();
  }
};

/** What a refinement left of what it was to make small. */
struct RefinedResidual
{
  double before{ 0.0 }; ///< of the tied mesh that the refinement starts from
  double after{ 0.0 };  ///< of the mesh returned
};

/** What a refinement reached. */
struct TemplateRefinementResult
{
  std::optional<RefinedResidual> landmarkError; ///< root mean square over the landmarks [mm]
  /** Root mean square over the organ, in standard deviations of the image there, of the sharpest images [1]. */
  std::optional<RefinedResidual> imageDifference;
};

} // namespace moserhex
