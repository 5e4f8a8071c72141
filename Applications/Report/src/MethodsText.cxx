#include "MethodsText.h"

#include "HtmlText.h"

#include <algorithm>
#include <map>

namespace moserhex::app
{
namespace
{

const char * const sandhu =
  "Sandhu R, Dominitz A, Gao Y, Tannenbaum A. Volumetric mapping of genus zero objects via mass preservation. "
  "arXiv:1205.1225, 2012.";
const char * const angenent = "Angenent S, Haker S, Tannenbaum A, Kikinis R. On the Laplace-Beltrami operator and "
                              "brain surface flattening. IEEE Trans Med Imaging 18(8):700-711, 1999.";
const char * const moser = "Moser J. On the volume elements on a manifold. Trans Am Math Soc 120(2):286-294, 1965.";
const char * const bertrand = "Bertrand G, Malandain G. A new characterization of three-dimensional simple points. "
                              "Pattern Recognit Lett 15(2):169-175, 1994.";
const char * const johnen = "Johnen A, Remacle J-F, Geuzaine C. Geometrical validity of curvilinear finite elements. "
                            "J Comput Phys 233:359-372, 2013.";
const char * const verdict = "Stimpson CJ, Ernst CD, Knupp P, Pebay PP, Thompson D. The Verdict geometric quality "
                             "library. Sandia National Laboratories, SAND2007-1751, 2007.";

/** Numbers references in the order in which they are cited. */
class Citations
{
public:
  /** "[2]" */
  std::string
  cite(const std::string & reference)
  {
    auto place = std::find(m_References.begin(), m_References.end(), reference);
    if (place == m_References.end())
    {
      m_References.push_back(reference);
      place = m_References.end() - 1;
    }
    return "[" + std::to_string(place - m_References.begin() + 1) + "]";
  }

