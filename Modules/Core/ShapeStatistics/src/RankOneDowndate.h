#pragma once

#include <Eigen/Core>

#include <vector>

namespace moserhex
{

/** An eigenvalue of D - rho y y^T, and how much of rho y lies along its eigenvector, squared. */
struct DowndatedMode
{
  double eigenvalue{ 0.0 };
  double explained{ 0.0 };
};

/** The `count` largest eigenvalues, descending, of diag(d) - rho y y^T.
 *
 * Entries of y below 1e-14 of its length keep their d, and explain nothing; between the other d the secular equation
 * is bisected to the last bits, as a distance from the nearer d. An eigenvalue of at most 1e-10 of the largest d is 0
 * but for rounding, no mode: it explains nothing.
 * \param d  descending, >= 0 \param y  as long \param rho  > 0 */
[[nodiscard]] std::vector<DowndatedMode>
downdatedModes(const Eigen::VectorXd & d, const Eigen::VectorXd & y, double rho, std::size_t count);

} // namespace moserhex
