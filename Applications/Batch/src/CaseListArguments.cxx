#include "CaseListArguments.h"

#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <CLI/CLI.hpp>

namespace moserhex::app
{

void
addCaseListOptions(CLI::App & command, CaseListOptions & options)
{
  command.add_flag("--all-labels", options.allLabels, "A mesh of each label of each file");
  command.add_option("--include", options.include, "Of folders only files that match GLOB; may be repeated")
    ->allow_extra_args(false)
    ->type_name("GLOB");
  command.add_option("--exclude", options.exclude, "Of folders no files that match GLOB; may be repeated")
    ->allow_extra_args(false)
    ->type_name("GLOB");
  command.add_option("--base", options.base, "Outputs mirror the paths below this folder")->type_name("DIR");
  command.add_option("--keep-columns", options.keepColumns, "Columns of lists to take over into the summary: a,b")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->type_name("NAMES");
  command.add_option("--format", options.ending, std::string("Ending of the meshes (") + hexMeshEndings + ")")
    ->capture_default_str();
}

} // namespace moserhex::app
