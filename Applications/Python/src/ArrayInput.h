#pragma once

#include "moserhex/HexMeshIO/ImageArray.h"

#include <pybind11/numpy.h>

namespace moserhex::python
{

/** The space of coordinates and affines that a caller has. */
enum class Space
{
  RAS,
  LPS
};

/** \throws InvalidInput (Usage)  neither "RAS" nor "LPS" */
[[nodiscard]] Space
spaceOf(const std::string & name);

/** From that space to LPS, and back: the same. */
[[nodiscard]] Vector3
flip(const Vector3 & p, Space space);

/** Copies an array of labels, whatever its strides, byte order and type of numbers.
 * \param affine  4 x 4, index to millimetres of `space`
 * \throws BadInput  Dimension, PixelType, Geometry, and what labelImageFrom throws */
[[nodiscard]] LabelImage
labelsFrom(const pybind11::object & labels, const pybind11::object & affine, Space space);

/** The same for values of any kind of number. \param name  of the array in messages */
[[nodiscard]] ScalarImage
scalarsFrom(const std::string & name, const pybind11::object & values, const pybind11::object & affine, Space space);

/** Values indexed [i, j, k], or [i, j, k, component]. Vectors and symmetric tensors are in `space`, as they are: see
 * turnToLps. */
[[nodiscard]] FieldImage
fieldFrom(const std::string & name, const pybind11::object & values, const pybind11::object & affine, Space space);

/** The voxels of an image of this shape. \throws BadInput  Empty, TooBig, Geometry; Dimension: not three numbers */
[[nodiscard]] VoxelGrid
gridFrom(const pybind11::object & shape, const pybind11::object & affine, Space space);

/** N x N x N values, or with components along a fourth axis, i fastest, components together.
 * \throws BadInput (Dimension)  sides that differ; PixelType */
[[nodiscard]] FieldVolume
cubeValuesFrom(const std::string & name, const pybind11::object & values);

/** Copies an array of real numbers with so many axes, the last index fastest, as they are.
 * \param shape  set to its sides \throws BadInput (Dimension)  another number of axes; PixelType */
[[nodiscard]] std::vector<double>
numbersFrom(const std::string & name, const pybind11::object & array, std::vector<std::size_t> & shape);

/** Copies K x 3 coordinates, as they are. \throws BadInput (Dimension)  another shape, or no real numbers */
[[nodiscard]] Positions
rowsFrom(const std::string & name, const pybind11::object & rows);

} // namespace moserhex::python
