#include "PythonErrors.h"

#include "ArgumentNames.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <itkMacro.h>

#include <string>

namespace moserhex::python
{
namespace
{

namespace py = pybind11;

constexpr const char * errorText =
  "What the library refuses or cannot do, in one line.\n\n"
  "`code` is a name that never changes, such as 'E_GEOMETRY'; Documentation/Errors.md lists them.";

void
raise(const py::handle & type, ErrorCode code, const std::string & message)
{
  const py::object error = type(withArguments(oneLine(message, 300)));
  error.attr("code") = nameOf(code);
  PyErr_SetObject(type.ptr(), error.ptr());
}

} // namespace

void
addError(py::module_ & module)
{
  // Kept for the life of the process, as the translator is.
  static PyObject * const type = PyErr_NewExceptionWithDoc("moserhex.Error", errorText, PyExc_RuntimeError, nullptr);
  if (type == nullptr)
  {
    throw py::error_already_set();
  }
  module.add_object("Error", py::reinterpret_borrow<py::object>(type));
  py::register_exception_translator([](std::exception_ptr exception) {
    try
    {
      std::rethrow_exception(exception);
    }
    catch (const Error & error)
    {
      raise(type, error.code(), error.what());
    }
    catch (const itk::ExceptionObject & error)
    {
      raise(type, ErrorCode::Internal, std::string(error.GetDescription()) + "; please report this");
    }
  });
}

} // namespace moserhex::python
