#include "CorrespondingLandmarks.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>
#include <map>
#include <set>

namespace moserhex::app
{
namespace
{

constexpr const char * remedy = "give the same points in both lists, each with a label of its own";

std::vector<ListedPoint>
pointsOf(const std::string & fileName, std::vector<std::string> & warnings)
{
  PointList list = readPoints(fileName);
  warnings.insert(warnings.end(), list.warnings.begin(), list.warnings.end());
  return std::move(list.points);
}

/** Whether all points have labels of their own; else none has one.
 * \throws BadInput  only some have a label, or two have the same */
bool
isLabelled(const std::vector<ListedPoint> & points, const std::string & fileName)
{
  const auto hasLabel = [](const ListedPoint & point) { return !point.label.empty(); };
  if (std::none_of(points.begin(), points.end(), hasLabel))
  {
    return false;
  }
  std::set<std::string> labels;
  for (const ListedPoint & point : points)
  {
    if (point.label.empty())
    {
      throw BadInput(ErrorCode::Precondition, fileName, point.name + " has no label, other landmarks have one", remedy);
    }
    if (!labels.insert(point.label).second)
    {
      throw BadInput(ErrorCode::Precondition, fileName, "two landmarks are labelled " + point.label, remedy);
    }
  }
  return true;
}

std::size_t
placedPoints(const std::vector<ListedPoint> & points)
{
  return static_cast<std::size_t>(
    std::count_if(points.begin(), points.end(), [](const ListedPoint & point) { return point.position.has_value(); }));
}

void
addPair(const ListedPoint & onTemplate, const ListedPoint & onSolid, std::vector<CorrespondingPoints> & points)
{
  if (onTemplate.position && onSolid.position)
  {
    points.push_back({ *onTemplate.position, *onSolid.position, onTemplate.name });
  }
}

std::vector<CorrespondingPoints>
pairedByLabel(const std::vector<ListedPoint> & ofTemplate, const std::vector<ListedPoint> & ofSolid)
{
  std::map<std::string, const ListedPoint *> solidByLabel;
  for (const ListedPoint & point : ofSolid)
  {
    solidByLabel.emplace(point.label, &point);
  }
  std::vector<CorrespondingPoints> points;
  for (const ListedPoint & point : ofTemplate)
  {
    const auto found = solidByLabel.find(point.label);
    if (found != solidByLabel.end())
    {
      addPair(point, *found->second, points);
    }
  }
  return points;
}

/** A row that one list does not place is left out of both, so that those behind it keep their partners. */
std::vector<CorrespondingPoints>
pairedByRow(const std::vector<ListedPoint> & ofTemplate,
            const std::vector<ListedPoint> & ofSolid,
            const std::string &              solidFile)
{
  if (ofTemplate.size() != ofSolid.size())
  {
    throw BadInput(ErrorCode::Precondition,
                   solidFile,
                   std::to_string(ofSolid.size()) + " landmarks without labels, the template has " +
                     std::to_string(ofTemplate.size()),
                   remedy);
  }
  std::map<std::size_t, const ListedPoint *> solidByRow;
  for (const ListedPoint & point : ofSolid)
  {
    solidByRow.emplace(point.row, &point);
  }
  std::vector<CorrespondingPoints> points;
  for (const ListedPoint & point : ofTemplate)
  {
    const auto found = solidByRow.find(point.row);
    if (found != solidByRow.end())
    {
      addPair(point, *found->second, points);
    }
  }
  return points;
}

} // namespace

CorrespondingLandmarks
readLandmarks(const std::string & templateFile, const std::string & solidFile)
{
  CorrespondingLandmarks         result;
  const std::vector<ListedPoint> ofTemplate = pointsOf(templateFile, result.warnings);
  const std::vector<ListedPoint> ofSolid = pointsOf(solidFile, result.warnings);
  const bool                     byLabel = isLabelled(ofTemplate, templateFile);
  if (isLabelled(ofSolid, solidFile) != byLabel)
  {
    throw BadInput(ErrorCode::Precondition,
                   byLabel ? solidFile : templateFile,
                   "its landmarks have no labels, those of the other list have",
                   remedy);
  }
  result.points = byLabel ? pairedByLabel(ofTemplate, ofSolid) : pairedByRow(ofTemplate, ofSolid, solidFile);
  if (result.points.empty())
  {
    throw BadInput(ErrorCode::Precondition,
                   solidFile,
                   byLabel ? "no landmark has the label of one of the template's, both with a position"
                           : "no landmark has a position in both lists",
                   remedy);
  }
  const std::size_t alone = placedPoints(ofTemplate) + placedPoints(ofSolid) - 2 * result.points.size();
  if (alone > 0)
  {
    result.warnings.push_back(std::to_string(alone) + " landmarks are in one of the two lists alone and do not count");
  }
  return result;
}

} // namespace moserhex::app
