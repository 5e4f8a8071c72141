#pragma once

#include "moserhex/LevelSet/FieldVolume.h"

#include <cstddef>
#include <string>
#include <vector>

namespace moserhex::app
{

/** Mean times volume, of each box. */
[[nodiscard]] FieldVolume
massesOf(FieldVolume means, const std::vector<double> & volumes);

/** Over all voxels. */
[[nodiscard]] double
sumOf(const FieldVolume & image, std::size_t component);

/** "integral over the mesh", of which number where there are several. */
[[nodiscard]] std::string
integralName(std::size_t component, int components);

/** As it is told, 0.123456789. */
[[nodiscard]] std::string
nineDigits(double value);

} // namespace moserhex::app
