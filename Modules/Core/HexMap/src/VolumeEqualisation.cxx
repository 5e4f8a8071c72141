#include "moserhex/HexMap/VolumeEqualisation.h"

#include "EqualisationFlaws.h"
#include "LatticeOptimiser.h"
#include "LatticeRefinement.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/Quality/HexQuality.h"
#include "moserhex/Quality/JacobianBounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <tuple>

namespace moserhex
{
namespace
{

/** n of the lattice a tangled mesh is taken back to. */
constexpr int coarsestNodesPerSide = 6;

/** Relative decrease over ten steps at which a minimisation ends [1]. */
constexpr double smallestDecrease = 1e-5;
constexpr double smallestDecreaseOfRepair = 1e-7;

/** Repair: cells with a Bezier coefficient below this (det J of a mean cell = 1) are watched. */
constexpr double doubtfulCoefficient = 0.2;
/** Repair, round r: weight 2000 2^r, margin times 1.3^r. */
constexpr double            repairWeight = 2000.0;
constexpr double            repairWeightGrowth = 2.0;
constexpr double            repairMarginGrowth = 1.3;
constexpr double            largestRepairMargin = 0.15;
constexpr EqualisationStage repairStage{ 0.02, 1000.0, 80.0, 60, 1 };
/** After so many useless rounds in a row the repair is over. */
constexpr int patience = 3;
/** The projection bends cells that are far from equal. Above the first mean square deviation it is not tried; below the
 * second it bends them hardly at all. */
constexpr double roughDeviation = 1e-3;
constexpr double readyDeviation = 3e-5;
constexpr int    settlingRounds = 5;
constexpr int    settlingSteps = 60;
constexpr double settlingGrowth = 4.0;
/** Of coarse lattices that the ordinary stages leave tangled. */
constexpr std::array<EqualisationStage, 2> untanglingStages{ { { 0.02, 0.0, 80.0, 60, 1 },
                                                               { 0.005, 0.0, 80.0, 60, 1 } } };
/** Springs longer than this part of the tolerance are made stiffer by this factor a round. */
constexpr double safePartOfTolerance = 0.8;
constexpr double springGrowth = 4.0;
constexpr double springGrowthOfTangled = 2.0; // lest springs outgrow the barrier of cells that are not yet positive
/** phi is not quite a distance away from the surface: what is aimed at, part of the tolerance. */
constexpr double aimedPartOfTolerance = 0.95;
/** Where the smallest scaled Jacobian is below this, the mesh is repaired, too, though it may be exact [1]. */
constexpr double aimedScaledJacobian = 0.035;

double
smallestScaledJacobian(const HexMesh & mesh)
{
  double smallest = 1.0;
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    smallest = std::min(smallest, hexCellQuality(cellCorners(mesh, cell)).scaledJacobian);
  }
  return smallest;
}

void
require(bool holds, const std::string & what)
{
  if (!holds)
  {
    throw InvalidInput("equalisation: " + what);
  }
}

void
requireStages(const std::vector<EqualisationStage> & stages)
{
  for (const EqualisationStage & stage : stages)
  {
    require(stage.regularisation > 0.0 && std::isfinite(stage.regularisation), "regularisation must be positive");
    require(stage.volumeWeight >= 0.0 && stage.surfaceWeight >= 0.0, "weights must not be negative");
    require(stage.maximumSteps >= 0, "number of steps must not be negative");
    require(stage.power >= 1 && stage.power <= 8, "power must be in 1..8");
  }
}

/** One attempt at the whole work: owns the mesh on its present lattice. */
class Equaliser
{
public:
  Equaliser(const HexMesh &             start,
            const SignedDistance &      phi,
            double                      volume,
            const CellMeasure &         measure,
            double                      total,
            const EqualisationOptions & options)
    : m_Mesh(start), m_Phi(phi), m_Volume(volume), m_Measure(measure), m_Total(total), m_Options(options)
  {
    m_Origin.setZero();
    for (const Vector3 & node : start.nodes)
    {
      m_Origin += node / static_cast<double>(start.nodes.size());
    }
    m_SurfacePoints = surfacePointsOf(start, phi);
  }

