#include "ShapeEnergyInstructionSets.h"

#include "CellKernels.h"

using namespace moserhex;

#define MOSERHEX_KERNEL_SOURCE "ShapeEnergy.cxx"
#define MOSERHEX_KERNEL_FUNCTIONS(set) set::moserhex::addShapeEnergy, set::moserhex::latticeVolumes
#include "moserhex/Analytic/EachInstructionSet.h"

std::vector<moserhex::testing::ShapeEnergyVariant>
moserhex::testing::shapeEnergyVariants()
{
  return runnableVariants<ShapeEnergyVariant>();
}
