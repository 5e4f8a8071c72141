#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace moserhex::slicer
{

/** How the value of a parameter is written. */
enum class ValueKind
{
  Flag,    ///< boolean: given or not
  Integer, ///< integer, its enumeration and its vector
  Real,    ///< float, double, their enumerations and vectors, point, region
  Text,    ///< string, its enumeration and its vector
  File     ///< image, geometry, transform, table, measurement, pointfile, file, directory
};

struct ModuleParameter
{
  std::string              element; ///< of the XML: "integer", "image", ...
  ValueKind                kind{ ValueKind::Text };
  std::string              name;
  std::string              flag;     ///< one character, without its dash; empty: none
  std::string              longFlag; ///< without its dashes; empty: none
  std::optional<int>       index;    ///< of an argument without a flag
  std::string              description;
  std::string              label;
  std::string              defaultValue;
  bool                     isOutput{ false };
  bool                     isList{ false };     ///< a vector, point or region: commas between its elements
  std::size_t              listSize{ 0 };       ///< elements of a list: 3 of a point, 6 of a region; 0: any number
  bool                     isMultiple{ false }; ///< may be given more than once, or with commas between its values
  std::string              coordinateSystem; ///< of a point, pointfile or region: lps, ras or ijk; empty: none of these
  std::vector<std::string> choices;          ///< of an enumeration
  std::optional<double>    minimum;
  std::optional<double>    maximum;
  std::vector<std::string> fileExtensions; ///< with their dots; empty: any

  /** A number or text that the module hands back in the return parameter file. */
  [[nodiscard]] bool
  isSimpleOutput() const;
};

struct ParameterGroup
{
  std::string                  label;
  std::string                  description;
  bool                         isAdvanced{ false };
  std::vector<ModuleParameter> parameters;
};

/** A module of 3D Slicer's execution model, as its XML describes it. */
struct ModuleDescription
{
  std::string                 category;
  std::string                 title;
  std::string                 description;
  std::string                 version;
  std::string                 documentation;
  std::string                 license;
  std::string                 contributor;
  std::string                 acknowledgements;
  std::vector<ParameterGroup> groups;

  /** nullptr: none of that name. */
  [[nodiscard]] const ModuleParameter *
  find(const std::string & name) const;
};

/** Reads the XML of the execution model (www.slicer.org, SlicerExecutionModel): all types of parameters.
 * \throws InvalidInput  not well-formed, an element or an attribute that is not known, a name that is missing, taken or
 * holds anything but letters, digits and _, a flag of a boolean that is on by default, indices that do not count from
 * 0, a default outside its choices or range; multiple="true" of a flag, an enumeration or a vector, with a default,
 * without long flag and index, or with an index that is not the last; a point or region with an index; names the line
 * or the parameter */
[[nodiscard]] ModuleDescription
parseModuleDescription(const std::string & xml);

} // namespace moserhex::slicer
