#pragma once

#include "ArrayInput.h"
#include "moserhex/LevelSet/DensityImage.h"

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
arrayOf(const ScalarVolume & image);

/** Indexed [i, j, k], or of several components [i, j, k, component]; a voxel's values are together in memory. */
[[nodiscard]] pybind11::array
arrayOf(const FieldVolume & image);

/** The numbers in that shape, the last index fastest. */
[[nodiscard]] pybind11::array
arrayOf(const std::vector<double> & numbers, const std::vector<pybind11::ssize_t> & shape);

/** Rows x columns. */
[[nodiscard]] pybind11::array
arrayOf(const Eigen::MatrixXd & matrix);

/** As many 3 x 3 matrices, their axes in `space`: S M S, S = diag(-1, -1, 1) or 1. */
[[nodiscard]] pybind11::array
arrayOf(const std::vector<Matrix3> & matrices, Space space);

/** Indexed [i, j, k], the first index fastest. */
[[nodiscard]] pybind11::array
arrayOf(const LabelImageType & image);

/** 4 x 4, from index to millimetres of `space`. */
[[nodiscard]] pybind11::array
affineOf(const LabelImageType & image, Space space);

/** The same. */
[[nodiscard]] pybind11::array
affineOf(const VoxelGrid & grid, Space space);

} // namespace moserhex::python
