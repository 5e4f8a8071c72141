// Places of landmarks and standardised images: closed forms, to round-off or to what the smoothing leaves.
#include "TemplateRefiner.h"

#include "SmoothedImage.h"
#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Analytic/Refusals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace moserhex;

namespace
{

/** A cube of side 10 mm at the origin. */
HexMesh
cube()
{
  return analytic::lattice(6, [](const Vector3 & index) { return Vector3(2.0 * index); });
}

/** Values of a function in voxels of 0.5 mm that cover the cube and 10 mm around it. */
template <typename TFunction>
ScalarVolume
imageOf(const TFunction & function, double outer = 10.0)
{
  ScalarVolume image;
  const int    size = static_cast<int>((10.0 + 2.0 * outer) / 0.5) + 1;
  image.size = { { size, size, size } };
  image.spacing = Vector3::Constant(0.5);
  image.origin = Vector3::Constant(-outer);
  for (int k = 0; k < size; ++k)
  {
    for (int j = 0; j < size; ++j)
    {
      for (int i = 0; i < size; ++i)
      {
        image.values.push_back(function(image.point(i, j, k)));
      }
    }
  }
  return image;
}

double
wave(const Vector3 & p)
{
  return std::sin(0.4 * p.x()) + std::cos(0.3 * p.y() - 0.2 * p.z());
}

TemplateRefinement
landmarkAt(const Vector3 & onTemplate, const Vector3 & onSolid)
{
  TemplateRefinement refinement;
  refinement.landmarks = { { onTemplate, onSolid } };
  return refinement;
}

} // namespace

TEST(TemplateRefiner, ALandmarkInsideIsFollowedByItsCell)
{
  const HexMesh            mesh = cube();
  const TemplateRefinement refinement = landmarkAt(Vector3(3.1, 4.7, 8.9), Vector3(3.1, 4.7, 8.9));
  const TemplateRefiner    refiner(mesh, refinement);
  EXPECT_LT(landmarkError(mesh, refiner.landmarks()), 1e-12);
  HexMesh moved = mesh;
  for (Vector3 & node : moved.nodes)
  {
    node = node.cwiseProduct(Vector3(1.0, 2.0, 1.0));
  }
  EXPECT_NEAR(landmarkError(moved, refiner.landmarks()), 4.7, 1e-12);
}

TEST(TemplateRefiner, ALandmarkOutsideIsThatOfTheNearestBoundaryPoint)
{
  const HexMesh            mesh = cube();
  const TemplateRefinement refinement = landmarkAt(Vector3(11.5, 4.7, 8.9), Vector3(10.0, 4.7, 8.9));
  EXPECT_LT(landmarkError(mesh, TemplateRefiner(mesh, refinement).landmarks()), 1e-12);
}

TEST(TemplateRefiner, SaysHowFarOutsideOfTheTemplateALandmarkIs)
{
  const HexMesh      mesh = cube();
  TemplateRefinement refinement = landmarkAt(Vector3(11.5, 4.7, 8.9), Vector3::Zero());
  refinement.landmarks.push_back({ Vector3(3.0, 4.0, 5.0), Vector3::Zero() });
  refinement.landmarks.push_back({ Vector3(-3.0, -4.0, 5.0), Vector3::Zero() });
  const std::vector<double> outside = TemplateRefiner(mesh, refinement).distancesOutside();
  ASSERT_EQ(outside.size(), 3u);
  EXPECT_NEAR(outside[0], 1.5, 1e-12);
  EXPECT_EQ(outside[1], 0.0);
  EXPECT_NEAR(outside[2], 5.0, 1e-12);
}

TEST(TemplateRefiner, AnImageInOtherUnitsIsTheSame)
{
  const HexMesh      mesh = cube();
  TemplateRefinement refinement;
  refinement.images =
    CorrespondingImages{ imageOf(wave), imageOf([](const Vector3 & p) { return 700.0 + 3.0 * wave(p); }) };
  const TemplateRefiner refiner(mesh, refinement);
  ASSERT_EQ(refiner.scales().size(), 3u);
  for (const double scale : refiner.scales())
  {
    EXPECT_LT(imageDifference(mesh, refiner.image(mesh, scale)), 1e-10);
  }
}

TEST(TemplateRefiner, ImagesAreInUnitsOfTheTemplatesDeviationWhateverTheirBrightness)
{
  const HexMesh      mesh = cube();
  TemplateRefinement refinement;
  const auto         brighter = [](const Vector3 & p) { return 7.0 + 3.0 * wave(p); };
  refinement.images = CorrespondingImages{ imageOf(wave), imageOf(brighter) };
  const LatticeImage image = TemplateRefiner(mesh, refinement).image(mesh, 1.0);
  double             sum = 0.0;
  double             squares = 0.0;
  for (const double value : image.values)
  {
    sum += value;
    squares += value * value;
  }
  const auto count = static_cast<double>(image.values.size());
  EXPECT_NEAR(squares / count - std::pow(sum / count, 2), 1.0, 1e-12);
  EXPECT_LT(imageDifference(mesh, image), 1e-12);
}

