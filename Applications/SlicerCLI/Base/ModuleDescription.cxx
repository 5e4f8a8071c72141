#include "ModuleDescription.h"

#include "ModuleValues.h"
#include "moserhex/Common/Errors.h"

#include <expat.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <memory>
#include <set>

namespace moserhex::slicer
{
namespace
{

constexpr std::size_t coordinatesOfPoint = 3;
constexpr std::size_t numbersOfRegion = 6; // its centre and its half sides

struct ElementType
{
  ValueKind   kind;
  bool        isList;
  std::size_t listSize;
};

const std::map<std::string, ElementType> types{
  { "boolean", { ValueKind::Flag, false, 0 } },
  { "integer", { ValueKind::Integer, false, 0 } },
  { "integer-enumeration", { ValueKind::Integer, false, 0 } },
  { "integer-vector", { ValueKind::Integer, true, 0 } },
  { "float", { ValueKind::Real, false, 0 } },
  { "float-enumeration", { ValueKind::Real, false, 0 } },
  { "float-vector", { ValueKind::Real, true, 0 } },
  { "double", { ValueKind::Real, false, 0 } },
  { "double-enumeration", { ValueKind::Real, false, 0 } },
  { "double-vector", { ValueKind::Real, true, 0 } },
  { "string", { ValueKind::Text, false, 0 } },
  { "string-enumeration", { ValueKind::Text, false, 0 } },
  { "string-vector", { ValueKind::Text, true, 0 } },
  { "point", { ValueKind::Real, true, coordinatesOfPoint } },
  { "region", { ValueKind::Real, true, numbersOfRegion } },
  { "pointfile", { ValueKind::File, false, 0 } },
  { "image", { ValueKind::File, false, 0 } },
  { "geometry", { ValueKind::File, false, 0 } },
  { "transform", { ValueKind::File, false, 0 } },
  { "table", { ValueKind::File, false, 0 } },
  { "measurement", { ValueKind::File, false, 0 } },
  { "file", { ValueKind::File, false, 0 } },
  { "directory", { ValueKind::File, false, 0 } },
};

/** Attributes that say something to Slicer only. */
const std::set<std::string> attributesForSlicer{ "type", "reference", "hidden", "aggregate" };

bool
hasPlace(const std::string & element)
{
  return element == "point" || element == "pointfile" || element == "region";
}

bool
endsWith(const std::string & text, const std::string & end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/** Options that every module has. */
const std::set<std::string> reservedNames{
  "xml", "help", "version", "echo", "logo", "returnparameterfile", "ignore_rest", "processinformationaddress"
};

std::string
trimmed(const std::string & text)
{
  const char * const white = " \t\r\n";
  const auto         begin = text.find_first_not_of(white);
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(white) - begin + 1);
}

std::vector<std::string>
splitAtCommas(const std::string & text)
{
  std::vector<std::string> parts;
  std::size_t              begin = 0;
  while (begin < text.size())
  {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    parts.push_back(trimmed(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return parts;
}

/** Follows the parser through the document. What it throws must not cross the C library: the first fault is kept. */
class Builder
{
public:
  explicit Builder(XML_Parser parser) : m_Parser(parser)
  {}

  void
  begin(const std::string & element, const std::map<std::string, std::string> & attributes)
  {
    m_Text.clear();
    m_Path.push_back(element);
    if (m_Path.size() == 1 && element != "executable")
    {
      refuse("the document is <" + element + ">, need <executable>");
    }
    if (m_Path.size() == 2 && element == "parameters")
    {
      const auto advanced = attributes.find("advanced");
      m_Result.groups.push_back({ "", "", advanced != attributes.end() && advanced->second == "true", {} });
    }
    if (m_Path.size() == 3 && m_Path[1] == "parameters" && element != "label" && element != "description")
    {
      beginParameter(element, attributes);
    }
  }

  void
  end()
  {
    const std::string element = m_Path.back();
    const std::string text = trimmed(m_Text);
    m_Text.clear();
    if (m_Path.size() == 2 && element != "parameters")
    {
      setOfModule(element, text);
    }
    else if (m_Path.size() == 3 && (element == "label" || element == "description"))
    {
      (element == "label" ? m_Result.groups.back().label : m_Result.groups.back().description) = text;
    }
    else if (m_Path.size() == 4)
    {
      setOfParameter(element, text);
    }
    else if (m_Path.size() == 5 && m_Path[3] == "constraints")
    {
      setOfConstraints(element, text);
    }
    m_Path.pop_back();
  }

  void
  addText(const std::string & text)
  {
    m_Text += text;
  }

  [[nodiscard]] const std::string &
  fault() const
  {
    return m_Fault;
  }

  [[nodiscard]] ModuleDescription
  result() const
  {
    return m_Result;
  }

private:
  void
  refuse(const std::string & what)
  {
    if (m_Fault.empty())
    {
      m_Fault = "line " + std::to_string(XML_GetCurrentLineNumber(m_Parser)) + ": " + what;
    }
  }

  ModuleParameter &
  parameter()
  {
    return m_Result.groups.back().parameters.back();
  }

  void
  beginParameter(const std::string & element, const std::map<std::string, std::string> & attributes)
  {
    ModuleParameter added;
    const auto      type = types.find(element);
    added.element = element;
    if (type == types.end())
    {
      refuse("unknown parameter <" + element + ">");
    }
    else
    {
      added.kind = type->second.kind;
      added.isList = type->second.isList;
      added.listSize = type->second.listSize;
      added.coordinateSystem = hasPlace(element) ? "lps" : "";
    }
    for (const auto & [attribute, value] : attributes)
    {
      setAttribute(added, attribute, value);
    }
    m_Result.groups.back().parameters.push_back(added);
  }

  void
  setAttribute(ModuleParameter & added, const std::string & attribute, const std::string & value)
  {
    const std::string & element = added.element;
    if (attribute == "fileExtensions" && added.kind == ValueKind::File)
    {
      added.fileExtensions = splitAtCommas(value);
    }
    else if (attribute == "multiple" && added.kind != ValueKind::Flag && !endsWith(element, "-enumeration") &&
             !endsWith(element, "-vector"))
    {
      if (value != "true" && value != "false")
      {
        refuse("multiple is true or false, not " + value);
      }
      added.isMultiple = value == "true";
    }
    else if (attribute == "coordinateSystem" && hasPlace(element))
    {
      if (value != "lps" && value != "ras" && value != "ijk")
      {
        refuse("coordinateSystem is lps, ras or ijk, not " + value);
      }
      added.coordinateSystem = value;
    }
    else if (attributesForSlicer.count(attribute) == 0)
    {
      refuse("<" + element + "> has no attribute " + attribute);
    }
  }

  void
  setOfModule(const std::string & element, const std::string & text)
  {
    const std::map<std::string, std::string *> fields{ { "category", &m_Result.category },
                                                       { "title", &m_Result.title },
                                                       { "description", &m_Result.description },
                                                       { "version", &m_Result.version },
                                                       { "documentation-url", &m_Result.documentation },
                                                       { "license", &m_Result.license },
                                                       { "contributor", &m_Result.contributor },
                                                       { "acknowledgements", &m_Result.acknowledgements } };
    const auto                                 field = fields.find(element);
    if (field == fields.end())
    {
      refuse("unknown element <" + element + ">");
      return;
    }
    *field->second = text;
  }

  void
  setOfParameter(const std::string & element, const std::string & text)
  {
    ModuleParameter &                          p = parameter();
    const std::map<std::string, std::string *> fields{
      { "name", &p.name },   { "longflag", &p.longFlag },    { "description", &p.description },
      { "label", &p.label }, { "default", &p.defaultValue },
    };
    const auto field = fields.find(element);
    if (field != fields.end())
    {
      *field->second = text;
    }
    else if (element == "flag")
    {
      p.flag = text.substr(text.find_first_not_of('-') == std::string::npos ? 0 : text.find_first_not_of('-'));
    }
    else if (element == "index")
    {
      const std::optional<long long> index = integerOf(text);
      if (!index || *index < 0)
      {
        refuse("index " + text + " is not a number from 0");
      }
      p.index = static_cast<int>(index.value_or(0));
    }
    else if (element == "channel")
    {
      p.isOutput = text == "output";
    }
    else if (element == "element")
    {
      p.choices.push_back(text);
    }
    else if (element != "constraints")
    {
      refuse("unknown element <" + element + "> of a parameter");
    }
  }

  void
  setOfConstraints(const std::string & element, const std::string & text)
  {
    const std::optional<double> bound = realOf(text);
    if (!bound)
    {
      refuse("<" + element + "> is not a number");
    }
    if (element == "minimum")
    {
      parameter().minimum = bound;
    }
    else if (element == "maximum")
    {
      parameter().maximum = bound;
    }
    else if (element != "step")
    {
      refuse("unknown constraint <" + element + ">");
    }
  }

  XML_Parser               m_Parser;
  std::vector<std::string> m_Path;
  std::string              m_Text;
  std::string              m_Fault;
  ModuleDescription        m_Result;
};

[[noreturn]] void
refuse(const std::string & what)
{
  throw InvalidInput("module description: " + what);
}

bool
isIdentifier(const std::string & name)
{
  return !name.empty() && std::isdigit(static_cast<unsigned char>(name.front())) == 0 &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

void
requireSoundMultiple(const ModuleParameter & parameter)
{
  const std::string & name = parameter.name;
  if (parameter.listSize != 0 && parameter.index)
  {
    refuse(name + ": a " + parameter.element + " needs a flag, not an index");
  }
  if (parameter.isMultiple && !parameter.index && parameter.longFlag.empty())
  {
    refuse(name + ": a multiple parameter needs a long flag or an index");
  }
  if (parameter.isMultiple && !parameter.defaultValue.empty())
  {
    refuse(name + ": a multiple parameter has no default");
  }
}

void
requireSound(const ModuleParameter & parameter)
{
  const std::string & name = parameter.name;
  if (!isIdentifier(name))
  {
    refuse("name \"" + name + "\" must be letters, digits and _, a letter first");
  }
  if (!parameter.longFlag.empty() && !isIdentifier(parameter.longFlag))
  {
    refuse(name + ": long flag \"" + parameter.longFlag + "\" must be letters, digits and _");
  }
  if (parameter.kind == ValueKind::Flag && parameter.defaultValue != "false")
  {
    refuse(name + ": a boolean must be false by default");
  }
  requireSoundMultiple(parameter);
  const bool mayBeEmpty = parameter.isList || parameter.isMultiple;
  if (parameter.kind != ValueKind::File && parameter.kind != ValueKind::Flag && !parameter.isSimpleOutput() &&
      !(parameter.kind == ValueKind::Text && parameter.choices.empty()) &&
      !(mayBeEmpty && parameter.defaultValue.empty()))
  {
    const std::string fault = faultOfValue(parameter, parameter.defaultValue);
    if (!fault.empty())
    {
      refuse(name + ": default " + fault);
    }
  }
}

/** Names, flags and indices of all parameters together. */
void
requireSound(const ModuleDescription & description)
{
  std::set<std::string> names;
  std::set<std::string> flags;
  std::set<int>         indices;
  std::optional<int>    multipleIndex;
  for (const ParameterGroup & group : description.groups)
  {
    for (const ModuleParameter & parameter : group.parameters)
    {
      requireSound(parameter);
      const std::string & name = parameter.name;
      if (!names.insert(name).second)
      {
        refuse("name " + name + " is taken twice");
      }
      if (!parameter.flag.empty() && (parameter.flag.size() != 1 || !flags.insert(parameter.flag).second))
      {
        refuse(name + ": flag " + parameter.flag + " must be one character of its own");
      }
      if (!parameter.longFlag.empty() &&
          (reservedNames.count(parameter.longFlag) != 0 || !flags.insert("--" + parameter.longFlag).second))
      {
        refuse(name + ": long flag " + parameter.longFlag + " is taken");
      }
      if (parameter.index && !indices.insert(*parameter.index).second)
      {
        refuse(name + ": index " + std::to_string(*parameter.index) + " is taken");
      }
      if (parameter.index && parameter.isMultiple)
      {
        multipleIndex = std::min(multipleIndex.value_or(*parameter.index), *parameter.index);
      }
      if (!parameter.index && parameter.flag.empty() && parameter.longFlag.empty() && !parameter.isSimpleOutput())
      {
        refuse(name + ": neither flag nor index");
      }
    }
  }
  if (!indices.empty() && *indices.rbegin() + 1 != static_cast<int>(indices.size()))
  {
    refuse("indices must count from 0");
  }
  if (multipleIndex && *multipleIndex != *indices.rbegin())
  {
    refuse("only the last index may be multiple");
  }
}

} // namespace

bool
ModuleParameter::isSimpleOutput() const
{
  return isOutput && kind != ValueKind::File && flag.empty() && longFlag.empty() && !index;
}

const ModuleParameter *
ModuleDescription::find(const std::string & name) const
{
  for (const ParameterGroup & group : groups)
  {
    for (const ModuleParameter & parameter : group.parameters)
    {
      if (parameter.name == name)
      {
        return &parameter;
      }
    }
  }
  return nullptr;
}

ModuleDescription
parseModuleDescription(const std::string & xml)
{
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(XML_ParserCreate(nullptr), XML_ParserFree);
  Builder                                                            builder(parser.get());
  XML_SetUserData(parser.get(), &builder);
  XML_SetElementHandler(
    parser.get(),
    [](void * data, const XML_Char * element, const XML_Char ** attributes) {
      std::map<std::string, std::string> all;
      for (; *attributes != nullptr; attributes += 2)
      {
        all[attributes[0]] = attributes[1];
      }
      static_cast<Builder *>(data)->begin(element, all);
    },
    [](void * data, const XML_Char *) { static_cast<Builder *>(data)->end(); });
  XML_SetCharacterDataHandler(parser.get(), [](void * data, const XML_Char * text, int length) {
    static_cast<Builder *>(data)->addText(std::string(text, static_cast<std::size_t>(length)));
  });
  if (XML_Parse(parser.get(), xml.data(), static_cast<int>(xml.size()), XML_TRUE) != XML_STATUS_OK)
  {
    refuse("line " + std::to_string(XML_GetCurrentLineNumber(parser.get())) + ": " +
           XML_ErrorString(XML_GetErrorCode(parser.get())));
  }
  if (!builder.fault().empty())
  {
    refuse(builder.fault());
  }
  const ModuleDescription description = builder.result();
  requireSound(description);
  return description;
}

} // namespace moserhex::slicer
