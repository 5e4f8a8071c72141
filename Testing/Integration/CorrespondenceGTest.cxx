// Known deformations of a solid without symmetry: how far the nodes of the deformed label's mesh are from where the
// deformation takes the nodes of the first one, and how far their best affine map is from that of the truth. Bounds:
// half a cell edge for the median over inner nodes when tied to the first mesh by shape alone, 2 % for the affine part
// with landmarks; the other ways are printed beside it.
#include "PipelineRun.h"

#include "moserhex/Analytic/KnownDeformations.h"
#include "moserhex/Correspondence/BoundaryLandmarks.h"
#include "moserhex/Correspondence/LandmarkErrors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

using namespace moserhex;
using namespace moserhex::integration;

namespace
{

HexMesh
meshOf(const ShortImage *         label,
       const HexMesh *            templateMesh,
       TemplateAlignment          alignment = TemplateAlignment::None,
       const TemplateRefinement & refinement = {})
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
};

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
  const HexMesh             baseline = meshOf(labelImage(analytic::labelVolume(solid)), nullptr);
  const ShortImage::Pointer label = labelImage(analytic::labelVolume(analytic::deformed(solid, deformation)));
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
  return { errorOf("on its own", meshOf(label, nullptr)),
           errorOf("tied", meshOf(label, &baseline)),
           errorOf("tied, affine", meshOf(label, &baseline, TemplateAlignment::Affine)),
           errorOf("tied, landmarks", meshOf(label, &baseline, TemplateAlignment::None, landmarks)) };
}

} // namespace

TEST(Correspondence, AShearIsFollowed)
{
  const CorrespondenceErrors errors = errorsUnder(analytic::shear());
  EXPECT_LE(errors.own.median, 0.5);
  EXPECT_LE(errors.affine.median, 0.5);
  EXPECT_LE(errors.landmarks.median, 0.5);
  EXPECT_LE(errors.landmarks.affine, 0.02);
}

TEST(Correspondence, ABendIsFollowed)
{
  const CorrespondenceErrors errors = errorsUnder(analytic::bend());
  EXPECT_LE(errors.own.median, 0.5);
  EXPECT_LE(errors.tied.median, 0.5);
  EXPECT_LE(errors.affine.median, 0.5);
  EXPECT_LE(errors.landmarks.median, 0.5);
  EXPECT_LE(errors.landmarks.affine, 0.02);
}

TEST(Correspondence, ALocalBulgeIsFollowedByATiedMesh)
{
  const CorrespondenceErrors errors = errorsUnder(analytic::bulge());
  EXPECT_LE(errors.tied.median, 0.5);
  EXPECT_LT(errors.tied.median, errors.own.median);
  EXPECT_LE(errors.affine.median, 0.5);
  EXPECT_LE(errors.landmarks.median, 0.5);
  EXPECT_LE(errors.landmarks.affine, 0.02);
}
