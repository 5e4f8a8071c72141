#include "ModuleArguments.h"

#include "ModuleValues.h"
#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace moserhex::slicer
{
namespace
{

[[noreturn]] void
refuse(const std::string & what)
{
  throw InvalidInput(ErrorCode::Usage, what + "; see --help");
}

const std::map<std::string, ModuleRequest> requests{ { "--xml", ModuleRequest::Xml },
                                                     { "--help", ModuleRequest::Help },
                                                     { "-h", ModuleRequest::Help },
                                                     { "--version", ModuleRequest::Version },
                                                     { "--logo", ModuleRequest::Logo } };

/** Options of every module that have a value. */
const std::string returnParameters = "--returnparameterfile";
const std::string processInformation = "--processinformationaddress";

} // namespace

/** Goes through the words of a command line. */
class ModuleArguments::Reader
{
public:
  Reader(ModuleArguments & result, const std::vector<std::string> & words) : m_Result(result), m_Words(words)
  {}

  void
  read()
  {
    while (m_Next < m_Words.size())
    {
      const std::string word = m_Words[m_Next++];
      if (m_OnlyArguments || word.size() < 2 || word[0] != '-')
      {
        m_Arguments.push_back(word);
      }
      else if (word == "--" || word == "--ignore_rest")
      {
        m_OnlyArguments = true;
      }
      else if (requests.count(word) != 0)
      {
        m_Result.m_Request = requests.at(word);
        return;
      }
      else if (word != "--echo")
      {
        readOption(word);
      }
    }
    takeArguments();
  }

private:
  void
  readOption(const std::string & word)
  {
    const std::size_t          equals = word.find('=');
    const std::string          option = word.substr(0, equals);
    std::optional<std::string> value;
    if (equals != std::string::npos)
    {
      value = word.substr(equals + 1);
    }
    if (!m_Seen.insert(option).second)
    {
      refuse(option + " is given twice");
    }
    if (option == returnParameters || option == processInformation)
    {
      const std::string given = valueOf(option, value);
      m_Result.m_ReturnParameterFile = option == returnParameters ? given : m_Result.m_ReturnParameterFile;
      return;
    }
    const ModuleParameter & parameter = parameterOf(option);
    if (parameter.kind == ValueKind::Flag)
    {
      if (value && *value != "true" && *value != "false")
      {
        refuse(option + " takes true or false, not " + *value);
      }
      m_Result.m_Values[parameter.name] = value.value_or("true");
      return;
    }
    take(parameter, option, valueOf(option, value));
  }

  [[nodiscard]] std::string
  valueOf(const std::string & option, const std::optional<std::string> & attached)
  {
    if (attached)
    {
      return *attached;
    }
    if (m_Next == m_Words.size())
    {
      refuse(option + " needs a value");
    }
    return m_Words[m_Next++];
  }

  [[nodiscard]] const ModuleParameter &
  parameterOf(const std::string & option) const
  {
    for (const ParameterGroup & group : m_Result.m_Description.groups)
    {
      for (const ModuleParameter & parameter : group.parameters)
      {
        if ((!parameter.longFlag.empty() && option == "--" + parameter.longFlag) ||
            (!parameter.flag.empty() && option == "-" + parameter.flag))
        {
          return parameter;
        }
      }
    }
    refuse("no option " + option);
  }

  void
  take(const ModuleParameter & parameter, const std::string & as, const std::string & value)
  {
    const std::string fault = faultOfValue(parameter, value);
    if (!fault.empty())
    {
      refuse(as + ": " + fault);
    }
    m_Result.m_Values[parameter.name] = value;
  }

  void
  takeArguments()
  {
    std::map<int, const ModuleParameter *> places;
    for (const ParameterGroup & group : m_Result.m_Description.groups)
    {
      for (const ModuleParameter & parameter : group.parameters)
      {
        if (parameter.index)
        {
          places[*parameter.index] = &parameter;
        }
      }
    }
    if (m_Arguments.size() > places.size())
    {
      refuse("too many arguments: " + m_Arguments[places.size()]);
    }
    for (const auto & [index, parameter] : places)
    {
      const auto place = static_cast<std::size_t>(index);
      if (place >= m_Arguments.size())
      {
        refuse(parameter->name + " is missing");
      }
      take(*parameter, parameter->name, m_Arguments[place]);
    }
  }

  ModuleArguments &                m_Result;
  const std::vector<std::string> & m_Words;
  std::size_t                      m_Next{ 0 };
  bool                             m_OnlyArguments{ false };
  std::set<std::string>            m_Seen;
  std::vector<std::string>         m_Arguments;
};

ModuleArguments::ModuleArguments(const ModuleDescription & description, const std::vector<std::string> & words)
  : m_Description(description)
{
  for (const ParameterGroup & group : description.groups)
  {
    for (const ModuleParameter & parameter : group.parameters)
    {
      m_Values[parameter.name] = parameter.defaultValue;
    }
  }
  Reader(*this, words).read();
}

bool
ModuleArguments::has(const std::string & name) const
{
  return !m_Values.at(name).empty();
}

std::string
ModuleArguments::text(const std::string & name) const
{
  return m_Values.at(name);
}

long long
ModuleArguments::integer(const std::string & name) const
{
  return integerOf(m_Values.at(name)).value();
}

double
ModuleArguments::real(const std::string & name) const
{
  return realOf(m_Values.at(name)).value();
}

bool
ModuleArguments::flag(const std::string & name) const
{
  return m_Values.at(name) == "true";
}

} // namespace moserhex::slicer
