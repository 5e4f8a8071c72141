// The kernels' source once for each instruction set, each in a namespace of its own: in the library a dispatcher picks
// one of them, and the others cannot be called.
#include "PanelKernelsInstructionSets.h"

#include "LineTransform.h"
#include "moserhex/Common/Lanes.h"

#include <algorithm>
#include <cstring>

using namespace moserhex;

#undef MOSERHEX_KERNEL
#define MOSERHEX_KERNEL
namespace plain
{
#include "PanelKernels.cxx"
}

#if defined(__x86_64__)
#undef MOSERHEX_KERNEL
#define MOSERHEX_KERNEL __attribute__((target("avx2")))
namespace avx2
{
#include "PanelKernels.cxx"
}

#undef MOSERHEX_KERNEL
#define MOSERHEX_KERNEL __attribute__((target("avx512f")))
namespace avx512
{
#include "PanelKernels.cxx"
}
#endif

std::vector<moserhex::testing::PanelKernelsVariant>
moserhex::testing::panelKernelsVariants()
{
  std::vector<PanelKernelsVariant> variants{ { "plain",
                                               plain::moserhex::multiplyColumns,
                                               plain::moserhex::foldColumns,
                                               plain::moserhex::unfoldColumns,
                                               plain::moserhex::transposeLines } };
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2"))
  {
    variants.push_back({ "avx2",
                         avx2::moserhex::multiplyColumns,
                         avx2::moserhex::foldColumns,
                         avx2::moserhex::unfoldColumns,
                         avx2::moserhex::transposeLines });
  }
  if (__builtin_cpu_supports("avx512f"))
  {
    variants.push_back({ "avx512f",
                         avx512::moserhex::multiplyColumns,
                         avx512::moserhex::foldColumns,
                         avx512::moserhex::unfoldColumns,
                         avx512::moserhex::transposeLines });
  }
#endif
  return variants;
}