  /** Minimises on the present lattice. */
  void
  minimise(const std::vector<EqualisationStage> & stages, bool isFirst, const ProgressCallback & progress)
  {
    LatticeOptimiser optimiser = makeOptimiser();
    Eigen::VectorXd  x = latticeVector(optimiser.layout(), m_Mesh.nodes, m_Origin, unit());
    if (!isFirst)
    {
      optimiser.attraction().moveNodesToLevel(x);
    }
    for (std::size_t s = 0; s < stages.size(); ++s)
    {
      const Stopwatch stopwatch;
      optimiser.attraction().freeze(x);
      if (!isFirst || s > 0)
      {
        optimiser.updateLevel(x);
      }
      optimiser.setTargetVolumes(targetVolumes(x, optimiser.layout()));
      const LimitedMemoryBfgsResult result =
        optimiser.minimise(x,
                           stages[s],
                           smallestDecrease,
                           progressBetween(progress,
                                           static_cast<double>(s) / static_cast<double>(stages.size()),
                                           static_cast<double>(s + 1) / static_cast<double>(stages.size())));
      keep(optimiser, x);
      log("minimise", result.report.steps, result.evaluations, stopwatch);
    }
    optimiser.updateLevel(x);
    m_Level = optimiser.attraction().level() * unit();
  }

  /** From a minimised mesh to an exact one. Most meshes may be projected as they are; where that leaves a flaw the
   * cells are made much more equal first, which costs more, and repaired after. */
  void
  finish(const EqualisationStage & lastStage, const ProgressCallback & progress)
  {
    if (uncertifiedCells() > m_Options.hopelessCells)
    {
      return;
    }
    settle(lastStage, roughDeviation, progressBetween(progress, 0.0, 0.2));
    const HexMesh minimised = m_Mesh;
    if (uncertifiedCells() <= tangledCells(m_Mesh.nodesPerSide))
    {
      project(progressBetween(progress, 0.2, 0.3));
      if (isFlawless())
      {
        return;
      }
      m_Mesh = minimised;
    }
    settle(lastStage, readyDeviation, progressBetween(progress, 0.3, 0.5));
    project(progressBetween(progress, 0.5, 0.6));
    repair(progressBetween(progress, 0.6, 1.0));
  }

  /** A lattice that is still tangled is minimised without regard to the volumes and with ever less regularisation, and
   * once more as before. Kept when that untangles it. */
  void
  untangle(const EqualisationStage & lastStage, const ProgressCallback & progress)
  {
    if (uncertifiedCells() == 0)
    {
      return;
    }
    const HexMesh tangled = m_Mesh;
    const double  level = m_Level;
    minimise({ untanglingStages[0], untanglingStages[1], lastStage }, true, progress);
    if (uncertifiedCells() > 0)
    {
      m_Mesh = tangled;
      m_Level = level;
    }
  }

  /** Takes the mesh to a finer or coarser lattice. */
  void
  resample(int nodesPerSide)
  {
    if (nodesPerSide == m_Mesh.nodesPerSide)
    {
      return;
    }
    m_Mesh.nodes = interpolateLattice(m_Mesh.nodes, m_Mesh.nodesPerSide, nodesPerSide);
    m_Mesh.nodesPerSide = nodesPerSide;
  }

  [[nodiscard]] EqualisationResult
  result()
  {
    EqualisationResult result;
    result.mesh = m_Mesh;
    result.level = m_Level;
    result.variance = deviation();
    result.concaveCells = volumeQuality(m_Mesh).concaveCells;
    result.uncertifiedCells = uncertifiedCells();
    result.largestDistance = largestDistance();
    result.uncoveredDistance = uncoveredDistance();
    result.steps = m_Steps;
    result.shortcomings = shortcomings(result);
    result.exact = result.shortcomings.empty();
    return result;
  }

private:
  /** Raises the weight of the volumes until the mean square deviation is below the goal. */
  void
  settle(EqualisationStage stage, double goal, const ProgressCallback & progress)
  {
    stage.maximumSteps = settlingSteps;
    for (int round = 0; round < settlingRounds && deviation() > goal; ++round)
    {
      stage.volumeWeight *= settlingGrowth;
      minimise({ stage }, true, progress);
    }
  }

