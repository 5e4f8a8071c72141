#pragma once

#include "OptimiserProblem.h"

#include <functional>
#include <vector>

namespace moserhex::optimisers
{

/** What one method made of one case. */
struct Outcome
{
  double      seconds{ 0.0 };
  int         evaluations{ 0 };     ///< of the energy and its gradient on the finest lattice
  int         hessianProducts{ 0 }; ///< on the finest lattice, those for diagonal blocks included
  double      energy{ 0.0 };        ///< of the last stage, by cell
  double      smallestJacobian{ 0.0 };
  double      variance{ 0.0 }; ///< of volume / mean
  std::size_t concaveCells{ 0 };
};

struct Method
{
  std::string                          name;
  std::function<Outcome(const Case &)> run;
};

[[nodiscard]] std::vector<Method>
methods();

} // namespace moserhex::optimisers
