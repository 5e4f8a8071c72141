#pragma once

#include "moserhex/Common/ErrorCode.h"

#include <string>

namespace moserhex
{

/** Checks an XML file of VTK for what its readers do not survive: entities, which could name other files; counts that
 * the file cannot hold, compressed or not; arrays of a type that VTK does not have.
 *
 * \param kind    "PolyData", "UnstructuredGrid": the element that must be there
 * \param remedy  for messages
 * \throws BadInput  Format, Unsupported (of another kind), Header, Truncated */
void
requireHonestXml(const std::string & fileName, const std::string & kind, const std::string & remedy);

} // namespace moserhex
