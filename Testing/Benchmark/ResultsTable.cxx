// moserhex_results DATA OUTPUT.md [--growth] [--cases K]
//
// Writes Documentation/Results.md: the exact meshes with an ablation and gmsh's next to them, then the columns of the
// paper's tables 1 and 2 next to ours, for the labelmaps in DATA/dev/Bosma22b (real prostates) and DATA/classic.
// --growth adds a table over N = 10 ... 32, which takes a minute; --cases K takes the first K labelmaps only.
#include "ExactResults.h"
#include "ResultsRun.h"

#include "moserhex/HexMeshIO/AtomicFile.h"

#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

namespace
{

using namespace moserhex;
using namespace moserhex::results;

struct Arguments
{
  std::filesystem::path data;
  std::string           output;
  bool                  growth{ false };
  std::size_t           cases{ std::numeric_limits<std::size_t>::max() };
};

struct PaperRow
{
  double concave, variance, concaveSmoothed, varianceSmoothed, seconds;
};

/** Table 2 of the paper: ten prostates. */
constexpr PaperRow paperProstates[] = { { 6.52, 0.33, 0.89, 0.81, 375 },  { 8.53, 1.27, 1.21, 0.34, 310 },
                                        { 6.62, 1.11, 1.69, 0.32, 297 },  { 10.75, 1.54, 0.54, 0.41, 393 },
                                        { 4.75, 1.28, 0.67, 0.35, 288 },  { 13.52, 1.27, 3.19, 0.55, 284 },
                                        { 18.37, 1.54, 2.26, 0.17, 295 }, { 13.46, 1.52, 1.02, 0.15, 302 },
                                        { 11.52, 0.86, 0.90, 0.16, 301 }, { 14.19, 0.68, 1.24, 0.11, 392 } };

/** Collects columns of numbers and prints their median and worst. */
class Columns
{
public:
  void
  add(const std::string & column, double value)
  {
    m_Values[column].push_back(value);
  }

  [[nodiscard]] double
  median(const std::string & column) const
  {
    return medianOf(m_Values.at(column));
  }

