#pragma once

#include "ModuleDescription.h"

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
   * takes no value, or `=true` and `=false`. Everything after `--` or `--ignore_rest` is an argument. Tolerates
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

  /** Where the simple outputs go; empty: nowhere. */
  [[nodiscard]] const std::string &
  returnParameterFile() const
  {
    return m_ReturnParameterFile;
  }

private:
  class Reader;

  const ModuleDescription &          m_Description;
  std::map<std::string, std::string> m_Values;
  std::string                        m_ReturnParameterFile;
  ModuleRequest                      m_Request{ ModuleRequest::Run };
};

} // namespace moserhex::slicer
