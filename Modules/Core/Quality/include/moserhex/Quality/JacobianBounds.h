#pragma once

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/Geometry/UnstructuredHexMesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace moserhex
{

/** Coefficient (p,q,r) has the number p + 3 (q + 3 r), p along xi, q along eta, r along zeta. */
using BezierCoefficients = std::array<double, 27>;

/** Bernstein-Bezier coefficients of det J of the trilinear hexahedron over the reference cube [0,1]^3 [mm^3].
 *
 *   det J = a(eta,zeta) . (b(xi,zeta) x c(xi,eta)) = sum_pqr B_pqr beta_p(xi) beta_q(eta) beta_r(zeta)
 *   beta_0 = (1-t)^2, beta_1 = 2 t (1-t), beta_2 = t^2      a, b, c: the tangents, bilinear
 *
 * min B <= det J <= max B everywhere in the cell (convex hull), and B = det J at the 8 corners (p, q, r in {0,2}).
 * Johnen, Remacle, Geuzaine, "Geometrical validity of curvilinear finite elements", J. Comput. Phys. 233, 2013. */
[[nodiscard]] BezierCoefficients
bezierJacobianCoefficients(const HexCorners & corners);

/** The smallest of the 27 coefficients of every cell: a lower bound of det J in the cell [mm^3].
 *
 * A cell whose number is positive (by more than rounding, see certifyPositive) is valid everywhere; one whose number
 * is not may be valid all the same: ask certifyPositive. Cells independent of each other: the same for any number of
 * threads. About 0.1 us a cell on one core.
 * \param threads  as in parallelFor; 0: all of the machine's */
[[nodiscard]] std::vector<double>
smallestBezierCoefficients(const HexMesh & mesh, unsigned int threads = 1);
/** The same for a mesh of any connectivity. */
[[nodiscard]] std::vector<double>
smallestBezierCoefficients(const UnstructuredHexMesh & mesh, unsigned int threads = 1);

/** What is known of the sign of det J in a cell. */
enum class JacobianSign
{
  Positive,    ///< det J > 0 in the whole closed cell
  NotPositive, ///< det J <= 0 at a corner, or negative at a point inside
  Undecided    ///< neither shown: the smallest det J is closer to 0 than rounding or the subdivision resolves
};

/** Options of certifyPositive: how long it may search. */
struct CertificateOptions
{
  unsigned int maximumDepth{ 36 };   ///< halvings one after the other, each in one direction; at most 60 [1]
  std::size_t  maximumBoxes{ 4000 }; ///< boxes looked at in one cell [1]
};

/** What certifyPositive found. */
struct JacobianCertificate
{
  JacobianSign sign{ JacobianSign::Undecided }; ///< of det J in the whole cell
  double       lowerBound{ 0.0 };               ///< min det J is not below [mm^3]
  double       upperBound{ 0.0 };               ///< smallest det J met at a point: min det J is not above [mm^3]
  Vector3      point{ Vector3::Zero() };        ///< where it was met, reference cube [0,1]^3 [1]
};

/** Is det J positive in the whole cell, not only at its corners?
 *
 * Coefficients all positive: yes. A corner with det J <= 0 by cornerJacobians(), or a negative value at a corner of a
 * box: no. Otherwise the box is halved (de Casteljau) along the direction in which the coefficients are farthest from
 * det J, to which they converge with order 2. Both answers ask for more than the rounding of the coefficients, 64 eps
 * |a||b||c| with the four edges along each axis as one vector (corners excepted, whose sign is taken as computed): they
 * hold in exact arithmetic for the coordinates as they are. No allocation.
 * \throws InvalidInput  maximumDepth above 60, or a coordinate is not finite */
[[nodiscard]] JacobianCertificate
certifyPositive(const HexCorners & corners, const CertificateOptions & options = {});

/** Cells of a mesh by what certifyPositive says. */
struct CertificateCounts
{
  std::size_t positive{ 0 };    ///< det J > 0 in the whole cell
  std::size_t notPositive{ 0 }; ///< det J <= 0 somewhere in the cell
  std::size_t undecided{ 0 };   ///< neither shown
};

/** certifyPositive for every cell; cells with positive coefficients cost as little as in smallestBezierCoefficients.
 * \throws InvalidInput  as certifyPositive */
[[nodiscard]] CertificateCounts
certifyCells(const HexMesh & mesh, const CertificateOptions & options = {}, unsigned int threads = 1);
/** The same for a mesh of any connectivity. */
[[nodiscard]] CertificateCounts
certifyCells(const UnstructuredHexMesh & mesh, const CertificateOptions & options = {}, unsigned int threads = 1);

} // namespace moserhex
