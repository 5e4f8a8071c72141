#include "GridTarget.h"

#include "CommandErrors.h"
#include "Integrals.h"
#include "moserhex/CubeTransfer/GridMasses.h"
#include "moserhex/CubeTransfer/GridSamples.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace moserhex::app
{

GridTarget::GridTarget(const HexMesh &         mesh,
                       const VoxelGrid &       grid,
                       const TransferOptions & options,
                       const TransferLog &     log)
  : m_Mesh(mesh), m_Grid(grid), m_Options(options), m_Log(log)
{}

FieldVolume
GridTarget::samples(const CubeFunction & f, int components, double background) const
{
  const CubeMap map(m_Mesh);
  GridSamples   result = gridSamples(map, m_Mesh, f, components, m_Grid, { background, m_Options.threads });
  if (result.inside == 0)
  {
    throw BadInput(ErrorCode::Geometry,
                   m_Options.like.empty() ? m_Options.mesh : m_Options.like,
                   "no voxel centre lies in the mesh",
                   "give an image of the subject, or smaller voxels");
  }
  m_Log.say(std::to_string(result.inside) + " voxels in the mesh");
  return std::move(result.image);
}

FieldVolume
GridTarget::labels(const CubeFunction &            labelAt,
                   const std::vector<LabelEntry> & labels,
                   const LabelAmounts &            before) const
{
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN(); // beyond the mesh, where no label has a place
  FieldVolume      result = samples(labelAt, 1, nowhere);
  if (!before.empty())
  {
    const std::vector<double> volumes(result.values.size(), m_Grid.voxelVolume());
    reportLabels(
      labels, before, { amountsOf(result.values, volumes), "mm3 in the image", "voxel", "take smaller voxels" }, m_Log);
  }
  std::replace_if(
    result.values.begin(), result.values.end(), [](double label) { return std::isnan(label); }, m_Options.background);
  return result;
}

FieldVolume
GridTarget::densities(const FieldVolume & masses) const
{
  const CubeMap   map(m_Mesh);
  GridMassOptions massOptions;
  massOptions.background = m_Options.background;
  massOptions.threads = m_Options.threads;
  GridMasses result = gridMasses(map, m_Mesh, masses, m_Grid, massOptions);
  if (result.reached == 0)
  {
    throw BadInput(
      ErrorCode::Geometry, m_Options.like, "the grid does not reach the mesh", "give an image of the subject");
  }
  constexpr double worthAWord = 0.01;
  if (result.imbalance > worthAWord)
  {
    char text[120];
    std::snprintf(
      text, sizeof text, "shares of voxels are off by up to %.2g of a voxel; their sum is right", result.imbalance);
    m_Log.warn(text);
  }
  for (std::size_t c = 0; c < result.outside.size(); ++c)
  {
    if (result.outside[c] != 0.0)
    {
      char text[120];
      std::snprintf(text, sizeof text, "%.6g of the ", result.outside[c]);
      m_Log.warn(text + integralName(c, masses.components) + ", " + nineDigits(sumOf(masses, c)) +
                 ", lies beyond the grid");
    }
  }
  return std::move(result.image);
}

} // namespace moserhex::app
