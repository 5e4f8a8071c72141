#pragma once

#include <vtkDataArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVersion.h>

namespace moserhex
{

// What differs between versions of VTK goes here and nowhere else. .ci/check_headers.py checks it.

/** The type of each cell. VTK 9.6 deprecates GetCellTypesArray(), the only name that VTK before it has. */
[[nodiscard]] inline vtkDataArray *
cellTypesOf(vtkUnstructuredGrid & grid)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return grid.GetCellTypes();
#else
  return grid.GetCellTypesArray();
#endif
}

} // namespace moserhex
