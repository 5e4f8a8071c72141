#include "ArrayInput.h"

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

void
requireThreeAxes(const std::string & name, const py::array & array)
{
  if (array.ndim() != 3)
  {
    throw BadInput(
      ErrorCode::Dimension, name, std::to_string(array.ndim()) + " axes, need 3", "give one volume, indexed [i, j, k]");
  }
}

/** The values as TTo, i fastest; TFrom is what the array holds. */
template <typename TFrom, typename TTo = TFrom>
std::vector<TTo>
voxelsOf(const py::array & array)
{
  std::vector<TTo>    voxels(static_cast<std::size_t>(array.size()));
  auto                next = voxels.begin();
  const auto * const  begin = static_cast<const char *>(array.data());
  const py::ssize_t * strides = array.strides();
  const py::ssize_t * shape = array.shape();
  for (py::ssize_t k = 0; k < shape[2]; ++k)
  {
    for (py::ssize_t j = 0; j < shape[1]; ++j)
    {
      const char * at = begin + j * strides[1] + k * strides[2];
      for (py::ssize_t i = 0; i < shape[0]; ++i, at += strides[0])
      {
        TFrom value;
        std::memcpy(&value, at, sizeof value);
        *next++ = static_cast<TTo>(value);
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

ArrayHeader
headerOf(const std::string & name, const py::array & array, const py::object & affine, Space space)
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
  for (py::ssize_t axis = 0; axis < 3; ++axis)
  {
    header.size[static_cast<std::size_t>(axis)] = static_cast<std::uint64_t>(array.shape(axis));
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
  requireThreeAxes(name, array);
  const ArrayHeader header = headerOf(name, array, affine, space);
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
  requireThreeAxes(name, array);
  const ArrayHeader header = headerOf(name, array, affine, space);
  return withType(array, [&](auto zero) {
    const auto                   doubles = voxelsOf<decltype(zero), double>(array);
    const py::gil_scoped_release release;
    return scalarImageFrom(header, doubles);
  });
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
