#pragma once

#include "Summary.h"

#include <string>

namespace moserhex::app
{

/** The group's figures as a table for people: how many cases are what, failures by code, quantiles, hours. */
[[nodiscard]] std::string
describe(const GroupFigures & group);

} // namespace moserhex::app
