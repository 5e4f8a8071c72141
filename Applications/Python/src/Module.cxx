// The compiled part of the package moserhex: arrays in, one call of the library, arrays out.
#include "ArgumentNames.h"
#include "Arguments.h"
#include "ArrayOutput.h"
#include "Interruption.h"
#include "MeshFile.h"
#include "MeshRecord.h"
#include "MeshReport.h"
#include "PythonComparison.h"
#include "PythonErrors.h"
#include "PythonMesh.h"
#include "PythonStatistics.h"
#include "PythonTransfer.h"
#include "ScaledJacobians.h"
#include "TemplateArguments.h"
#include "Version.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/LevelSet/AgreementDensity.h"

#include <pybind11/stl.h>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace
{

namespace py = pybind11;
using namespace moserhex;
using namespace moserhex::python;

/** What messages and reports call an image of the density and a template that have no file. */
constexpr const char * densityName = "density";
constexpr const char * templateName = "template";

std::optional<LabelValue>
labelFrom(const std::optional<long long> & label)
{
  if (!label)
  {
    return std::nullopt;
  }
  if (*label < 0 || *label > std::numeric_limits<LabelValue>::max())
  {
    throw InvalidInput(ErrorCode::Labels, "label: " + std::to_string(*label) + ", need 1 to 2^31-1");
  }
  return static_cast<LabelValue>(*label);
}

std::unique_ptr<PythonMesh>
meshSolidOf(LabelImage                         image,
            const std::optional<LabelValue> &  label,
            const std::optional<ScalarImage> & density,
            const app::MeshCommandOptions &    options,
            const PythonMesh *                 templateMesh,
            TemplateRefinement                 refinement,
            Space                              space,
            Interruption &                     interruption)
{
  const Stopwatch        stopwatch;
  const app::ChosenSolid solid = app::chooseSolid(std::move(image), label);
  RunReport              report = app::startReport(options);
  app::addSolid(solid, report);
  if (density)
  {
    report.density.emplace().file = density->fileName;
    report.warnings.insert(report.warnings.end(), density->warnings.begin(), density->warnings.end());
  }
  const auto          goOn = [&](double fraction) { return interruption.goOn(fraction); };
  app::PipelineInputs inputs;
  inputs.density = density ? density->image.GetPointer() : nullptr;
  if (templateMesh != nullptr)
  {
    inputs.tied = app::tiedTo(templateMesh->lattice(), options);
    const auto ofCells = app::templateCellWarnings(app::cellRecordOf("", templateMesh->record()), options);
    report.warnings.insert(report.warnings.end(), ofCells.begin(), ofCells.end());
    if (const auto turn = app::turnOfLattice("", templateMesh->record()))
    {
      inputs.tied->latticeTurn = turn->rotation;
    }
    inputs.tied->refinement = std::move(refinement);
  }
  const auto pipeline = app::runPipeline(solid, inputs, options, goOn);
  app::addResults(*pipeline, inputs, report);
  const HexMesh & mesh = pipeline->GetHexMesh();
  HexMeshFields   fields = app::fieldsOf(mesh, solid, options.threads);
  fields.meshArrays = app::recordOf(report);
  report.warnings = withArguments(std::move(report.warnings));
  report.seconds = stopwatch.seconds();
  return std::make_unique<PythonMesh>(mesh, std::move(fields), space, report.warnings, toJson(report));
}

std::unique_ptr<PythonMesh>
makeMesh(const py::object &               labels,
         const py::object &               affine,
         const std::optional<long long> & label,
         const std::string &              space,
         int                              shells,
         int                              padding,
         const std::string &              stage,
         const std::string &              way,
         const std::string &              frame,
         const std::string &              shellMethod,
         const std::string &              topology,
         double                           maximumRepair,
         const py::object &               density,
         const py::object &               densityAffine,
         const PythonMesh *               templateMesh,
         const std::string &              align,
         const py::object &               landmarks,
         const py::object &               templateLandmarks,
         const py::object &               image,
         const py::object &               imageAffine,
         const py::object &               templateImage,
         const py::object &               templateImageAffine,
         bool                             localGrowth,
         long long                        threads,
         bool                             allowPartial,
         const py::object &               progress)
{
  app::MeshCommandOptions options;
  options.input.file = "labels";
  options.shells = shells;
  options.padding = padding;
  options.stage = stage;
  options.way = way;
  options.frame = frame;
  options.shellMethod = shellMethod;
  options.topology = topology;
  options.maximumRepairPercent = maximumRepair;
  options.density = density.is_none() ? "" : densityName;
  options.templateMesh = templateMesh == nullptr ? "" : templateName;
  options.align = align;
  options.threads = threadsFrom(threads);
  options.threads = options.threads == 0 ? defaultThreadCount() : options.threads;
  options.allowPartial = allowPartial;
  if (way == "fast" && (stage != "exact" || templateMesh != nullptr))
  {
    options.way.reset(); // the default, which counts for exact meshes without a template only
  }
  app::requireUsable(options);
  app::requireUsed(options);

  const Space                     ownSpace = spaceOf(space);
  const std::optional<LabelValue> chosen = labelFrom(label);
  LabelImage                      labelImage = labelsFrom(labels, affine, ownSpace);
  std::optional<ScalarImage>      densityImage;
  if (!density.is_none())
  {
    densityImage = scalarsFrom(densityName, density, densityAffine, ownSpace);
  }
  const TemplateArguments tie{ landmarks,     templateLandmarks,   image,      imageAffine,
                               templateImage, templateImageAffine, localGrowth };
  TemplateRefinement      refinement = refinementFrom(tie, templateMesh, ownSpace);
  Interruption            interruption(progress);
  try
  {
    const py::gil_scoped_release release;
    return meshSolidOf(std::move(labelImage),
                       chosen,
                       densityImage,
                       options,
                       templateMesh,
                       std::move(refinement),
                       ownSpace,
                       interruption);
  }
  catch (const Cancelled &)
  {
    interruption.rethrow();
    throw;
  }
}

std::unique_ptr<PythonMesh>
readMesh(const std::string & fileName, const std::string & space, bool sandbox)
{
  const Space                  ownSpace = spaceOf(space);
  const py::gil_scoped_release release;
  const HexCellFile            file = readHexCells(fileName, { sandbox });
  HexMesh                      mesh = latticeOf(file.mesh, fileName);
  HexMeshFields                fields;
  fields.scaledJacobian = app::scaledJacobiansOf(mesh);
  fields.meshArrays = app::recordOf(fileName, file.meshArrays);
  return std::make_unique<PythonMesh>(std::move(mesh), std::move(fields), ownSpace, file.warnings, "");
}

/** Labels, affine, warnings. */
py::tuple
readLabels(const std::string &                fileName,
           const std::string &                space,
           const std::optional<double> &      threshold,
           const std::optional<std::string> & segment,
           bool                               sandbox)
{
  const Space ownSpace = spaceOf(space);
  LabelImage  image;
  {
    const py::gil_scoped_release release;
    image = readLabelImage(fileName, { threshold, segment, sandbox });
  }
  return py::make_tuple(arrayOf(*image.image), affineOf(*image.image, ownSpace), image.warnings);
}

/** \param labelmaps  pairs of labels and affine; all that is not 0 is the organ \return density, affine */
py::tuple
agreementOf(const std::vector<std::pair<py::object, py::object>> & labelmaps,
            const std::string &                                    space,
            double                                                 disputed,
            double                                                 smoothing)
{
  const Space              ownSpace = spaceOf(space);
  std::vector<LabelVolume> labels;
  for (const auto & [values, affine] : labelmaps)
  {
    labels.push_back(labelVolumeOfAll(*labelsFrom(values, affine, ownSpace).image));
  }
  AgreementDensity agreement;
  {
    const py::gil_scoped_release release;
    agreement = agreementDensity(labels, { disputed, smoothing });
  }
  return py::make_tuple(arrayOf(agreement.density), affineOf(agreement.density, ownSpace));
}

} // namespace

