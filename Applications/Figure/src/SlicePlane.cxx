#include "SlicePlane.h"

#include "CommandErrors.h"

#include <array>
#include <charconv>

namespace moserhex::app
{
namespace
{

/** The whole text as a number. */
template <typename TNumber>
std::optional<TNumber>
numberIn(const std::string & text)
{
  TNumber      number{};
  const char * end = text.data() + text.size();
  const auto   result = std::from_chars(text.data(), end, number);
  return result.ec == std::errc() && result.ptr == end ? std::optional<TNumber>(number) : std::nullopt;
}

} // namespace

SlicePlane
parsePlane(const std::string & text)
{
  const std::size_t                colon = text.find(':');
  const std::string                name = text.substr(0, colon);
  const bool                       hasNumber = colon != std::string::npos;
  const std::string                number = hasNumber ? text.substr(colon + 1) : "";
  const std::array<std::string, 3> patientPlanes{ "sagittal", "coronal", "axial" };
  const std::array<std::string, 3> latticeAxes{ "i", "j", "k" };
  for (int axis = 0; axis < 3; ++axis)
  {
    SlicePlane plane;
    plane.axis = axis;
    if (name == patientPlanes[static_cast<std::size_t>(axis)])
    {
      plane.position = numberIn<double>(number);
      if (plane.position.has_value() == hasNumber)
      {
        return plane;
      }
    }
    if (name == latticeAxes[static_cast<std::size_t>(axis)])
    {
      plane.layer = numberIn<int>(number);
      if (plane.layer)
      {
        return plane;
      }
    }
  }
  throw UsageError("--plane " + oneLine(text, 40) +
                   " is none; give axial, coronal or sagittal, with :MM for a place, or i:K j:K k:K");
}

} // namespace moserhex::app
