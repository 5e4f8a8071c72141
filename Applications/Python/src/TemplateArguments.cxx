#include "TemplateArguments.h"

#include "moserhex/HexMeshIO/FileErrors.h"

namespace moserhex::python
{
namespace
{

namespace py = pybind11;

/** \return whether both are given. \throws InvalidInput (Usage)  one of them is */
bool
isPair(const py::object & one, const py::object & other, const char * names)
{
  if (one.is_none() != other.is_none())
  {
    throw InvalidInput(ErrorCode::Usage, std::string(names) + " need each other");
  }
  return !one.is_none();
}

std::vector<CorrespondingPoints>
landmarksFrom(const TemplateArguments & arguments, Space templateSpace, Space space)
{
  const Positions onTemplate = rowsFrom("template_landmarks", arguments.templateLandmarks);
  const Positions onSolid = rowsFrom("landmarks", arguments.landmarks);
  if (onTemplate.size() != onSolid.size() || onSolid.empty())
  {
    throw BadInput(ErrorCode::Dimension,
                   "landmarks",
                   std::to_string(onSolid.size()) + " points, template_landmarks has " +
                     std::to_string(onTemplate.size()),
                   "give the same points in the same order");
  }
  std::vector<CorrespondingPoints> points(onSolid.size());
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    points[k] = { flip(onTemplate[k], templateSpace), flip(onSolid[k], space), "point " + std::to_string(k) };
    if (!points[k].onTemplate.allFinite() || !points[k].onSolid.allFinite())
    {
      throw BadInput(ErrorCode::PixelType,
                     "landmarks",
                     "point " + std::to_string(k) + " is not finite",
                     "leave it out of landmarks and template_landmarks");
    }
  }
  return points;
}

} // namespace

TemplateRefinement
refinementFrom(const TemplateArguments & arguments, const PythonMesh * templateMesh, Space space)
{
  const bool hasLandmarks =
    isPair(arguments.landmarks, arguments.templateLandmarks, "landmarks and template_landmarks");
  const bool hasImages = isPair(arguments.image, arguments.templateImage, "image and template_image");
  if (arguments.localGrowth && !hasLandmarks && !hasImages)
  {
    throw InvalidInput(ErrorCode::Usage, "local_growth needs image or landmarks: shapes do not show it");
  }
  TemplateRefinement refinement;
  refinement.localGrowth = arguments.localGrowth;
  if (templateMesh == nullptr)
  {
    if (hasLandmarks || hasImages)
    {
      throw InvalidInput(ErrorCode::Usage, "landmarks and image need a template");
    }
    return refinement;
  }
  const Space templateSpace = templateMesh->space();
  if (hasLandmarks)
  {
    refinement.landmarks = landmarksFrom(arguments, templateSpace, space);
  }
  if (hasImages)
  {
    refinement.images =
      CorrespondingImages{ app::comparableVolume(scalarsFrom(
                             "template_image", arguments.templateImage, arguments.templateImageAffine, templateSpace)),
                           app::comparableVolume(scalarsFrom("image", arguments.image, arguments.imageAffine, space)) };
  }
  return refinement;
}

} // namespace moserhex::python
