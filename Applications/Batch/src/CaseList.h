#pragma once

#include "MeshOptions.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** One mesh to make. */
struct BatchCase
{
  /** The mesh's file, relative to the output folder, with '/': what the case is known by. Unique in a list. */
  std::string name;

  /** What `mesh` is told. input.file, output and reportFile are paths as this process can open them; the report stands
   * beside the mesh, with the ending .json in place of the mesh's. Threads and quiet are not set. */
  MeshCommandOptions options;

  std::string              labelName; ///< of a label that --all-labels found, where the file has a name for it
  std::vector<std::string> kept;      ///< cells of CaseList::keptColumns
};

/** What to make meshes of. */
struct CaseListOptions
{
  /** Each a folder, searched to its bottom for labelmaps; a labelmap or surface; a pattern with * ? or [] ; or a list:
   * .csv or .tsv with columns input, output, label and other options of `mesh`, .txt with one file a line. */
  std::vector<std::string> inputs;

  std::string              outputFolder;
  std::string              ending{ ".vtu" }; ///< of the meshes, where a list does not name them
  std::string              base;        ///< outputs mirror the inputs' paths below this folder; empty: see listCases
  std::vector<std::string> include;     ///< patterns: files of folders must match one of them; empty: all
  std::vector<std::string> exclude;     ///< patterns: files of folders must match none of them
  std::vector<std::string> keepColumns; ///< of lists, that are not options: taken over into the summary
  bool                     allLabels{ false }; ///< a mesh of each label where none is named
  MeshCommandOptions       defaults;           ///< where a list says nothing else
};

struct CaseList
{
  std::vector<BatchCase>   cases; ///< in the order of the inputs; files of a folder sorted by their path
  std::vector<std::string> keptColumns;
  std::vector<std::string> warnings;
};

/** Lists the cases and checks all names; nothing is written, and images are read only for allLabels, one after the
 * other: with the sandbox, before other threads work (see readLabelImage).
 *
 * Outputs mirror the inputs: PATH/NAME.nii.gz below a base folder becomes PATH/NAME.vtu below the output folder, with
 * all entities of a BIDS name kept. The base is the folder that was searched; of a list, the folder it lies in; of
 * files and patterns, the deepest folder that holds them all. Paths are compared as they are written, links in them
 * are not resolved.
 *
 * Of a folder every labelmap counts, known by its ending, that lies in it or below and passes include and exclude (see
 * SearchFilter), but neither hidden ones nor those behind a link to a folder or in an output folder below it. Files
 * that exist win over patterns, which find labelmaps and surfaces.
 *
 * A list has a column `input`, and may have `output` and any of meshingOptionNames(); an empty cell (or n/a) leaves the
 * default, and the label `all` stands for allLabels. Its inputs and densities are relative to its folder, its outputs
 * to the output folder.
 *
 * With allLabels, label 3 called "Left Putamen" of sub-01_dseg.nii.gz becomes sub-01_label-LeftPutamen_dseg.vtu (a BIDS
 * name; see labelledName), of atlas.nrrd it becomes atlas_label-LeftPutamen.vtu; without a name, label-3. Names that
 * are the same but for what is left out of them get the label's number, too. Of segments that overlap each is a case
 * with the option segment. A surface is one case, and so is a file whose labels cannot be read, which will fail with
 * the reason; so is a row of a list that names a label, a segment or a threshold.
 *
 * Warnings, one line for all of a kind: inputs given twice with the same options (made once), outputs that differ in
 * upper and lower case only, inputs or densities that do not exist (their cases fail).
 *
 * \throws UsageError  nothing to do, in all or in one input; two cases with one output or one report; an output that is
 * an input, lies outside the output folder, or is a file of the batch itself; no ending of a mesh or of an input; a
 * column that is neither an option nor kept, or to be kept and not there; an option's value, with file and line
 * \throws BadInput  an input that does not exist, a list or a folder that cannot be read; IOError */
[[nodiscard]] CaseList
listCases(const CaseListOptions & options);

} // namespace moserhex::app
