#pragma once

#include "ModuleArguments.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace moserhex::slicer
{

/** What Slicer reads from the standard output while a module runs: <filter-...> tags, each on a line of its own. */
class ModuleProgress
{
public:
  /** Begins with <filter-start>. */
  explicit ModuleProgress(std::string name);
  /** Ends with <filter-end>. */
  ~ModuleProgress();
  ModuleProgress(const ModuleProgress &) = delete;
  ModuleProgress &
  operator=(const ModuleProgress &) = delete;

  /** \param fraction  done, in [0,1]; going back is ignored, and so is less than a hundredth more */
  void
  show(double fraction);

  /** What is being done. */
  void
  comment(const std::string & text);

private:
  std::string m_Name;
  double      m_Shown{ -1.0 };
};

/** Names and values of simple outputs. */
using SimpleOutputs = std::vector<std::pair<std::string, std::string>>;

/** The work of a module. Warnings are lines on the standard output, as Slicer takes the error output for errors. */
using ModuleWork = std::function<SimpleOutputs(const ModuleArguments & arguments, ModuleProgress & progress)>;

/** main() of a module: answers --xml, --help, --version and --logo, or does the work and writes the return parameter
 * file. What the work throws is one line on the error output. \return the exit status
 * \param xml  the description, printed as it is by --xml and the only source of the options */
[[nodiscard]] int
runModule(int argc, char ** argv, const std::string & xml, const ModuleWork & work);

/** The text of --help: every parameter with its flags, range, default and description. */
[[nodiscard]] std::string
helpOf(const ModuleDescription & description, const std::string & program);

} // namespace moserhex::slicer
