#pragma once

#include "moserhex/ShapeStatistics/Procrustes.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace moserhex::app
{

struct AtlasOptions
{
  std::vector<std::string> inputs; ///< meshes, folders, or one table with a column `mesh`; see listAtlasSubjects
  std::string              outputFolder;

  AlignmentKind alignment{ AlignmentKind::Rigid };
  std::size_t   maximumModes{ 0 };        ///< kept; 0: as varianceFraction says
  double        varianceFraction{ 0.95 }; ///< of the total variance, in the modes that are kept [1]
  std::size_t   modeMeshes{ 5 };          ///< modes whose meshes are written, at most
  std::size_t   samples{ 1000 };          ///< of the model, for specificity

  std::string              group;      ///< column of groups; empty: no comparison of groups
  std::string              regressor;  ///< column of numbers; empty: no regression
  std::vector<std::string> covariates; ///< columns, nuisance of both tests; not of that of itself
  std::size_t              permutations{ 10000 };
  std::uint64_t            seed{ 1 };

  std::string images;                   ///< column of image files; empty: no mean image
  std::string imageSampling{ "cells" }; ///< of the cube: "cells", "nodes", or a number of boxes along each axis
  bool        normaliseImages{ false }; ///< to mean 0 and standard deviation 1 in each organ

  double      labelSpacing{ 1.0 }; ///< voxel side of the template's labelmap; 0: none is written [mm]
  std::string projectOnto;         ///< model file: the inputs are not analysed, but projected onto it
  std::string reconstructWith;     ///< model file: the input is a table of scores, meshes are made of it

  bool         sandbox{ true };
  unsigned int threads{ 0 };
  bool         quiet{ false };
};

} // namespace moserhex::app
