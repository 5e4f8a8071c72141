#pragma once

#include <pybind11/pybind11.h>

namespace moserhex::python
{

/** Functions of a mesh and images of several components: cell_means, node_samples, cell_volumes, grid_samples,
 * grid_masses. */
void
addTransfer(pybind11::module_ & module);

} // namespace moserhex::python
