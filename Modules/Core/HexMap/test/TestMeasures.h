#pragma once

#include "TestLattices.h"
#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/HexMap/CellMeasure.h"
#include "moserhex/LevelSet/Density.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>

namespace moserhex::testing
{

/** mu = constant + slope . x */
class LinearDensity : public Density
{
public:
  LinearDensity(double constant, const Vector3 & slope) : m_Constant(constant), m_Slope(slope)
  {}

  [[nodiscard]] ValueAndGradient
  at(const Vector3 & p) const override
  {
    return { m_Constant + m_Slope.dot(p), m_Slope };
  }

private:
  double  m_Constant;
  Vector3 m_Slope;
};

/** The mesh scaled by 2, turned and 100 mm away from the origin. */
inline HexMesh
farAndOblique(HexMesh mesh)
{
  const Matrix3 turn = Eigen::AngleAxisd(0.7, Vector3(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  for (Vector3 & node : mesh.nodes)
  {
    node = 2.0 * (turn * node) + Vector3(100.0, -50.0, 30.0);
  }
  return mesh;
}

inline std::vector<double>
measuresOf(const CellMeasure & measure, const HexMesh & mesh)
{
  std::vector<double> measures;
  measure.evaluate(mesh, 1, measures);
  return measures;
}

/** Fitted order of max |m(x + t d) - m(x) - t dm/dx d| in t, for one random displacement d of every node. */
inline double
taylorOrder(const CellMeasure & measure, const HexMesh & mesh)
{
  Random    random(17);
  Positions displacement(mesh.nodes.size());
  for (Vector3 & d : displacement)
  {
    d = Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  }
  std::vector<double> measures;
  CellGradients       gradients;
  measure.evaluate(mesh, 1, measures, &gradients);

  std::vector<double> steps;
  std::vector<double> remainders;
  for (const double step : { 4e-3, 2e-3, 1e-3, 5e-4 })
  {
    HexMesh moved = mesh;
    for (std::size_t node = 0; node < moved.nodes.size(); ++node)
    {
      moved.nodes[node] += step * displacement[node];
    }
    const std::vector<double> movedMeasures = measuresOf(measure, moved);
    double                    largest = 0.0;
    for (std::size_t cell = 0; cell < measures.size(); ++cell)
    {
      const auto nodes = mesh.cellNodes(cell);
      double     linear = 0.0;
      for (std::size_t a = 0; a < 8; ++a)
      {
        const auto row = static_cast<Eigen::Index>(3 * a);
        linear += gradients.col(static_cast<Eigen::Index>(cell)).segment<3>(row).dot(displacement[nodes[a]]);
      }
      largest = std::max(largest, std::abs(movedMeasures[cell] - measures[cell] - step * linear));
    }
    steps.push_back(step);
    remainders.push_back(largest);
  }
  return analytic::observedOrder(steps, remainders);
}

/** One and three threads give the same bits, with gradients and without. */
inline void
expectSameForThreads(const CellMeasure & measure, const HexMesh & mesh)
{
  std::vector<double> one;
  std::vector<double> three;
  CellGradients       oneGradient;
  CellGradients       threeGradient;
  measure.evaluate(mesh, 1, one, &oneGradient);
  measure.evaluate(mesh, 3, three, &threeGradient);
  EXPECT_EQ(one, three);
  EXPECT_TRUE(oneGradient == threeGradient);
  measure.evaluate(mesh, 3, three);
  EXPECT_EQ(measuresOf(measure, mesh), three);
}

} // namespace moserhex::testing
