#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace moserhex::app
{

/** Absolute, without . and .. and doubled or last slashes; links are not resolved. */
[[nodiscard]] std::filesystem::path
normalPath(const std::string & path);

/** The deepest folder that holds all of these files, at least one. */
[[nodiscard]] std::filesystem::path
commonFolder(const std::vector<std::string> & files);

/** Whether a relative path without needless parts stays below the folder that it starts from. */
[[nodiscard]] bool
staysBelow(const std::filesystem::path & relative);

/** The name without the ending of a labelmap or surface; .nii.gz and .seg.nrrd are one ending. */
[[nodiscard]] std::string
stemOf(const std::string & inputName);

/** With .json in place of the mesh's ending. */
[[nodiscard]] std::string
reportNameOf(const std::string & meshName);

/** With .html in place of the report's ending. */
[[nodiscard]] std::string
pageNameOf(const std::string & reportName);

/** The mesh's name with a label in it: a.vtu becomes a_label-TEXT.vtu. In a BIDS name the label stands where BIDS wants
 * it, before _desc- and the suffix: sub-01_desc-manual_dseg.vtu becomes sub-01_label-TEXT_desc-manual_dseg.vtu; one
 * that is there already is extended, since an entity may not occur twice: sub-01_label-GM_mask.vtu becomes
 * sub-01_label-GM+TEXT_mask.vtu. */
[[nodiscard]] std::string
labelledName(const std::string & meshName, const std::string & text);

/** Whether the batch itself keeps a file of this name at the top of the output folder, upper and lower case alike:
 * summary.csv, summary.json, summary.html, journal*.jsonl, .lock* */
[[nodiscard]] bool
isNameOfBatch(const std::string & name);

/** ASCII only. */
[[nodiscard]] std::string
lowerCase(std::string text);

} // namespace moserhex::app
