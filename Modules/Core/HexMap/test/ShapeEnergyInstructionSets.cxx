// The kernel's source once for each instruction set, each in a namespace of its own: in the library a dispatcher picks
// one of them, and the others cannot be called.
#include "ShapeEnergyInstructionSets.h"

#include "CellKernels.h"

using namespace moserhex;

#undef MOSERHEX_KERNEL
#define MOSERHEX_KERNEL
namespace plain
{
#include "ShapeEnergy.cxx"
}

#if defined(__x86_64__)
#undef MOSERHEX_KERNEL
#define MOSERHEX_KERNEL __attribute__((target("avx2")))
namespace avx2
{
#include "ShapeEnergy.cxx"
}

#undef MOSERHEX_KERNEL
#define MOSERHEX_KERNEL __attribute__((target("avx512f")))
namespace avx512
{
#include "ShapeEnergy.cxx"
}
#endif

std::vector<moserhex::testing::ShapeEnergyVariant>
moserhex::testing::shapeEnergyVariants()
{
  std::vector<ShapeEnergyVariant> variants{
    { "plain", plain::moserhex::addShapeEnergy, plain::moserhex::latticeVolumes }
  };
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2"))
  {
    variants.push_back({ "avx2", avx2::moserhex::addShapeEnergy, avx2::moserhex::latticeVolumes });
  }
  if (__builtin_cpu_supports("avx512f"))
  {
    variants.push_back({ "avx512f", avx512::moserhex::addShapeEnergy, avx512::moserhex::latticeVolumes });
  }
#endif
  return variants;
}
