#include "SubjectFunction.h"

#include "moserhex/CubeTransfer/CubeAxes.h"

#include <algorithm>
#include <cstdio>

namespace moserhex::app
{

ImageInterpolation
interpolationOf(const TransferOptions & options)
{
  return options.nearest || options.labels ? ImageInterpolation::Nearest : ImageInterpolation::Linear;
}

SubjectFunction::SubjectFunction(const TransferImage & image, const TransferOptions & options)
  : m_Field(image.volume, image.hasValue, interpolationOf(options))
  , m_Components(image.volume.components)
  , m_IsMasked(!image.hasValue.empty())
  , m_Options(options)
{}

void
SubjectFunction::operator()(const CubePoint & point, double * values) const
{
  ++m_Asked;
  if (!m_Field.evaluate(point.position, values))
  {
    ++m_Beyond;
    std::fill_n(values, m_Components, m_Options.background);
    return;
  }
  if (m_Options.rotate)
  {
    turn(rotationPart(point.jacobian).transpose(), m_Components, values);
  }
}

void
SubjectFunction::requireCover(const TransferLog & log) const
{
  if (m_Beyond > 0 && m_Beyond == m_Asked)
  {
    throw BadInput(ErrorCode::Geometry,
                   m_Options.input,
                   m_IsMasked ? "the image's mask does not reach the mesh" : "the image does not reach the mesh",
                   "give the image of the same scan, both in LPS millimetres");
  }
  if (m_Beyond > 0)
  {
    char text[120];
    std::snprintf(text,
                  sizeof text,
                  ": %.3g %% of the mesh lies beyond the image%s: background there",
                  100.0 * static_cast<double>(m_Beyond) / static_cast<double>(m_Asked),
                  m_IsMasked ? " or its mask" : "");
    log.warn(m_Options.input + text);
  }
}

} // namespace moserhex::app
