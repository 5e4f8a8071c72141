#pragma once

#include <string>

namespace CLI
{
class App;
}

namespace moserhex::app
{

/** All commands of the program and their options as JSON, for the manual: an array of commands, each with `name`,
 * `description` and `options`. An option has `names` (empty for an argument by place), `place`, `description`, `values`
 * (type and range; "" of a flag), `default`, `required`, `several` and `excludes`. Hidden options are left out. */
[[nodiscard]] std::string
describeCommands(const CLI::App & program);

} // namespace moserhex::app
