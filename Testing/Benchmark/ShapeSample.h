#pragma once

#include "CorrespondenceParts.h"

#include "moserhex/Correspondence/SurfaceModelQuality.h"
#include "moserhex/Geometry/TriangleMesh.h"
#include "moserhex/ShapeStatistics/ModelQuality.h"

#include <string>
#include <vector>

namespace moserhex::correspondence
{

/** A subject of a sample: its label's surface, and a mesh by every way. */
struct Subject
{
  std::filesystem::path file;
  std::string           name;
  double                volume{ 0.0 }; ///< of the label [mL]
  TriangleMesh          surface;       ///< of the conditioned label [mm]
  std::vector<HexMesh>  meshes;        ///< in the order of the ways
};

/** Subjects that all have meshes by every way, and what is to be said about them. */
struct Sample
{
  std::vector<Subject>     subjects;
  std::size_t              medoid{ 0 }; ///< to whose own mesh the others are tied
  std::vector<std::string> remarks;
};

/** The labelmaps of a folder by name; where `subject` is given, the first of those in whose names it matches the same
 * text. \throws std::runtime_error  a name in which it does not match */
[[nodiscard]] std::vector<std::filesystem::path>
filesOfSubjects(const std::filesystem::path & folder, const Arguments & arguments);

/** \param ways  the first: own. A label that is refused by one of them is left out, with a remark
 * \throws std::runtime_error  fewer than three subjects are left */
[[nodiscard]] Sample
meshSample(const std::vector<std::filesystem::path> & files,
           const std::vector<Way> &                   ways,
           const Arguments &                          arguments);

/** One more way: all subjects are tied, by a way that ties, to the mean of their last meshes, aligned by Procrustes of
 * their boundary nodes and made of equal volumes, as moserhex atlas writes it. A label that is refused ends the run. */
void
tieToMean(const Way & way, AlignmentKind alignment, Sample & sample);

/** One more way: every subject is tied to its own shape as the model of their last meshes has it, aligned likewise,
 * with so many modes. What differs from subject to subject without any pattern is left out of that shape. */
void
tieToModel(const Way & way, AlignmentKind alignment, std::size_t modes, Sample & sample);

/** Corresponding points of all subjects of a sample on their surfaces: what a model makes of them. */
struct Correspondence
{
  std::string              name;
  ModelQuality             points;   ///< by points, for every number of modes
  SurfaceModelQuality      surfaces; ///< by the labels' surfaces, for the numbers of rowsOfModes()
  std::vector<double>      missed;   ///< per subject, 95 % of its surface are nearer to what the points span [mm]
  std::vector<std::string> remarks;
};

/** The numbers of modes that have a row in the tables, for so many subjects. */
[[nodiscard]] std::vector<std::size_t>
rowsOfModes(std::size_t subjects);

/** From the boundary nodes of the meshes made by a way. */
[[nodiscard]] Correspondence
correspondenceBy(const Sample & sample, const std::vector<Way> & ways, std::size_t way, AlignmentKind alignment);

/** From nearest points: the boundary nodes of the medoid's own mesh on the surfaces of the others' own meshes. For the
 * search all have the same size and are aligned by Procrustes, node by node; the points then go back to each subject.
 */
[[nodiscard]] Correspondence
simpleBaseline(const Sample & sample, AlignmentKind alignment);

} // namespace moserhex::correspondence
