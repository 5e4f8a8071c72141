#pragma once

#include "PythonMesh.h"
#include "TemplateInputs.h"

#include <pybind11/pybind11.h>

namespace moserhex::python
{

/** What a call of mesh says of a template, apart from the template itself; None for what it does not. */
struct TemplateArguments
{
  pybind11::object landmarks;         ///< K x 3, in the space of the label
  pybind11::object templateLandmarks; ///< K x 3, in the space of the template
  pybind11::object image;
  pybind11::object imageAffine; ///< in the space of the label
  pybind11::object templateImage;
  pybind11::object templateImageAffine;  ///< in the space of the template
  bool             localGrowth{ false }; ///< every cell grows as landmarks and images show
};

/** \param templateMesh  nullptr: none \param space  of the label
 * \throws BadInput  Dimension: other numbers of landmarks, or of axes; PixelType: values that are not finite; what
 * scalarsFrom throws; InvalidInput (Usage): one of a pair without the other, or without a template */
[[nodiscard]] TemplateRefinement
refinementFrom(const TemplateArguments & arguments, const PythonMesh * templateMesh, Space space);

} // namespace moserhex::python
