#pragma once

#include "ChosenSolid.h"
#include "moserhex/LevelSet/AgreementDensity.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace moserhex::app
{

struct AgreementCommandOptions
{
  std::vector<std::string> labelmaps;
  InputOptions             solid; ///< of each of them; its file is not read
  std::string              output;
  AgreementOptions         agreement;
  bool                     quiet{ false };
};

/** Adds `agreement` and its options. */
CLI::App *
addAgreementCommand(CLI::App & program, AgreementCommandOptions & options);

/** Writes the density of what several segmentations of one organ agree on, for mesh --density.
 * \throws UsageError, BadInput, InvalidInput, IOError */
void
runAgreementCommand(const AgreementCommandOptions & options);

} // namespace moserhex::app
