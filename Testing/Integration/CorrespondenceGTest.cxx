// Known deformations of a solid without symmetry: how far the nodes of the deformed label's mesh are from where the
// deformation takes the nodes of the first one. Bounds: half a cell edge for the median over inner nodes, and 0.1 for
// the affine part; all of it is measured in Documentation/Correspondence.md. Repeated runs: bit for bit.
#include "PipelineRun.h"

#include "moserhex/Analytic/KnownDeformations.h"
#include "moserhex/Correspondence/LandmarkErrors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

using namespace moserhex;
using namespace moserhex::integration;

namespace
{

ShortImage::Pointer
labelOf(const analytic::Solid & solid)
{
  return labelImage(analytic::labelVolume(solid));
}

HexMesh
meshOf(const ShortImage * label, const HexMesh * templateMesh = nullptr)
{
  auto pipeline = Pipeline::New();
  pipeline->SetInput(label);
  pipeline->SetNumberOfShells(8);
  pipeline->SetNumberOfWorkUnits(2);
  if (templateMesh != nullptr)
  {
    pipeline->SetTemplateMesh(*templateMesh);
    pipeline->SetTemplateAlignment(TemplateAlignment::None);
  }
  pipeline->Update();
  return pipeline->GetHexMesh();
}

const HexMesh &
baseline()
{
  static const HexMesh mesh = meshOf(labelOf(analytic::pearShapedSolid()));
  return mesh;
}

ShortImage::Pointer
deformedLabel(const analytic::KnownDeformation & deformation)
{
  return labelOf(analytic::deformed(analytic::pearShapedSolid(), deformation));
}

/** Median over inner nodes [cell edges]. */
double
medianLandmarkError(const HexMesh & followUp, const analytic::KnownDeformation & deformation)
{
  std::vector<double> errors = innerLandmarkErrors(baseline(), followUp, deformation.forward);
  std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2), errors.end());
  return errors[errors.size() / 2];
}

} // namespace

TEST(Correspondence, AShearIsFollowedByAMeshOfItsOwn)
{
  const analytic::KnownDeformation shear = analytic::shear();
  const HexMesh                    own = meshOf(deformedLabel(shear));
  EXPECT_LE(medianLandmarkError(own, shear), 0.5);
  Positions expected = baseline().nodes;
  std::transform(expected.begin(), expected.end(), expected.begin(), shear.forward);
  const Matrix3 error = affinePart(baseline().nodes, own.nodes) - affinePart(baseline().nodes, expected);
  EXPECT_LE(error.cwiseAbs().maxCoeff(), 0.1);
}

TEST(Correspondence, ABendIsFollowedEitherWay)
{
  const analytic::KnownDeformation bend = analytic::bend();
  const ShortImage::Pointer        label = deformedLabel(bend);
  EXPECT_LE(medianLandmarkError(meshOf(label), bend), 0.5);
  EXPECT_LE(medianLandmarkError(meshOf(label, &baseline()), bend), 0.5);
}

TEST(Correspondence, ALocalBulgeIsFollowedByATiedMesh)
{
  const analytic::KnownDeformation bulge = analytic::bulge();
  const ShortImage::Pointer        label = deformedLabel(bulge);
  const double                     tied = medianLandmarkError(meshOf(label, &baseline()), bulge);
  EXPECT_LE(tied, 0.5);
  EXPECT_LT(tied, medianLandmarkError(meshOf(label), bulge));
}

TEST(Correspondence, RepeatedRunsGiveTheSameBytes)
{
  const ShortImage::Pointer label = deformedLabel(analytic::bulge());
  const Positions           once = meshOf(label, &baseline()).nodes;
  const Positions           again = meshOf(label, &baseline()).nodes;
  ASSERT_EQ(once.size(), again.size());
  EXPECT_EQ(std::memcmp(once.data(), again.data(), once.size() * sizeof(Vector3)), 0);
}
