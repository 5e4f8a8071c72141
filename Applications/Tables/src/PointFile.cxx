#include "PointFile.h"

#include "TextTable.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

namespace moserhex::app
{
namespace
{

using Json = nlohmann::json;

constexpr const char * fiducialColumns = "id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID";
constexpr const char * exportAgain = "save it again from 3D Slicer";

enum class PointFormat
{
  Fiducials,
  Markups,
  Commas,
  Tabs,
  None
};

PointFormat
formatOf(const std::string & fileName)
{
  std::string name = fileName;
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  });
  static const std::array<std::pair<std::string, PointFormat>, 4> endings{ { { ".fcsv", PointFormat::Fiducials },
                                                                             { ".mrk.json", PointFormat::Markups },
                                                                             { ".csv", PointFormat::Commas },
                                                                             { ".tsv", PointFormat::Tabs } } };
  for (const auto & [ending, format] : endings)
  {
    if (name.size() >= ending.size() && name.compare(name.size() - ending.size(), ending.size(), ending) == 0)
    {
      return format;
    }
  }
  return PointFormat::None;
}

[[noreturn]] void
refuse(const std::string & fileName, const std::string & cause, const std::string & remedy)
{
  throw BadInput(ErrorCode::Format, fileName, cause, remedy);
}

/** The factors that turn a coordinate system into LPS. */
Vector3
toLps(const std::string & fileName, const std::string & system)
{
  if (system == "LPS" || system == "1")
  {
    return Vector3::Ones();
  }
  if (system == "RAS" || system == "0")
  {
    return { -1.0, -1.0, 1.0 };
  }
  refuse(fileName, "coordinate system " + oneLine(system, 20) + ", need LPS or RAS", exportAgain);
}

double
coordinateOf(const std::string & fileName, const std::string & point, const std::string & cell)
{
  double       value = 0.0;
  const char * end = cell.data() + cell.size();
  const auto   parsed = std::from_chars(cell.data(), end, value);
  if (parsed.ec != std::errc() || parsed.ptr != end || !std::isfinite(value))
  {
    refuse(fileName, oneLine(point, 40) + ": " + oneLine("'" + cell + "'", 30) + " is not a coordinate", "correct it");
  }
  return value;
}

/** Three cells of a row; nothing when all are empty. */
std::optional<Vector3>
vectorOf(const std::string &              fileName,
         const std::string &              point,
         const std::vector<std::string> & cells,
         const std::array<std::size_t, 3> columns)
{
  if (std::all_of(columns.begin(), columns.end(), [&cells](std::size_t column) { return cells[column].empty(); }))
  {
    return std::nullopt;
  }
  return Vector3(coordinateOf(fileName, point, cells[columns[0]]),
                 coordinateOf(fileName, point, cells[columns[1]]),
                 coordinateOf(fileName, point, cells[columns[2]]));
}

/** Takes the columns that it knows, and keeps the others. */
class PointColumns
{
public:
  PointColumns(std::string fileName, const std::vector<std::string> & columns, const Vector3 & factors)
    : m_FileName(std::move(fileName)), m_Factors(factors), m_Count(columns.size())
  {
    m_Position = threeOf(columns, { "x", "y", "z" });
    m_Cube = threeOf(columns, { "c1", "c2", "c3" });
    m_Label = oneOf(columns, { "label", "name" });
    m_Description = oneOf(columns, { "description", "desc" });
    for (std::size_t column = 0; column < columns.size(); ++column)
    {
      if (!m_Taken.count(column))
      {
        m_Others.push_back(column);
        m_OtherNames.push_back(columns[column]);
      }
    }
    if (!m_Position && !m_Cube)
    {
      refuse(m_FileName, "neither columns x, y, z nor c1, c2, c3", "name the columns of the coordinates so");
    }
  }

  [[nodiscard]] const std::vector<std::string> &
  otherNames() const
  {
    return m_OtherNames;
  }

  [[nodiscard]] ListedPoint
  point(const std::vector<std::string> & cells, std::size_t line) const
  {
    ListedPoint point;
    if (cells.size() != m_Count)
    {
      refuse(m_FileName,
             "line " + std::to_string(line) + ": " + std::to_string(cells.size()) + " cells for " +
               std::to_string(m_Count) + " columns",
             exportAgain);
    }
    point.label = m_Label ? cells[*m_Label] : "";
    point.description = m_Description ? cells[*m_Description] : "";
    point.name = point.label.empty() ? "line " + std::to_string(line) : point.label;
    if (m_Position)
    {
      point.position = vectorOf(m_FileName, point.name, cells, *m_Position);
    }
    if (point.position)
    {
      point.position = m_Factors.cwiseProduct(*point.position);
    }
    if (m_Cube)
    {
      point.cube = vectorOf(m_FileName, point.name, cells, *m_Cube);
    }
    for (const std::size_t column : m_Others)
    {
      point.others.push_back(cells[column]);
    }
    return point;
  }

private:
  using Three = std::array<std::size_t, 3>;

