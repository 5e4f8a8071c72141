// Known deformations of a solid without symmetry: how far the nodes of the deformed label's mesh are from where the
// deformation takes the nodes of the first one. Bounds: half a cell edge for the median over inner nodes when tied to
// the first mesh, 2 % for the affine part; what meshes of their own give is printed beside it.
#include "PipelineRun.h"

#include "moserhex/Analytic/SolidShapes.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace moserhex;
using namespace moserhex::integration;

namespace
{

/** A map of space and its inverse. */
struct Deformation
{
  const char *                              name;
  std::function<Vector3(const Vector3 & p)> forward;
  std::function<Vector3(const Vector3 & p)> inverse;
};

constexpr double radiusOfBend = 90.0; // [mm]
constexpr double heightOfBulge = 4.0;
constexpr double widthOfBulge = 12.0;

const Vector3 placeOfBulge(20.0, 9.0, 4.0);

Deformation
shear()
{
  const Matrix3 F = (Matrix3() << 1.0, 0.0, 0.25, 0.0, 1.0, 0.0, 0.0, 0.1, 1.0).finished();
  return { "shear",
           [F](const Vector3 & p) { return Vector3(F * p); },
           [F](const Vector3 & p) { return Vector3(F.inverse() * p); } };
}

/** About an axis along z, of radius 90 mm at y = 0. */
Deformation
bend()
{
  return { "bend",
           [](const Vector3 & p) {
             const double angle = p.x() / radiusOfBend;
             const double r = radiusOfBend - p.y();
             return Vector3(r * std::sin(angle), radiusOfBend - r * std::cos(angle), p.z());
           },
           [](const Vector3 & p) {
             const double angle = std::atan2(p.x(), radiusOfBend - p.y());
             return Vector3(radiusOfBend * angle, radiusOfBend - std::hypot(p.x(), radiusOfBend - p.y()), p.z());
           } };
}

Vector3
bulged(const Vector3 & p)
{
  const double decay = std::exp(-(p - placeOfBulge).squaredNorm() / (widthOfBulge * widthOfBulge));
  return p + heightOfBulge * decay * placeOfBulge.normalized();
}

Deformation
bulge()
{
  return { "bulge", bulged, [](const Vector3 & p) {
            Vector3 q = p;
            for (int step = 0; step < 50; ++step)
            {
              q += p - bulged(q); // a contraction: the bulge is flatter than steep
            }
            return q;
          } };
}

analytic::Solid
unevenSolid()
{
  analytic::Solid solid = analytic::ellipsoid({ 26.0, 20.0, 16.0 });
  const auto      ellipsoid = solid.signedFunction;
  solid.signedFunction = [ellipsoid](const Vector3 & p) {
    return ellipsoid(Vector3(p.x(), p.y() * (1.0 + 0.004 * p.x()), p.z() * (1.0 - 0.006 * p.y()))); // pear-shaped
  };
  return solid;
}

ShortImage::Pointer
labelOf(const analytic::Solid & solid, const Deformation * deformation)
{
  analytic::Solid deformed = solid;
  deformed.box = { Vector3(-40.0, -36.0, -30.0), Vector3(40.0, 36.0, 30.0) };
  if (deformation != nullptr)
  {
    deformed.signedFunction = [&solid, deformation](const Vector3 & p) {
      return solid.signedFunction(deformation->inverse(p));
    };
  }
  return labelImage(analytic::labelVolume(deformed));
}

HexMesh
meshOf(const ShortImage * label, const HexMesh * templateMesh)
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

/** Median over inner nodes of the distance to where they should be [mm]. */
double
medianLandmarkError(const HexMesh & baseline, const HexMesh & followUp, const Deformation & deformation)
{
  std::vector<double> errors;
  const int           n = baseline.nodesPerSide;
  for (int k = 1; k + 1 < n; ++k)
  {
    for (int j = 1; j + 1 < n; ++j)
    {
      for (int i = 1; i + 1 < n; ++i)
      {
        const std::size_t node = baseline.nodeNumber(i, j, k);
        errors.push_back((followUp.nodes[node] - deformation.forward(baseline.nodes[node])).norm());
      }
    }
  }
  std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2), errors.end());
  return errors[errors.size() / 2];
}

/** The best affine map from the nodes of one mesh to those of another. */
Matrix3
affinePart(const HexMesh & from, const HexMesh & to)
{
  Vector3 middleFrom = Vector3::Zero();
  Vector3 middleTo = Vector3::Zero();
  for (std::size_t node = 0; node < from.nodes.size(); ++node)
  {
    middleFrom += from.nodes[node] / static_cast<double>(from.nodes.size());
    middleTo += to.nodes[node] / static_cast<double>(from.nodes.size());
  }
  Matrix3 squares = Matrix3::Zero();
  Matrix3 products = Matrix3::Zero();
  for (std::size_t node = 0; node < from.nodes.size(); ++node)
  {
    const Vector3 a = from.nodes[node] - middleFrom;
    squares += a * a.transpose();
    products += (to.nodes[node] - middleTo) * a.transpose();
  }
  return products * squares.inverse();
}

struct LandmarkErrors
{
  double  own{ 0.0 };  ///< of a mesh made on its own, in cell edges [1]
  double  tied{ 0.0 }; ///< tied to the baseline [1]
  Matrix3 affine;      ///< from the baseline to the mesh made on its own
};

LandmarkErrors
landmarkErrors(const Deformation & deformation)
{
  const analytic::Solid     solid = unevenSolid();
  const HexMesh             baseline = meshOf(labelOf(solid, nullptr), nullptr);
  const ShortImage::Pointer label = labelOf(solid, &deformation);
  const HexMesh             tied = meshOf(label, &baseline);
  const double              edge = std::cbrt(hexVolume(cellCorners(tied, 0)));
  const HexMesh             own = meshOf(label, nullptr);
  LandmarkErrors            errors;
  errors.own = medianLandmarkError(baseline, own, deformation) / edge;
  errors.tied = medianLandmarkError(baseline, tied, deformation) / edge;
  errors.affine = affinePart(baseline, own);
  std::printf("%s: median landmark error of inner nodes %.2f cell edges on its own, %.2f tied to the baseline\n",
              deformation.name,
              errors.own,
              errors.tied);
  return errors;
}

} // namespace

TEST(Correspondence, AShearIsFollowedByAMeshOfItsOwn)
{
  const LandmarkErrors errors = landmarkErrors(shear());
  const Matrix3        F = (Matrix3() << 1.0, 0.0, 0.25, 0.0, 1.0, 0.0, 0.0, 0.1, 1.0).finished();
  std::printf("affine part off by %.3f\n", (errors.affine - F).cwiseAbs().maxCoeff());
  EXPECT_LE(errors.own, 0.5);
}

TEST(Correspondence, ABendIsFollowedEitherWay)
{
  const LandmarkErrors errors = landmarkErrors(bend());
  EXPECT_LE(errors.own, 0.5);
  EXPECT_LE(errors.tied, 0.5);
}

TEST(Correspondence, ALocalBulgeIsFollowedByATiedMesh)
{
  const LandmarkErrors errors = landmarkErrors(bulge());
  EXPECT_LE(errors.tied, 0.5);
  EXPECT_LT(errors.tied, errors.own);
}
