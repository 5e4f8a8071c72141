#pragma once

#include "moserhex/LevelSet/DensityImage.h"

#include <cstddef>
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

  /** Every cell grows as they show, in place of all cells alike: tissue that has grown at the cost of its surroundings,
   * or died back, shows in the cells' volumes. Needs landmarks or images. */
  bool localGrowth{ false };

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

/** How differently the cells have grown: volume over that of the template's cell, in parts of their organs. */
struct LocalGrowth
{
  double      smallest{ 1.0 }; ///< of a cell [1]
  double      largest{ 1.0 };  ///< [1]
  std::size_t limited{ 0 };    ///< cells that would have grown or shrunk more than what is allowed
};

/** What a refinement reached. */
struct TemplateRefinementResult
{
  std::optional<RefinedResidual> landmarkError; ///< root mean square over the landmarks [mm]
  /** Root mean square over the organ, in standard deviations of the image there, of the sharpest images reached [1]. */
  std::optional<RefinedResidual> imageDifference;
  std::optional<LocalGrowth>     growth;              ///< where it was asked for
  double                         smallestPull{ 1.0 }; ///< part of the ties' weights that led to exact meshes [1]
  bool                           complete{ false };   ///< by all images, from smooth to sharp
};

} // namespace moserhex