PYBIND11_MODULE(_moserhex, module)
{
  addError(module);
  module.attr("__version__") = app::version;
  py::class_<PythonMesh>(module, "Mesh")
    .def_property_readonly("nodes_per_side", &PythonMesh::nodesPerSide)
    .def_property_readonly("padding_layers", &PythonMesh::paddingLayers)
    .def_property_readonly("space", [](const PythonMesh & self) { return self.space() == Space::RAS ? "RAS" : "LPS"; })
    .def_property_readonly("warnings", &PythonMesh::warnings)
    .def_property_readonly("report", &PythonMesh::report)
    .def("points", &PythonMesh::points)
    .def("cells", &PythonMesh::cells)
    .def("quality", [](const PythonMesh & self, long long threads) { return self.quality(threadsFrom(threads)); })
    .def("cube_coordinates",
         [](const PythonMesh & self, const py::object & points, long long threads) {
           return self.cubeCoordinates(points, threadsFrom(threads));
         })
    .def("positions", &PythonMesh::positions)
    .def("write", &PythonMesh::write);
  module.def("mesh", &makeMesh);
  module.def("read", &readMesh);
  module.def("read_labels", &readLabels);
  module.def("agreement", &agreementOf);
  addTransfer(module);
  addComparison(module);
  addShapeStatistics(module);
}
