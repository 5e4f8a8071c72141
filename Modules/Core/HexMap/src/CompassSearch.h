#pragma once

#include "EdgeJudge.h"

#include <vector>

namespace moserhex
{

/** Compass search with complete polling for the placement of smallest objective; see placeFrame. */
class CompassSearch
{
public:
  /** Both must outlive the search. */
  CompassSearch(const EdgeJudge & judge, const FramePlacementOptions & options);

  void
  run(const ProgressCallback & progress);

  /** Rotation vector and boost, each divided by its bound: both lie in the unit ball. */
  using Coordinates = Eigen::Matrix<double, 6, 1>;

  struct Candidate
  {
    Coordinates    x{ Coordinates::Zero() };
    FramePlacement placement;
    EdgeScore      score;
    double         objective{ 0.0 };
  };

  [[nodiscard]] const Candidate &
  best() const
  {
    return m_Best;
  }
  [[nodiscard]] int
  evaluations() const
  {
    return m_Evaluations;
  }
  [[nodiscard]] const StepReport &
  report() const
  {
    return m_Report;
  }

private:
  /** Goes to the best neighbour when it is better; false when none is. */
  bool
  poll(double step);

  std::vector<Candidate>
  evaluate(const std::vector<Coordinates> & points);

  const EdgeJudge &             m_Judge;
  const FramePlacementOptions & m_Options;
  std::vector<Eigen::Index>     m_Axes;
  Candidate                     m_Best;
  int                           m_Evaluations{ 0 };
  StepReport                    m_Report;
};

} // namespace moserhex
