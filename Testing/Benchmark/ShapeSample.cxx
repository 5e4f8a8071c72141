#include "ShapeSample.h"

#include "moserhex/Correspondence/NearestPointCorrespondence.h"
#include "moserhex/Correspondence/SurfaceDistance.h"
#include "moserhex/Deformation/LatticeAlignment.h"
#include "moserhex/Deformation/SurfaceMotion.h"
#include "moserhex/Geometry/ClosestPoint.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/Geometry/SurfaceRemeshing.h"
#include "moserhex/LevelSet/MarchingTetrahedra.h"
#include "moserhex/ShapeStatistics/EqualVolumeShape.h"
#include "moserhex/ShapeStatistics/Procrustes.h"
#include "moserhex/ShapeStatistics/ShapeModel.h"

#include <algorithm>
#include <iostream>
#include <regex>
#include <set>
#include <stdexcept>

namespace moserhex::correspondence
{
namespace
{

constexpr double edgeOfSurface = 1.0; ///< of the triangles of a label's surface [mm]

/** A lattice whose boundary nodes are these. */
HexMesh
withBoundaryPoints(HexMesh mesh, const Positions & points)
{
  const std::vector<std::size_t> nodes = boundaryNodes(mesh);
  for (std::size_t b = 0; b < nodes.size(); ++b)
  {
    mesh.nodes[nodes[b]] = points[b];
  }
  return mesh;
}

std::vector<HexMesh>
meshesBy(const Sample & sample, std::size_t way)
{
  std::vector<HexMesh> meshes;
  for (const Subject & subject : sample.subjects)
  {
    meshes.push_back(subject.meshes[way]);
  }
  return meshes;
}

/** Generalised Procrustes alignment of the boundary nodes. */
std::vector<SimilarityTransform>
alignmentOf(const std::vector<HexMesh> & meshes, AlignmentKind kind)
{
  std::vector<Positions> points;
  points.reserve(meshes.size());
  std::transform(meshes.begin(), meshes.end(), std::back_inserter(points), boundaryPoints);
  ProcrustesOptions options;
  options.kind = kind;
  const ProcrustesResult result = generalisedProcrustes(
    points.size(), [&](std::size_t subject) { return points[subject]; }, options);
  if (!result.report.converged)
  {
    throw std::runtime_error("Procrustes: " + result.report.note);
  }
  return result.transforms;
}

/** A row a subject. */
Eigen::MatrixXd
rowsOf(const std::vector<Positions> & subjects)
{
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(subjects.size()),
                       static_cast<Eigen::Index>(3 * subjects.front().size()));
  for (std::size_t s = 0; s < subjects.size(); ++s)
  {
    rows.row(static_cast<Eigen::Index>(s)) = coordinatesOf(subjects[s]).transpose();
  }
  return rows;
}

ModelQuality
pointQuality(const std::vector<SubjectSurface> & subjects)
{
  std::vector<Positions> points;
  for (const SubjectSurface & subject : subjects)
  {
    points.push_back(subject.points);
  }
  return modelQuality(fitShapeModel(MatrixTable(rowsOf(points))).scores, points.front().size());
}

/** Aligns by Procrustes, then measures. */
Correspondence
measured(const std::string & name, const Sample & sample, const std::vector<HexMesh> & meshes, AlignmentKind kind)
{
  Correspondence                         result{ name, {}, {}, {}, {} };
  std::vector<SubjectSurface>            aligned;
  const std::vector<SimilarityTransform> transforms = alignmentOf(meshes, kind);
  for (std::size_t s = 0; s < meshes.size(); ++s)
  {
    const TriangleMesh & surface = sample.subjects[s].surface;
    result.missed.push_back(surfaceDistance(surface, latticeSurface(meshes[s])).p95);
    aligned.push_back({ transformed(boundaryPoints(meshes[s]), transforms[s]),
                        { transformed(surface.vertices, transforms[s]), surface.triangles } });
  }
  const auto span = [&](const Positions & points) {
    return latticeSurface(withBoundaryPoints(meshes.front(), points));
  };
  result.points = pointQuality(aligned);
  result.surfaces = surfaceModelQuality(aligned, span, rowsOfModes(meshes.size()));
  return result;
}

SimilarityTransform
inverseOf(const SimilarityTransform & transform)
{
  SimilarityTransform inverse;
  inverse.scale = 1.0 / transform.scale;
  inverse.rotation = transform.rotation.transpose();
  inverse.translation = -(inverse.scale * (inverse.rotation * transform.translation));
  return inverse;
}

void
addRemark(const Way & way, const std::string & subject, const results::Run & run, Sample & sample)
{
  const std::string remark = remarkOn(run);
  if (!remark.empty())
  {
    sample.remarks.push_back(subject + ", " + way.name + ": " + remark);
  }
}

/** The surface of a solid in triangles that are not smaller than distances need them. */
TriangleMesh
evenSurface(const LevelSet & phi)
{
  const TriangleMesh       fine = marchingTetrahedra(phi, 0.0);
  const ClosestPointSearch search(fine);
  SurfaceRemeshingOptions  options;
  options.targetEdgeLength = edgeOfSurface;
  return remeshSurface(fine, options, [&](const Vector3 & p) { return search.closest(p).point; }).mesh;
}

/** The subjects with their own meshes. */
Sample
ownMeshes(const std::vector<std::filesystem::path> & files, const Way & own, int shells)
{
  Sample sample;
  for (const auto & file : files)
  {
    const std::string name = results::caseName(file);
    std::cerr << name << std::endl;
    const std::string refusal = refusalOf([&] {
      const LabelImage          label = readLabelImage(file.string());
      const results::LabelSolid solid = results::conditionedSolid(label, shells);
      const results::Run        run = meshAlone(label, shells);
      addRemark(own, name, run, sample);
      sample.subjects.push_back(
        { file, name, solid.volume / 1000.0, evenSurface(solid.phi), { run.pipeline->GetHexMesh() } });
    });
    if (!refusal.empty())
    {
      sample.remarks.push_back(name + ": left out, " + refusal);
    }
  }
  return sample;
}

/** Meshes of a subject by all ways but the first, which is its own. \return why one was refused; empty: none */
std::string
tieTo(const HexMesh & medoid, const std::vector<Way> & ways, Subject & subject, Sample & sample)
{
  std::string refusal;
  for (std::size_t way = 1; way < ways.size() && refusal.empty(); ++way)
  {
    std::cerr << subject.name << ", " << ways[way].name << std::endl;
    refusal = refusalOf([&] {
      const results::Run run = meshBy(ways[way], readLabelImage(subject.file.string()), medoid);
      addRemark(ways[way], subject.name, run, sample);
      subject.meshes.push_back(run.pipeline->GetHexMesh());
    });
  }
  return refusal;
}

/** The mean of aligned meshes, of equal volumes. */
HexMesh
meanMesh(const std::vector<HexMesh> & meshes, AlignmentKind alignment, Sample & sample)
{
  const std::vector<SimilarityTransform> transforms = alignmentOf(meshes, alignment);
  HexMesh                                mean = meshes.front();
  std::fill(mean.nodes.begin(), mean.nodes.end(), Vector3::Zero());
  for (std::size_t s = 0; s < meshes.size(); ++s)
  {
    const Positions nodes = transformed(meshes[s].nodes, transforms[s]);
    for (std::size_t node = 0; node < nodes.size(); ++node)
    {
      mean.nodes[node] += nodes[node] / static_cast<double>(meshes.size());
    }
  }
  EqualVolumeShape shape = equalVolumeShape(mean);
  if (!shape.exact)
  {
    sample.remarks.push_back("the mean mesh is not exact: " + shape.shortcomings.front());
  }
  return std::move(shape.mesh);
}

/** Ties a subject by one more way. */
void
addTied(const Way & way, const HexMesh & other, Subject & subject, Sample & sample)
{
  std::cerr << subject.name << ", " << way.name << std::endl;
  const results::Run run = meshBy(way, readLabelImage(subject.file.string()), other);
  addRemark(way, subject.name, run, sample);
  subject.meshes.push_back(run.pipeline->GetHexMesh());
}

std::vector<HexMesh>
lastMeshes(const Sample & sample)
{
  return meshesBy(sample, sample.subjects.front().meshes.size() - 1);
}

void
requireEnough(const Sample & sample)
{
  if (sample.subjects.size() < 3)
  {
    throw std::runtime_error("a model needs three subjects, there are " + std::to_string(sample.subjects.size()));
  }
}

} // namespace

