#include "AtlasPage.h"

#include "AtlasCellFields.h"
#include "GroupPage.h"
#include "HtmlTable.h"
#include "HtmlText.h"
#include "ImagePicture.h"
#include "MeanLabelmap.h"
#include "PageFrame.h"
#include "Version.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

#include <algorithm>

namespace moserhex::app
{
namespace
{

constexpr Eigen::Index mostModes = 6; ///< columns of the table

constexpr int picturesSide = 96; ///< voxels of the mean image's slices along the longest side of the mean

/** "-2.5 to +3": what the meshes of a mode show, in standard deviations. */
std::string
shownDeviations(const AtlasResult & result, std::size_t mode)
{
  if (2 * mode + 1 >= result.modeMeshes.size())
  {
    return "&ndash;";
  }
  const double down = result.modeMeshes[2 * mode + 1].deviations;
  const double up = result.modeMeshes[2 * mode].deviations;
  return (down == 0.0 ? "none" : "&minus;" + shortNumber(-down)) + " to " +
         (up == 0.0 ? "none" : "+" + shortNumber(up));
}

std::string
modelSection(const AtlasResult & result)
{
  const ShapeModel &                    shape = result.model.shape;
  std::vector<std::vector<std::string>> rows;
  double                                held = 0.0;
  for (Eigen::Index mode = 0; mode < shape.variances.size(); ++mode)
  {
    const auto place = static_cast<std::size_t>(mode);
    held += shape.variances[mode];
    std::vector<std::string> row{ std::to_string(mode + 1),
                                  fixedNumber(100.0 * shape.variances[mode] / shape.totalVariance, 1),
                                  fixedNumber(100.0 * held / shape.totalVariance, 1) };
    const bool               isKnown = place < result.quality.generalisation.size();
    row.push_back(isKnown ? shortNumber(result.quality.generalisation[place]) : "&ndash;");
    row.push_back(isKnown ? shortNumber(result.quality.specificity[place]) : "&ndash;");
    row.push_back(shownDeviations(result, place));
    rows.push_back(row);
  }
  return section("model",
                 "Modes of variation",
                 "<p>The mean has " + fixedNumber(result.mean.volume / 1000.0, 2) + " mL; " +
                   (result.mean.exact ? "all its cells have the same volume and are certified." : "it is NOT exact.") +
                   " Subjects lie " + shortNumber(result.alignment.deviation) +
                   " mm from it (root mean square over the nodes).</p>\n" +
                   tableText("Modes, the first holds most of the variance",
                             { "Mode",
                               "Variance (%)",
                               "Together (%)",
                               "Generalisation (mm)",
                               "Specificity (mm)",
                               "Meshes show (standard deviations)" },
                             rows) +
                   "<p class=\"hint\">A mesh of a mode shows three standard deviations, or fewer where three are no "
                   "possible shape; the file's name says plus3 or minus3 all the same.</p>\n");
}

/** Of each change the largest, of nodes the farthest that one moved. */
std::string
largestChanges(const AtlasTest & test)
{
  std::string text;
  for (const PlaceChange & change : changesOf(test))
  {
    text += (text.empty() ? "" : ", ") + (change.group.empty() ? "" : escapeHtml(change.group) + " ") +
            shortNumber(change.values.colwise().norm().maxCoeff());
  }
  return text + (test.areCells ? "" : " mm") + (test.groups.empty() ? " per unit" : "");
}

std::string
testsSection(const AtlasResult & result)
{
  std::vector<std::vector<std::string>> rows;
  for (const AtlasTest & test : result.tests)
  {
    std::string covariates;
    for (const std::string & covariate : test.covariates)
    {
      covariates += (covariates.empty() ? "" : ", ") + escapeHtml(covariate);
    }
    rows.push_back({ escapeHtml(describe(test)),
                     std::to_string(test.subjects.size()),
                     covariates.empty() ? "none" : covariates,
                     std::to_string(test.result.permutations) + (test.result.areAllOrders ? ", all orders" : ""),
                     shortNumber(test.result.pFamilyWise.minCoeff()),
                     shortNumber(test.result.smallestPossibleP),
                     std::to_string(placesAtLevel(test.result.pFamilyWise)),
                     std::to_string(placesAtLevel(test.result.qFalseDiscovery)),
                     shortNumber(effectSizes(test).cwiseAbs().maxCoeff()),
                     largestChanges(test) });
  }
  if (rows.empty())
  {
    return "";
  }
  return section("tests",
                 "Tests at every place",
                 "<p>Where it is, the picture in three dimensions shows: colour it by family-wise p, effect size or "
                 "change.</p>\n" +
                   tableText("Report the family-wise p",
                             { "Test",
                               "Subjects",
                               "Covariates",
                               "Permutations",
                               "Smallest p, family-wise",
                               "Smallest p that can be",
                               "Nodes or cells at 0.05, family-wise",
                               "Nodes or cells at 0.05, false discovery",
                               "Largest effect size",
                               "Largest change" },
                             rows));
}

std::string
imagesSection(const AtlasResult & result, const AtlasOptions & options)
{
  if (!result.images)
  {
    return "";
  }
  const MeanImage & images = *result.images;
  const HexMesh &   mesh = result.mean.mesh;
  Vector3           low = mesh.nodes.front();
  Vector3           high = mesh.nodes.front();
  for (const Vector3 & node : mesh.nodes)
  {
    low = low.cwiseMin(node);
    high = high.cwiseMax(node);
  }
  const LabelVolume organ = voxelised(mesh, (high - low).maxCoeff() / picturesSide, options.threads);
  const auto        figures = [&](const FieldVolume & cube, const std::string & name, const std::string & id) {
    const FieldVolume      image = imageInMesh(cube, mesh, organ, options.threads);
    const CellField::Range range = rangeInOrgan(image, organ);
    return "<h3>" + name + ", " + shortNumber(range.low) + " (black) to " + shortNumber(range.high) +
           " (white)</h3>\n<div class=\"slices\">" + pictureFigures(image, organ, name, id) + "</div>\n";
  };
  std::string leftOut;
  for (const std::string & name : images.leftOut)
  {
    leftOut += (leftOut.empty() ? " Left out, for the reasons above: " : ", ") + escapeHtml(name);
  }
  return section("images",
                 "Mean image",
                 "<p>Mean of " + std::to_string(images.subjects) + " images (column " + escapeHtml(options.images) +
                   (options.normaliseImages ? ", each made mean 0 and standard deviation 1 in its organ" : "") +
                   "), carried to the cube by each subject's own mesh and shown in the mean organ." + leftOut +
                   (leftOut.empty() ? "" : ".") +
                   (images.mean.components > 1
                      ? " The first of " + std::to_string(images.mean.components) + " numbers of a voxel."
                      : "") +
                   " The inside is where the outline puts it: a blurred mean or a large deviation may be anatomy that "
                   "lies elsewhere.</p>\n" +
                   figures(images.mean, "Mean", "image-mean") +
                   figures(images.deviation, "Standard deviation over the subjects", "image-deviation"));
}

} // namespace

std::string
atlasPage(const AtlasResult & result, const AtlasOptions & options)
{
  const Eigen::Index modes = std::min(mostModes, result.scores.cols());
  GroupContent       content;
  content.heading = "Atlas of " + std::to_string(result.subjects.subjects.size()) + " subjects";
  content.subtitle = "Mean, modes and tests over meshes with one lattice";
  content.caseName = "subject";
  content.version = version;
  content.warnings = result.warnings;
  content.introduction = modelSection(result) + testsSection(result);
  content.conclusion = imagesSection(result, options);
  content.columns = { { "volume", "volume (mL)", true, true },
                      { "size", "size (mm)", false, true },
                      { "distance", "distance to the mean (mm)", true, true } };
  for (Eigen::Index mode = 0; mode < modes; ++mode)
  {
    const std::string number = std::to_string(mode + 1);
    content.columns.push_back({ "mode-" + number, "mode " + number + " (sd)", mode == 0, true });
  }
  for (std::size_t i = 0; i < result.subjects.subjects.size(); ++i)
  {
    PageRow row{ result.subjects.subjects[i].name, "done", "", "", {}, "", result.figures[i].outline };
    row.figures = { result.figures[i].volume / 1000.0, result.figures[i].centroidSize, result.distances[i] };
    for (Eigen::Index mode = 0; mode < modes; ++mode)
    {
      row.figures.push_back(result.scores(static_cast<Eigen::Index>(i), mode));
    }
    content.rows.push_back(row);
  }
  content.mesh = &result.mean.mesh;
  content.fields = atlasCellFields(result);
  return groupPage(content);
}

void
writeAtlasPage(const std::string & fileName, const AtlasResult & result, const AtlasOptions & options)
{
  writeTextFile(fileName, atlasPage(result, options));
}

} // namespace moserhex::app
