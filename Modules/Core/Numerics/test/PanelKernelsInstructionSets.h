#pragma once

#include "PanelKernels.h"

#include <string>
#include <vector>

namespace moserhex::testing
{

/** The kernels compiled for one instruction set only. */
struct PanelKernelsVariant
{
  std::string                name;
  decltype(&multiplyColumns) multiply;
  decltype(&foldColumns)     fold;
  decltype(&unfoldColumns)   unfold;
  decltype(&transposeLines)  transpose;
};

/** Those that this machine can run. */
[[nodiscard]] std::vector<PanelKernelsVariant>
panelKernelsVariants();

/** All there are. */
constexpr const char * panelKernelsVariantNames[] = { "plain", "avx2", "avx512f" };

} // namespace moserhex::testing
