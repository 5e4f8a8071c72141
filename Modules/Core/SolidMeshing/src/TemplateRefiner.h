#pragma once

#include "moserhex/HexMap/LatticeTies.h"
#include "moserhex/SolidMeshing/TemplateRefinement.h"

#include <vector>

namespace moserhex
{

/** Turns what a template's refinement says into ties of a lattice.
 *
 * A landmark's place is the one of its point in the template's mesh; outside of it the nearest one on its boundary.
 * Images are made smooth at a scale and compared at the lattice's samples, in units of the template's standard
 * deviation there. Brightness and contrast are taken away by the grey levels of the darkest and brightest tissues
 * (quantiles of 1 and 99 %), which do not depend on how much of the organ these fill. */
class TemplateRefiner
{
public:
  /** Keeps references. \param templateMesh  in its own space
   * \throws InvalidInput  a point that is not finite; (TemplateImage)  an image that does not cover its mesh */
  TemplateRefiner(const HexMesh & templateMesh, const TemplateRefinement & refinement);

  [[nodiscard]] const std::vector<LatticeLandmark> &
  landmarks() const
  {
    return m_Landmarks;
  }

  /** Of the landmarks' points on the template to its mesh, in their order; 0 inside [mm]. */
  [[nodiscard]] const std::vector<double> &
  distancesOutside() const
  {
    return m_DistancesOutside;
  }

  /** \param points  of the solid [mm] \throws InvalidInput (Image)  the solid's image does not cover them */
  void
  requireSolidCovered(const Positions & points) const;

  /** Standard deviations of the smoothing, from coarse to fine, in edges of a mean cell; a single zero when there are
   * no images. */
  [[nodiscard]] std::vector<double>
  scales() const;

  /** \param mesh  of the solid as it is \param scale  one of scales() [edges of a mean cell]
   * \throws InvalidInput (TemplateImage, Image)  an image that is constant in the organ at this scale, or does not
   * cover it */
  [[nodiscard]] LatticeImage
  image(const HexMesh & mesh, double scale) const;

private:
  const HexMesh &              m_Template;
  const TemplateRefinement &   m_Refinement;
  std::vector<LatticeLandmark> m_Landmarks;
  std::vector<double>          m_DistancesOutside;
};

/** A mean cell's [mm]. */
[[nodiscard]] double
cellEdge(const HexMesh & mesh);

/** Root mean square distance of the landmarks to where they belong; 0 without any [mm]. */
[[nodiscard]] double
landmarkError(const HexMesh & mesh, const std::vector<LatticeLandmark> & landmarks);

/** Root mean square difference of the image at the samples and the values that belong there [unit of the image]. */
[[nodiscard]] double
imageDifference(const HexMesh & mesh, const LatticeImage & image);

} // namespace moserhex
