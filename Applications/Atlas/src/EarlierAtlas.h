#pragma once

#include <string>
#include <vector>

namespace moserhex::app
{

/** Whether an atlas was written to a folder, or begun: its mean and its modes are no subjects. */
[[nodiscard]] bool
holdsAtlas(const std::string & folder);

/** Marks a folder as one that holds an atlas, before its first file is written. \throws IOError */
void
markAtlasBegun(const std::string & folder);

/** \throws UsageError  the folder holds an atlas, of which what is written there would replace files */
void
requireNoAtlas(const std::string & folder);

/** Removes what an earlier atlas wrote to a folder, as this one may write less. Nothing where the folder holds no
 * atlas; other files stay. \throws IOError  a file cannot be removed */
void
removeEarlierAtlas(const std::string & folder);

/** \param files  inputs, of which some may not be there
 * \throws UsageError  one of them lies in the output folder and has a name that an atlas writes */
void
requireNotOverwritten(const std::vector<std::string> & files, const std::string & outputFolder);

} // namespace moserhex::app
