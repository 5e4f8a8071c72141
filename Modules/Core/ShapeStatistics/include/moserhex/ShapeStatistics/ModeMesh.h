#pragma once

#include "moserhex/ShapeStatistics/EqualVolumeShape.h"

namespace moserhex
{

/** Options of exactModeMesh. */
struct ModeMeshOptions
{
  /** Tried one after the other until one gives an exact mesh [standard deviations]. */
  std::vector<double> deviations{ 3.0, 2.5, 2.0, 1.5, 1.0 };
  unsigned int        threads{ 0 }; ///< 0: all; the result does not depend on it
};

/** What exactModeMesh made. */
struct ModeMesh
{
  double                   deviations{ 0.0 }; ///< of `deviations` the one shown; 0: none gave an exact mesh
  EqualVolumeShape         shape;             ///< nothing when none did
  std::vector<std::string> attempts;          ///< those that did not, and why
};

/** The mean displaced by some deviations, as an equal-volume mesh of the outline there (equalVolumeShape, held to the
 * displaced mesh). A displaced boundary that cuts itself is no shape, nor is one of which no exact mesh is found: then
 * the next number of deviations is tried.
 *
 * \param mean          of the model \param displacement  of every node at one deviation: plus or minus a mode times its
 * standard deviation [mm]
 * \throws InvalidInput  as requireValid(mean), n < 3, another number of displacements than nodes, or a deviation that
 * is not positive \throws Cancelled     by the callback \note Deterministic for any number of threads. */
[[nodiscard]] ModeMesh
exactModeMesh(const HexMesh &          mean,
              const Positions &        displacement,
              const ModeMeshOptions &  options = {},
              const ProgressCallback & progress = {});

} // namespace moserhex