  std::optional<std::size_t>
  oneOf(const std::vector<std::string> & columns, const std::array<std::string, 2> & names)
  {
    for (const std::string & name : names)
    {
      const auto found = std::find(columns.begin(), columns.end(), name);
      if (found != columns.end())
      {
        const auto column = static_cast<std::size_t>(found - columns.begin());
        m_Taken.insert(column);
        return column;
      }
    }
    return std::nullopt;
  }

  std::optional<Three>
  threeOf(const std::vector<std::string> & columns, const std::array<std::string, 3> & names)
  {
    Three       three{};
    std::size_t count = 0;
    for (std::size_t n = 0; n < names.size(); ++n)
    {
      if (const auto column = oneOf(columns, { names[n], names[n] }))
      {
        three[n] = *column;
        ++count;
      }
    }
    if (count != 0 && count != names.size())
    {
      refuse(m_FileName, "not all of the columns " + names[0] + ", " + names[1] + ", " + names[2], "give all three");
    }
    return count == 0 ? std::nullopt : std::optional(three);
  }

  std::string                m_FileName;
  Vector3                    m_Factors;
  std::size_t                m_Count;
  std::set<std::size_t>      m_Taken;
  std::optional<Three>       m_Position;
  std::optional<Three>       m_Cube;
  std::optional<std::size_t> m_Label;
  std::optional<std::size_t> m_Description;
  std::vector<std::size_t>   m_Others;
  std::vector<std::string>   m_OtherNames;
};

PointList
readTable(const std::string & fileName)
{
  const TextTable    table = readTextTable(fileName);
  const PointColumns columns(fileName, table.columns, Vector3::Ones());
  PointList          list{ columns.otherNames(), {} };
  for (const TextTable::Row & row : table.rows)
  {
    list.points.push_back(columns.point(row.cells, row.line));
    list.points.back().row = row.number;
  }
  return list;
}

/** The value of "# key = value" in a line, whatever blanks are in it, as Slicer takes it apart; nothing in other lines.
 */
std::optional<std::string>
headerValue(const std::string & line, const std::string & key)
{
  const std::size_t equals = line.find('=');
  if (equals == std::string::npos || withoutBlanksAround(line.substr(1, equals - 1)) != key)
  {
    return std::nullopt;
  }
  return withoutBlanksAround(line.substr(equals + 1));
}

/** Takes the cells behind the named columns away, two since Slicer 5: the status of the position, and whether a program
 * made the point. \return whether the position is defined; also where its status is not given */
bool
takeStatus(std::size_t named, std::vector<std::string> & cells)
{
  if (cells.size() <= named)
  {
    return true;
  }
  const std::string status = cells[named];
  cells.resize(named);
  return status.empty() || status == "2";
}

PointList
readFiducials(const std::string & fileName)
{
  std::optional<std::string> system;
  std::string                names = fiducialColumns;
  PointList                  list;
  const TextTable            lines = readTextLines(fileName, "line");
  for (const TextTable::Row & row : lines.rows)
  {
    const std::string & line = row.cells.front();
    if (line.front() == '#')
    {
      const auto stated = headerValue(line, "CoordinateSystem");
      system = stated ? stated : system;
      names = headerValue(line, "columns").value_or(names);
      continue;
    }
    const std::vector<std::string> columns = cellsOfLine(fileName, row.line, names, ',');
    std::vector<std::string>       cells = cellsOfLine(fileName, row.line, line, ',');
    const bool                     isDefined = takeStatus(columns.size(), cells);
    ListedPoint point = PointColumns(fileName, columns, toLps(fileName, system.value_or("RAS"))).point(cells, row.line);
    point.position = isDefined ? point.position : std::nullopt;
    point.others.clear();
    point.row = list.points.size() + 1;
    list.points.push_back(std::move(point));
  }
  if (!system && !list.points.empty())
  {
    list.warnings.push_back(fileName + ": the header names no CoordinateSystem: points taken as RAS");
  }
  return list;
}

ListedPoint
controlPoint(const std::string & fileName, const Json & json, const Vector3 & factors, std::size_t number)
{
  ListedPoint point;
  point.row = number;
  point.label = json.value("label", "");
  point.description = json.value("description", "");
  point.name = point.label.empty() ? "point " + std::to_string(number) : point.label;
  if (json.value("positionStatus", "defined") != "defined" || !json.contains("position"))
  {
    return point;
  }
  const auto position = json.at("position").get<std::vector<double>>();
  if (position.size() != 3)
  {
    refuse(fileName, oneLine(point.name, 40) + ": the position has not three numbers", exportAgain);
  }
  point.position = factors.cwiseProduct(Vector3(position[0], position[1], position[2]));
  return point;
}

