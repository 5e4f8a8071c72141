#include "ShapeSample.h"

#include <algorithm>
#include <iostream>

namespace moserhex::correspondence
{
namespace
{
using results::fixed;

/** Numbers of modes with a row of their own. */
constexpr std::size_t rowsOfModes[] = { 1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 25, 30, 40, 50 };

/** Of the model's measures. */
struct Measure
{
  const char *              title;
  const std::vector<double> ModelQuality::*value;
  const std::vector<double> ModelQuality::*error; ///< null: there is none
  int                                      digits;
};

constexpr Measure measures[] = {
  { "Compactness: part of the variance", &ModelQuality::compactness, nullptr, 3 },
  { "Generalisation (mm)", &ModelQuality::generalisation, &ModelQuality::generalisationError, 3 },
  { "Specificity (mm)", &ModelQuality::specificity, &ModelQuality::specificityError, 3 },
};

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

/** All correspondences have as many modes as the one with the fewest. */
std::size_t
commonModes(const std::vector<Correspondence> & all)
{
  std::size_t modes = all.front().quality.compactness.size();
  for (const Correspondence & one : all)
  {
    modes = std::min(modes, one.quality.compactness.size());
  }
  return modes;
}

void
writeMeasure(std::ostream & os, const Measure & measure, const std::vector<Correspondence> & all)
{
  os << '\n' << measure.title << ":\n\n";
  writeHeading(os, "modes", all);
  for (const std::size_t modes : rowsOfModes)
  {
    if (modes > commonModes(all))
    {
      break;
    }
    os << "| " << modes << " |";
    for (const Correspondence & one : all)
    {
      os << ' ' << fixed((one.quality.*measure.value)[modes - 1], measure.digits);
      if (measure.error != nullptr)
      {
        os << " &plusmn; " << fixed((one.quality.*measure.error)[modes - 1], measure.digits);
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

/** At how many numbers of modes each way is better than the last one, the baseline. */
void
writeVerdict(std::ostream & os, const std::vector<Correspondence> & all)
{
  const std::size_t    modes = commonModes(all);
  const ModelQuality & baseline = all.back().quality;
  for (std::size_t way = 0; way + 1 < all.size(); ++way)
  {
    const ModelQuality & quality = all[way].quality;
    std::size_t          generalisation = 0;
    std::size_t          specificity = 0;
    for (std::size_t m = 0; m < modes; ++m)
    {
      generalisation += quality.generalisation[m] < baseline.generalisation[m] ? 1 : 0;
      specificity += quality.specificity[m] < baseline.specificity[m] ? 1 : 0;
    }
    os << "\n*" << all[way].name << "* is better than *" << all.back().name << "* in generalisation with "
       << generalisation << " of " << modes << " numbers of modes, in specificity with " << specificity << ".\n";
  }
}

void
writeSample(std::ostream & os, const std::string & title, const Sample & sample)
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
  for (const std::string & remark : sample.remarks)
  {
    os << "\n* " << remark;
  }
  os << (sample.remarks.empty() ? "" : "\n");
}

} // namespace

void
writeModels(std::ostream & os, const Arguments & arguments)
{
  std::vector<Way> ways = waysToCorrespond();
  ways.erase(std::remove_if(ways.begin(), ways.end(), [](const Way & way) { return way.oneFrame; }), ways.end());
  for (const auto & folder : arguments.folders)
  {
    const Sample                sample = meshSample(filesOfSubjects(folder, arguments), ways, arguments);
    std::vector<Correspondence> all;
    for (std::size_t way = 0; way < ways.size(); ++way)
    {
      all.push_back(correspondenceBy(sample, ways, way, arguments.alignment));
    }
    all.push_back(simpleBaseline(sample, arguments.alignment));
    writeSample(os, (folder.parent_path().filename() / folder.filename()).string(), sample);
    for (const Measure & measure : measures)
    {
      writeMeasure(os, measure, all);
    }
    writeMissed(os, all);
    writeVerdict(os, all);
    os << std::endl;
  }
}

} // namespace moserhex::correspondence
