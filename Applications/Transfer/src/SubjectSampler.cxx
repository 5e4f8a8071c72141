#include "SubjectSampler.h"

#include "CommandErrors.h"
#include "Integrals.h"
#include "moserhex/CubeTransfer/RefinedMeans.h"

#include <cmath>
#include <cstdio>
#include <functional>
#include <numeric>
#include <utility>

namespace moserhex::app
{
namespace
{

constexpr double integralTolerance = 1e-6; ///< of a density, which --conserve keeps

void
tellIntegrals(const RefinedMeans & result, const TransferOptions & options, const TransferLog & log)
{
  const double volume = std::accumulate(result.means.volumes.begin(), result.means.volumes.end(), 0.0);
  for (std::size_t c = 0; c < result.integrals.size(); ++c)
  {
    char text[120];
    std::snprintf(text, sizeof text, ": %.9g +- %.2g, volume %.9g mm3", result.integrals[c], result.errors[c], volume);
    log.say(integralName(c, result.means.image.components) + text);
  }
  if (result.relativeError > integralTolerance)
  {
    char text[160];
    std::snprintf(text,
                  sizeof text,
                  ": the integral is known to %.2g only, of %.0e wanted: the image has steps or noise; "
                  "more --points may help",
                  result.relativeError,
                  integralTolerance);
    log.warn(oneLine(options.input, 60) + text);
  }
}

} // namespace

SubjectSampler::SubjectSampler(const TransferImage &   image,
                               const HexMesh &         mesh,
                               const TransferOptions & options,
                               const TransferLog &     log)
  : m_Image(image), m_Mesh(mesh), m_Options(options), m_Log(log), m_Function(image.volume, image.hasValue, options)
{}

FieldVolume
SubjectSampler::cube() const
{
  if (m_Options.sampling == "nodes")
  {
    return nodes();
  }
  if (m_Options.labels)
  {
    return labels();
  }
  return m_Options.conserve ? conservedMeans().image : means();
}

CubeMeans
SubjectSampler::conservedMeans() const
{
  const CubeMeanOptions first = rule(boxes());
  CubeMeans             firstMeans = cubeMeans(m_Mesh, std::cref(m_Function), m_Function.components(), first);
  m_Function.requireCover(m_Log);
  const SubjectFunction finer(m_Image.volume, m_Image.hasValue, m_Options); // m_Function counts the mesh, evenly
  RefinementOptions     refinement;
  refinement.tolerance = integralTolerance;
  refinement.threads = m_Options.threads;
  RefinedMeans result = refinedMeans(m_Mesh, std::cref(finer), std::move(firstMeans), first.pointsPerAxis, refinement);
  tellIntegrals(result, m_Options, m_Log);
  return std::move(result.means);
}

LabelAmounts
SubjectSampler::labelVolumes() const
{
  if (!hasShares(m_Image))
  {
    m_Log.say(std::to_string(m_Image.labels.size()) + " labels around the organ, too many to tell their volumes");
    return {};
  }
  const SubjectFunction     labelAt(m_Image.volume, m_Image.hasValue, m_Options);
  const std::vector<double> values = labelsOfPlaces(m_Image, m_Options.background);
  return volumesOf(labelFractions(m_Mesh, std::cref(labelAt), values, rule(m_Mesh.nodesPerSide - 1)), values);
}

FieldVolume
SubjectSampler::nodes() const
{
  FieldVolume result = cubeNodeSamples(m_Mesh, std::cref(m_Function), m_Function.components(), m_Options.threads);
  m_Function.requireCover(m_Log);
  const LabelAmounts before = m_Options.labels ? labelVolumes() : LabelAmounts();
  if (!before.empty())
  {
    const std::vector<double> one(result.values.size(), 1.0);
    reportLabels(m_Image.labels,
                 before,
                 { amountsOf(result.values, one), "nodes", "node of the cube", "take --sampling N, or --fractions" },
                 m_Log);
  }
  return result;
}

FieldVolume
SubjectSampler::labels() const
{
  const int                 perAxis = boxes();
  const std::vector<double> values = labelsOfPlaces(m_Image, m_Options.background);
  if (m_Options.fractions && values.size() == 1)
  {
    throw BadInput(ErrorCode::EmptyLabel, m_Options.input, "no label, so no fractions", "leave --fractions out");
  }
  const CubeMeans fractions = labelFractions(m_Mesh, std::cref(m_Function), values, rule(perAxis));
  m_Function.requireCover(m_Log);
  const LabelAmounts before = volumesOf(fractions, values);
  if (m_Options.fractions)
  {
    reportLabels(m_Image.labels, before, { before, "mm3 in the cube", "", "" }, m_Log);
    return withoutZero(fractions.image);
  }
  FieldVolume result = majority(fractions.image, values);
  reportLabels(m_Image.labels,
               before,
               { amountsOf(result.values, fractions.volumes),
                 "mm3 in the cube",
                 "box of the cube",
                 "take --sampling N above " + std::to_string(perAxis) + ", or --fractions" },
               m_Log);
  return result;
}

FieldVolume
SubjectSampler::means() const
{
  CubeMeans result = cubeMeans(m_Mesh, std::cref(m_Function), m_Function.components(), rule(boxes()));
  m_Function.requireCover(m_Log);
  if (m_Function.components() == 1)
  {
    const double volume = std::accumulate(result.volumes.begin(), result.volumes.end(), 0.0);
    m_Log.say("integral over the mesh: " + nineDigits(sumOf(massesOf(result.image, result.volumes), 0)) + ", volume " +
              nineDigits(volume) + " mm3");
  }
  return std::move(result.image);
}

int
SubjectSampler::boxes() const
{
  const int    perAxis = boxesPerAxis("--sampling", m_Options.sampling, m_Mesh.nodesPerSide - 1);
  const double numbers = m_Options.fractions ? static_cast<double>(m_Image.labels.size()) : m_Function.components();
  requireWritableSize(std::pow(perAxis, 3) * numbers, "--sampling " + m_Options.sampling);
  return perAxis;
}

CubeMeanOptions
SubjectSampler::rule(int boxes) const
{
  return meanOptions(m_Options, boxes, m_Mesh, m_Image.volume);
}

} // namespace moserhex::app
