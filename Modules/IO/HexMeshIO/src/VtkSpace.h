#pragma once

#include "moserhex/Common/Types.h"

class vtkFieldData;

namespace moserhex
{

/** Whether the second line of a legacy file says SPACE=RAS, as Slicer writes it. */
[[nodiscard]] bool
saysRas(const char * header);

/** Whether there is a field array SPACE = "RAS", as Slicer writes it. */
[[nodiscard]] bool
saysRas(vtkFieldData * data);

/** A half turn about the third axis: orientation stays. */
void
turnRasIntoLps(Positions & positions);

} // namespace moserhex
