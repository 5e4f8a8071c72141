#ifndef itkLabelVolumeConversion_h
#define itkLabelVolumeConversion_h

#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/LabelVolume.h"

#include <itkNumericTraits.h>

#include <Eigen/SVD>

#include <set>
#include <sstream>

namespace itk
{

/** The labels of the buffered region other than 0, as text: "1, 2, 7"; the first 20 and an ellipsis. */
template <typename TImage>
std::string
DescribeLabels(const TImage * image)
{
  using PixelType = typename TImage::PixelType;
  constexpr std::size_t     shown = 20;
  const auto *              first = image->GetBufferPointer();
  const std::set<PixelType> labels(first, first + image->GetBufferedRegion().GetNumberOfPixels());
  std::ostringstream        text;
  std::size_t               count = 0;
  for (const PixelType label : labels)
  {
    if (label == PixelType{})
    {
      continue;
    }
    if (count == shown)
    {
      text << ", ...";
      break;
    }
    text << (count++ == 0 ? "" : ", ") << static_cast<typename NumericTraits<PixelType>::PrintType>(label);
  }
  return count == 0 ? "none" : text.str();
}

/** One label of the buffered region as a mask. A direction that is orthonormal within 1e-3, as text headers with few
 * digits give, is replaced by the nearest orthonormal matrix.
 * \throws moserhex::InvalidInput  no voxel has the label (lists those present), or the image axes are sheared */
template <typename TImage>
moserhex::LabelVolume
LabelVolumeFromImage(const TImage * image, const typename TImage::PixelType & label)
{
  static_assert(TImage::ImageDimension == 3, "labelmaps are three-dimensional");
  const auto            region = image->GetBufferedRegion();
  const auto            direction = image->GetDirection();
  moserhex::LabelVolume volume;

  typename TImage::PointType origin;
  image->TransformIndexToPhysicalPoint(region.GetIndex(), origin);
  moserhex::Matrix3 axes;
  for (unsigned int a = 0; a < 3; ++a)
  {
    volume.size[a] = static_cast<int>(region.GetSize(a));
    volume.spacing[static_cast<int>(a)] = image->GetSpacing()[a];
    volume.origin[static_cast<int>(a)] = origin[a];
    for (unsigned int b = 0; b < 3; ++b)
    {
      axes(static_cast<int>(a), static_cast<int>(b)) = direction[a][b];
    }
  }
  const Eigen::JacobiSVD<moserhex::Matrix3> svd(axes, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double error = (svd.singularValues() - moserhex::Vector3::Ones()).cwiseAbs().maxCoeff();
  if (!(error <= 1e-3))
  {
    throw moserhex::InvalidInput("image direction is not orthonormal (error " + std::to_string(error) +
                                 ", allowed 0.001): resample the image on perpendicular axes");
  }
  volume.direction = svd.matrixU() * svd.matrixV().transpose();

  const auto * first = image->GetBufferPointer();
  volume.inside.resize(region.GetNumberOfPixels());
  bool any = false;
  for (std::size_t voxel = 0; voxel < volume.inside.size(); ++voxel)
  {
    const bool inside = first[voxel] == label;
    volume.inside[voxel] = inside ? 1 : 0;
    any = any || inside;
  }
  if (!any)
  {
    std::ostringstream message;
    message << "label " << static_cast<typename NumericTraits<typename TImage::PixelType>::PrintType>(label)
            << " is not in the image; labels present: " << DescribeLabels(image);
    throw moserhex::InvalidInput(message.str());
  }
  return volume;
}

} // namespace itk

#endif
