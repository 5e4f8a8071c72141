#include "ShapeSample.h"

#include <algorithm>
#include <functional>
#include <iostream>

namespace moserhex::correspondence
{
namespace
{
using results::fixed;

/** A number for each number of modes, with its standard error where there is one. */
struct Measure
{
  const char *                                               title;
  std::function<double(const Correspondence &, std::size_t)> value; ///< by the row's number, from 0
  std::function<double(const Correspondence &, std::size_t)> error; ///< empty: none
};

/** Of the measures by points, which are known for every number of modes. */
double
inRow(const std::vector<double> & values, const std::vector<std::size_t> & rows, std::size_t row)
{
  return values.at(rows[row] - 1);
}

std::vector<Measure>
measuresFor(const std::vector<std::size_t> & rows)
{
  using C = Correspondence;
  const auto ofPoints = [rows](const std::vector<double> ModelQuality::*values) {
    return [rows, values](const C & c, std::size_t row) { return inRow(c.points.*values, rows, row); };
  };
  const auto ofSurfaces = [](const std::vector<double> SurfaceModelQuality::*values) {
    return [values](const C & c, std::size_t row) { return (c.surfaces.*values).at(row); };
  };
  return {
    { "Compactness: part of the variance", ofPoints(&ModelQuality::compactness), {} },
    { "Generalisation by points (mm)",
      ofPoints(&ModelQuality::generalisation),
      ofPoints(&ModelQuality::generalisationError) },
    { "Specificity by points (mm)", ofPoints(&ModelQuality::specificity), ofPoints(&ModelQuality::specificityError) },
    { "Generalisation by surfaces (mm)",
      ofSurfaces(&SurfaceModelQuality::generalisation),
      ofSurfaces(&SurfaceModelQuality::generalisationError) },
    { "Specificity by surfaces (mm)",
      ofSurfaces(&SurfaceModelQuality::specificity),
      ofSurfaces(&SurfaceModelQuality::specificityError) }
  };
}

void
writeHeading(std::ostream & os, const std::string & first, const std::vector<Correspondence> & all)
{
  os << "| " << first << " |";
  for (const Correspondence & one : all)
  {
    os << ' ' << one.name << " |";
  }
  os << "\n|";
  for (std::size_t column = 0; column <= all.size(); ++column)
  {
    os << " --- |";
  }
  os << '\n';
}

/** The rows for which all have modes: subjects that are the same shape have fewer. */
std::vector<std::size_t>
commonRows(std::vector<std::size_t> rows, const std::vector<Correspondence> & all)
{
  for (const Correspondence & one : all)
  {
    const std::size_t modes = one.points.compactness.size();
    rows.erase(std::upper_bound(rows.begin(), rows.end(), modes), rows.end());
  }
  return rows;
}

void
writeMeasure(std::ostream &                      os,
             const Measure &                     measure,
             const std::vector<std::size_t> &    rows,
             const std::vector<Correspondence> & all)
{
  os << '\n' << measure.title << ":\n\n";
  writeHeading(os, "modes", all);
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    os << "| " << rows[row] << " |";
    for (const Correspondence & one : all)
    {
      os << ' ' << fixed(measure.value(one, row), 3);
      if (measure.error)
      {
        os << " &plusmn; " << fixed(measure.error(one, row), 3);
      }
      os << " |";
    }
    os << '\n';
  }
}

void
writeMissed(std::ostream & os, const std::vector<Correspondence> & all)
{
  os << "\nSurface that the points miss: 95 % of the label's surface are nearer to what they span (mm):\n\n";
  writeHeading(os, "subjects", all);
  for (const bool worst : { false, true })
  {
    os << (worst ? "| worst |" : "| median |");
    for (const Correspondence & one : all)
    {
      os << ' ' << fixed(worst ? results::largestOf(one.missed) : results::medianOf(one.missed), 2) << " |";
    }
    os << '\n';
  }
}

/** In how many rows each way is better, that is smaller, than the last one, the baseline. */
void
writeVerdict(std::ostream &                      os,
             const std::vector<Measure> &        measures,
             const std::vector<std::size_t> &    rows,
             const std::vector<Correspondence> & all)
{
  os << "\nRows of " << rows.size() << " in which a way is better than *" << all.back().name << "*:\n\n";
  writeHeading(os, "measure", { all.begin(), all.end() - 1 });
  for (const Measure & measure : measures)
  {
    if (measure.error) // compactness has none: it is no distance, and large is good
    {
      os << "| " << measure.title << " |";
      for (std::size_t way = 0; way + 1 < all.size(); ++way)
      {
        std::size_t better = 0;
        for (std::size_t row = 0; row < rows.size(); ++row)
        {
          better += measure.value(all[way], row) < measure.value(all.back(), row) ? 1 : 0;
        }
        os << ' ' << better << " |";
      }
      os << '\n';
    }
  }
}

void
writeSample(std::ostream &                   os,
            const std::string &              title,
            const Sample &                   sample,
            const std::vector<std::string> & remarks)
{
  std::vector<double> volumes;
  for (const Subject & subject : sample.subjects)
  {
    volumes.push_back(subject.volume);
  }
  const auto [smallest, largest] = std::minmax_element(volumes.begin(), volumes.end());
  os << "### " << title << "\n\n"
     << sample.subjects.size() << " subjects of " << fixed(*smallest, 1) << " to " << fixed(*largest, 1)
     << " mL, median " << fixed(results::medianOf(volumes), 1) << " mL; medoid " << sample.subjects[sample.medoid].name
     << ".\n";
  for (const std::string & remark : remarks)
  {
    os << "\n* " << remark;
  }
  os << (remarks.empty() ? "" : "\n");
}

constexpr std::size_t modesOfShapes = 5;

/** Own; rigid ties to the medoid; to the mean of what came of these; and to each subject's shape in a model of these.
 */
std::vector<Way>
waysOfModels()
{
  std::vector<Way> ways{
    { "own", false, {} }, { "tied", true, {} }, { "to the mean", true, {} }, { "to its shape", true, {} }
  };
  for (Way & way : ways)
  {
    way.options.templateAlignment = TemplateAlignment::Rigid;
  }
  return ways;
}

} // namespace

void
writeModels(std::ostream & os, const Arguments & arguments)
{
  const std::vector<Way> ways = waysOfModels();
  for (const auto & folder : arguments.folders)
  {
    Sample sample = meshSample(filesOfSubjects(folder, arguments), { ways[0], ways[1] }, arguments);
    tieToMean(ways[2], arguments.alignment, sample);
    tieToModel(ways[3], arguments.alignment, modesOfShapes, sample);
    std::vector<Correspondence> all;
    for (std::size_t way = 0; way < ways.size(); ++way)
    {
      all.push_back(correspondenceBy(sample, ways, way, arguments.alignment));
    }
    all.push_back(simpleBaseline(sample, arguments.alignment));
    std::vector<std::string> remarks = sample.remarks;
    remarks.insert(remarks.end(), all.back().remarks.begin(), all.back().remarks.end());
    writeSample(os, (folder.parent_path().filename() / folder.filename()).string(), sample, remarks);
    const std::vector<std::size_t> rows = commonRows(rowsOfModes(sample.subjects.size()), all);
    const std::vector<Measure>     measures = measuresFor(rows);
    for (const Measure & measure : measures)
    {
      writeMeasure(os, measure, rows, all);
    }
    writeMissed(os, all);
    writeVerdict(os, measures, rows, all);
    os << std::endl;
  }
}

} // namespace moserhex::correspondence