  void
  project(const ProgressCallback & progress)
  {
    const Stopwatch     stopwatch;
    EqualMeasureOptions options = m_Options.projection;
    options.threads = m_Options.threads;
    EqualMeasureResult result = projectOntoEqualMeasure(m_Mesh, m_Measure, target(), m_Phi, options, progress);
    m_Mesh = std::move(result.mesh);
    m_Deviation = result.report.residual;
    int solverSteps = 0;
    for (const EqualMeasureStep & step : result.steps)
    {
      solverSteps += step.solverSteps;
    }
    log("project", result.report.steps, solverSteps, stopwatch);
  }

  /** Pushes doubtful cells open and pulls what is off the surface harder, in rounds. Projects again when nothing is
   * left to repair, when a round did not help, and in the end; keeps the best projected mesh. */
  void
  repair(const ProgressCallback & progress)
  {
    LatticeOptimiser  optimiser = makeOptimiser();
    std::vector<bool> isWatched(optimiser.layout().nodes, false);
    const FlawLimits  limits = flawLimits();
    EqualisationFlaws present = flaws(optimiser);
    EqualisationFlaws fewest = present;
    HexMesh           best = m_Mesh;
    double            bestDeviation = m_Deviation;
    double            margin = m_Options.repairMargin;
    double            weight = repairWeight;
    int               uselessRounds = 0;
    EqualisationStage stage = repairStage;
    for (int round = 1; round <= m_Options.repairRounds && uselessRounds < patience && !present.none(limits); ++round)
    {
      const Stopwatch         stopwatch;
      const EqualisationFlaws before = present;
      Eigen::VectorXd         x = latticeVector(optimiser.layout(), m_Mesh.nodes, m_Origin, unit());
      optimiser.setBarrier(watchedCells(optimiser.layout(), isWatched), margin, weight);
      const double growth = before.uncertified > 0 ? springGrowthOfTangled : springGrowth;
      optimiser.attraction().strengthen(x, safePartOfTolerance * limits.distance, growth);
      optimiser.coverage().strengthen(safePartOfTolerance * limits.uncovered, growth);
      optimiser.attraction().freeze(x);
      optimiser.updateLevel(x);
      optimiser.setTargetVolumes(targetVolumes(x, optimiser.layout()));
      const LimitedMemoryBfgsResult result = optimiser.minimise(x, stage, smallestDecreaseOfRepair, progress);
      keep(optimiser, x);
      if (deviation() > readyDeviation)
      {
        stage.volumeWeight *= settlingGrowth;
      }
      log("repair", result.report.steps, result.evaluations, stopwatch);
      present = flaws(optimiser);
      if (present.none(limits) || !present.worthwhileAfter(before, limits) || round == m_Options.repairRounds)
      {
        project(progress);
        present = flaws(optimiser);
        if (present.fewerThan(fewest, limits))
        {
          fewest = present;
          best = m_Mesh;
          bestDeviation = m_Deviation;
        }
      }
      uselessRounds = present.worthwhileAfter(before, limits) ? 0 : uselessRounds + 1;
      margin = std::min(repairMarginGrowth * margin, largestRepairMargin);
      weight *= repairWeightGrowth;
    }
    m_Mesh = std::move(best);
    m_Deviation = bestDeviation;
  }

  /** Exact, and with the boundary clearly within its tolerance. */
  [[nodiscard]] bool
  isFlawless()
  {
    const EqualisationResult present = result();
    return present.exact && present.largestDistance <= aimedPartOfTolerance * m_Options.surfaceTolerance &&
           smallestScaledJacobian(m_Mesh) >= aimedScaledJacobian;
  }

