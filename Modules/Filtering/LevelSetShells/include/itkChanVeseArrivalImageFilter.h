#ifndef itkChanVeseArrivalImageFilter_h
#define itkChanVeseArrivalImageFilter_h

#include "itkWeightedChanVeseFunction.h"

#include <itkSparseFieldLevelSetImageFilter.h>

#include <vector>

namespace itk
{

/** \class ChanVeseArrivalImageFilter
 * \brief Evolves a front under WeightedChanVeseFunction and writes the time at which it passes each pixel.
 *
 * Input 0 is the level set of the first front (negative inside, distances in nodes); the feature and weight images are
 * those of the function. The output is not the final level set but the time of arrival: linear interpolation of phi
 * between two steps, the (negative) first level set where the front starts, +infinity where it has not come.
 *
 * The solver is itk::SparseFieldLevelSetImageFilter, which is serial: results do not depend on the number of threads.
 * It stops when the front has passed ReachedFraction of the pixels with beta = 1 (Converged), when the number of
 * pixels inside has not grown for StallIterations (the front has arrived everywhere it can go, or has vanished), or
 * after NumberOfIterations.
 */
template <typename TImage>
class ITK_TEMPLATE_EXPORT ChanVeseArrivalImageFilter : public SparseFieldLevelSetImageFilter<TImage, TImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ChanVeseArrivalImageFilter);

  using Self = ChanVeseArrivalImageFilter;
  using Superclass = SparseFieldLevelSetImageFilter<TImage, TImage>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;
  using ImageType = TImage;                              ///< of all inputs and the output
  using PixelType = typename ImageType::PixelType;       ///< of a level set, real
  using FunctionType = WeightedChanVeseFunction<TImage>; ///< the equation of motion
  using typename Superclass::TimeStepType;

  // The parts of itkNewMacro, which in ITK 5.2 leaves a second semicolon behind.
  itkSimpleNewMacro(Self);
  itkCreateAnotherMacro(Self);
  itkCloneMacro(Self);
  itkOverrideGetNameOfClassMacro(ChanVeseArrivalImageFilter);

  /** beta: 1 in the organ, 0 elsewhere. */
  itkSetInputMacro(FeatureImage, ImageType);
  itkGetInputMacro(FeatureImage, ImageType);

  /** w > 0: how fast the front may move at each pixel. */
  itkSetInputMacro(WeightImage, ImageType);
  itkGetInputMacro(WeightImage, ImageType);

  /** nu: weight of the curvature, in units of the region force [nodes]. */
  itkSetMacro(CurvatureWeight, double);
  itkGetConstMacro(CurvatureWeight, double);

  /** Half the width of the Heaviside function [nodes]. */
  itkSetMacro(HeavisideWidth, double);
  itkGetConstMacro(HeavisideWidth, double);

  /** Part of the pixels with beta = 1 that the front has to pass, in (0,1]. */
  itkSetMacro(ReachedFraction, double);
  itkGetConstMacro(ReachedFraction, double);

  /** Iterations without growth after which the front counts as stopped. */
  itkSetMacro(StallIterations, unsigned int);
  itkGetConstMacro(StallIterations, unsigned int);

  ///@{
  /** After Update(): whether ReachedFraction was reached, and the part that was. */
  itkGetConstMacro(Converged, bool);
  itkGetConstMacro(PassedFraction, double);
  ///@}

  ///@{
  /** After Update(): means of beta inside and outside the last front. */
  itkGetConstMacro(MeanInside, double);
  itkGetConstMacro(MeanOutside, double);
  ///@}

protected:
  ChanVeseArrivalImageFilter();
  ~ChanVeseArrivalImageFilter() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  /** \throws ExceptionObject  an input is missing, or an option is out of range */
  void
  VerifyPreconditions() ITKv5_CONST override;

  /** Hands images and options to the function. \throws ExceptionObject  no pixel has beta > 0.5 */
  void
  Initialize() override;

  /** Notes what the last step passed, and takes the means anew. */
  void
  InitializeIteration() override;

  /** Keeps the time step, which times of arrival are interpolated in. */
  TimeStepType
  CalculateChange() override;

  /** Converged, stalled, or NumberOfIterations made. Reports progress. */
  bool
  Halt() override;

  /** Puts the times of arrival in the place of the last level set. */
  void
  PostProcessOutput() override;

private:
  /** Notes the time of pixels that came inside during the last step; counts those inside. */
  void
  RecordArrivals();

  typename FunctionType::Pointer m_Function;
  double                         m_CurvatureWeight{ 0.1 };
  double                         m_HeavisideWidth{ 1.5 };
  double                         m_ReachedFraction{ 0.95 };
  unsigned int                   m_StallIterations{ 100 };

  std::vector<PixelType> m_Arrival;
  std::vector<PixelType> m_Previous; ///< level set before the last step; empty before the first
  double                 m_Time{ 0.0 };
  double                 m_TimeStep{ 0.0 };
  SizeValueType          m_FeatureCount{ 0 };
  SizeValueType          m_LargestCount{ 0 };
  unsigned int           m_IterationsWithoutGrowth{ 0 };
  bool                   m_Converged{ false };
  double                 m_PassedFraction{ 0.0 };
  double                 m_MeanInside{ 0.0 };
  double                 m_MeanOutside{ 0.0 };
};

} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#include "itkChanVeseArrivalImageFilter.hxx"
#endif

#endif
