// Known deformations of a solid without symmetry: how far the nodes of the deformed label's mesh are from where the
// deformation takes the nodes of the first one, and how far their best affine map is from that of the truth. Bounds:
// half a cell edge for the median over inner nodes when tied to the first mesh by shape alone, 2 % for the affine part
// with landmarks and with images, of bend and bulge also by shape alone; the other ways are printed beside it.
#include "PipelineRun.h"

#include "moserhex/Analytic/KnownDeformations.h"
#include "moserhex/Correspondence/BoundaryLandmarks.h"
#include "moserhex/Correspondence/LandmarkErrors.h"

#include <itkImageRegionIteratorWithIndex.h>

#include <Eigen/LU>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

using namespace moserhex;
using namespace moserhex::integration;

namespace
{

using DensityImage = Pipeline::DensityImageType;

HexMesh
meshOf(const ShortImage *         label,
       const HexMesh *            templateMesh,
       TemplateAlignment          alignment = TemplateAlignment::None,
       const TemplateRefinement & refinement = {},
       const DensityImage *       density = nullptr)
{
  auto pipeline = Pipeline::New();
  pipeline->SetInput(label);
  pipeline->SetNumberOfShells(8);
  pipeline->SetNumberOfWorkUnits(2);
  if (templateMesh != nullptr)
  {
    pipeline->SetTemplateMesh(*templateMesh);
    pipeline->SetTemplateAlignment(alignment);
    pipeline->SetTemplateRefinement(refinement);
    pipeline->SetDensityImage(density);
  }
  pipeline->Update();
  return pipeline->GetHexMesh();
}

struct CorrespondenceError
{
  double median{ 0.0 }; ///< of inner nodes, in cell edges [1]
  double affine{ 0.0 }; ///< largest entry of the affine part less that of the truth [1]
};

/** A mesh of the deformed label made on its own, and others that are tied to the baseline. */
struct CorrespondenceErrors
{
  CorrespondenceError own;
  CorrespondenceError tied;
  CorrespondenceError affine;    ///< aligned so
  CorrespondenceError landmarks; ///< refined by them
  CorrespondenceError images;    ///< refined by them, the deformed one's values those of the places before
  CorrespondenceError density;   ///< equal masses of what filled the first solid evenly
};

/** Waves of 16 to 22 mm along three oblique directions, so that every place has values around it of its own. */
double
waves(const Vector3 & p)
{
  return std::sin(Vector3(0.36, 0.05, -0.04).dot(p)) + std::sin(Vector3(-0.06, 0.32, 0.05).dot(p) + 1.0) +
         std::sin(Vector3(0.03, -0.07, 0.28).dot(p) + 2.0);
}

ScalarVolume
imageOf(const VoxelGrid & grid, const std::function<double(const Vector3 & p)> & f)
{
  ScalarVolume image;
  static_cast<VoxelGrid &>(image) = grid;
  for (int k = 0; k < grid.size[2]; ++k)
  {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      for (int i = 0; i < grid.size[0]; ++i)
      {
        image.values.push_back(f(grid.point(i, j, k)));
      }
    }
  }
  return image;
}

DensityImage::Pointer
densityImage(const ShortImage * label, const std::function<double(const Vector3 & p)> & f)
{
  auto image = DensityImage::New();
  image->CopyInformation(label);
  image->SetRegions(label->GetLargestPossibleRegion());
  image->Allocate();
  itk::ImageRegionIteratorWithIndex<DensityImage> at(image, image->GetLargestPossibleRegion());
  for (; !at.IsAtEnd(); ++at)
  {
    const auto point = image->TransformIndexToPhysicalPoint<double>(at.GetIndex());
    at.Set(f(Vector3(point[0], point[1], point[2])));
  }
  return image;
}

/** Of the volume of a small cube, by central differences. */
double
growthAt(const std::function<Vector3(const Vector3 & p)> & f, const Vector3 & p)
{
  constexpr double h = 1e-4; // [mm]
  Matrix3          gradient;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector3 step = h * Vector3::Unit(axis);
    gradient.col(axis) = (f(p + step) - f(p - step)) / (2.0 * h);
  }
  return gradient.determinant();
}

