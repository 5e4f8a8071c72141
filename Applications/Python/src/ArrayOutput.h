#pragma once

#include "ArrayInput.h"

namespace moserhex::python
{

// Arrays that own their numbers.

/** K x 3, from LPS. */
[[nodiscard]] pybind11::array
arrayOf(const Positions & positions, Space space);

/** side x side x side values, the first index fastest. */
[[nodiscard]] pybind11::array
cubeOf(const std::vector<double> & values, int side);

/** Indexed [i, j, k], the first index fastest. */
[[nodiscard]] pybind11::array
arrayOf(const LabelImageType & image);

/** 4 x 4, from index to millimetres of `space`. */
[[nodiscard]] pybind11::array
affineOf(const LabelImageType & image, Space space);

} // namespace moserhex::python
