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
};

/** Finds the subjects of meshes, folders of meshes (and those below, hidden ones left out), or of one table.
 *
 * A table (.csv .tsv) has a column `mesh`, relative to the table's folder, which also names the subject unless a column
 * `subject` does. Else a mesh is named by its path below the folder, or its file's name, without the ending; where that
 * is taken, by its whole path.
 * \param outputFolder  left out where it lies below a folder
 * \throws UsageError  a table among other inputs, a mesh or a subject given twice
 * \throws BadInput    an input is missing, no mesh or table, a folder has no mesh, or the table no column `mesh` or an
 * empty cell in it; IOError */
[[nodiscard]] AtlasSubjects
listAtlasSubjects(const std::vector<std::string> & inputs, const std::string & outputFolder);

/** A column as numbers; nothing where the cell is empty or n/a. Cells that are no numbers are allowed where there are
 * just two different ones: 0 for the first in the alphabet, 1 for the other. \throws BadInput  no such column, or other
 * cells that are no numbers */
[[nodiscard]] std::vector<std::optional<double>>
numbersOfColumn(const AtlasSubjects & subjects, const std::string & column);

/** A column of files, relative to the table's folder; nothing where the cell is empty or n/a.
 * \throws BadInput  no such column */
[[nodiscard]] std::vector<std::optional<std::string>>
filesOfColumn(const AtlasSubjects & subjects, const std::string & column);

/** A column of groups: 0 for `names[0]`, 1 for `names[1]` and so on, ascending as numbers or in the alphabet; nothing
 * where the cell is empty or n/a. */
struct GroupColumn
{
  std::vector<std::optional<double>> numbers;
  std::vector<std::string>           names;
};

/** Two different numbers or words, or more words. \throws BadInput  no such column, fewer than two different values, or
 * more than two numbers, which may be a measurement */
[[nodiscard]] GroupColumn
groupsOfColumn(const AtlasSubjects & subjects, const std::string & column);

} // namespace moserhex::app
