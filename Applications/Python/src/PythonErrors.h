#pragma once

#include <pybind11/pybind11.h>

namespace moserhex::python
{

/** Makes moserhex.Error, a RuntimeError with the attribute `code`, and turns the library's errors into it. */
void
addError(pybind11::module_ & module);

} // namespace moserhex::python