TEST(TemplateRefiner, GreyValuesDoNotDependOnHowMuchOfTheOrganATissueFills)
{
  const auto ball = [](double radius) {
    return imageOf([radius](const Vector3 & p) {
      return 100.0 + 50.0 / (1.0 + std::exp(4.0 * ((p - Vector3::Constant(5.0)).norm() - radius)));
    });
  };
  const HexMesh      mesh = cube();
  TemplateRefinement refinement;
  refinement.images = CorrespondingImages{ ball(4.0), ball(3.0) }; // 27 and 11 % of the cube
  const LatticeImage image = TemplateRefiner(mesh, refinement).image(mesh, 0.5);
  const double       bright = *std::max_element(image.values.begin(), image.values.end());
  const double       dark = *std::min_element(image.values.begin(), image.values.end());
  EXPECT_NEAR(image.image(Vector3::Constant(5.0)).value, bright, 0.1 * (bright - dark));
  EXPECT_NEAR(image.image(Vector3::Constant(0.5)).value, dark, 0.1 * (bright - dark));
}

TEST(TemplateRefiner, RefusesWhatSaysNothing)
{
  const HexMesh mesh = cube();
  EXPECT_THROW(TemplateRefiner(mesh, landmarkAt(Vector3::Constant(NAN), Vector3::Zero())), InvalidInput);
  TemplateRefinement refinement;
  refinement.images = CorrespondingImages{ imageOf(wave, -2.0), imageOf(wave) }; // does not cover the cube
  EXPECT_EQ(analytic::codeThrownBy([&] { TemplateRefiner(mesh, refinement); }), ErrorCode::TemplateImage);
  refinement.images = CorrespondingImages{ imageOf(wave), imageOf(wave, -2.0) };
  EXPECT_EQ(analytic::codeThrownBy([&] { TemplateRefiner(mesh, refinement).requireSolidCovered(mesh.nodes); }),
            ErrorCode::Image);
  const ScalarVolume constant = imageOf([](const Vector3 &) { return 7.0; });
  refinement.images = CorrespondingImages{ constant, imageOf(wave) };
  EXPECT_EQ(analytic::codeThrownBy([&] { (void)TemplateRefiner(mesh, refinement).image(mesh, 1.0); }),
            ErrorCode::TemplateImage);
  refinement.images = CorrespondingImages{ imageOf(wave), constant };
  EXPECT_EQ(analytic::codeThrownBy([&] { (void)TemplateRefiner(mesh, refinement).image(mesh, 1.0); }),
            ErrorCode::Image);
}

TEST(SmoothedImage, WavesShorterThanItsGridLeaveNoPattern)
{
  const double sigma = 4.0; // a grid of 2 mm on voxels of 0.5 mm
  for (const double wavelength : { 1.25, 1.7, 1.9, 2.3, 2.9 })
  {
    const double        k = 2.0 * pi / wavelength;
    const SmoothedImage waves(
      imageOf([k](const Vector3 & q) { return std::sin(k * q.x() + 0.5 * k * q.z()); }, 14.0), cube().nodes, sigma);
    for (double x = 0.0; x <= 10.0; x += 0.37)
    {
      EXPECT_LT(std::abs(waves.at(Vector3(x, 5.1, 4.3)).value), 0.06) << wavelength << ' ' << x;
    }
  }
}

TEST(SmoothedImage, KeepsLinearFunctionsAndDampsWaves)
{
  const double        sigma = 1.5;
  const double        k = 0.8;
  const SmoothedImage linear(imageOf([](const Vector3 & p) { return 2.0 * p.x() - p.z(); }), cube().nodes, sigma);
  const Vector3       p(4.3, 5.1, 6.2);
  EXPECT_NEAR(linear.at(p).value, 2.0 * p.x() - p.z(), 1e-9);
  EXPECT_LT((linear.at(p).gradient - Vector3(2.0, 0.0, -1.0)).norm(), 1e-9);
  const SmoothedImage waves(imageOf([k](const Vector3 & q) { return std::sin(k * q.x()); }), cube().nodes, sigma);
  EXPECT_NEAR(waves.at(p).value, std::exp(-0.5 * k * k * sigma * sigma) * std::sin(k * p.x()), 0.02);
}
