#pragma once

#include <string>
#include <vector>

namespace moserhex::app
{

/** Whether an atlas was written to a folder: its mean and its modes are no subjects. */
[[nodiscard]] bool
holdsAtlas(const std::string & folder);

/** Removes what an earlier atlas wrote to a folder, as this one may write less. Nothing where the folder holds no
 * atlas; other files stay. \throws IOError  a file cannot be removed */
void
removeEarlierAtlas(const std::string & folder);

/** \param files  inputs, of which some may not be there
 * \throws UsageError  one of them lies in the output folder and has a name that an atlas writes */
void
requireNotOverwritten(const std::vector<std::string> & files, const std::string & outputFolder);

} // namespace moserhex::app
