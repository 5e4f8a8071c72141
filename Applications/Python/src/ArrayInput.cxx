#include "ArrayInput.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace moserhex::python
{
namespace
{

namespace py = pybind11;

/** \throws BadInput (PixelType)  no array of real numbers */
py::array
realArray(const std::string & name, const py::object & object)
{
  const auto array = py::array::ensure(object);
  if (!array)
  {
    PyErr_Clear();
    throw BadInput(ErrorCode::PixelType, name, "not an array", "give a numpy array");
  }
  const char kind = array.dtype().kind();
  if (std::strchr("biuf", kind) == nullptr || array.itemsize() > 8)
  {
    throw BadInput(ErrorCode::PixelType,
                   name,
                   "values of type " + py::str(array.dtype()).cast<std::string>(),
                   "give integers, bools, or floats of at most 64 bits");
  }
  return array;
}

/** In this machine's byte order, half precision as single. */
py::array
inNativeTypes(const py::array & array)
{
  const py::dtype type = array.dtype();
  const bool      half = type.kind() == 'f' && type.itemsize() == 2;
  const auto      native = half ? py::dtype("f4") : py::reinterpret_borrow<py::dtype>(type.attr("newbyteorder")("="));
  return array.attr("astype")(native, py::arg("copy") = false);
}

/** Three axes, or one more for the components. */
void
requireVolume(const std::string & name, const py::array & array, bool mayHaveComponents)
{
  if (array.ndim() != 3 && !(mayHaveComponents && array.ndim() == 4))
  {
    throw BadInput(ErrorCode::Dimension,
                   name,
                   std::to_string(array.ndim()) + " axes, need 3" + (mayHaveComponents ? " or 4" : ""),
                   mayHaveComponents ? "give one volume, indexed [i, j, k] or [i, j, k, component]"
                                     : "give one volume, indexed [i, j, k]");
  }
}

/** The values as TTo, those of a voxel together, i fastest of its numbers; TFrom is what the array holds. */
template <typename TFrom, typename TTo = TFrom>
std::vector<TTo>
voxelsOf(const py::array & array)
{
  std::vector<TTo>    voxels(static_cast<std::size_t>(array.size()));
  auto                next = voxels.begin();
  const auto * const  begin = static_cast<const char *>(array.data());
  const py::ssize_t * strides = array.strides();
  const py::ssize_t * shape = array.shape();
  const py::ssize_t   components = array.ndim() == 4 ? shape[3] : 1;
  const py::ssize_t   step = array.ndim() == 4 ? strides[3] : 0;
  for (py::ssize_t k = 0; k < shape[2]; ++k)
  {
    for (py::ssize_t j = 0; j < shape[1]; ++j)
    {
      const char * at = begin + j * strides[1] + k * strides[2];
      for (py::ssize_t i = 0; i < shape[0]; ++i, at += strides[0])
      {
        for (py::ssize_t component = 0; component < components; ++component)
        {
          TFrom value;
          std::memcpy(&value, at + component * step, sizeof value);
          *next++ = static_cast<TTo>(value);
        }
      }
    }
  }
  return voxels;
}

/** Calls body with a zero of the type of the array's values. */
template <typename TBody>
auto
withType(const py::array & array, const TBody & body)
{
  const char kind = array.dtype().kind();
  const auto bytes = array.itemsize();
  if (kind == 'f')
  {
    return bytes == 4 ? body(float{}) : body(double{});
  }
  if (kind == 'i')
  {
    return bytes == 1   ? body(std::int8_t{})
           : bytes == 2 ? body(std::int16_t{})
           : bytes == 4 ? body(std::int32_t{})
                        : body(std::int64_t{});
  }
  return bytes == 1   ? body(std::uint8_t{})
         : bytes == 2 ? body(std::uint16_t{})
         : bytes == 4 ? body(std::uint32_t{})
                      : body(std::uint64_t{});
}

using Shape = std::array<std::uint64_t, 3>;

Shape
shapeOf(const py::array & array)
{
  return { { static_cast<std::uint64_t>(array.shape(0)),
             static_cast<std::uint64_t>(array.shape(1)),
             static_cast<std::uint64_t>(array.shape(2)) } };
}

ArrayHeader
headerOf(const std::string & name, const Shape & shape, const py::object & affine, Space space)
{
  const auto refuse = [&name](const std::string & cause) {
    throw BadInput(ErrorCode::Geometry, name, cause, "give the 4 x 4 affine, index to millimetres");
  };
  const auto matrix = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(affine);
  if (!matrix || matrix.ndim() != 2 || matrix.shape(0) != 4 || matrix.shape(1) != 4)
  {
    PyErr_Clear();
    refuse("the affine is not a 4 x 4 matrix of numbers");
  }
  if (matrix.at(3, 0) != 0.0 || matrix.at(3, 1) != 0.0 || matrix.at(3, 2) != 0.0 || matrix.at(3, 3) != 1.0)
  {
    refuse("the affine's last row is not 0 0 0 1");
  }
  ArrayHeader header;
  header.name = name;
  header.size = shape;
  for (py::ssize_t axis = 0; axis < 3; ++axis)
  {
    header.columns.col(axis) = flip(Vector3(matrix.at(0, axis), matrix.at(1, axis), matrix.at(2, axis)), space);
  }
  header.origin = flip(Vector3(matrix.at(0, 3), matrix.at(1, 3), matrix.at(2, 3)), space);
  requireValid(header); // before its voxels are copied
  return header;
}

} // namespace

Space
spaceOf(const std::string & name)
{
  if (name != "RAS" && name != "LPS")
  {
    throw InvalidInput(ErrorCode::Usage, "space: " + oneLine(name, 40) + " is none of RAS, LPS");
  }
  return name == "RAS" ? Space::RAS : Space::LPS;
}

Vector3
flip(const Vector3 & p, Space space)
{
  return space == Space::RAS ? Vector3(-p[0], -p[1], p[2]) : p;
}

LabelImage
labelsFrom(const py::object & labels, const py::object & affine, Space space)
{
  const std::string name = "labels";
  const py::array   array = inNativeTypes(realArray(name, labels));
  requireVolume(name, array, false);
  const ArrayHeader header = headerOf(name, shapeOf(array), affine, space);
  return withType(array, [&](auto zero) {
    const auto                   voxels = voxelsOf<decltype(zero)>(array);
    const py::gil_scoped_release release;
    return labelImageFrom(header, voxels);
  });
}

ScalarImage
scalarsFrom(const std::string & name, const py::object & values, const py::object & affine, Space space)
{
  const py::array array = inNativeTypes(realArray(name, values));
  requireVolume(name, array, false);
  const ArrayHeader header = headerOf(name, shapeOf(array), affine, space);
  return withType(array, [&](auto zero) {
    const auto                   doubles = voxelsOf<decltype(zero), double>(array);
    const py::gil_scoped_release release;
    return scalarImageFrom(header, doubles);
  });
}

FieldImage
fieldFrom(const std::string & name, const py::object & values, const py::object & affine, Space space)
{
  const py::array array = inNativeTypes(realArray(name, values));
  requireVolume(name, array, true);
  const ArrayHeader header = headerOf(name, shapeOf(array), affine, space);
  const int         components = array.ndim() == 4 ? static_cast<int>(array.shape(3)) : 1;
  return withType(array, [&](auto zero) {
    auto                         doubles = voxelsOf<decltype(zero), double>(array);
    const py::gil_scoped_release release;
    return fieldImageFrom(header, components, std::move(doubles));
  });
}

VoxelGrid
gridFrom(const py::object & shape, const py::object & affine, Space space)
{
  const auto sizes = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>::ensure(shape);
  if (!sizes || sizes.ndim() != 1 || sizes.shape(0) != 3 || sizes.at(0) < 0 || sizes.at(1) < 0 || sizes.at(2) < 0)
  {
    PyErr_Clear();
    throw BadInput(ErrorCode::Dimension, "shape", "not three sizes", "give the shape of the image, (i, j, k)");
  }
  Shape counts;
  std::copy_n(sizes.data(), 3, counts.begin());
  return voxelGridFrom(headerOf("image", counts, affine, space));
}

FieldVolume
cubeValuesFrom(const std::string & name, const py::object & values)
{
  const py::array array = inNativeTypes(realArray(name, values));
  requireVolume(name, array, true);
  const py::ssize_t side = array.shape(0);
  if (array.shape(1) != side || array.shape(2) != side || side < 1 || side > 1000 || array.size() == 0)
  {
    throw BadInput(ErrorCode::Dimension, name, "not a cube of values", "give N x N x N values, N from 1 to 1000");
  }
  FieldVolume cube;
  cube.size.fill(static_cast<int>(side));
  cube.components = array.ndim() == 4 ? static_cast<int>(array.shape(3)) : 1;
  cube.values = withType(array, [&](auto zero) { return voxelsOf<decltype(zero), double>(array); });
  return cube;
}

std::vector<double>
numbersFrom(const std::string & name, const py::object & numbers, std::vector<std::size_t> & shape)
{
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(realArray(name, numbers));
  if (!array || array.ndim() != static_cast<py::ssize_t>(shape.size()))
  {
    PyErr_Clear();
    throw BadInput(ErrorCode::Dimension,
                   name,
                   "another number of axes than " + std::to_string(shape.size()),
                   "give the shape that help() says");
  }
  std::copy_n(array.shape(), shape.size(), shape.begin());
  return { array.data(), array.data() + array.size() };
}

Positions
rowsFrom(const std::string & name, const py::object & rows)
{
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(realArray(name, rows));
  if (!array || array.ndim() != 2 || array.shape(1) != 3)
  {
    PyErr_Clear();
    throw BadInput(ErrorCode::Dimension, name, "not an array of rows of three", "give an array of shape (K, 3)");
  }
  Positions      positions(static_cast<std::size_t>(array.shape(0)));
  const double * next = array.data();
  for (Vector3 & position : positions)
  {
    position = { next[0], next[1], next[2] };
    next += 3;
  }
  return positions;
}

} // namespace moserhex::python
