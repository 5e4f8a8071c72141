#pragma once

#include "moserhex/HexMeshIO/RunReport.h"

#include <string>

namespace moserhex::app
{

/** Parts of the page of a case that need the report alone, as HTML: sections with their headings. */

/** The traffic light in words, a sign and a colour, with the reasons. */
[[nodiscard]] std::string
trustSection(const RunReport & report);

/** Numbers first looked for. */
[[nodiscard]] std::string
keyFigures(const RunReport & report);

[[nodiscard]] std::string
stageSection(const RunReport & report);

/** What the repair of the label changed, and where. */
[[nodiscard]] std::string
repairSection(const RunReport & report);

/** How the mesh was tied to another one, and how far the two are apart; empty without a template. */
[[nodiscard]] std::string
templateSection(const RunReport & report);

[[nodiscard]] std::string
methodsSection(const RunReport & report);

/** Files, options and versions. */
[[nodiscard]] std::string
provenanceSection(const RunReport & report);

} // namespace moserhex::app
