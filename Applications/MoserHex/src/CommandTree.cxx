#include "CommandTree.h"

#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

namespace moserhex::app
{
namespace
{

using Json = nlohmann::ordered_json;

Json
describe(const CLI::Option & option)
{
  Json names = Json::array();
  for (const std::string & name : option.get_snames())
  {
    names.push_back("-" + name);
  }
  for (const std::string & name : option.get_lnames())
  {
    names.push_back("--" + name);
  }
  std::vector<std::string> excludes;
  for (const CLI::Option * other : option.get_excludes())
  {
    excludes.push_back(other->get_name());
  }
  std::sort(excludes.begin(), excludes.end()); // they are in the order of addresses
  Json result;
  result["names"] = names;
  result["place"] = option.get_positional() ? option.get_name(true, false) : "";
  result["description"] = option.get_description();
  result["values"] = option.get_items_expected_max() == 0 ? "" : option.get_type_name();
  result["default"] = option.get_default_str();
  result["required"] = option.get_required();
  result["several"] = option.get_items_expected_max() > 1;
  result["excludes"] = excludes;
  return result;
}

} // namespace

std::string
describeCommands(const CLI::App & program)
{
  Json commands = Json::array();
  for (const CLI::App * command : program.get_subcommands([](const CLI::App *) { return true; }))
  {
    Json options = Json::array();
    for (const CLI::Option * option : command->get_options())
    {
      if (!option->get_group().empty())
      {
        options.push_back(describe(*option));
      }
    }
    commands.push_back(
      { { "name", command->get_name() }, { "description", command->get_description() }, { "options", options } });
  }
  return commands.dump(2) + "\n";
}

} // namespace moserhex::app
