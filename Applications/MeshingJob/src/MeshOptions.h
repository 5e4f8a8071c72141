#pragma once

#include "ChosenSolid.h"

#include <optional>
#include <string>
#include <vector>

namespace moserhex::app
{

struct MeshCommandOptions
{
  InputOptions               input;
  std::string                output;
  std::string                reportFile;            ///< JSON; empty: no report
  std::string                pageFile;              ///< the report as HTML; empty: none
  bool                       reproducible{ false }; ///< the report has no times, threads and memory
  int                        shells{ 10 };
  std::string                stage{ "exact" };      ///< initial | smoothed | moser | exact
  std::optional<std::string> way;                   ///< fast (also when not given) | faithful
  int                        padding{ 0 };          ///< layers of pillow cells around the lattice
  std::string                frame{ "anatomical" }; ///< anatomical | ridge
  std::string                templateMesh;          ///< mesh that this one is to be like; empty: none
  std::string                align{ "rigid" };      ///< rigid | affine | none, or a transform's file: how the template
                                                    ///< is brought to the label
  std::string  transformFile;                       ///< where to write the motion that brought it there; empty: not
  std::string  landmarks;                           ///< points on the label, ...
  std::string  templateLandmarks;                   ///< ... and the same places on the template; empty: none
  std::string  image;                               ///< an image of the label's subject, ...
  std::string  templateImage;                       ///< ... and one of the template's; empty: none
  bool         localGrowth{ false };                ///< every cell grows as landmarks and images show
  std::string  density;                             ///< image of a positive density; empty: volumes
  bool         allowPartial{ false };               ///< write a mesh that is not exact, with a warning
  std::string  shellMethod{ "auto" };               ///< auto | chan-vese | snapshots | eikonal
  std::string  topology{ "repair" };                ///< repair | reject
  double       maximumRepairPercent{ 5.0 };         ///< of the label's voxels
  unsigned int threads{ 0 };                        ///< 0: all of the machine's
  bool         quiet{ false };
};

/** The values that options in words may have. */
inline const std::vector<std::string> stageNames{ "initial", "smoothed", "moser", "exact" };
inline const std::vector<std::string> wayNames{ "fast", "faithful" };
inline const std::vector<std::string> frameNames{ "anatomical", "ridge" };
inline const std::vector<std::string> alignNames{ "rigid", "affine", "none" };
inline const std::vector<std::string> topologyNames{ "repair", "reject" };
inline const std::vector<std::string> shellMethodNames{ "auto", "chan-vese", "snapshots", "eikonal" };

inline constexpr int fewestShells = 2;
inline constexpr int mostShells = 64;

/** \throws UsageError  a value out of its range, or options that exclude each other */
void
requireUsable(const MeshCommandOptions & options);

/** What options of one mesh must not be, but may be where they are the defaults of many: an alignment without a
 * template. \throws UsageError */
void
requireUsed(const MeshCommandOptions & options);

/** fast | faithful */
[[nodiscard]] std::string
wayOf(const MeshCommandOptions & options);

} // namespace moserhex::app