PointList
readMarkups(const std::string & fileName)
{
  std::string text;
  for (const TextTable::Row & row : readTextLines(fileName, "line").rows)
  {
    text += row.cells.front() + '\n';
  }
  try
  {
    PointList  list;
    const Json document = Json::parse(text);
    for (const Json & markup : document.at("markups"))
    {
      const Vector3 factors = toLps(fileName, markup.value("coordinateSystem", "LPS"));
      if (markup.value("coordinateUnits", "mm") != "mm")
      {
        refuse(fileName, "coordinateUnits are not mm", exportAgain);
      }
      for (const Json & json : markup.at("controlPoints"))
      {
        list.points.push_back(controlPoint(fileName, json, factors, list.points.size() + 1));
      }
    }
    return list;
  }
  catch (const Json::exception & error)
  {
    refuse(fileName, std::string("not Slicer's markups (") + error.what() + ")", exportAgain);
  }
}

void
append(std::vector<std::string> & cells, const std::optional<Vector3> & vector)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    cells.push_back(vector ? numberText((*vector)[axis]) : "");
  }
}

// Lines are exact: points are data of the user that come back, and a label "-" or "+L1" is no formula to be defused.

std::string
tableText(const PointList & list, char separator)
{
  const auto               hasCube = [](const ListedPoint & point) { return point.cube.has_value(); };
  const bool               isCube = std::any_of(list.points.begin(), list.points.end(), hasCube);
  std::vector<std::string> names{ "label", "description" };
  names.insert(names.end(), list.otherColumns.begin(), list.otherColumns.end());
  names.insert(names.end(), { "x", "y", "z" });
  if (isCube)
  {
    names.insert(names.end(), { "c1", "c2", "c3" });
  }
  std::string text = exactLine(names, separator);
  for (const ListedPoint & point : list.points)
  {
    std::vector<std::string> cells{ point.label, point.description };
    cells.insert(cells.end(), point.others.begin(), point.others.end());
    append(cells, point.position);
    if (isCube)
    {
      append(cells, point.cube);
    }
    text += exactLine(cells, separator);
  }
  return text;
}

std::string
fiducialsText(const PointList & list)
{
  std::string text = "# Markups fiducial file version = 4.11\n# CoordinateSystem = LPS\n# columns = ";
  text += std::string(fiducialColumns) + '\n';
  std::size_t number = 0;
  for (const ListedPoint & point : list.points)
  {
    if (point.position)
    {
      std::vector<std::string> cells{ std::to_string(++number) };
      append(cells, point.position);
      const std::vector<std::string> rest{ "0", "0", "0", "1", "1", "1", "0", point.label, point.description, "" };
      cells.insert(cells.end(), rest.begin(), rest.end());
      text += exactLine(cells, ',');
    }
  }
  return text;
}

std::string
markupsText(const PointList & list)
{
  Json points = Json::array();
  for (const ListedPoint & point : list.points)
  {
    Json json{ { "id", std::to_string(points.size() + 1) },
               { "label", point.label },
               { "description", point.description },
               { "positionStatus", point.position ? "defined" : "undefined" } };
    if (point.position)
    {
      json["position"] = { (*point.position)[0], (*point.position)[1], (*point.position)[2] };
    }
    points.push_back(json);
  }
  const Json document{
    { "@schema",
      "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/"
      "markups-schema-v1.0.3.json#" },
    { "markups",
      { { { "type", "Fiducial" },
          { "coordinateSystem", "LPS" },
          { "coordinateUnits", "mm" },
          { "controlPoints", points } } } }
  };
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace

bool
isPointFileName(const std::string & fileName)
{
  return formatOf(fileName) != PointFormat::None;
}

PointList
readPoints(const std::string & fileName)
{
  switch (formatOf(fileName))
  {
    case PointFormat::Fiducials:
      return readFiducials(fileName);
    case PointFormat::Markups:
      return readMarkups(fileName);
    default:
      return readTable(fileName);
  }
}

void
writePoints(const std::string & fileName, const PointList & list)
{
  switch (formatOf(fileName))
  {
    case PointFormat::Fiducials:
      return writeTextFile(fileName, fiducialsText(list));
    case PointFormat::Markups:
      return writeTextFile(fileName, markupsText(list));
    case PointFormat::Commas:
      return writeTextFile(fileName, tableText(list, ','));
    case PointFormat::Tabs:
      return writeTextFile(fileName, tableText(list, '\t'));
    case PointFormat::None:
      break;
  }
  throw BadInput(
    ErrorCode::Usage, fileName, "not the name of a list of points", "give a .fcsv, .mrk.json, .csv or .tsv name");
}

} // namespace moserhex::app
