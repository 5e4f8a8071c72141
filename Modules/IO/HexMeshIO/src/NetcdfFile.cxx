#include "NetcdfFile.h"

#include <cstring>
#include <utility>

namespace moserhex
{
namespace
{

// The numbers of the format's specification ("NetCDF Classic Format").
constexpr std::int32_t dimensionTag = 10;
constexpr std::int32_t variableTag = 11;
constexpr std::int32_t attributeTag = 12;
constexpr std::int32_t charType = 2;
constexpr std::int32_t intType = 4;
constexpr std::int32_t floatType = 5;
constexpr std::int32_t doubleType = 6;

template <typename TUnsigned>
void
putUnsigned(std::string & bytes, TUnsigned value)
{
  for (int shift = 8 * static_cast<int>(sizeof(TUnsigned)) - 8; shift >= 0; shift -= 8)
  {
    bytes += static_cast<char>((value >> shift) & 0xFFu);
  }
}

void
putInt(std::string & bytes, std::int32_t value)
{
  putUnsigned(bytes, static_cast<std::uint32_t>(value));
}

void
putSize(std::string & bytes, std::size_t size)
{
  putUnsigned(bytes, static_cast<std::uint32_t>(size));
}

void
fillUp(std::string & bytes)
{
  bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
}

/** Length and characters. */
void
putText(std::string & bytes, std::string_view text)
{
  putSize(bytes, text.size());
  bytes += text;
  fillUp(bytes);
}

void
putTextAttribute(std::string & bytes, std::string_view name, std::string_view text)
{
  putText(bytes, name);
  putInt(bytes, charType);
  putText(bytes, text);
}

/** A list of `count` entries, or the format's way to say that there is none. */
void
putList(std::string & bytes, std::int32_t tag, std::size_t count, std::string_view entries)
{
  putInt(bytes, count == 0 ? 0 : tag);
  putSize(bytes, count);
  bytes += entries;
}

} // namespace

NetcdfFile::Dimension
NetcdfFile::addDimension(std::string_view name, std::size_t length)
{
  m_Dimensions.push_back({ std::string(name), length });
  return static_cast<Dimension>(m_Dimensions.size() - 1);
}

NetcdfFile::Dimension
NetcdfFile::addRecordDimension(std::string_view name)
{
  return addDimension(name, 0);
}

void
NetcdfFile::addAttribute(std::string_view name, std::string_view text)
{
  putTextAttribute(m_Attributes.bytes, name, text);
  ++m_Attributes.count;
}

void
NetcdfFile::addAttribute(std::string_view name, std::int32_t value)
{
  putText(m_Attributes.bytes, name);
  putInt(m_Attributes.bytes, intType);
  putInt(m_Attributes.bytes, 1);
  putInt(m_Attributes.bytes, value);
  ++m_Attributes.count;
}

void
NetcdfFile::addAttribute(std::string_view name, float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  putText(m_Attributes.bytes, name);
  putInt(m_Attributes.bytes, floatType);
  putInt(m_Attributes.bytes, 1);
  putUnsigned(m_Attributes.bytes, bits);
  ++m_Attributes.count;
}

void
NetcdfFile::addVariableAttribute(std::string_view name, std::string_view text)
{
  AttributeList & attributes = m_Variables.back().attributes;
  putTextAttribute(attributes.bytes, name, text);
  ++attributes.count;
}

void
NetcdfFile::addVariable(std::string_view name, std::vector<Dimension> dimensions, const std::vector<double> & values)
{
  std::string data;
  data.reserve(8 * values.size());
  for (const double value : values)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    putUnsigned(data, bits);
  }
  m_Variables.push_back({ std::string(name), std::move(dimensions), {}, doubleType, std::move(data) });
}

void
NetcdfFile::addVariable(std::string_view                  name,
                        std::vector<Dimension>            dimensions,
                        const std::vector<std::int32_t> & values)
{
  std::string data;
  data.reserve(4 * values.size());
  for (const std::int32_t value : values)
  {
    putInt(data, value);
  }
  m_Variables.push_back({ std::string(name), std::move(dimensions), {}, intType, std::move(data) });
}

void
NetcdfFile::addTexts(std::string_view name, std::vector<Dimension> dimensions, const std::vector<std::string> & texts)
{
  const std::size_t length = m_Dimensions[static_cast<std::size_t>(dimensions.back())].length;
  std::string       data;
  for (std::string text : texts)
  {
    text.resize(length, '\0');
    data += text;
  }
  fillUp(data);
  m_Variables.push_back({ std::string(name), std::move(dimensions), {}, charType, std::move(data) });
}

/** \param begins  where each variable's data begin in the file */
std::string
NetcdfFile::headerFor(const std::vector<std::uint64_t> & begins) const
{
  std::string dimensions;
  for (const DimensionEntry & dimension : m_Dimensions)
  {
    putText(dimensions, dimension.name);
    putSize(dimensions, dimension.length);
  }
  std::string variables;
  for (std::size_t i = 0; i < m_Variables.size(); ++i)
  {
    const Variable & variable = m_Variables[i];
    putText(variables, variable.name);
    putSize(variables, variable.dimensions.size());
    for (const Dimension dimension : variable.dimensions)
    {
      putInt(variables, dimension);
    }
    putList(variables, attributeTag, static_cast<std::size_t>(variable.attributes.count), variable.attributes.bytes);
    putInt(variables, variable.type);
    putSize(variables, variable.data.size());
    putUnsigned(variables, begins[i]);
  }
  std::string header = "CDF\x02";
  putInt(header, 1); // records
  putList(header, dimensionTag, m_Dimensions.size(), dimensions);
  putList(header, attributeTag, static_cast<std::size_t>(m_Attributes.count), m_Attributes.bytes);
  putList(header, variableTag, m_Variables.size(), variables);
  return header;
}

std::string
NetcdfFile::bytes() const
{
  std::vector<std::uint64_t> begins(m_Variables.size());
  std::uint64_t              next = headerFor(begins).size(); // as long with any numbers
  for (std::size_t i = 0; i < m_Variables.size(); ++i)
  {
    begins[i] = next;
    next += m_Variables[i].data.size();
  }
  std::string result = headerFor(begins);
  result.reserve(next);
  for (const Variable & variable : m_Variables)
  {
    result += variable.data;
  }
  return result;
}

} // namespace moserhex
