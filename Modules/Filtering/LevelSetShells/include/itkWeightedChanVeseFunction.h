#ifndef itkWeightedChanVeseFunction_h
#define itkWeightedChanVeseFunction_h

#include "itkMoserHexMacros.h"

#include <itkLevelSetFunction.h>

namespace itk
{

/** \class WeightedChanVeseFunction
 * \brief Descent of the Chan-Vese energy of a binary solid in a weighted metric.
 *
 *   E(phi) = int H(phi) (beta - mu_in)^2 + (1 - H(phi)) (beta - mu_out)^2 dx  +  nu F int |grad H(phi)| dx
 *
 *   phi_t = w(x) |grad phi| ( nu F kappa - [ (beta - mu_out)^2 - (beta - mu_in)^2 ] )
 *   F     = (1 - mu_out)^2 - (1 - mu_in)^2
 *
 * phi < 0 inside the front, beta is 1 in the organ and 0 elsewhere, mu_in and mu_out are the means of beta on the two
 * sides. The energy is Chan and Vese's; only the metric, <a,b>_w = int a b / w, differs from the plain one (w = 1).
 *
 * The Heaviside function is the regularised one with compact support,
 *
 *   H(phi) = 1 for phi < -e, 0 for phi > e, (1 - phi/e - sin(pi phi/e)/pi) / 2 between
 *
 * written for phi < 0 inside. Compact support matters: a sparse-field solver clamps phi at a few nodes, so an
 * arc-tangent would leak over the whole box, make mu_in = mu_out for a small front and stop it.
 *
 * Curvature is measured in units of the region force F: otherwise mu_out = V / V_box, large in a tight box, would let
 * curvature kill a small seed.
 *
 * \note Lengths are in nodes (scale coefficients 1). The time step is 0.45 nodes of propagation and 1/6 of curvature;
 *       ITK's own default (1/6) is a static variable and is not touched.
 */
template <typename TImage>
class ITK_TEMPLATE_EXPORT WeightedChanVeseFunction : public LevelSetFunction<TImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(WeightedChanVeseFunction);

  using Self = WeightedChanVeseFunction;
  using Superclass = LevelSetFunction<TImage>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;
  using ImageType = TImage; ///< of the level set, the feature and the weight
  using typename Superclass::FloatOffsetType;
  using typename Superclass::GlobalDataStruct;
  using typename Superclass::NeighborhoodType;
  using typename Superclass::RadiusType;
  using typename Superclass::ScalarValueType;
  using typename Superclass::TimeStepType;

  // The parts of itkNewMacro, which in ITK 5.2 leaves a second semicolon behind.
  itkSimpleNewMacro(Self);
  itkCreateAnotherMacro(Self);
  itkCloneMacro(Self);
  itkOverrideGetNameOfClassMacro(WeightedChanVeseFunction);

  /** beta: 1 in the organ, 0 elsewhere. */
  void
  SetFeatureImage(const ImageType * image)
  {
    m_FeatureImage = image;
  }

  /** w > 0, same grid as the feature image. */
  void
  SetWeightImage(const ImageType * image)
  {
    m_WeightImage = image;
  }

  /** e: half the width of the Heaviside function [nodes]. */
  void
  SetHeavisideWidth(double width)
  {
    m_HeavisideWidth = width;
  }

  ///@{
  /** Means of beta inside and outside the front. */
  double
  GetMeanInside() const
  {
    return m_MeanInside;
  }
  double
  GetMeanOutside() const
  {
    return m_MeanOutside;
  }
  ///@}

  /** H(phi). */
  double
  Heaviside(double phi) const;

  /** Computes both means for a level-set image; called once per iteration. Sums in the order of the pixels. */
  void
  UpdateMeans(const ImageType * levelSet);

  /** w [ (beta - mu_out)^2 - (beta - mu_in)^2 ]: positive moves the front outwards. */
  ScalarValueType
  PropagationSpeed(const NeighborhoodType & neighborhood,
                   const FloatOffsetType &  offset,
                   GlobalDataStruct *       globalData) const override;

  /** w F, which ITK multiplies with nu kappa. */
  ScalarValueType
  CurvatureSpeed(const NeighborhoodType & neighborhood,
                 const FloatOffsetType &  offset,
                 GlobalDataStruct *       globalData) const override;

  /** The largest step in which nothing moves by more than 0.45 nodes of propagation or 1/6 of curvature. */
  TimeStepType
  ComputeGlobalTimeStep(void * globalData) const override;

protected:
  WeightedChanVeseFunction();
  ~WeightedChanVeseFunction() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  /** (beta - mu_out)^2 - (beta - mu_in)^2: positive drives the front outwards. */
  double
  RegionForce(double beta) const;

  typename ImageType::ConstPointer m_FeatureImage;
  typename ImageType::ConstPointer m_WeightImage;
  double                           m_HeavisideWidth{ 1.5 };
  double                           m_MeanInside{ 1.0 };
  double                           m_MeanOutside{ 0.0 };
};

} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#include "itkWeightedChanVeseFunction.hxx"
#endif

#endif
