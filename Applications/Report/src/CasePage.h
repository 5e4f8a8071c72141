#pragma once

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"
#include "moserhex/HexMeshIO/RunReport.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** What the page of one case shows; what is not there is left out of it. */
struct CaseContent
{
  RunReport                 report;
  std::vector<LabelEntry>   labels;           ///< that were meshed
  const LabelImageType *    image{ nullptr }; ///< with these labels; null: not read
  const HexMesh *           mesh{ nullptr };  ///< null: there is none
  std::vector<std::int32_t> labelOfCells;     ///< where several labels were meshed together; else empty
};

/** One HTML document that needs no other file: whether the mesh can be trusted and why, slices, a 3-D view, histograms,
 * the stages, what was repaired, a paragraph for a paper, and the report itself (toJson) to download. The same content
 * gives the same bytes.
 * \throws InvalidInput (Usage)  a program without pages */
[[nodiscard]] std::string
casePage(const CaseContent & content);

/** Writes it, complete or not at all. \throws IOError; InvalidInput (Usage) */
void
writeCasePage(const std::string & fileName, const CaseContent & content);

} // namespace moserhex::app
