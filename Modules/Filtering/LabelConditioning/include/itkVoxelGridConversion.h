#ifndef itkVoxelGridConversion_h
#define itkVoxelGridConversion_h

#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/VoxelGrid.h"

#include <Eigen/SVD>

#include <string>

namespace itk
{

/** Where the voxels of the buffered region are; its first index becomes voxel (0,0,0). A direction that is orthonormal
 * within 1e-3, as text headers with few digits give, is replaced by the nearest orthonormal matrix.
 * \throws moserhex::InvalidInput  the image axes are sheared */
template <typename TImage>
moserhex::VoxelGrid
VoxelGridFromImage(const TImage * image)
{
  static_assert(TImage::ImageDimension == 3, "images are three-dimensional");
  const auto          region = image->GetBufferedRegion();
  const auto          direction = image->GetDirection();
  moserhex::VoxelGrid grid;

  typename TImage::PointType origin;
  image->TransformIndexToPhysicalPoint(region.GetIndex(), origin);
  moserhex::Matrix3 axes;
  for (unsigned int a = 0; a < 3; ++a)
  {
    grid.size[a] = static_cast<int>(region.GetSize(a));
    grid.spacing[static_cast<int>(a)] = image->GetSpacing()[a];
    grid.origin[static_cast<int>(a)] = origin[a];
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
  grid.direction = svd.matrixU() * svd.matrixV().transpose();
  return grid;
}

} // namespace itk

#endif