  /** Of the present mesh; the optimiser's surface points are associated with it. */
  [[nodiscard]] EqualisationFlaws
  flaws(LatticeOptimiser & optimiser) const
  {
    const auto x = latticeVector(optimiser.layout(), m_Mesh.nodes, m_Origin, unit());
    optimiser.coverage().associate(x);
    return { uncertifiedCells(),
             optimiser.attraction().largestDistance(x),
             optimiser.coverage().largestDistance(),
             smallestScaledJacobian(m_Mesh) };
  }

  [[nodiscard]] FlawLimits
  flawLimits() const
  {
    return { aimedPartOfTolerance * m_Options.surfaceTolerance / unit(),
             aimedPartOfTolerance * largestUncoveredDistance() / unit(),
             aimedScaledJacobian };
  }

  /** Of the surface from the boundary, in an exact mesh [mm]. */
  [[nodiscard]] double
  largestUncoveredDistance() const
  {
    return std::max(m_Options.surfaceTolerance, m_Options.coverageTolerance * unit());
  }

  [[nodiscard]] double
  unit() const
  {
    return std::cbrt(m_Volume / static_cast<double>(m_Mesh.cellCount()));
  }

  [[nodiscard]] double
  target() const
  {
    return m_Total / static_cast<double>(m_Mesh.cellCount());
  }

  [[nodiscard]] LatticeOptimiser
  makeOptimiser() const
  {
    const double  edge = unit();
    const Vector3 origin = m_Origin;
    const auto    scaled = [edge, origin, &phi = m_Phi](const Vector3 & p, Vector3 & gradient) {
      return phi(origin + edge * p, gradient) / edge;
    };
    Positions surfacePoints = m_SurfacePoints;
    for (Vector3 & point : surfacePoints)
    {
      point = (point - origin) / edge;
    }
    LatticeOptimiser optimiser(m_Mesh.nodesPerSide,
                               scaled,
                               std::move(surfacePoints),
                               static_cast<double>(m_Mesh.cellCount()),
                               m_Options.threads);
    optimiser.attraction().setLevel(m_Level / edge);
    return optimiser;
  }

  void
  keep(LatticeOptimiser & optimiser, const Eigen::VectorXd & x)
  {
    m_Mesh.nodes = latticePositions(optimiser.layout(), x, m_Origin, unit());
    m_Level = optimiser.attraction().level() * unit();
  }

  /** The volumes with which the cells, at their present mean densities, have equal measures. Cells that are flat or
   * inverted count with the mean density. */
  [[nodiscard]] std::vector<double>
  targetVolumes(const Eigen::VectorXd & x, const LatticeLayout & layout) const
  {
    const HexMesh       mesh{ m_Mesh.nodesPerSide, latticePositions(layout, x, m_Origin, unit()) };
    std::vector<double> measures;
    m_Measure.evaluate(mesh, m_Options.threads, measures);
    std::vector<double> volumes = cellVolumes(mesh);
    const double        cellVolume = unit() * unit() * unit();
    const double        meanDensity = m_Total / m_Volume;
    double              sum = 0.0;
    for (std::size_t cell = 0; cell < volumes.size(); ++cell)
    {
      const bool   isSound = volumes[cell] > 0.1 * cellVolume && measures[cell] > 0.0;
      const double density = isSound ? measures[cell] / volumes[cell] : meanDensity;
      volumes[cell] = meanDensity / density;
      sum += volumes[cell];
    }
    for (double & volume : volumes)
    {
      volume *= static_cast<double>(volumes.size()) / sum;
    }
    return volumes;
  }

  [[nodiscard]] double
  deviation() const
  {
    std::vector<double> measures;
    m_Measure.evaluate(m_Mesh, m_Options.threads, measures);
    double sum = 0.0;
    for (const double measure : measures)
    {
      sum += std::pow(measure / target() - 1.0, 2);
    }
    return sum / static_cast<double>(measures.size());
  }

