#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace moserhex
{

/** A file of the NetCDF classic format with 64-bit offsets (CDF-2), put together in memory: what Exodus II is made of.
 *
 * Variables over the record dimension must be added behind all others, and have one record. */
class NetcdfFile
{
public:
  using Dimension = std::int32_t;

  /** \param length  > 0 */
  [[nodiscard]] Dimension
  addDimension(std::string_view name, std::size_t length);

  /** The dimension of unlimited length; here it is 1. */
  [[nodiscard]] Dimension
  addRecordDimension(std::string_view name);

  void
  addAttribute(std::string_view name, std::string_view text);
  void
  addAttribute(std::string_view name, std::int32_t value);
  void
  addAttribute(std::string_view name, float value);

  /** An attribute of the variable that was added last. */
  void
  addVariableAttribute(std::string_view name, std::string_view text);

  void
  addVariable(std::string_view name, std::vector<Dimension> dimensions, const std::vector<double> & values);
  void
  addVariable(std::string_view name, std::vector<Dimension> dimensions, const std::vector<std::int32_t> & values);

  /** Texts, each filled up with zeros to the length of the last dimension; one that does not fit is cut. */
  void
  addTexts(std::string_view name, std::vector<Dimension> dimensions, const std::vector<std::string> & texts);

  [[nodiscard]] std::string
  bytes() const;

private:
  struct DimensionEntry
  {
    std::string name;
    std::size_t length; ///< 0: the record dimension
  };

  struct AttributeList
  {
    std::int32_t count{ 0 };
    std::string  bytes;
  };

  struct Variable
  {
    std::string            name;
    std::vector<Dimension> dimensions;
    AttributeList          attributes;
    std::int32_t           type;
    std::string            data; ///< big-endian, filled up to a multiple of 4
  };

  [[nodiscard]] std::string
  headerFor(const std::vector<std::uint64_t> & begins) const;

  std::vector<DimensionEntry> m_Dimensions;
  AttributeList               m_Attributes;
  std::vector<Variable>       m_Variables;
};

} // namespace moserhex
