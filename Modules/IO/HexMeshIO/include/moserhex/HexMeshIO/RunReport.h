#pragma once

#include "moserhex/Common/Types.h"
#include "moserhex/Geometry/AffineTransform.h"
#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/LevelSet/TopologyRepair.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace moserhex
{

/** Quality of the mesh after a stage; definitions in the Quality module. */
struct StageQuality
{
  double volumeVariance{ 0.0 };        ///< population variance of the volume ratio [1]
  double concavePercent{ 0.0 };        ///< cells with a corner Jacobian <= 0 [%]
  double scaledJacobianMinimum{ 0.0 }; ///< [1]
  double scaledJacobianMedian{ 0.0 };  ///< [1]
  double scaledJacobianMean{ 0.0 };    ///< [1]
};

/** One stage of a run. */
struct StageRecord
{
  std::string                 name;           ///< as MeshingStageReport::name
  double                      seconds{ 0.0 }; ///< wall time [s]
  std::optional<StageQuality> quality;        ///< only for stages that leave a mesh
  std::string                 note{};         ///< what the stage did, in words; may be empty
};

/** What a run read, did and made, or why it made nothing: written as JSON beside the mesh. Lengths in mm, LPS.
 * What is empty was not used, or not known yet when the run failed; it is left out. */
struct RunReport
{
  /** The labelmap or surface that was read. */
  struct Input
  {
    std::string               file;                       ///< its name, as given
    std::string               sha256;                     ///< sha256OfInput
    std::vector<std::int64_t> labels;                     ///< one, or those that were taken together; none: not read
    std::string               labelName;                  ///< of the one
    Vector3                   spacing{ Vector3::Zero() }; ///< [mm]
    std::size_t               voxels{ 0 };   ///< of the label, or of all labels together, before its repair
    double                    volume{ 0.0 }; ///< voxels x volume of a voxel [mm^3]
  };
  /** What was asked for. */
  struct Parameters
  {
    int         shells{ 0 };          ///< N
    int         padding{ 0 };         ///< layers of pillow cells
    std::string stage;                ///< initial | smoothed | moser | exact
    std::string shellMethod;          ///< auto | chan-vese | snapshots | eikonal
    std::string way;                  ///< fast | faithful; empty when the stage is not exact
    std::string frame;                ///< anatomical | ridge
    std::string density;              ///< file; empty: volumes
    bool        localGrowth{ false }; ///< was asked for

    std::string                topology;             ///< repair | reject
    double                     maximumRepair{ 0.0 }; ///< [%]
    std::optional<double>      threshold;            ///< of a probability map
    std::optional<std::string> segment;              ///< of a .seg.nrrd
  };
  /** The density that was kept, in the image's own unit. */
  struct Density
  {
    std::string file;               ///< its name, as given
    std::string sha256;             ///< of the file's content
    double      mean{ 0.0 };        ///< over the label, 0: not known [unit of the image]
    double      mass{ 0.0 };        ///< mean times the label's volume [unit of the image * mm^3]
    double      massPerCell{ 0.0 }; ///< what every cell holds [unit of the image * mm^3]
  };
  /** How the lattice was turned for its edges' sake. */
  struct Frame
  {
    double angle{ 0.0 };       ///< [degree]
    double scoreBefore{ 0.0 }; ///< of the frame before it was turned, as scoreAfter
    double scoreAfter{ 0.0 };  ///< of the cube's edges on the surface, less is better [1]
  };
  /** The motion that was sought to bring a template to the label. */
  struct Alignment
  {
    double          angle{ 0.0 };       ///< by which it was turned [degree]
    double          translation{ 0.0 }; ///< by which its middle was moved [mm]
    double          rmsBefore{ 0.0 };   ///< of its surface to the label's [mm]
    AffineTransform motion{};           ///< from the template's space to the label's, without the scaling
  };
  /** How the template lay at the label before its nodes were moved one by one, see TemplateFit. */
  struct Placement
  {
    double scale{ 1.0 };  ///< by which it was made larger [1]
    double rms{ 0.0 };    ///< of its surface to the label's [mm]
    double median{ 0.0 }; ///< of the same distances [mm]
  };
  /** What a refinement left of a distance. */
  struct Residual
  {
    double before{ 0.0 }; ///< of the tied mesh that the refinement starts from
    double after{ 0.0 };  ///< of the mesh written
  };
  /** A file that was read. */
  struct File
  {
    std::string role;   ///< mesh | transform | landmarks | template_landmarks | image | template_image
    std::string name;   ///< its name, as given
    std::string sha256; ///< of its content
  };
  /** How differently cells have grown, where they were let to. */
  struct Growth
  {
    double      smallest{ 1.0 }; ///< volume over that of the template's cell, in parts of their organs [1]
    double      largest{ 1.0 };  ///< [1]
    std::size_t limited{ 0 };    ///< cells that would have grown or shrunk more than what is allowed
  };
  /** The mesh that this one is tied to, how it was brought to the label, and how the two were made more alike. */
  struct Template
  {
    std::vector<File>        files;     ///< the mesh first, then what else is known of both subjects
    std::string              alignment; ///< rigid | affine | none | file
    std::optional<Alignment> aligned;   ///< where it was sought
    std::optional<Placement> placed;    ///< empty: no mesh yet
    std::string              start;     ///< of the mesh: template | own (the label's own mesh); empty: no mesh yet
    std::optional<Residual>  landmarks; ///< root mean square over them [mm]
    std::optional<Residual>  imageDifference; ///< root mean square, in standard deviations of the image [1]
    std::optional<Growth>    growth;          ///< of single cells; empty: all cells equal
  };
  /** What stage J promises, and whether it was reached. */
  struct Exact
  {
    bool                     reached{ false };           ///< EqualisationResult::exact
    bool                     certified{ false };         ///< det J > 0 in every whole cell
    std::size_t              uncertifiedCells{ 0 };      ///< EqualisationResult::uncertifiedCells
    double                   variance{ 0.0 };            ///< mean (measure / target - 1)^2 [1]
    double                   massQuadratureError{ 0.0 }; ///< with a density: estimated, of the worst cell's mass [1]
    std::vector<std::string> shortcomings;               ///< empty when reached
  };
  /** What was done to the label's topology, and how it was smoothed. */
  struct Conditioning
  {
    std::size_t                 components{ 1 };    ///< of the label as it was, as are cavities and handles
    std::size_t                 cavities{ 0 };      ///< of the label as it was
    long                        handles{ 0 };       ///< of the label as it was
    std::vector<TopologyChange> changes;            ///< in the order they were made; empty: it was one solid of genus 0
    std::size_t                 voxelsAdded{ 0 };   ///< inside now, not before
    std::size_t                 voxelsRemoved{ 0 }; ///< inside before, not now
    double                      voxelVolume{ 0.0 }; ///< [mm^3]
    double                      changedPercent{ 0.0 }; ///< voxels added and removed over those of the label [%]
    double                      sigma{ 0.0 };          ///< of the Gaussian [mm]
    double                      dice{ 0.0 };           ///< of the conditioned solid and the repaired label's voxels [1]
  };
  /** The mesh that was written. */
  struct Mesh
  {
    std::string file;          ///< its name, as given
    std::size_t nodes{ 0 };    ///< with those of the padding
    std::size_t cells{ 0 };    ///< with those of the padding
    double      volume{ 0.0 }; ///< sum of the cell volumes [mm^3]
    std::string outline{};     ///< seen from the front: "x,z x,z ...", a closed polygon [mm, LPS]; empty: not made
  };
  /** Distance of the mesh's boundary to the surface of the solid that was meshed, see BoundaryDistance. */
  struct Surface
  {
    double rms{ 0.0 };     ///< of boundary nodes and quadrilateral centres to the solid's surface [mm]
    double maximum{ 0.0 }; ///< [mm]
  };
  /** Why there is no mesh. */
  struct Failure
  {
    ErrorCode   code{ ErrorCode::Internal }; ///< kind of fault
    std::string message;                     ///< for people, one line
  };
  /** Of the programs that made the mesh. */
  struct Versions
  {
    std::string moserhex; ///< of MoserHex
    std::string git;      ///< what git describe says of its source; "unknown" outside a repository
    std::string itk;      ///< of ITK
    std::string vtk;      ///< of VTK
    std::string eigen;    ///< of Eigen
  };

  std::optional<Failure>      failure;      ///< empty: meshed
  Input                       input;        ///< what was read
  std::optional<Density>      density;      ///< empty: volumes
  std::optional<Conditioning> conditioning; ///< empty: not done yet
  Parameters                  parameters;   ///< what was asked for
  std::vector<StageRecord>    stages;       ///< in order of execution
  Mesh                        mesh;         ///< of a failed run the file's name only
  std::optional<Surface>      surface;      ///< empty: no mesh yet
  std::optional<Template>     templateMesh; ///< empty: no template
  std::optional<Frame>        frame;        ///< when it was asked for
  std::optional<Vector3>      latticeTurn;  ///< rotation off the patient's axes, axis times angle [degree]; empty: none
  std::optional<Exact>        exact;        ///< empty: the last stage is another, or no mesh yet
  std::vector<std::string>    warnings;     ///< what a user should be told, one line each
  Versions                    versions;     ///< itk, vtk and eigen are filled in by libraryVersions()
  unsigned int                threads{ 0 }; ///< as asked for; 0: all of the machine's
  double                      seconds{ 0.0 }; ///< whole run, wall time
  std::optional<double>       peakMemory;     ///< of the process [MiB]
  bool reproducible{ false };                 ///< seconds, threads and memory are left out: the same run, the same text
};

/** What all cells of a mesh have the same of, in words. */
struct EqualMeasure
{
  const char * singular; ///< "volume", "mass" or "volume over its growth"
  const char * plural;   ///< "volumes", "masses" or "volumes over their growth"
};

/** By what was asked for. */
[[nodiscard]] EqualMeasure
equalMeasureOf(const RunReport & report);

/** Versions of ITK, VTK and Eigen this library was built with. */
[[nodiscard]] RunReport::Versions
libraryVersions();

/** The report as JSON: keys in a fixed order, numbers with round-trip precision in the C locale, non-finite numbers as
 * null, text that is not UTF-8 with replacement characters. */
[[nodiscard]] std::string
toJson(const RunReport & report);

/** Writes toJson(report), complete or not at all. \throws IOError */
void
writeRunReport(const std::string & fileName, const RunReport & report);

} // namespace moserhex
