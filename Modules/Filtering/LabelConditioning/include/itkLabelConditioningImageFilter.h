#ifndef itkLabelConditioningImageFilter_h
#define itkLabelConditioningImageFilter_h

#include "itkCoreAlgorithm.h"

#include "moserhex/LevelSet/LabelConditioning.h"

#include <itkImage.h>
#include <itkImageToImageFilter.h>

namespace itk
{

/** \class LabelConditioningImageFilter
 * \brief One label of a labelmap to the signed distance of a solid ball on an isotropic grid.
 *
 * Topology repaired to one solid of genus 0, shape interpolated between thick slices, smoothed without a change of
 * topology or volume: moserhex::conditionLabel(), whose documentation has the steps and the guarantees. Output: phi
 * [mm], negative inside, on a grid along the axes of the image.
 *
 * The size, spacing and origin of the output depend on the pixels of the input. They are known after Update(); before,
 * the largest possible region of the output is empty. So update this filter before filters that ask for the geometry of
 * their input are connected to it.
 *
 * \par Errors
 * InvalidInputError: the label is not in the image (the message lists those that are), is not of genus 0 and to be
 * rejected ("label 3: 1 handle, V-E+F = 0, need 2 (genus 0)") or more in need of repair than allowed, or is too thin;
 * the image axes are sheared. ProcessAborted. */
template <typename TLabelImage, typename TOutputImage = Image<double, 3>>
class ITK_TEMPLATE_EXPORT LabelConditioningImageFilter : public ImageToImageFilter<TLabelImage, TOutputImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LabelConditioningImageFilter);

  using Self = LabelConditioningImageFilter;
  using Superclass = ImageToImageFilter<TLabelImage, TOutputImage>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(LabelConditioningImageFilter);

  using LabelImageType = TLabelImage;                ///< of the input
  using OutputImageType = TOutputImage;              ///< phi [mm]
  using LabelType = typename TLabelImage::PixelType; ///< a label's value
  using ReportType = moserhex::ConditioningReport;   ///< what was changed

  static_assert(TLabelImage::ImageDimension == 3 && TOutputImage::ImageDimension == 3, "three-dimensional images only");

  /** Value of the label; 0 is the background and refused. Default 1. */
  itkSetMacro(Label, LabelType);
  itkGetConstMacro(Label, LabelType);

  /** Nodes per side of the lattice the solid is meant for: sets the spacing of the grid when Spacing is 0. */
  itkOptionMacro(NodesPerSide, int, nodesPerSide);

  /** Spacing of the grid [mm]; 0: from the volume and NodesPerSide. */
  itkOptionMacro(Spacing, double, spacing);

  /** Standard deviation of the smoothing in units of the largest voxel side. */
  itkOptionMacro(Smoothing, double, smoothing);

  /** The Gaussian's standard deviation is never below this [mm]. Default 0. */
  itkOptionMacro(MinimumSigma, double, minimumSigma);

  /** Ratio of voxel sides above which slices are interpolated by shape. */
  itkOptionMacro(SliceAnisotropy, double, sliceAnisotropy);

  /** Smallest Dice coefficient with the label's voxels before the label counts as too thin. */
  itkOptionMacro(MinimumDice, double, minimumDice);

  /** Whether a label that is not one solid of genus 0 is repaired (default) or refused. */
  itkOptionMacro(TopologyPolicy, moserhex::TopologyPolicy, topology);

  /** Most that a repair may change, relative to the label [1]. */
  itkOptionMacro(MaximumRepair, double, maximumRepair);

  /** After Update(): volume of the label after its repair [mm^3]. */
  itkGetConstMacro(LabelVolume, double);

  /** After Update(): the label after its repair, cut out with a margin of one voxel. */
  const moserhex::LabelVolume &
  GetRepairedLabel() const
  {
    return m_RepairedLabel;
  }

  /** After Update(): what was changed. */
  const ReportType &
  GetReport() const
  {
    return m_Report;
  }

protected:
  LabelConditioningImageFilter() = default;
  ~LabelConditioningImageFilter() override = default;

  /** \throws ExceptionObject  no input; Label 0; NodesPerSide < 2; Spacing < 0 */
  void
  VerifyPreconditions() ITKv5_CONST override;

  /** Says that the largest possible region is empty: the grid depends on the pixels. */
  void
  GenerateOutputInformation() override;

  /** The whole input: the label may be anywhere. */
  void
  GenerateInputRequestedRegion() override;

  /** The whole output: it is made in one piece. */
  void
  EnlargeOutputRequestedRegion(DataObject * output) override;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  LabelType                     m_Label{ NumericTraits<LabelType>::OneValue() };
  moserhex::ConditioningOptions m_Options;
  ReportType                    m_Report;
  moserhex::LabelVolume         m_RepairedLabel;
  double                        m_LabelVolume{ 0.0 };
};

} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#include "itkLabelConditioningImageFilter.hxx"
#endif

#endif
