#pragma once

#include "moserhex/LevelSet/DensityImage.h"

#include <optional>
#include <vector>

namespace moserhex
{

/** The same place of the organ in two subjects. */
struct CorrespondingPoints
{
  Vector3 onTemplate{ Vector3::Zero() }; ///< in the template's own space [mm]
  Vector3 onSolid{ Vector3::Zero() };    ///< [mm]
};

/** One image of each subject, of the same kind. */
struct CorrespondingImages
{
  ScalarVolume ofTemplate; ///< in the template's own space
  ScalarVolume ofSolid;
};

/** What says more than the shapes do about where the places of a template are in a solid. */
struct TemplateRefinement
{
  std::vector<CorrespondingPoints>   landmarks;
  std::optional<CorrespondingImages> images;

  [[nodiscard]] bool
  any() const
  {
    return !landmarks.empty() || images.has_value();
  }
};

/** What a refinement did. The median counts as it does for the landmarks. */
struct TemplateRefinementResult
{
  double landmarkErrorBefore{ 0.0 }; ///< root mean square over the landmarks [mm]
  double landmarkErrorAfter{ 0.0 };
  double imageDifferenceBefore{ 0.0 }; ///< root mean square, in standard deviations of the image in the organ [1]
  double imageDifferenceAfter{ 0.0 };
};

} // namespace moserhex
