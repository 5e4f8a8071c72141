#include "OptimiserMethods.h"

#include "LatticeRefinement.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/Quality/HexQuality.h"

#include <algorithm>
#include <cmath>

namespace moserhex::optimisers
{
namespace
{
using Eigen::VectorXd;

/** The product's stages for a lattice of the size wanted, with more steps. */
const EqualisationStage firstStage{ 0.05, 20.0, 80.0, 100, 1 };
const EqualisationStage lastStage{ 0.02, 50.0, 80.0, 100, 1 };

constexpr double smallestDecrease = 1e-5; // over ten steps of L-BFGS, or one of Newton
constexpr int    coarsestNodesPerSide = 6;
constexpr int    repetitions = 2; // the shortest time counts

/** Makes a preconditioner for a stage that begins at x. */
using PreconditionerMaker =
  std::function<PreconditionerInPlace(Problem &, const VectorXd & x, const EqualisationStage & stage)>;

PreconditionerInPlace
noPreconditioner(Problem & /*problem*/, const VectorXd & /*x*/, const EqualisationStage & /*stage*/)
{
  return {};
}

PreconditionerInPlace
blockJacobi(Problem & problem, const VectorXd & x, const EqualisationStage & stage)
{
  problem.linearise(x);
  return problem.blockJacobi(x, stage);
}

PreconditionerInPlace
cosineLaplacian(Problem & problem, const VectorXd & /*x*/, const EqualisationStage & /*stage*/)
{
  return [&problem](VectorXd & v) { problem.solveLaplacian(v); };
}

void
minimiseByBfgs(Problem & problem, VectorXd & x, const EqualisationStage & stage, const PreconditionerMaker & maker)
{
  LimitedMemoryBfgsOptions options;
  options.maximumSteps = stage.maximumSteps;
  options.smallestDecrease = smallestDecrease;
  const auto f = [&](const VectorXd & at, VectorXd & gradient) { return problem.energy(at, stage, gradient); };
  minimiseByLimitedMemoryBfgs(f, x, maker(problem, x, stage), options);
}

/** Conjugate gradients for H d = -gradient, preconditioned by the cosine Laplacian, to a tenth of the residual. */
VectorXd
newtonDirection(Problem & problem, const VectorXd & x, const EqualisationStage & stage, const VectorXd & gradient)
{
  constexpr int    maximumSteps = 60;
  constexpr double tolerance = 0.1;
  VectorXd         d = VectorXd::Zero(x.size());
  VectorXd         r = -gradient;
  VectorXd         z = r;
  problem.solveLaplacian(z);
  VectorXd     p = z;
  double       rz = r.dot(z);
  const double enough = tolerance * tolerance * rz;
  for (int step = 0; step < maximumSteps && rz > enough; ++step)
  {
    const VectorXd Hp = problem.hessianProduct(x, stage, p);
    const double   length = rz / p.dot(Hp); // the Gauss-Newton form and the springs are positive definite together
    d += length * p;
    r -= length * Hp;
    z = r;
    problem.solveLaplacian(z);
    const double next = r.dot(z);
    p = z + next / rz * p;
    rz = next;
  }
  return d;
}

/** Truncated Newton with the Gauss-Newton Hessian and Armijo's line search. */
void
minimiseByNewton(Problem & problem, VectorXd & x, const EqualisationStage & stage)
{
  constexpr double sufficientDecrease = 1e-4;
  constexpr int    maximumTrials = 25;
  VectorXd         gradient(x.size());
  double           value = problem.energy(x, stage, gradient);
  for (int step = 0; step < stage.maximumSteps; ++step)
  {
    problem.linearise(x);
    const VectorXd d = newtonDirection(problem, x, stage, gradient);
    const double   slope = gradient.dot(d);
    double         length = 1.0;
    VectorXd       next = x + d;
    double         nextValue = problem.energy(next, stage, gradient);
    for (int trial = 0; trial < maximumTrials && !(nextValue <= value + sufficientDecrease * length * slope); ++trial)
    {
      length *= 0.5;
      next = x + length * d;
      nextValue = problem.energy(next, stage, gradient);
    }
    if (!(nextValue < value))
    {
      return;
    }
    const double decrease = value - nextValue;
    x.swap(next);
    value = nextValue;
    if (decrease < smallestDecrease * std::abs(value))
    {
      return;
    }
  }
}

/** The energy of the last stage and the quality of a lattice on the problem that all methods share. */
Outcome
assess(Problem & problem, const VectorXd & x)
{
  Outcome outcome;
  outcome.evaluations = problem.evaluations();
  outcome.hessianProducts = problem.hessianProducts();
  VectorXd                unused(x.size());
  const HexMesh           mesh = problem.mesh(x);
  const HexQualitySummary quality = summarizeQuality(mesh);
  outcome.energy = problem.energy(x, lastStage, unused) / static_cast<double>(mesh.cellCount());
  outcome.smallestJacobian = quality.scaledJacobian.minimum;
  outcome.variance = quality.volumeVariance;
  outcome.concaveCells = quality.concaveCells;
  return outcome;
}

/** Runs several times and keeps the shortest time. */
Outcome
timed(const Case & organ, const std::function<VectorXd(Problem &)> & minimise)
{
  Outcome outcome;
  double  seconds = 0.0;
  for (int repetition = 0; repetition < repetitions; ++repetition)
  {
    Problem         problem(organ, organ.start);
    const Stopwatch stopwatch;
    const VectorXd  x = minimise(problem);
    const double    elapsed = stopwatch.seconds();
    seconds = repetition == 0 ? elapsed : std::min(seconds, elapsed);
    outcome = assess(problem, x);
  }
  outcome.seconds = seconds;
  return outcome;
}

/** Minimises on the lattice wanted, one stage after the other. */
Method
direct(const std::string &                                                             name,
       const std::vector<EqualisationStage> &                                          stages,
       const std::function<void(Problem &, VectorXd & x, const EqualisationStage &)> & minimise)
{
  return { name, [=](const Case & organ) {
            return timed(organ, [&](Problem & problem) {
              VectorXd x = problem.start();
              for (const EqualisationStage & stage : stages)
              {
                minimise(problem, x, stage);
              }
              return x;
            });
          } };
}

Method
directBfgs(const std::string & name, const PreconditionerMaker & maker)
{
  return direct(name, { firstStage, lastStage }, [maker](Problem & problem, VectorXd & x, const EqualisationStage & s) {
    minimiseByBfgs(problem, x, s, maker);
  });
}

Method
directNewton(const std::string & name)
{
  std::vector<EqualisationStage> stages{ firstStage, lastStage };
  stages[0].maximumSteps = 12;
  stages[1].maximumSteps = 8;
  return direct(name, stages, minimiseByNewton);
}

/** The lattice on another number of nodes. */
HexMesh
resampled(const HexMesh & mesh, int nodesPerSide)
{
  return { nodesPerSide, interpolateLattice(mesh.nodes, mesh.nodesPerSide, nodesPerSide) };
}

Outcome
coarseToFine(const Case & organ)
{
  const EqualisationOptions options; // the product's stages
  return timed(organ, [&](Problem & finest) {
    const int              n = organ.start.nodesPerSide;
    const std::vector<int> levels = refinementLevels(coarsestNodesPerSide, n);
    HexMesh                mesh = organ.start;
    for (std::size_t level = 0; level + 1 < levels.size(); ++level)
    {
      mesh = resampled(mesh, levels[level]);
      Problem  problem(organ, mesh);
      VectorXd x = problem.start();
      for (const EqualisationStage & stage : options.coarseStages)
      {
        minimiseByBfgs(problem, x, stage, cosineLaplacian);
      }
      mesh = problem.mesh(x);
    }
    VectorXd x = finest.vectorOf(resampled(mesh, n));
    finest.moveBoundaryToLevel(x);
    for (const EqualisationStage & stage : options.finestStages)
    {
      minimiseByBfgs(finest, x, stage, cosineLaplacian);
    }
    return x;
  });
}

} // namespace

std::vector<Method>
methods()
{
  return { directBfgs("L-BFGS, plain", noPreconditioner),
           directBfgs("L-BFGS, block Jacobi", blockJacobi),
           directBfgs("L-BFGS, cosine Laplacian", cosineLaplacian),
           directNewton("truncated Newton, cosine Laplacian"),
           { "L-BFGS, cosine Laplacian, coarse to fine", coarseToFine } };
}

} // namespace moserhex::optimisers
