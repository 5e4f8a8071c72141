#pragma once

#include "AtlasTest.h"
#include "moserhex/Geometry/HexMesh.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace moserhex::app
{

/** Writes NAME.vtu and NAME.csv of a test into a folder: its figures at every node, on the mean mesh.
 * \throws IOError */
void
writeAtlasTest(const std::string & folder, const AtlasTest & test, const HexMesh & mean);

/** Of a test, for atlas.json. */
[[nodiscard]] nlohmann::ordered_json
testJson(const AtlasTest & test);

} // namespace moserhex::app
