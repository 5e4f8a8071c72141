#include "CorrespondingLandmarks.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <map>
#include <optional>

namespace moserhex::app
{
namespace
{

constexpr const char * remedy = "give the same points in both lists, with the same labels";

std::vector<ListedPoint>
placedPoints(const std::string & fileName, std::vector<std::string> & warnings)
{
  PointList list = readPoints(fileName);
  warnings.insert(warnings.end(), list.warnings.begin(), list.warnings.end());
  std::vector<ListedPoint> placed;
  for (ListedPoint & point : list.points)
  {
    if (point.position)
    {
      placed.push_back(std::move(point));
    }
  }
  return placed;
}

/** Nothing when a label is missing or there twice. */
std::optional<std::map<std::string, Vector3>>
byLabel(const std::vector<ListedPoint> & points)
{
  std::map<std::string, Vector3> positions;
  for (const ListedPoint & point : points)
  {
    if (point.label.empty() || !positions.emplace(point.label, *point.position).second)
    {
      return std::nullopt;
    }
  }
  return positions;
}

} // namespace

CorrespondingLandmarks
readLandmarks(const std::string & templateFile, const std::string & solidFile)
{
  CorrespondingLandmarks         result;
  const std::vector<ListedPoint> ofTemplate = placedPoints(templateFile, result.warnings);
  const std::vector<ListedPoint> ofSolid = placedPoints(solidFile, result.warnings);
  const auto                     labelsOfTemplate = byLabel(ofTemplate);
  const auto                     labelsOfSolid = byLabel(ofSolid);
  if (labelsOfTemplate && labelsOfSolid)
  {
    for (const auto & [label, position] : *labelsOfTemplate)
    {
      const auto found = labelsOfSolid->find(label);
      if (found != labelsOfSolid->end())
      {
        result.points.push_back({ position, found->second });
      }
    }
  }
  else if (ofTemplate.size() == ofSolid.size())
  {
    for (std::size_t p = 0; p < ofTemplate.size(); ++p)
    {
      result.points.push_back({ *ofTemplate[p].position, *ofSolid[p].position });
    }
  }
  else
  {
    throw BadInput(ErrorCode::Precondition,
                   solidFile,
                   std::to_string(ofSolid.size()) + " landmarks without labels of their own, the template has " +
                     std::to_string(ofTemplate.size()),
                   remedy);
  }
  if (result.points.empty())
  {
    throw BadInput(ErrorCode::Precondition, solidFile, "no landmark has the label of one of the template's", remedy);
  }
  const std::size_t alone = ofTemplate.size() + ofSolid.size() - 2 * result.points.size();
  if (alone > 0)
  {
    result.warnings.push_back(std::to_string(alone) + " landmarks are in one of the two lists alone and do not count");
  }
  return result;
}

} // namespace moserhex::app