/** The middle one, of two the larger. */
double
medianOf(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

CorrespondenceErrors
errorsUnder(const analytic::KnownDeformation & deformation)
{
  const analytic::Solid     solid = analytic::pearShapedSolid();
  const LabelVolume         before = analytic::labelVolume(solid);
  const LabelVolume         after = analytic::labelVolume(analytic::deformed(solid, deformation));
  const HexMesh             baseline = meshOf(labelImage(before), nullptr);
  const ShortImage::Pointer label = labelImage(after);
  const auto                errorOf = [&](const char * way, const HexMesh & mesh) {
    const CorrespondenceError error{ medianOf(innerLandmarkErrors(baseline, mesh, deformation.forward)),
                                     affinePartError(baseline, mesh, deformation.forward) };
    std::printf("%s, %s: median of inner nodes %.2f cell edges, affine part off by %.3f\n",
                deformation.name.c_str(),
                way,
                error.median,
                error.affine);
    return error;
  };
  TemplateRefinement landmarks;
  landmarks.landmarks = boundaryLandmarks(baseline, deformation.forward);
  TemplateRefinement images;
  images.images =
    CorrespondingImages{ imageOf(before, waves),
                         imageOf(after, [&](const Vector3 & p) { return waves(deformation.inverse(p)); }) };
  const DensityImage::Pointer density =
    densityImage(label, [&](const Vector3 & p) { return 1.0 / growthAt(deformation.forward, deformation.inverse(p)); });
  return { errorOf("on its own", meshOf(label, nullptr)),
           errorOf("tied", meshOf(label, &baseline)),
           errorOf("tied, affine", meshOf(label, &baseline, TemplateAlignment::Affine)),
           errorOf("tied, landmarks", meshOf(label, &baseline, TemplateAlignment::None, landmarks)),
           errorOf("tied, images", meshOf(label, &baseline, TemplateAlignment::None, images)),
           errorOf("tied, density", meshOf(label, &baseline, TemplateAlignment::None, {}, density)) };
}

} // namespace

TEST(Correspondence, AShearIsFollowed)
{
  const CorrespondenceErrors errors = errorsUnder(analytic::shear());
  EXPECT_LE(errors.own.median, 0.5);
  EXPECT_LE(errors.affine.median, 0.5);
  EXPECT_LE(errors.landmarks.median, 0.5);
  EXPECT_LE(errors.landmarks.affine, 0.02);
  EXPECT_LE(errors.images.median, 0.5);
  EXPECT_LE(errors.images.affine, 0.02);
}

TEST(Correspondence, ABendIsFollowed)
{
  const CorrespondenceErrors errors = errorsUnder(analytic::bend());
  EXPECT_LE(errors.own.median, 0.5);
  EXPECT_LE(errors.tied.median, 0.5);
  EXPECT_LE(errors.tied.affine, 0.02);
  EXPECT_LE(errors.affine.median, 0.5);
  EXPECT_LE(errors.landmarks.median, 0.5);
  EXPECT_LE(errors.landmarks.affine, 0.02);
  EXPECT_LE(errors.images.median, 0.5);
  EXPECT_LE(errors.images.affine, 0.02);
  EXPECT_LE(errors.density.median, 0.5);
}

TEST(Correspondence, ALocalBulgeIsFollowedByATiedMesh)
{
  const CorrespondenceErrors errors = errorsUnder(analytic::bulge());
  EXPECT_LE(errors.tied.median, 0.5);
  EXPECT_LT(errors.tied.median, errors.own.median);
  EXPECT_LE(errors.tied.affine, 0.02);
  EXPECT_LE(errors.affine.median, 0.5);
  EXPECT_LE(errors.affine.affine, 0.02);
  EXPECT_LE(errors.landmarks.median, 0.5);
  EXPECT_LE(errors.landmarks.affine, 0.02);
  EXPECT_LE(errors.images.median, 0.5);
  EXPECT_LE(errors.images.affine, 0.02);
  EXPECT_LE(errors.density.median, 0.5);
}
