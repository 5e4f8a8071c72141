#pragma once

#include <pybind11/pybind11.h>

namespace moserhex::python
{

/** Statistics of many shapes: procrustes, exact_mean, fit_shapes, scores_of, reconstruct, permutation_test. */
void
addShapeStatistics(pybind11::module_ & module);

} // namespace moserhex::python
