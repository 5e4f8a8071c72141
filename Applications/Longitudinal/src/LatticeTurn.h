#pragma once

#include <optional>
#include <string>

namespace moserhex::app
{

/** What the report beside a mesh (its name with the ending .json) says of the lattice's direction: that it was turned
 * against the patient's axes, so that indices are not the same places as in other meshes. Nothing when it was not, or
 * when there is no report of `moserhex mesh`. */
[[nodiscard]] std::optional<std::string>
turnOfLattice(const std::string & meshFile);

} // namespace moserhex::app
