#include "TemplateWarnings.h"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace moserhex::app
{
namespace
{

/** Of the radius of the ball of the label's volume: the median of the surfaces' distances that is doubtful [1]. */
constexpr double farAway = 0.25;
/** Of that radius: a median below which neither direction of a transform is worth a word [1]. */
constexpr double nearby = 0.05;
/** The inverse of a transform counts as the right one below this part of the median [1]. */
constexpr double muchNearer = 0.5;
constexpr double smallestScale = 0.5;
constexpr double largestScale = 2.0;

/** Empty: nothing to be said. */
std::string
warningOfPlace(const TemplateFit & fit, const RunReport::Template & tied, double radius)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(1);
  if (fit.medianOfInverse && fit.median > nearby * radius && *fit.medianOfInverse < muchNearer * fit.median)
  {
    text << "the inverse of the transform brings the template's surface to " << *fit.medianOfInverse << " instead of "
         << fit.median
         << " mm (median) from the label's; --align takes the one from the template's space to the label's";
  }
  else if (fit.median > farAway * radius)
  {
    text << "before it was bent, the template's surface was " << fit.median
         << " mm (median) from the label's, whose radius is " << radius << " mm; "
         << (tied.aligned ? "is it of this organ? --align takes a transform, too" : "try --align rigid");
  }
  return text.str();
}

/** Empty: nothing to be said. */
std::string
warningOfSize(const TemplateFit & fit)
{
  if (fit.scale >= smallestScale && fit.scale <= largestScale)
  {
    return "";
  }
  std::ostringstream text;
  text << "the template was made " << std::setprecision(3) << fit.scale
       << " times as large: is --template in millimetres, and of this organ?";
  return text.str();
}

} // namespace

std::vector<std::string>
templateWarnings(const TemplateFit & fit, const RunReport::Template & tied, double volume)
{
  const double             radius = std::cbrt(0.75 * volume / pi);
  std::vector<std::string> warnings;
  for (const std::string & warning : { warningOfPlace(fit, tied, radius), warningOfSize(fit) })
  {
    if (!warning.empty())
    {
      warnings.push_back(warning);
    }
  }
  return warnings;
}

} // namespace moserhex::app
