#pragma once

#include "moserhex/Quality/HexQuality.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace moserhex::results
{

/** What the tables say of a mesh. */
struct MeshNumbers
{
  double cells{ 0.0 };
  double variance{ 0.0 };         ///< of volume / mean [1]
  double concavePercent{ 0.0 };   ///< cells with det J <= 0 at a corner
  double certifiedPercent{ 0.0 }; ///< cells with det J > 0 everywhere, proven
  double smallestJacobian{ 0.0 }; ///< scaled [1]
  double medianJacobian{ 0.0 };   ///< scaled [1]
  double meanJacobian{ 0.0 };     ///< scaled [1]
  double volumeError{ 0.0 };      ///< |mesh / label - 1| [1]
  double boundary{ 0.0 };         ///< largest distance of boundary nodes and face centres to the surface [mm]
  double seconds{ 0.0 };
};

/** Quality and volume; boundary and seconds are left to the caller. */
[[nodiscard]] MeshNumbers
numbersOf(const HexQualitySummary & quality, double labelVolume);

/** The two lines at the top: `firstColumn`, the numbers, `lastColumn`. */
void
writeHeading(std::ostream & os, const std::string & firstColumn, const std::string & lastColumn);

void
writeRow(std::ostream & os, const std::string & name, const MeshNumbers & numbers, const std::string & note = {});

/** A row without numbers. */
void
writeRefusal(std::ostream & os, const std::string & name, const std::string & reason);

/** Per column the median of the rows, and their worst: the smallest of cells, certified and scaled Jacobian, the
 * largest of the others. */
[[nodiscard]] MeshNumbers
medianOf(const std::vector<MeshNumbers> & rows);
[[nodiscard]] MeshNumbers
worstOf(const std::vector<MeshNumbers> & rows);

} // namespace moserhex::results
