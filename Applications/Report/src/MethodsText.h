#pragma once

#include "moserhex/HexMeshIO/RunReport.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** What was done, in words for a paper, with numbers in brackets for the references. */
struct MethodsText
{
  std::string              paragraph;
  std::vector<std::string> references; ///< in the order of their numbers, from 1
};

/** \param report  of a run that gave a mesh */
[[nodiscard]] MethodsText
methodsText(const RunReport & report);

} // namespace moserhex::app
