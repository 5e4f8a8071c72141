#pragma once

#include "moserhex/Common/StepReport.h"

#include <Eigen/Core>

#include <functional>

namespace moserhex
{

/** Options of minimiseByLimitedMemoryBfgs. */
struct LimitedMemoryBfgsOptions
{
  int          maximumSteps{ 100 };        ///< at most, >= 0
  int          memory{ 8 };                ///< pairs kept, at least 1
  int          window{ 10 };               ///< the decrease is judged over so many steps
  double       smallestDecrease{ 1e-5 };   ///< done when f falls by less than this part of |f| within a window [1]
  double       sufficientDecrease{ 1e-4 }; ///< Armijo's constant [1]
  int          maximumTrials{ 25 };        ///< of one line search
  unsigned int threads{ 1 };               ///< for the method's own sums; the result does not depend on it
};

/** How the minimisation ended. */
struct LimitedMemoryBfgsResult
{
  double     value{ 0.0 };        ///< f at the end
  double     gradientNorm{ 0.0 }; ///< Euclidean
  int        evaluations{ 0 };    ///< of f and its gradient
  StepReport report;              ///< residual: decrease of f over the last window, relative [1]
};

/** f and its gradient at a point; the gradient comes in with the point's size, contents undefined. May return a number
 * that is not finite for a point outside f's domain: the line search then shortens the step. */
using DifferentiableFunction = std::function<double(const Eigen::VectorXd & x, Eigen::VectorXd & gradient)>;

/** Replaces a vector by H0 times it, H0 symmetric positive definite: an approximate inverse of f's Hessian up to a
 * scale, which is fitted. */
using PreconditionerInPlace = std::function<void(Eigen::VectorXd &)>;

/** Minimises f by L-BFGS (Nocedal and Wright, "Numerical Optimization", algorithm 7.4) with the initial inverse Hessian
 *
 *   gamma H0,   gamma = s.y / y.H0 y  from the latest pair
 *
 * (1 before there is one), a backtracking line search (Armijo, quadratic interpolation, at most halving to a tenth),
 * and a restart from gamma H0 without the pairs where the search fails or the direction does not descend.
 *
 * \param x               start; the minimiser found on return
 * \param preconditioner  empty: the identity
 * \param progress        told of every step
 * \throws InvalidInput   an option out of range, or f not finite at the start
 * \throws Cancelled      by the callback
 * \note `converged` says that f stopped falling (or that its gradient vanished); running out of steps does not throw;
 * `note` says why there was no convergence. f never rises. */
LimitedMemoryBfgsResult
minimiseByLimitedMemoryBfgs(const DifferentiableFunction &   f,
                            Eigen::VectorXd &                x,
                            const PreconditionerInPlace &    preconditioner = {},
                            const LimitedMemoryBfgsOptions & options = {},
                            const ProgressCallback &         progress = {});

} // namespace moserhex
