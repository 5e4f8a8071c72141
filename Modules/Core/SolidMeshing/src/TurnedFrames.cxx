#include "TurnedFrames.h"

#include "moserhex/HexMap/FramePlacement.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace moserhex
{
namespace
{

const double degree = pi / 180.0;

/** Of the lattice of rotation vectors [degree]. */
constexpr double stepOfTurns = 12.5;

/** No turn of a cube is farther than this from the nearest of its symmetries [degree]. */
constexpr double farthestTurn = 62.8;

/** Turns equally far from two symmetries of the cube belong to both. */
constexpr double tie = 1e-9;

/** Added to the scores, whose logarithm is taken. */
constexpr double smallestScore = 1e-12;

/** |w| of the quaternions of the cube's 24 turns times q, as large as they get. */
double
largestRealPart(const Eigen::Quaterniond & q)
{
  // The cube's turns: the units, (1,1,1,1)/2 and (1,1,0,0)/sqrt(2) with all signs and places; so the real part is the
  // largest of the sums of one, two or four magnitudes.
  std::vector<double> parts{ std::abs(q.w()), std::abs(q.x()), std::abs(q.y()), std::abs(q.z()) };
  std::sort(parts.rbegin(), parts.rend());
  return std::max(
    { parts[0], (parts[0] + parts[1]) / std::sqrt(2.0), 0.5 * (parts[0] + parts[1] + parts[2] + parts[3]) });
}

} // namespace

std::vector<Matrix3>
turnsOfTheCube(double step)
{
  struct Turn
  {
    double  angle;
    Matrix3 rotation;
  };
  std::vector<Turn> turns;
  const int         most = static_cast<int>(std::ceil(farthestTurn / step));
  for (int k = -most; k <= most; ++k)
  {
    for (int j = -most; j <= most; ++j)
    {
      for (int i = -most; i <= most; ++i)
      {
        const Vector3                  vector = step * degree * Vector3(i, j, k);
        const double                   angle = vector.norm();
        const Eigen::AngleAxis<double> turn(angle, angle > 0.0 ? Vector3(vector / angle) : Vector3::UnitX());
        const Eigen::Quaterniond       quaternion(turn);
        if (angle <= farthestTurn * degree && std::abs(quaternion.w()) >= largestRealPart(quaternion) - tie)
        {
          turns.push_back({ angle, turn.toRotationMatrix() });
        }
      }
    }
  }
  std::stable_sort(turns.begin(), turns.end(), [](const Turn & a, const Turn & b) { return a.angle < b.angle; });
  std::vector<Matrix3> rotations;
  for (const Turn & turn : turns)
  {
    rotations.push_back(turn.rotation);
  }
  return rotations;
}

std::vector<Matrix3>
promisingTurns(const TriangleMesh & surface, const Positions & sphereMap, std::size_t count, unsigned int threads)
{
  struct Candidate
  {
    double  score;
    Matrix3 rotation;
  };
  std::vector<Candidate>      candidates;
  std::vector<FramePlacement> placements;
  for (const Matrix3 & turn : turnsOfTheCube(stepOfTurns))
  {
    candidates.push_back({ 0.0, turn });
    placements.push_back({ turn, Vector3::Zero() });
  }
  FramePlacementOptions options;
  options.threads = threads;
  for (const int nodesPerSide : { 6, 10 })
  {
    options.nodesPerSide = nodesPerSide;
    const std::vector<EdgeScore> scores = edgeScores(surface, sphereMap, placements, options);
    for (std::size_t c = 0; c < candidates.size(); ++c)
    {
      candidates[c].score += std::log(scores[c].score + smallestScore);
    }
  }
  candidates.erase(candidates.begin()); // the identity
  std::stable_sort(
    candidates.begin(), candidates.end(), [](const Candidate & a, const Candidate & b) { return a.score < b.score; });
  std::vector<Matrix3> turns;
  for (std::size_t c = 0; c < std::min(count, candidates.size()); ++c)
  {
    turns.push_back(candidates[c].rotation);
  }
  return turns;
}

} // namespace moserhex