std::vector<std::size_t>
rowsOfModes(std::size_t subjects)
{
  std::vector<std::size_t> rows;
  for (const std::size_t modes : { 1, 2, 3, 5, 8, 12, 16, 25, 40 })
  {
    if (modes + 2 <= subjects) // without one subject there is one mode less
    {
      rows.push_back(modes);
    }
  }
  return rows;
}

std::vector<std::filesystem::path>
filesOfSubjects(const std::filesystem::path & folder, const Arguments & arguments)
{
  std::vector<std::filesystem::path> files;
  std::set<std::string>              seen;
  const std::regex                   expression(arguments.subject);
  for (const auto & file : results::imagesIn(folder, std::numeric_limits<std::size_t>::max()))
  {
    const std::string name = results::caseName(file);
    std::smatch       match;
    if (!std::regex_search(name, match, expression))
    {
      throw std::runtime_error(file.string() + ": no \"" + arguments.subject + "\" in the name");
    }
    const bool isNew = arguments.subject.empty() || seen.insert(match.str()).second;
    if (isNew && files.size() < arguments.cases)
    {
      files.push_back(file);
    }
  }
  return files;
}

Sample
meshSample(const std::vector<std::filesystem::path> & files, const std::vector<Way> & ways, const Arguments & arguments)
{
  Sample sample = ownMeshes(files, ways.front(), arguments.shells);
  requireEnough(sample);
  std::vector<Positions>                 aligned;
  const std::vector<SimilarityTransform> transforms = alignmentOf(meshesBy(sample, 0), arguments.alignment);
  for (std::size_t s = 0; s < sample.subjects.size(); ++s)
  {
    aligned.push_back(transformed(boundaryPoints(sample.subjects[s].meshes.front()), transforms[s]));
  }
  const Subject medoid = sample.subjects[medoidOf(aligned)];
  Sample        complete;
  complete.remarks = sample.remarks;
  for (Subject & subject : sample.subjects)
  {
    const std::string refusal = tieTo(medoid.meshes.front(), ways, subject, complete);
    if (refusal.empty())
    {
      complete.subjects.push_back(std::move(subject));
    }
    else
    {
      complete.remarks.push_back(subject.name + ": left out, " + refusal);
    }
  }
  requireEnough(complete);
  const auto place = std::find_if(complete.subjects.begin(), complete.subjects.end(), [&](const Subject & subject) {
    return subject.name == medoid.name;
  });
  if (place == complete.subjects.end())
  {
    throw std::runtime_error(medoid.name + " cannot be tied to itself");
  }
  complete.medoid = static_cast<std::size_t>(place - complete.subjects.begin());
  return complete;
}