  [[nodiscard]] double
  worst(const std::string & column) const
  {
    return largestOf(m_Values.at(column));
  }

private:
  std::map<std::string, std::vector<double>> m_Values;
};

void
writePaperRows(std::ostream & os)
{
  Columns columns;
  for (const PaperRow & row : paperProstates)
  {
    columns.add("concave", row.concave);
    columns.add("variance", row.variance);
    columns.add("concave smoothed", row.concaveSmoothed);
    columns.add("variance smoothed", row.varianceSmoothed);
    columns.add("seconds", row.seconds);
  }
  for (const bool worst : { false, true })
  {
    const auto value = [&](const char * column) { return worst ? columns.worst(column) : columns.median(column); };
    os << "| *paper, 10 prostates, " << (worst ? "worst" : "median") << "* | | > 10 | " << fixed(value("concave"), 2)
       << " | " << fixed(value("variance"), 2) << " | " << fixed(value("concave smoothed"), 2) << " | "
       << fixed(value("variance smoothed"), 2) << " | " << fixed(value("seconds"), 0) << " | | | |\n";
  }
}

void
writeProstates(std::ostream & os, const std::vector<std::filesystem::path> & files)
{
  os
    << "## Prostates: the paper's table 2\n\n"
       "`--stage moser`, 8000 nodes, 6859 hexahedra (N = 10). \"Initial\" is the variance after the shells are "
       "joined,\n"
       "before any smoothing or flow. The paper's times are MATLAB on a 2.66 GHz dual core.\n\n"
       "| case | mL | initial vol. var. | % concave | vol. var. | % concave (w/ smooth) | vol. var. (w/ smooth) | time "
       "(s) | SJ min | SJ median | boundary max (mm) |\n"
       "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  Columns                                    columns;
  std::map<std::string, std::vector<double>> seconds;
  std::vector<std::string>                   order;
  Columns                                    shells;
  for (const auto & file : files)
  {
    std::cerr << caseName(file) << std::endl;
    const LabelImage image = readLabelImage(file.string());
    const Run        smooth = runPipeline(image, {});
    RunOptions       plainOptions;
    plainOptions.smoothing = false;
    const Run  plain = runPipeline(image, plainOptions);
    RunOptions snapshotOptions = plainOptions;
    snapshotOptions.method = Pipeline::ShellMethod::Snapshots;
    const Run  snapshots = runPipeline(image, snapshotOptions);
    RunOptions eikonalOptions;
    eikonalOptions.method = Pipeline::ShellMethod::Eikonal;
    const Run eikonal = runPipeline(image, eikonalOptions);

    const HexQualitySummary &  initial = qualityAfter(smooth, "initial map");
    const HexQualitySummary &  raw = qualityAfter(plain, "moser flow");
    const HexQualitySummary &  final = qualityAfter(smooth, "moser flow");
    const SolidMeshingResult & result = smooth.pipeline->GetResult();
    const double               millilitres = smooth.pipeline->GetLabelVolume() / 1000.0;
    os << "| " << caseName(file) << " | " << fixed(millilitres, 1) << " | " << significant(initial.volumeVariance)
       << " | " << fixed(raw.concavePercent, 2) << " | " << significant(raw.volumeVariance) << " | "
       << fixed(final.concavePercent, 2) << " | " << significant(final.volumeVariance) << " | "
       << fixed(smooth.seconds, 1) << " | " << fixed(final.scaledJacobian.minimum, 2) << " | "
       << fixed(final.scaledJacobian.median, 2) << " | " << fixed(result.boundary.maximum, 2) << " |\n";

    columns.add("initial", initial.volumeVariance);
    columns.add("concave", raw.concavePercent);
    columns.add("variance", raw.volumeVariance);
    columns.add("concave smoothed", final.concavePercent);
    columns.add("variance smoothed", final.volumeVariance);
    columns.add("seconds", smooth.seconds);
    columns.add("boundary", result.boundary.maximum);
    columns.add("snapshot initial", qualityAfter(snapshots, "initial map").volumeVariance);
    columns.add("snapshot concave", qualityAfter(snapshots, "moser flow").concavePercent);
    columns.add("snapshot variance", qualityAfter(snapshots, "moser flow").volumeVariance);
    columns.add("eikonal initial", qualityAfter(eikonal, "initial map").volumeVariance);
    columns.add("eikonal concave", qualityAfter(eikonal, "moser flow").concavePercent);
    columns.add("eikonal variance", qualityAfter(eikonal, "moser flow").volumeVariance);
    shells.add("volume error", 100.0 * result.shells.worstVolumeError);
    shells.add("gap", -result.shells.smallestRelativeGap());
    shells.add("angle", -result.shells.minimumAngle);
    for (const AreaPreservingMapResult & map : result.sphereMaps)
    {
      shells.add("flips", map.quality.flippedTriangles);
      shells.add("rms", map.quality.areaRatioRms);
      shells.add("solid angle", std::abs(map.quality.solidAngleSum - 12.566370614359172));
    }
    for (const MeshingStageReport & stage : smooth.pipeline->GetStages())
    {
      if (seconds.find(stage.name) == seconds.end())
      {
        order.push_back(stage.name);
      }
      seconds[stage.name].push_back(stage.seconds);
    }
  }
  for (const bool worst : { false, true })
  {
    const auto value = [&](const char * column) { return worst ? columns.worst(column) : columns.median(column); };
    os << "| **" << (worst ? "worst" : "median") << "** | | " << significant(value("initial")) << " | "
       << fixed(value("concave"), 2) << " | " << significant(value("variance")) << " | "
       << fixed(value("concave smoothed"), 2) << " | " << significant(value("variance smoothed")) << " | "
       << fixed(value("seconds"), 1) << " | | | " << fixed(value("boundary"), 2) << " |\n";
  }
  writePaperRows(os);

  os << "\n## How the shells are made\n\n"
        "| shells | initial vol. var., median / worst | % concave, median / worst | vol. var., median / worst |\n"
        "| --- | --- | --- | --- |\n";
  const auto row = [&](const std::string & name, const std::string & a, const std::string & b, const std::string & c) {
    os << "| " << name << " | " << significant(columns.median(a)) << " / " << significant(columns.worst(a)) << " | "
       << fixed(columns.median(b), 2) << " / " << fixed(columns.worst(b), 2) << " | " << significant(columns.median(c))
       << " / " << significant(columns.worst(c)) << " |\n";
  };
  row("coupled Chan-Vese, smoothed", "initial", "concave smoothed", "variance smoothed");
  row("coupled Chan-Vese, no smoothing", "initial", "concave", "variance");
  row("eikonal, smoothed", "eikonal initial", "eikonal concave", "eikonal variance");
  row(
    "uncoupled snapshots (the paper's way), no smoothing", "snapshot initial", "snapshot concave", "snapshot variance");

  os << "\n## Shells and sphere maps of these prostates\n\n"
        "| measure | worst |\n| --- | --- |\n"
     << "| shell volume error | " << significant(shells.worst("volume error")) << " % |\n"
     << "| smallest gap between shells / mean gap | " << fixed(-shells.worst("gap"), 2) << " |\n"
     << "| smallest angle of a triangle | " << fixed(-shells.worst("angle"), 1) << " degrees |\n"
     << "| flipped triangles on the sphere | " << fixed(shells.worst("flips"), 0) << " |\n"
     << "| area ratio rms per triangle | " << significant(shells.worst("rms")) << " |\n"
     << "| solid angles, difference from 4 pi | " << significant(shells.worst("solid angle")) << " |\n";

  os << "\n## Seconds per stage\n\n| stage | median | worst |\n| --- | --- | --- |\n";
  for (const std::string & stage : order)
  {
    os << "| " << stage << " | " << fixed(medianOf(seconds[stage]), 2) << " | " << fixed(largestOf(seconds[stage]), 2)
       << " |\n";
  }
}

struct Model
{
  const char * paperName;
  const char * file;
  int          shells;
  const char * paperVariance;
  const char * paperConcave;
};
constexpr Model models[] = { { "Max-Planck 1", "maxplanck_choi", 6, "0.25", "14.9" },
                             { "Max-Planck 2", "maxplanck_choi", 7, "0.22", "11.6" },
                             { "squirrel", "squirrel_vhacd", 8, "0.24", "11.1" },
                             { "tooth", "tooth_tora", 6, "0.18", "16.4" },
                             { "brain", "brain_choi", 7, "0.13", "7.20" },
                             { "(Buddha)", "buddha_choi", 10, "", "" },
                             { "(hippocampus)", "hippocampus_choi", 10, "", "" } };

std::filesystem::path
fileOf(const Model & model, const std::filesystem::path & folder)
{
  return folder / (std::string(model.file) + ".nii.gz");
}

std::vector<ExactCase>
classicCases(const std::filesystem::path & folder, std::size_t atMost)
{
  std::vector<ExactCase> cases;
  for (const Model & model : models)
  {
    if (cases.size() < atMost)
    {
      cases.push_back({ model.paperName, fileOf(model, folder), model.shells });
    }
  }
  return cases;
}

std::vector<ExactCase>
prostateCases(const std::vector<std::filesystem::path> & files)
{
  std::vector<ExactCase> cases;
  for (const auto & file : files)
  {
    cases.push_back({ caseName(file), file, 10 });
  }
  return cases;
}

void
writeExactHeading(std::ostream & os)
{
  os << "## Exact meshes: the default\n\n"
        "`--stage exact --way fast`, 8000 nodes, 6859 hexahedra (N = 10). Certified: det J > 0 in the whole cell, by\n"
        "Bezier coefficients. Volume error: mesh against voxels. Boundary: nodes and face centres to the conditioned\n"
        "surface. Times with reading and writing.\n\n";
}

void
writeClassics(std::ostream & os, const std::filesystem::path & folder)
{
  os << "\n## Classic shapes: the paper's table 1\n\n"
        "Models of the same name, voxelised; not the paper's own files. Models in brackets are not in its table.\n\n"
        "| model | nodes | hexahedra | vol. var., paper | vol. var. | % concave, paper | % concave | SJ median | note "
        "|\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const Model & model : models)
  {
    std::cerr << model.file << std::endl;
    const int n = 2 * model.shells;
    os << "| " << model.paperName << " | " << n * n * n << " | " << (n - 1) * (n - 1) * (n - 1) << " | "
       << model.paperVariance << " | ";
    try
    {
      RunOptions options;
      options.shells = model.shells;
      const Run                 run = runPipeline(readLabelImage(fileOf(model, folder).string()), options);
      const HexQualitySummary & final = qualityAfter(run, "moser flow");
      os << significant(final.volumeVariance) << " | " << model.paperConcave << " | " << fixed(final.concavePercent, 2)
         << " | " << fixed(final.scaledJacobian.median, 2) << " | |\n";
    }
    catch (const itk::ExceptionObject & error)
    {
      os << "- | " << model.paperConcave << " | - | - | refused: " << error.GetDescription() << " |\n";
    }
    catch (const Error & error)
    {
      os << "- | " << model.paperConcave << " | - | - | refused: " << error.what() << " |\n";
    }
  }
}

Arguments
parse(int argc, char ** argv)
{
  Arguments                arguments;
  std::vector<std::string> names;
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if (word == "--growth")
    {
      arguments.growth = true;
    }
    else if (word == "--cases" && i + 1 < argc)
    {
      arguments.cases = std::stoul(argv[++i]);
    }
    else
    {
      names.push_back(word);
    }
  }
  if (names.size() != 2 || arguments.cases == 0)
  {
    throw std::invalid_argument("usage: moserhex_results DATA OUTPUT.md [--growth] [--cases K]");
  }
  arguments.data = names[0];
  arguments.output = names[1];
  return arguments;
}

