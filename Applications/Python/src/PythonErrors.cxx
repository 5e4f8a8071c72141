#include "PythonErrors.h"

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

/** Messages name options as the command line has them: here they are arguments. */
std::string
withArguments(std::string text)
{
  const std::pair<const char *, const char *> names[] = { { "--allow-partial", "allow_partial=True" },
                                                          { "--max-repair", "max_repair" },
                                                          { "--topology repair", "topology='repair'" },
                                                          { "--topology", "topology" },
                                                          { "--stage exact", "stage='exact'" },
                                                          { "--stage", "stage" },
                                                          { "--shells", "shells" },
                                                          { "--density", "density" },
                                                          { "--label", "label" },
                                                          { "--frame", "frame" },
                                                          { "--template", "template" },
                                                          { "--align", "align" },
                                                          { "--padding", "padding" },
                                                          { "--shell-method", "shell_method" },
                                                          { "--threshold", "labels >= threshold" },
                                                          { "--way", "way" } };
  for (const auto & [option, argument] : names)
  {
    for (auto at = text.find(option); at != std::string::npos; at = text.find(option))
    {
      text.replace(at, std::char_traits<char>::length(option), argument);
    }
  }
  return text;
}

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
