#include "ArrayOutput.h"

#include <algorithm>

namespace moserhex::python
{

namespace py = pybind11;

namespace
{

/** \param step  from a voxel to the next along an axis, LPS [mm] */
template <typename TStep>
py::array
affineOf(TStep step, const Vector3 & origin, Space space)
{
  py::array_t<double> affine({ 4, 4 });
  auto                entry = affine.mutable_unchecked<2>();
  for (py::ssize_t column = 0; column < 4; ++column)
  {
    const Vector3 steps = flip(column < 3 ? step(static_cast<unsigned int>(column)) : origin, space);
    for (py::ssize_t row = 0; row < 3; ++row)
    {
      entry(row, column) = steps[row];
    }
    entry(3, column) = column < 3 ? 0.0 : 1.0;
  }
  return affine;
}

} // namespace

py::array
arrayOf(const Positions & positions, Space space)
{
  py::array_t<double> array({ static_cast<py::ssize_t>(positions.size()), py::ssize_t{ 3 } });
  double *            next = array.mutable_data();
  for (const Vector3 & position : positions)
  {
    const Vector3 flipped = flip(position, space);
    next = std::copy_n(flipped.data(), 3, next);
  }
  return array;
}

py::array
cubeOf(const std::vector<double> & values, int side)
{
  py::array_t<double, py::array::f_style> array({ side, side, side });
  std::copy(values.begin(), values.end(), array.mutable_data());
  return array;
}

py::array
arrayOf(const ScalarVolume & image)
{
  py::array_t<double, py::array::f_style> array({ image.size[0], image.size[1], image.size[2] });
  std::copy(image.values.begin(), image.values.end(), array.mutable_data());
  return array;
}

py::array
arrayOf(const FieldVolume & image)
{
  const auto               number = static_cast<py::ssize_t>(sizeof(double));
  const py::ssize_t        voxel = number * image.components;
  std::vector<py::ssize_t> shape{ image.size[0], image.size[1], image.size[2] };
  std::vector<py::ssize_t> strides{ voxel, voxel * shape[0], voxel * shape[0] * shape[1] };
  if (image.components > 1)
  {
    shape.push_back(image.components);
    strides.push_back(number);
  }
  return py::array_t<double>(shape, strides, image.values.data()); // copied
}

py::array
arrayOf(const std::vector<double> & numbers, const std::vector<py::ssize_t> & shape)
{
  return py::array_t<double>(shape, numbers.data()); // copied
}

py::array
arrayOf(const Eigen::MatrixXd & matrix)
{
  py::array_t<double> array({ static_cast<py::ssize_t>(matrix.rows()), static_cast<py::ssize_t>(matrix.cols()) });
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
    array.mutable_data(), matrix.rows(), matrix.cols()) = matrix;
  return array;
}

py::array
arrayOf(const std::vector<Matrix3> & matrices, Space space)
{
  py::array_t<double> array({ static_cast<py::ssize_t>(matrices.size()), py::ssize_t{ 3 }, py::ssize_t{ 3 } });
  const Vector3       signs = flip(Vector3::Ones(), space);
  double *            next = array.mutable_data();
  for (const Matrix3 & matrix : matrices)
  {
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> entries(next);
    entries = signs.asDiagonal() * matrix * signs.asDiagonal();
    next += 9;
  }
  return array;
}

py::array
arrayOf(const LabelImageType & image)
{
  const auto                                  size = image.GetLargestPossibleRegion().GetSize();
  py::array_t<LabelValue, py::array::f_style> array({ size[0], size[1], size[2] });
  std::copy_n(image.GetBufferPointer(), array.size(), array.mutable_data());
  return array;
}

py::array
affineOf(const LabelImageType & image, Space space)
{
  return affineOf(
    [&image](unsigned int axis) {
      Vector3 step;
      for (unsigned int row = 0; row < 3; ++row)
      {
        step[row] = image.GetDirection()(row, axis) * image.GetSpacing()[axis];
      }
      return step;
    },
    Vector3(image.GetOrigin()[0], image.GetOrigin()[1], image.GetOrigin()[2]),
    space);
}

py::array
affineOf(const VoxelGrid & grid, Space space)
{
  return affineOf(
    [&grid](unsigned int axis) { return Vector3(grid.direction.col(axis) * grid.spacing[axis]); }, grid.origin, space);
}

} // namespace moserhex::python
