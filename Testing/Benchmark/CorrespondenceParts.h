#pragma once

#include "ResultsRun.h"

#include "moserhex/Geometry/RigidAlignment.h"

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <limits>
#include <string>
#include <vector>

namespace moserhex::correspondence
{

/** A way to a mesh whose nodes are to be at the same places as those of another one. */
struct Way
{
  std::string         name;
  bool                tied{ false }; ///< to the other mesh, as the options say; else made on its own
  SolidMeshingOptions options;       ///< but for shells and template
};

/** All that the tables compare; the first is the mesh made on its own. */
[[nodiscard]] std::vector<Way>
waysToCorrespond();

/** \param other  what the mesh is tied to, by a way that ties; also gives the number of shells */
[[nodiscard]] results::Run
meshBy(const Way & way, const LabelImage & label, const HexMesh & other);

/** Made on its own. */
[[nodiscard]] results::Run
meshAlone(const LabelImage & label, int shells);

/** What the tables call meshByAgreement. */
inline constexpr const char * agreedName = "tied, agreed masses";

/** Meshes of two labels. */
struct MeshedPair
{
  results::Run first;
  results::Run second;
};

/** Of labels that lie in one frame, by equal masses of what they agree on (agreementDensity), the second tied to the
 * first. */
[[nodiscard]] MeshedPair
meshByAgreement(const LabelImage & first, const LabelImage & second, int shells);

/** What a reader of a table should know of a mesh: it is not exact, its lattice is turned. Empty: nothing. */
[[nodiscard]] std::string
remarkOn(const results::Run & run);

/** What an action was refused with; empty: it was not. Other exceptions pass. */
[[nodiscard]] std::string
refusalOf(const std::function<void()> & action);

struct Arguments
{
  std::vector<std::filesystem::path> folders;
  int                                shells{ 10 };
  std::size_t                        cases{ std::numeric_limits<std::size_t>::max() }; ///< at most, of a folder
  std::string                        subject; ///< regular expression; empty: every labelmap is a subject
  AlignmentKind                      alignment{ AlignmentKind::Rigid };
};

/** Distances of corresponding nodes, with those of the surfaces, for labelmaps of the same studies in two folders. */
void
writeTestRetest(std::ostream & os, const Arguments & arguments);

/** Compactness, generalisation and specificity for the labelmaps of each folder, next to the simple baseline. */
void
writeModels(std::ostream & os, const Arguments & arguments);

/** Landmark errors under known deformations of a solid made in code. */
void
writeDeformations(std::ostream & os, const Arguments & arguments);

} // namespace moserhex::correspondence
