#include "SeedParts.h"

namespace moserhex::fuzz
{
namespace
{

constexpr const char * fiducials = "# Markups fiducial file version = 4.11\n# CoordinateSystem = RAS\n"
                                   "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n"
                                   "1,-12.5,3.25,40,0,0,0,1,1,1,0,apex,\"at the, tip\",\n"
                                   "2,1e-3,-7,4.0625,0,0,0,1,1,1,0,base,,vtkMRMLScalarVolumeNode1\n";

constexpr const char * markups = R"({
  "@schema": "https://raw.githubusercontent.com/slicer/slicer/master/markups-schema-v1.0.3.json#",
  "markups": [
    {
      "type": "Fiducial", "coordinateSystem": "LPS", "coordinateUnits": "mm",
      "controlPoints": [
        { "id": "1", "label": "apex", "description": "", "position": [12.5, -3.25, 40.0], "positionStatus": "defined" },
        { "id": "2", "label": "b\u00e4se", "description": "no place yet", "positionStatus": "undefined" }
      ]
    }
  ]
}
)";

constexpr const char * table = "label,x,y,z,c1,c2,c3,grade\n"
                               "core-1,12.5,-3.25,40,0.5,0.25,0.125,3\n"
                               "\"core, \"\"2\"\"\",,,,1,0,0.5,\n"
                               "core-3,-1e2,0,7,,,,4\n";

constexpr const char * tabs = "name\tx\ty\tz\tdescription\n"
                              "apex\t12.5\t-3.25\t40\tat the tip\n"
                              "base\t\t\t\t\n";

} // namespace

void
addPoints(std::vector<Seed> & seeds)
{
  const auto add = [&seeds](const char * format, const char * name, const char * text) {
    seeds.push_back({ SeedUse::Points, format, { name, text }, {} });
  };
  add("fcsv", "points.fcsv", fiducials);
  add("mrk.json", "points.mrk.json", markups);
  add("points-csv", "points.csv", table);
  add("points-tsv", "points.tsv", tabs);
}

} // namespace moserhex::fuzz
