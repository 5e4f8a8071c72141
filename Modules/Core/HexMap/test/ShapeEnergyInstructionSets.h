#pragma once

#include "ShapeEnergy.h"

#include <string>
#include <vector>

namespace moserhex::testing
{

/** addShapeEnergy compiled for one instruction set only. */
struct ShapeEnergyVariant
{
  std::string               name;
  decltype(&addShapeEnergy) addEnergy;
  decltype(&latticeVolumes) volumes;
};

/** Those that this machine can run; the plain one comes first. */
[[nodiscard]] std::vector<ShapeEnergyVariant>
shapeEnergyVariants();

/** All there are. */
constexpr const char * shapeEnergyVariantNames[] = { "plain", "avx2", "avx512f" };

} // namespace moserhex::testing
