#pragma once

#include "ModuleDescription.h"

#include <optional>
#include <string>
#include <vector>

namespace moserhex::slicer
{

/** The whole text as a number; nothing where it is none, or not finite. */
[[nodiscard]] std::optional<long long>
integerOf(const std::string & text);
[[nodiscard]] std::optional<double>
realOf(const std::string & text);

/** The elements of a value: "1,2" is two of a vector, and "a.vtk,b.vtk" two of a parameter that may be multiple. Commas
 * between quotation marks do not divide a text or a file's name. An empty list has none. */
[[nodiscard]] std::vector<std::string>
elementsOf(const ModuleParameter & parameter, const std::string & value);

/** What is wrong with a value: "300 is not in 2 to 64"; empty when nothing is. */
[[nodiscard]] std::string
faultOfValue(const ModuleParameter & parameter, const std::string & value);

/** "2 to 64", "repair, reject"; empty where anything will do. */
[[nodiscard]] std::string
rangeOf(const ModuleParameter & parameter);

} // namespace moserhex::slicer
