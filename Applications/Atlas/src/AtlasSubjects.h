#pragma once

#include "TextTable.h"

#include <optional>
#include <string>
#include <vector>

namespace moserhex::app
{

struct AtlasSubject
{
  std::string name; ///< unique
  std::string mesh; ///< file
};

/** Who is analysed, in the order of the table, or of the inputs, those of a folder sorted by their paths. */
struct AtlasSubjects
{
  std::vector<AtlasSubject> subjects;
  TextTable                 table;       ///< a row for each subject; no columns where there is no table
  std::string               tableFolder; ///< that files in the table are relative to
  std::vector<std::string>  warnings;    ///< of folders that are left out
};

/** Finds the subjects of meshes, folders of meshes (and those below, hidden ones left out), or of one table.
 *
 * A table (.csv .tsv) has a column `mesh`, relative to the table's folder, which also names the subject unless a column
 * `subject` does. Else a mesh is named by its path below the folder, or its file's name, without the ending; where that
 * is taken, by its whole path.
 * \param outputFolder  left out where it lies below a folder, as are, with a warning, folders of other atlases
 * \throws UsageError  a table among other inputs, a mesh or a subject given twice, a folder that is the output
 * \throws BadInput    an input is missing, no mesh or table, a folder has no mesh or is an atlas, or the table has no
 * row, no column `mesh` or a missing cell in it; IOError */
[[nodiscard]] AtlasSubjects
listAtlasSubjects(const std::vector<std::string> & inputs, const std::string & outputFolder);

/** A number of every subject; nothing where the cell is missing (isMissing). */
using NumberColumn = std::vector<std::optional<double>>;

/** A column of numbers, or of two words: 0 for the first in the alphabet, 1 for the other. \throws BadInput  no such
 * column, more words, numbers and words, or words that begin like numbers */
[[nodiscard]] NumberColumn
numbersOfColumn(const AtlasSubjects & subjects, const std::string & column);

/** The same, and of k > 2 words the k - 1 columns of groupColumns. \throws BadInput  no such column, numbers and words,
 * or words that begin like numbers */
[[nodiscard]] std::vector<NumberColumn>
covariatesOfColumn(const AtlasSubjects & subjects, const std::string & column);

/** A column of files, relative to the table's folder; nothing where the cell is missing.
 * \throws BadInput  no such column */
[[nodiscard]] std::vector<std::optional<std::string>>
filesOfColumn(const AtlasSubjects & subjects, const std::string & column);

/** A column of groups: 0 for `names[0]`, 1 for `names[1]` and so on, ascending as numbers or in the alphabet. */
struct GroupColumn
{
  NumberColumn             numbers;
  std::vector<std::string> names;
};

/** Two different numbers or words, or more words. \throws BadInput  no such column, fewer than two different values,
 * numbers and words, or more than two numbers, which may be a measurement */
[[nodiscard]] GroupColumn
groupsOfColumn(const AtlasSubjects & subjects, const std::string & column);

} // namespace moserhex::app
