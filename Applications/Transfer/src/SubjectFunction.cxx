#include "SubjectFunction.h"

#include "CommandErrors.h"
#include "moserhex/CubeTransfer/CubeAxes.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace moserhex::app
{

int
boxesPerAxis(const std::string & option, const std::string & sampling, int cellsPerAxis)
{
  if (sampling == "cells")
  {
    return cellsPerAxis;
  }
  int          number = 0;
  const char * end = sampling.data() + sampling.size();
  const auto   parsed = std::from_chars(sampling.data(), end, number);
  if (parsed.ec != std::errc() || parsed.ptr != end || number < 1 || number > 1000)
  {
    throw UsageError(option + " " + sampling + ": need cells, nodes, or a number from 1 to 1000");
  }
  return number;
}

ImageInterpolation
interpolationOf(const TransferOptions & options)
{
  return options.nearest || options.labels ? ImageInterpolation::Nearest : ImageInterpolation::Linear;
}

CubeMeanOptions
meanOptions(const TransferOptions & options, int boxes, const HexMesh & mesh, const VoxelGrid & image)
{
  constexpr double          fewest = 4.0;
  constexpr double          most = 48.0;
  const std::vector<double> volumes = cellVolumes(mesh);
  const double              volume = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  CubeMeanOptions           result;
  result.samplesPerAxis = boxes;
  result.threads = options.threads;
  const double edge = std::cbrt(volume) / std::max(boxes, mesh.nodesPerSide - 1);
  result.pointsPerAxis =
    options.pointsPerAxis > 0
      ? options.pointsPerAxis
      : static_cast<int>(std::clamp(std::ceil(2.0 * edge / image.spacing.minCoeff()), fewest, most));
  return result;
}

SubjectFunction::SubjectFunction(const FieldVolume &                image,
                                 const std::vector<unsigned char> & hasValue,
                                 const TransferOptions &            options)
  : m_Field(image, hasValue, interpolationOf(options))
  , m_Components(image.components)
  , m_IsMasked(!hasValue.empty())
  , m_Options(options)
{}

bool
SubjectFunction::evaluate(const CubePoint & point, double * values) const
{
  ++m_Asked;
  if (!m_Field.evaluate(point.position, values))
  {
    ++m_Beyond;
    std::fill_n(values, m_Components, m_Options.background);
    return false;
  }
  if (m_Options.rotate)
  {
    turn(rotationPart(point.jacobian).transpose(), m_Components, values);
  }
  return true;
}

double
SubjectFunction::partBeyond() const
{
  return static_cast<double>(m_Beyond) / std::max(1.0, static_cast<double>(m_Asked));
}

void
SubjectFunction::requireCover(const TransferLog & log) const
{
  if (m_Beyond > 0 && m_Beyond == m_Asked)
  {
    throw BadInput(ErrorCode::Geometry,
                   m_Options.input,
                   m_IsMasked ? "no voxel with data reaches the mesh" : "the image does not reach the mesh",
                   "give the image of the same scan, both in LPS millimetres");
  }
  if (m_Beyond > 0)
  {
    char text[160];
    std::snprintf(text,
                  sizeof text,
                  ": %.3g %% of the mesh lies beyond the image%s: background there",
                  100.0 * partBeyond(),
                  m_IsMasked ? " or its mask, or on voxels that are not finite" : "");
    log.warn(m_Options.input + text);
  }
}

} // namespace moserhex::app
