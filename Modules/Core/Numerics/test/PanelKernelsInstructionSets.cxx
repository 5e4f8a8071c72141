#include "PanelKernelsInstructionSets.h"

#include "LineTransform.h"
#include "moserhex/Common/Lanes.h"

#include <algorithm>
#include <cstring>

using namespace moserhex;

#define MOSERHEX_KERNEL_SOURCE "PanelKernels.cxx"
#define MOSERHEX_KERNEL_FUNCTIONS(set)                                                                                 \
  set::moserhex::multiplyColumns, set::moserhex::foldColumns, set::moserhex::unfoldColumns,                            \
    set::moserhex::transposeLines
#include "moserhex/Analytic/EachInstructionSet.h"

std::vector<moserhex::testing::PanelKernelsVariant>
moserhex::testing::panelKernelsVariants()
{
  return runnableVariants<PanelKernelsVariant>();
}