void
writeResults(const Arguments & arguments)
{
  const auto prostates = imagesIn(arguments.data / "dev" / "Bosma22b", arguments.cases);
  if (prostates.empty())
  {
    throw std::runtime_error("no labelmap in " + (arguments.data / "dev" / "Bosma22b").string());
  }
  std::ostringstream text;
  text
    << "# Results\n\n"
       "Written by `moserhex_results DATA Documentation/Results.md --growth` (preset `bench`); do not edit by hand.\n"
       "Data: PI-CAI prostate segmentations (CC BY-NC 4.0, Saha et al., Lancet Oncol 2024) and classic shapes;\n"
       "neither is part of this repository. Volume variance, % concave and scaled Jacobian (SJ) as defined in\n"
       "`Modules/Core/Quality/README.md`. The optimiser behind the exact meshes, next to others: "
       "[Optimisers.md](Optimisers.md).\n"
       "Settings were chosen while looking at these fifteen prostates.\n\n";
  std::ostringstream growth;
  if (arguments.growth) // the first to run, as its memory is the process's peak
  {
    writeGrowth(growth, prostates[prostates.size() / 2]);
  }
  const std::vector<ExactCase>                              cases = prostateCases(prostates);
  const std::filesystem::path                               classics = arguments.data / "classic";
  const std::vector<std::function<void(std::ostream & os)>> parts{
    writeExactHeading,
    [&](std::ostream & os) { writeExact(os, cases); },
    [&](std::ostream & os) { writeAblation(os, cases); },
    [&](std::ostream & os) { writeGmsh(os, cases); },
    [&](std::ostream & os) {
      os << "\n### Exact meshes of the classic shapes\n\nShells as in the paper's table 1, below.\n\n";
      writeExact(os, classicCases(classics, arguments.cases));
    },
    [&](std::ostream & os) { os << growth.str() << '\n'; },
    [&](std::ostream & os) { writeProstates(os, prostates); },
    [&](std::ostream & os) { writeClassics(os, classics); },
  };
  for (const auto & part : parts) // a run that is interrupted leaves the parts that are done
  {
    part(text);
    writeTextFile(arguments.output, text.str());
  }
}

} // namespace

int
main(int argc, char ** argv)
{
  try
  {
    writeResults(parse(argc, argv));
  }
  catch (const std::invalid_argument & error)
  {
    std::cerr << error.what() << '\n';
    return 2;
  }
  catch (const std::exception & error)
  {
    std::cerr << "moserhex_results: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