void
tieToMean(const Way & way, AlignmentKind alignment, Sample & sample)
{
  const HexMesh mean = meanMesh(lastMeshes(sample), alignment, sample);
  for (Subject & subject : sample.subjects)
  {
    addTied(way, mean, subject, sample);
  }
}

void
tieToModel(const Way & way, AlignmentKind alignment, std::size_t modes, Sample & sample)
{
  std::vector<HexMesh>                   shapes = lastMeshes(sample);
  const std::vector<SimilarityTransform> transforms = alignmentOf(shapes, alignment);
  std::vector<Positions>                 aligned;
  for (std::size_t s = 0; s < shapes.size(); ++s)
  {
    aligned.push_back(transformed(shapes[s].nodes, transforms[s]));
  }
  const Eigen::MatrixXd rows = rowsOf(aligned);
  ShapeModelOptions     options;
  options.maximumModes = modes;
  const ShapeModel model = fitShapeModel(MatrixTable(rows), options).model;
  for (std::size_t s = 0; s < shapes.size(); ++s)
  {
    const Eigen::VectorXd scores = scoresOf(model, rows.row(static_cast<Eigen::Index>(s)).transpose());
    shapes[s].nodes = transformed(pointsOf(reconstruct(model, scores)), inverseOf(transforms[s]));
    addTied(way, shapes[s], sample.subjects[s], sample);
  }
}

Correspondence
correspondenceBy(const Sample & sample, const std::vector<Way> & ways, std::size_t way, AlignmentKind alignment)
{
  return measured(ways[way].name, sample, meshesBy(sample, way), alignment);
}

Correspondence
simpleBaseline(const Sample & sample, AlignmentKind alignment)
{
  std::vector<HexMesh>                   meshes = meshesBy(sample, 0);
  const std::vector<SimilarityTransform> motions = alignmentOf(meshes, AlignmentKind::Similarity);
  const Positions          points = transformed(boundaryPoints(meshes[sample.medoid]), motions[sample.medoid]);
  std::vector<std::string> remarks;
  for (std::size_t s = 0; s < meshes.size(); ++s)
  {
    if (s != sample.medoid)
    {
      const NearestPointResult nearest =
        nearestPointCorrespondence(points, latticeSurface(transformed(meshes[s], motions[s])));
      if (!nearest.report.converged)
      {
        remarks.push_back(sample.subjects[s].name + ", nearest point: the alignment still moved by " +
                          results::significant(nearest.report.residual) + " mm after " +
                          std::to_string(nearest.report.steps) + " steps");
      }
      meshes[s] = withBoundaryPoints(std::move(meshes[s]), transformed(nearest.points, inverseOf(motions[s])));
    }
  }
  Correspondence result = measured("nearest point", sample, meshes, alignment);
  result.remarks = std::move(remarks);
  return result;
}

} // namespace moserhex::correspondence