  [[nodiscard]] const std::vector<std::string> &
  references() const
  {
    return m_References;
  }

private:
  std::vector<std::string> m_References;
};

std::string
labelSentence(const RunReport & report, Citations & citations)
{
  const RunReport::Input & input = report.input;
  std::string              text = "The segmentation (" + std::to_string(input.voxels) + " voxels of " +
                     shortNumber(input.spacing.x()) + " x " + shortNumber(input.spacing.y()) + " x " +
                     shortNumber(input.spacing.z()) + " mm, " + fixedNumber(input.volume / 1000.0, 2) +
                     " mL) was turned into a structured hexahedral mesh with MoserHex " + report.versions.moserhex +
                     ", which implements and extends the mass-preserving volumetric map of Sandhu et al. " +
                     citations.cite(sandhu) + ". ";
  if (!report.conditioning)
  {
    return text;
  }
  const RunReport::Conditioning & conditioning = *report.conditioning;
  text += conditioning.changes.empty()
            ? "The label was a single solid without cavities and handles. "
            : "The label's topology was repaired by the smallest change of volume, in simple points " +
                citations.cite(bertrand) + " (" + std::to_string(conditioning.voxelsAdded) + " voxels added, " +
                std::to_string(conditioning.voxelsRemoved) + " removed, " +
                shortNumber(conditioning.changedPercent, 2) + " %). ";
  return text + "It was smoothed with a Gaussian of " + shortNumber(conditioning.sigma) +
         " mm (Dice coefficient with the label " + fixedNumber(conditioning.dice, 3) + "). ";
}

/** "brought to the label by ..." */
std::string
placementWords(const RunReport::Template & tied)
{
  static const std::map<std::string, std::string> ways{ { "rigid", "brought to the label by a rigid motion" },
                                                        { "affine", "brought to the label by an affine map" },
                                                        { "file", "brought to the label by a transform from a file" },
                                                        { "none", "taken as it lay, in one space with the label," } };
  std::string                                     text = ways.at(tied.alignment);
  if (tied.placed)
  {
    text += " and scaled to its volume (surfaces ";
    if (tied.aligned)
    {
      text += shortNumber(tied.aligned->rmsBefore, 2) + " mm apart before and ";
    }
    text += shortNumber(tied.placed->rms, 2) + (tied.aligned ? " mm after" : " mm apart") + ", root mean square)";
  }
  return text;
}

/** What drew the mesh further. */
std::string
refinementWords(const RunReport::Template & tied)
{
  std::string text;
  if (tied.landmarks)
  {
    text += "Corresponding landmarks drew it from " + shortNumber(tied.landmarks->before, 2) + " to " +
            shortNumber(tied.landmarks->after, 2) + " mm (root mean square). ";
  }
  if (tied.imageDifference)
  {
    text += "Images of both drew it from a difference of " + shortNumber(tied.imageDifference->before, 2) + " to " +
            shortNumber(tied.imageDifference->after, 2) + " standard deviations. ";
  }
  if (tied.growth)
  {
    text += "Cells were free to grow as these show: from " + shortNumber(tied.growth->smallest, 2) + " to " +
            shortNumber(tied.growth->largest, 2) + " times as much as the organ. ";
  }
  return text;
}

std::string
latticeSentence(const RunReport & report, Citations & citations)
{
  const std::string n = std::to_string(2 * report.parameters.shells);
  const bool        isBent = report.templateMesh && report.templateMesh->start != "own";
  if (isBent)
  {
    return "A template mesh of " + n + " x " + n + " x " + n + " nodes was " + placementWords(*report.templateMesh) +
           " and bent to fill it. " + refinementWords(*report.templateMesh);
  }
  const std::string conformal = citations.cite(angenent);
  const std::string equalAreas = citations.cite(moser);
  const std::string own = "Nested shells of the solid were mapped to spheres conformally " + conformal +
                          " and with equal areas " + equalAreas + " and gave the initial lattice of " + n + " x " + n +
                          " x " + n + " nodes. ";
  return report.templateMesh ? own + "Its nodes were then drawn towards those of a template mesh of as many nodes, " +
                                 placementWords(*report.templateMesh) + ". " + refinementWords(*report.templateMesh)
                             : own;
}

std::string
resultSentence(const RunReport & report, Citations & citations)
{
  std::string text = "The mesh has " + std::to_string(report.mesh.nodes) + " nodes and " +
                     std::to_string(report.mesh.cells) + " hexahedra";
  if (report.parameters.padding > 0)
  {
    text += " (" + std::to_string(report.parameters.padding) + " layers of pillow cells among them)";
  }
  text += " and " + fixedNumber(report.mesh.volume / 1000.0, 2) + " mL";
  if (report.surface)
  {
    text += "; its surface is within " + fixedNumber(report.surface->maximum, 2) +
            " mm of the smoothed label's (root mean square " + fixedNumber(report.surface->rms, 2) + " mm)";
  }
  text += ". ";
  if (report.exact && report.exact->reached)
  {
    text += std::string("All cells have the same ") + equalMeasureOf(report).singular + " (variance " +
            shortNumber(report.exact->variance, 2) + ")";
    text += report.exact->certified
              ? ", and their Jacobian determinants are positive everywhere, as their Bernstein coefficients certify " +
                  citations.cite(johnen) + ". "
              : ". ";
  }
  for (auto stage = report.stages.rbegin(); stage != report.stages.rend(); ++stage)
  {
    if (stage->quality)
    {
      return text + "Their scaled Jacobian " + citations.cite(verdict) + " has the median " +
             fixedNumber(stage->quality->scaledJacobianMedian, 2) + " and the minimum " +
             fixedNumber(stage->quality->scaledJacobianMinimum, 2) + ".";
    }
  }
  return text;
}

} // namespace

MethodsText
methodsText(const RunReport & report)
{
  Citations   citations;
  MethodsText text;
  // One after the other: the order of the calls is that of the numbers.
  text.paragraph = labelSentence(report, citations);
  text.paragraph += latticeSentence(report, citations);
  text.paragraph += resultSentence(report, citations);
  text.references = citations.references();
  return text;
}

} // namespace moserhex::app