  [[nodiscard]] double
  largestDistance() const
  {
    const LatticeOptimiser optimiser = makeOptimiser();
    const auto             x = latticeVector(optimiser.layout(), m_Mesh.nodes, m_Origin, unit());
    return optimiser.attraction().largestDistance(x) * unit();
  }

  [[nodiscard]] double
  uncoveredDistance() const
  {
    LatticeOptimiser optimiser = makeOptimiser();
    optimiser.coverage().associate(latticeVector(optimiser.layout(), m_Mesh.nodes, m_Origin, unit()));
    return optimiser.coverage().largestDistance() * unit();
  }

  [[nodiscard]] std::size_t
  uncertifiedCells() const
  {
    return m_Mesh.cellCount() - certifyCells(m_Mesh, {}, m_Options.threads).positive;
  }

  /** Adds the cells that are doubtful now to the watched ones. */
  [[nodiscard]] std::vector<std::size_t>
  watchedCells(const LatticeLayout & layout, std::vector<bool> & isWatched) const
  {
    const std::vector<double> smallest = smallestBezierCoefficients(m_Mesh, m_Options.threads);
    const double              bound = doubtfulCoefficient * m_Volume / static_cast<double>(m_Mesh.cellCount());
    for (std::size_t cell = 0; cell < smallest.size(); ++cell)
    {
      if (smallest[cell] < bound)
      {
        isWatched[layout.firstNode(cell)] = true;
      }
    }
    std::vector<std::size_t> cells;
    for (std::size_t node = 0; node < isWatched.size(); ++node)
    {
      if (isWatched[node])
      {
        cells.push_back(node);
      }
    }
    return cells;
  }

  [[nodiscard]] std::vector<std::string>
  shortcomings(const EqualisationResult & result) const
  {
    std::vector<std::string> lines;
    const auto               add = [&lines](const auto &... parts) {
      std::ostringstream line;
      (line << ... << parts);
      lines.push_back(line.str());
    };
    const std::size_t cells = m_Mesh.cellCount();
    if (!(result.variance <= largestExactVariance))
    {
      add("cells are not equal: variance ", result.variance, ", must be at most ", largestExactVariance);
    }
    if (result.concaveCells > 0)
    {
      add(result.concaveCells, " of ", cells, " cells are concave");
    }
    if (result.uncertifiedCells > result.concaveCells)
    {
      add(result.uncertifiedCells, " of ", cells, " cells are not certified positive inside");
    }
    if (!(result.largestDistance <= m_Options.surfaceTolerance))
    {
      add(
        "boundary up to ", result.largestDistance, " mm off the surface, must be at most ", m_Options.surfaceTolerance);
    }
    const double tip = largestUncoveredDistance();
    if (!(result.uncoveredDistance <= tip))
    {
      add("surface up to ", result.uncoveredDistance, " mm off the boundary, must be at most ", tip);
    }
    return lines;
  }

  void
  log(const std::string & name, int iterations, int evaluations, const Stopwatch & stopwatch)
  {
    EqualisationStep step;
    step.name = name;
    step.nodesPerSide = m_Mesh.nodesPerSide;
    step.iterations = iterations;
    step.evaluations = evaluations;
    step.seconds = stopwatch.seconds();
    step.variance = deviation();
    step.uncertified = uncertifiedCells();
    step.distance = largestDistance();
    step.uncovered = uncoveredDistance();
    m_Steps.push_back(step);
  }

  /** Relative deviation of 1e-9 of every cell. */
  static constexpr double largestExactVariance = 1e-18;

  HexMesh                       m_Mesh;
  const SignedDistance &        m_Phi;
  double                        m_Volume;
  const CellMeasure &           m_Measure;
  double                        m_Total;
  const EqualisationOptions &   m_Options;
  Vector3                       m_Origin;
  Positions                     m_SurfacePoints; ///< spread over the organ's surface [mm]
  double                        m_Level{ 0.0 };
  double                        m_Deviation{ 0.0 };
  std::vector<EqualisationStep> m_Steps;
};

/** Smaller is better. */
auto
badness(const EqualisationResult & result, double tolerance)
{
  return std::make_tuple(!result.exact,
                         result.concaveCells,
                         result.uncertifiedCells,
                         std::max(tolerance, result.largestDistance),
                         result.uncoveredDistance,
                         result.variance);
}

} // namespace

