#pragma once

#include <array>

namespace moserhex::detail
{

/** The six tetrahedra of a cube as paths of corners; a corner is three bits (i, j, k). The first three are positively
 * oriented on a right-handed grid, the last three negatively. */
inline constexpr std::array<std::array<unsigned int, 4>, 6> kuhnPaths{ { { { 0, 1, 3, 7 } },
                                                                         { { 0, 2, 6, 7 } },
                                                                         { { 0, 4, 5, 7 } },
                                                                         { { 0, 1, 5, 7 } },
                                                                         { { 0, 4, 6, 7 } },
                                                                         { { 0, 2, 3, 7 } } } };
inline constexpr int                                        positiveKuhnPaths = 3;

} // namespace moserhex::detail
