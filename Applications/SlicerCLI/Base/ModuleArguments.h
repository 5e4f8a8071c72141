#pragma once

#include "ModuleDescription.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace moserhex::slicer
{

/** What the user, or Slicer, asked of a module besides its own parameters. */
enum class ModuleRequest
{
  Run,
  Xml,
  Help,
  Version,
  Logo
};

/** The values of a module's parameters: as given, or the defaults of the description. */
class ModuleArguments
{
public:
  /** Takes `--flag value`, `--flag=value`, `-f value`, `-f=value` and arguments in the order of their index; a boolean
   * takes no value, or `=true` and `=false`; a parameter that is multiple takes its flag more than once, or, where it
   * has an index, all arguments that are left. Everything after `--` or `--ignore_rest` is an argument. Tolerates
   * --processinformationaddress and --echo.
   * \throws InvalidInput  (ErrorCode::Usage) an option that is not known, given twice or without a value, too few or
   * too many arguments, a value out of its range; a request other than Run asks for no arguments */
  ModuleArguments(const ModuleDescription & description, const std::vector<std::string> & words);

  [[nodiscard]] ModuleRequest
  request() const
  {
    return m_Request;
  }

  /** Whether the value was given, and is not empty. */
  [[nodiscard]] bool
  has(const std::string & name) const;

  [[nodiscard]] std::string
  text(const std::string & name) const;

  [[nodiscard]] long long
  integer(const std::string & name) const;

  [[nodiscard]] double
  real(const std::string & name) const;

  [[nodiscard]] bool
  flag(const std::string & name) const;

  /** The elements of a vector, or all values of a parameter that is multiple, in the order given. */
  [[nodiscard]] std::vector<std::string>
  texts(const std::string & name) const;

  [[nodiscard]] std::vector<long long>
  integers(const std::string & name) const;

  [[nodiscard]] std::vector<double>
  reals(const std::string & name) const;

  /** The points given, none to many: LPS millimetres, also where the module has them as RAS; of ijk, indices.
   * \pre the parameter is a point */
  [[nodiscard]] std::vector<std::array<double, 3>>
  points(const std::string & name) const;

  /** Where the simple outputs go; empty: nowhere. */
  [[nodiscard]] const std::string &
  returnParameterFile() const
  {
    return m_ReturnParameterFile;
  }

private:
  class Reader;

  const ModuleDescription &                       m_Description;
  std::map<std::string, std::vector<std::string>> m_Values; ///< one value, or as many as a multiple one was given
  std::string                                     m_ReturnParameterFile;
  ModuleRequest                                   m_Request{ ModuleRequest::Run };
};

} // namespace moserhex::slicer
