#pragma once

#include "TestLattices.h"
#include "moserhex/HexMap/SignedDistance.h"

#include <cmath>

namespace moserhex::testing
{

/** Ellipsoid |q / a| = 1, bent in the plane of x and z by the shear q = (x, y, z + curvature x^2), which keeps its
 * volume; placed in space by p = shift + turn q.
 *
 * The distance is that of one Newton step, f / |grad f| with f = (|q / a|^2 - 1) / 2, smoothed where grad f vanishes:
 * of length 1 to about 1 % on the surface, smooth everywhere. */
struct BentEllipsoid
{
  Vector3 semiAxes{ Vector3::Ones() };
  double  curvature{ 0.0 };            ///< [1/mm]
  Matrix3 turn{ Matrix3::Identity() }; ///< a rotation
  Vector3 shift{ Vector3::Zero() };

  [[nodiscard]] double
  volume() const
  {
    return 4.0 / 3.0 * pi * semiAxes.prod();
  }

  /** The solid's point that the ball's point of direction and radius comes to. */
  [[nodiscard]] Vector3
  ofUnitBall(const Vector3 & point) const
  {
    const Vector3 q = point.cwiseProduct(semiAxes);
    return shift + turn * Vector3(q[0], q[1], q[2] - curvature * q[0] * q[0]);
  }

  [[nodiscard]] SignedDistance
  distance() const
  {
    return [*this](const Vector3 & point, Vector3 & gradient) {
      const Vector3 p = turn.transpose() * (point - shift);
      const Vector3 D = semiAxes.cwiseProduct(semiAxes).cwiseInverse();
      const Vector3 q(p[0], p[1], p[2] + curvature * p[0] * p[0]);
      const Vector3 Dq = D.cwiseProduct(q);
      Matrix3       J = Matrix3::Identity(); // dq/dp
      J(2, 0) = 2.0 * curvature * p[0];
      Matrix3 H = J.transpose() * D.asDiagonal() * J;
      H(0, 0) += 2.0 * curvature * Dq[2];
      const Vector3 df = J.transpose() * Dq;
      const double  f = 0.5 * (q.dot(Dq) - 1.0);
      const double  smallest = 0.1 / semiAxes.maxCoeff();
      const double  length = std::sqrt(df.squaredNorm() + smallest * smallest);
      gradient = turn * (df / length - f / (length * length * length) * (H * df));
      return f / length;
    };
  }

  /** Ball's lattice with nodes on the sphere and homothetic shells, n = 2 shells nodes a side, carried over. */
  [[nodiscard]] HexMesh
  lattice(int shells) const
  {
    HexMesh mesh = starShapedMesh(shells, [](const Vector3 &) { return 1.0; });
    for (Vector3 & node : mesh.nodes)
    {
      node = ofUnitBall(node);
    }
    return mesh;
  }

  /** Of the boundary nodes of such a lattice: points of the surface. */
  [[nodiscard]] Positions
  boundaryPoints(int shells) const
  {
    const HexMesh mesh = lattice(shells);
    Positions     points;
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    {
      if (onBoundary(mesh.nodesPerSide, node))
      {
        points.push_back(mesh.nodes[node]);
      }
    }
    return points;
  }
};

inline BentEllipsoid
ballOfRadius(double radius)
{
  return { Vector3::Constant(radius) };
}

/** The box [0,1]^3 stretched to these sides: exact distance, with kinks beyond its edges. */
inline SignedDistance
boxDistance(const Vector3 & sides)
{
  return [half = Vector3(0.5 * sides)](const Vector3 & point, Vector3 & gradient) {
    const Vector3 p = point - half;
    const Vector3 beyond = p.cwiseAbs() - half;
    const Vector3 outside = beyond.cwiseMax(0.0);
    const double  distance = outside.norm();
    Eigen::Index  nearest = 0;
    const double  inside = beyond.maxCoeff(&nearest);
    gradient.setZero();
    if (distance > 0.0)
    {
      gradient = (outside / distance).cwiseProduct(p.cwiseSign());
      return distance;
    }
    gradient[nearest] = p[nearest] < 0.0 ? -1.0 : 1.0;
    return inside;
  };
}

} // namespace moserhex::testing
