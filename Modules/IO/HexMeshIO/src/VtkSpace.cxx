#include "VtkSpace.h"

#include <vtkFieldData.h>
#include <vtkStringArray.h>

#include <string>

namespace moserhex
{

bool
saysRas(const char * header)
{
  return header && std::string(header).find("SPACE=RAS") != std::string::npos;
}

bool
saysRas(vtkFieldData * data)
{
  auto * space = vtkStringArray::SafeDownCast(data->GetAbstractArray("SPACE"));
  return space && space->GetNumberOfValues() > 0 && space->GetValue(0) == "RAS";
}

void
turnRasIntoLps(Positions & positions)
{
  for (Vector3 & position : positions)
  {
    position.x() = -position.x();
    position.y() = -position.y();
  }
}

} // namespace moserhex
