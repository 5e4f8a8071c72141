#include "moserhex/ShapeStatistics/Procrustes.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Common/Stopwatch.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace moserhex
{
namespace
{

/** Subjects in memory at the same time; fixed, so that sums do not depend on the threads. */
constexpr std::size_t subjectsAtOnce = 16;

Vector3
centroidOf(const Positions & points)
{
  Vector3 sum = Vector3::Zero();
  for (const Vector3 & p : points)
  {
    sum += p;
  }
  return sum / static_cast<double>(points.size());
}

/** A plain mean smaller than this part of the subjects' size has cancelled out. */
constexpr double smallestPlainSize = 0.1;

void
requireArguments(std::size_t count, const SubjectLoader & load, const ProcrustesOptions & options)
{
  if (count == 0 || !load)
  {
    throw InvalidInput("Procrustes: no subject");
  }
  if (!(options.tolerance > 0.0) || options.maximumSteps < 1)
  {
    throw InvalidInput("Procrustes: the tolerance and the number of steps must be positive");
  }
}

/** Prepares subjects in parallel, then takes them one after the other. */
template <typename TPrepare, typename TTake>
void
forEachSubject(std::size_t count, unsigned int threads, const TPrepare & prepare, const TTake & take)
{
  std::vector<Positions> slots(std::min(count, subjectsAtOnce));
  for (std::size_t begin = 0; begin < count; begin += subjectsAtOnce)
  {
    const std::size_t size = std::min(subjectsAtOnce, count - begin);
    parallelFor(size, threads, [&](std::size_t slot) {
      try
      {
        slots[slot] = prepare(begin + slot);
      }
      catch (const InvalidInput & error)
      {
        throw InvalidInput(error.code(), "subject " + std::to_string(begin + slot) + ": " + error.what());
      }
    });
    for (std::size_t slot = 0; slot < size; ++slot)
    {
      take(begin + slot, slots[slot]);
    }
  }
}

/** Adds up subjects of equal numbers of points. */
class MeanOfSubjects
{
public:
  void
  add(std::size_t subject, const Positions & points)
  {
    if (m_Count == 0)
    {
      m_Sum.assign(points.size(), Vector3::Zero());
    }
    if (points.size() != m_Sum.size())
    {
      throw InvalidInput("Procrustes: subject " + std::to_string(subject) + " has " + std::to_string(points.size()) +
                         " points, those before it " + std::to_string(m_Sum.size()));
    }
    for (std::size_t a = 0; a < points.size(); ++a)
    {
      m_Sum[a] += points[a];
    }
    ++m_Count;
  }

  [[nodiscard]] Positions
  mean() const
  {
    Positions result = m_Sum;
    for (Vector3 & point : result)
    {
      point /= static_cast<double>(m_Count);
    }
    return result;
  }

private:
  Positions   m_Sum;
  std::size_t m_Count{ 0 };
};

double
rootMeanSquareDistance(const Positions & a, const Positions & b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += (a[i] - b[i]).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/** The plain mean; sets the mean size. */
Positions
plainMean(std::size_t count, const SubjectLoader & load, unsigned int threads, double & size)
{
  MeanOfSubjects sum;
  double         sizes = 0.0;
  forEachSubject(count, threads, load, [&](std::size_t subject, const Positions & points) {
    sum.add(subject, points);
    sizes += centroidSize(points);
  });
  size = sizes / static_cast<double>(count);
  return sum.mean();
}

} // namespace

double
centroidSize(const Positions & points)
{
  if (points.empty())
  {
    throw InvalidInput("centroid size: no point");
  }
  const Vector3 centroid = centroidOf(points);
  double        sum = 0.0;
  for (const Vector3 & p : points)
  {
    sum += (p - centroid).squaredNorm();
  }
  return std::sqrt(sum);
}

SimilarityTransform
alignToMean(const Positions & subject, const Positions & mean, AlignmentKind kind, double size)
{
  if (kind == AlignmentKind::None)
  {
    return {};
  }
  SimilarityTransform result = rigidAlignment(subject, mean);
  if (kind == AlignmentKind::Rigid)
  {
    return result;
  }
  result.scale = size / centroidSize(subject);
  result.translation = centroidOf(mean) - result.scale * (result.rotation * centroidOf(subject));
  return result;
}

ProcrustesResult
generalisedProcrustes(std::size_t count, const SubjectLoader & load, const ProcrustesOptions & options)
{
  requireArguments(count, load, options);
  const Stopwatch  stopwatch;
  ProcrustesResult result;
  result.mean = plainMean(count, load, options.threads, result.size);
  if (options.kind != AlignmentKind::None && centroidSize(result.mean) < smallestPlainSize * result.size)
  {
    result.mean = load(0);
  }
  result.transforms.resize(count);
  while (!result.report.converged && result.report.steps < options.maximumSteps)
  {
    MeanOfSubjects sum;
    double         squares = 0.0;
    const auto     align = [&](std::size_t subject) {
      const Positions points = load(subject);
      result.transforms[subject] = alignToMean(points, result.mean, options.kind, result.size);
      return transformed(points, result.transforms[subject]);
    };
    forEachSubject(count, options.threads, align, [&](std::size_t subject, const Positions & points) {
      sum.add(subject, points);
      squares += std::pow(rootMeanSquareDistance(points, result.mean), 2);
    });
    const Positions mean = sum.mean();
    const double    move = rootMeanSquareDistance(mean, result.mean);
    // About the new mean: the squares about the old one less that of the mean's move.
    result.deviation = std::sqrt(std::max(0.0, squares / static_cast<double>(count) - move * move));
    result.report.residual = move * std::sqrt(static_cast<double>(mean.size())) / result.size;
    result.report.converged = result.report.residual < options.tolerance;
    result.mean = mean;
    ++result.report.steps;
  }
  if (!result.report.converged)
  {
    result.report.note = "the mean still moved by " + std::to_string(result.report.residual) + " of its size";
  }
  result.report.seconds = stopwatch.seconds();
  return result;
}

} // namespace moserhex
