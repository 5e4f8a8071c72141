#include "Integrals.h"

#include <algorithm>
#include <cstdio>

namespace moserhex::app
{

FieldVolume
massesOf(FieldVolume means, const std::vector<double> & volumes)
{
  for (std::size_t box = 0; box < volumes.size(); ++box)
  {
    std::for_each(means.at(box), means.at(box) + means.components, [&](double & value) { value *= volumes[box]; });
  }
  return means;
}

double
sumOf(const FieldVolume & image, std::size_t component)
{
  double sum = 0.0;
  for (std::size_t voxel = 0; voxel < image.gridVoxels(); ++voxel)
  {
    sum += image.at(voxel)[component];
  }
  return sum;
}

std::string
integralName(std::size_t component, int components)
{
  return "integral over the mesh" + (components == 1 ? "" : " of number " + std::to_string(component + 1));
}

std::string
nineDigits(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

} // namespace moserhex::app
