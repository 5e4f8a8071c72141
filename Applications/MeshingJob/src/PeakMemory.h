#pragma once

#include <optional>

namespace moserhex::app
{

/** The most memory that this process has held so far, without that of the program that started it [MiB]; empty where
 * the system does not say. */
[[nodiscard]] std::optional<double>
peakMemory();

} // namespace moserhex::app