std::size_t
tangledCells(int nodesPerSide)
{
  return static_cast<std::size_t>(std::max(2, nodesPerSide / 3));
}

EqualisationResult
equaliseMeasures(const HexMesh &             start,
                 const SignedDistance &      phi,
                 double                      volume,
                 const CellMeasure &         measure,
                 double                      total,
                 const EqualisationOptions & options,
                 const ProgressCallback &    progress)
{
  requireValid(start);
  require(volume > 0.0 && std::isfinite(volume), "the volume must be positive and finite");
  require(total > 0.0 && std::isfinite(total), "the total must be positive and finite");
  require(static_cast<bool>(phi), "a surface is needed");
  requireStages(options.coarseStages);
  requireStages(options.finestStages);
  requireStages(options.directStages);
  require(options.repairRounds >= 0 && options.repairMargin > 0.0, "repair options out of range");
  require(options.surfaceTolerance > 0.0 && options.coverageTolerance >= 0.0, "the tolerances must be positive");
  const int n = options.nodesPerSide == 0 ? start.nodesPerSide : options.nodesPerSide;
  require(n >= start.nodesPerSide, "the lattice wanted is coarser than the one given");

  const Stopwatch    stopwatch;
  const int          coarse = std::min(n, coarsestNodesPerSide);
  EqualisationResult result = Equaliser(start, phi, volume, measure, total, options).result();
  const auto         keepBetter = [&](EqualisationResult && other) {
    other.steps.insert(other.steps.begin(), result.steps.begin(), result.steps.end());
    if (result.mesh.nodesPerSide != n ||
        badness(other, options.surfaceTolerance) < badness(result, options.surfaceTolerance))
    {
      result = std::move(other);
      return;
    }
    result.steps = std::move(other.steps);
  };
  if (n == start.nodesPerSide && !result.exact)
  {
    Equaliser direct(start, phi, volume, measure, total, options);
    direct.minimise(options.directStages, true, progressBetween(progress, 0.0, 0.2));
    direct.finish(options.directStages.back(), progressBetween(progress, 0.2, 0.5));
    keepBetter(direct.result());
  }
  if (n > start.nodesPerSide || (!result.exact && n > coarse))
  {
    Equaliser              gradual(start, phi, volume, measure, total, options);
    const std::vector<int> levels = refinementLevels(n > start.nodesPerSide ? start.nodesPerSide : coarse, n);
    const auto             count = static_cast<double>(levels.size());
    for (std::size_t l = 0; l < levels.size(); ++l)
    {
      gradual.resample(levels[l]);
      gradual.minimise(l + 1 < levels.size() ? options.coarseStages : options.finestStages,
                       l == 0,
                       progressBetween(progress,
                                       0.5 + 0.2 * static_cast<double>(l) / count,
                                       0.5 + 0.2 * static_cast<double>(l + 1) / count));
      if (l + 1 < levels.size())
      {
        gradual.untangle(options.coarseStages.back(), {});
      }
    }
    gradual.finish(options.finestStages.back(), progressBetween(progress, 0.7, 1.0));
    keepBetter(gradual.result());
  }
  result.report.converged = result.exact;
  result.report.steps = static_cast<int>(result.steps.size());
  result.report.residual = result.variance;
  result.report.seconds = stopwatch.seconds();
  reportProgress(progress, 1.0);
  return result;
}

EqualisationResult
equaliseVolumes(const HexMesh &             start,
                const SignedDistance &      phi,
                double                      volume,
                const EqualisationOptions & options,
                const ProgressCallback &    progress)
{
  return equaliseMeasures(start, phi, volume, VolumeMeasure(), volume, options, progress);
}

} // namespace moserhex
