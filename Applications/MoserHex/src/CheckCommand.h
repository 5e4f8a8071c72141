#pragma once

#include "ChosenSolid.h"

#include <string>

namespace moserhex::app
{

struct CheckCommandOptions
{
  InputOptions input;
  bool         allLabels{ false };          ///< each label by itself, as a table
  double       maximumRepairPercent{ 5.0 }; ///< of the label's voxels
  std::string  jsonFile;                    ///< empty: none
  unsigned int threads{ 0 };
  bool         quiet{ false };
};

/** Says what a label is, without changing it: components, cavities, handles, contacts of voxels, borders of the image,
 * and what a repair of its topology would change.
 * \throws UsageError, BadInput, IOError */
void
runCheckCommand(const CheckCommandOptions & options);

} // namespace moserhex::app
