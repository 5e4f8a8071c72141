#pragma once

#include <pybind11/pybind11.h>

namespace moserhex::python
{

/** compare: two meshes of one lattice. */
void
addComparison(pybind11::module_ & module);

} // namespace moserhex::python
