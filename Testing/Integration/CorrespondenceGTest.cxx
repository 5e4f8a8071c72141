// Known deformations of a solid without symmetry: how far the nodes of the deformed label's mesh are from where the
// deformation takes the nodes of the first one, and how far their best affine map is from that of the truth. Bounds:
// half a cell edge for the median over inner nodes when tied to the first mesh by shape alone, 2 % for the affine part
// with landmarks; the other ways are printed beside it.
#include "PipelineRun.h"

#include "moserhex/Analytic/SolidShapes.h"
#include "moserhex/Geometry/HexMeshNumbering.h"

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

/** Sixty boundary nodes and where the deformation takes them. */
TemplateRefinement
landmarksOn(const HexMesh & baseline, const Deformation & deformation)
{
  constexpr std::size_t          count = 60;
  const std::vector<std::size_t> nodes = boundaryNodes(baseline);
  TemplateRefinement             refinement;
  for (std::size_t l = 0; l < count; ++l)
  {
    const Vector3 & place = baseline.nodes[nodes[(2 * l + 1) * nodes.size() / (2 * count)]];
    refinement.landmarks.push_back({ place, deformation.forward(place) });
  }
  return refinement;
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

CorrespondenceErrors
errorsUnder(const Deformation & deformation)
{
  const analytic::Solid     solid = unevenSolid();
  const HexMesh             baseline = meshOf(labelOf(solid, nullptr), nullptr);
  const ShortImage::Pointer label = labelOf(solid, &deformation);
  HexMesh                   truth = baseline;
  for (Vector3 & node : truth.nodes)
  {
    node = deformation.forward(node);
  }
  const auto errorOf = [&](const char * way, const HexMesh & mesh) {
    const double              edge = std::cbrt(hexVolume(cellCorners(mesh, 0)));
    const CorrespondenceError error{ medianLandmarkError(baseline, mesh, deformation) / edge,
                                     (affinePart(baseline, mesh) - affinePart(baseline, truth)).cwiseAbs().maxCoeff() };
    std::printf("%s, %s: median of inner nodes %.2f cell edges, affine part off by %.3f\n",
                deformation.name,
                way,
                error.median,
                error.affine);
    return error;
  };
  return { errorOf("on its own", meshOf(label, nullptr)),
           errorOf("tied", meshOf(label, &baseline)),
           errorOf("tied, affine", meshOf(label, &baseline, TemplateAlignment::Affine)),
           errorOf("tied, landmarks",
                   meshOf(label, &baseline, TemplateAlignment::None, landmarksOn(baseline, deformation))) };
}

} // namespace

TEST(Correspondence, AShearIsFollowed)
{
  const CorrespondenceErrors errors = errorsUnder(shear());
  EXPECT_LE(errors.own.median, 0.5);
  EXPECT_LE(errors.affine.median, 0.5);
  EXPECT_LE(errors.landmarks.median, 0.5);
  EXPECT_LE(errors.landmarks.affine, 0.02);
}

TEST(Correspondence, ABendIsFollowed)
{
  const CorrespondenceErrors errors = errorsUnder(bend());
  EXPECT_LE(errors.own.median, 0.5);
  EXPECT_LE(errors.tied.median, 0.5);
  EXPECT_LE(errors.affine.median, 0.5);
  EXPECT_LE(errors.landmarks.median, 0.5);
  EXPECT_LE(errors.landmarks.affine, 0.02);
}

TEST(Correspondence, ALocalBulgeIsFollowedByATiedMesh)
{
  const CorrespondenceErrors errors = errorsUnder(bulge());
  EXPECT_LE(errors.tied.median, 0.5);
  EXPECT_LT(errors.tied.median, errors.own.median);
  EXPECT_LE(errors.affine.median, 0.5);
  EXPECT_LE(errors.landmarks.median, 0.5);
  EXPECT_LE(errors.landmarks.affine, 0.02);
}
