#pragma once

#include <string>
#include <vector>

namespace moserhex
{

/** An array under a name of its own. One that is written has 1, 3, 6 or 9 components. */
struct NamedArray
{
  std::string         name; ///< of one that is written: not that of another, ours (LatticeIndex, ...) among them
  int                 components{ 1 }; ///< 3: vector; 6: symmetric tensor xx yy zz xy yz xz; 9: tensor by rows
  std::vector<double> values;          ///< components x nodes, cells or 1, those of one together; NaN: no value
};

} // namespace moserhex
