#pragma once

#include "CaseList.h"

namespace CLI
{
class App;
}

namespace moserhex::app
{

/** Which cases there are of the inputs, and how their files are called: the same options for all commands of batches.
 */
void
addCaseListOptions(CLI::App & command, CaseListOptions & options);

} // namespace moserhex::app
