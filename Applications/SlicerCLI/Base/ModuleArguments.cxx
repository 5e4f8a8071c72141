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
    if (option == returnParameters || option == processInformation)
    {
      requireFirst(option, option);
      const std::string given = valueOf(option, value);
      m_Result.m_ReturnParameterFile = option == returnParameters ? given : m_Result.m_ReturnParameterFile;
      return;
    }
    const ModuleParameter & parameter = parameterOf(option);
    if (!parameter.isMultiple)
    {
      requireFirst(parameter.name, option);
    }
    if (parameter.kind == ValueKind::Flag)
    {
      if (value && *value != "true" && *value != "false")
      {
        refuse(option + " takes true or false, not " + *value);
      }
      m_Result.m_Values[parameter.name] = { value.value_or("true") };
      return;
    }
    take(parameter, option, valueOf(option, value));
  }

  /** Its long and its short flag are one and the same. */
  void
  requireFirst(const std::string & what, const std::string & option)
  {
    if (!m_Seen.insert(what).second)
    {
      refuse(option + " is given twice");
    }
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
    std::vector<std::string> & values = m_Result.m_Values[parameter.name];
    if (!parameter.isMultiple)
    {
      values.clear();
    }
    values.push_back(value);
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
    const bool takesAll = !places.empty() && places.rbegin()->second->isMultiple;
    if (m_Arguments.size() > places.size() && !takesAll)
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
      const std::size_t end = parameter->isMultiple ? m_Arguments.size() : place + 1;
      for (std::size_t i = place; i < end; ++i)
      {
        take(*parameter, parameter->name, m_Arguments[i]);
      }
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
      m_Values[parameter.name] = parameter.isMultiple || (parameter.isList && parameter.defaultValue.empty())
                                   ? std::vector<std::string>{}
                                   : std::vector<std::string>{ parameter.defaultValue };
    }
  }
  Reader(*this, words).read();
}

bool
ModuleArguments::has(const std::string & name) const
{
  const std::vector<std::string> & values = m_Values.at(name);
  return std::any_of(values.begin(), values.end(), [](const std::string & value) { return !value.empty(); });
}

std::string
ModuleArguments::text(const std::string & name) const
{
  const std::vector<std::string> & values = m_Values.at(name);
  return values.empty() ? "" : values.front();
}

long long
ModuleArguments::integer(const std::string & name) const
{
  return integerOf(text(name)).value();
}

double
ModuleArguments::real(const std::string & name) const
{
  return realOf(text(name)).value();
}

bool
ModuleArguments::flag(const std::string & name) const
{
  return text(name) == "true";
}

std::vector<std::string>
ModuleArguments::texts(const std::string & name) const
{
  std::vector<std::string> all;
  for (const std::string & value : m_Values.at(name))
  {
    for (const std::string & element : elementsOf(*m_Description.find(name), value))
    {
      all.push_back(element);
    }
  }
  return all;
}

std::vector<long long>
ModuleArguments::integers(const std::string & name) const
{
  std::vector<long long> all;
  for (const std::string & element : texts(name))
  {
    all.push_back(integerOf(element).value());
  }
  return all;
}

std::vector<double>
ModuleArguments::reals(const std::string & name) const
{
  std::vector<double> all;
  for (const std::string & element : texts(name))
  {
    all.push_back(realOf(element).value());
  }
  return all;
}

std::vector<std::array<double, 3>>
ModuleArguments::points(const std::string & name) const
{
  const double                       sign = m_Description.find(name)->coordinateSystem == "ras" ? -1.0 : 1.0;
  const std::vector<double>          numbers = reals(name);
  std::vector<std::array<double, 3>> all;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
  {
    all.push_back({ sign * numbers[i], sign * numbers[i + 1], numbers[i + 2] });
  }
  return all;
}

} // namespace moserhex::slicer
