#include "MeshNumbers.h"

#include "ResultsRun.h"

#include <array>
#include <cmath>
#include <ostream>

namespace moserhex::results
{
namespace
{

struct Column
{
  const char * title;
  double MeshNumbers::*value;
  int                  digits; ///< after the point; negative: two significant digits
  bool                 smallIsBad;
};

constexpr int significantDigits = -1;

constexpr std::array<Column, 10> columns{ {
  { "cells", &MeshNumbers::cells, 0, true },
  { "vol. var.", &MeshNumbers::variance, significantDigits, false },
  { "% concave", &MeshNumbers::concavePercent, 2, false },
  { "% certified", &MeshNumbers::certifiedPercent, 2, true },
  { "SJ min", &MeshNumbers::smallestJacobian, 3, true },
  { "SJ median", &MeshNumbers::medianJacobian, 3, true },
  { "SJ mean", &MeshNumbers::meanJacobian, 3, true },
  { "volume error", &MeshNumbers::volumeError, significantDigits, false },
  { "boundary max (mm)", &MeshNumbers::boundary, 2, false },
  { "time (s)", &MeshNumbers::seconds, 2, false },
} };

std::vector<double>
valuesOf(const std::vector<MeshNumbers> & rows, const Column & column, double factor = 1.0)
{
  std::vector<double> values;
  for (const MeshNumbers & row : rows)
  {
    values.push_back(factor * row.*column.value);
  }
  return values;
}

} // namespace

MeshNumbers
numbersOf(const HexQualitySummary & quality, double labelVolume)
{
  MeshNumbers numbers;
  numbers.cells = static_cast<double>(quality.cells);
  numbers.variance = quality.volumeVariance;
  numbers.concavePercent = quality.concavePercent;
  numbers.certifiedPercent = 100.0 * static_cast<double>(quality.certified.positive) / numbers.cells;
  numbers.smallestJacobian = quality.scaledJacobian.minimum;
  numbers.medianJacobian = quality.scaledJacobian.median;
  numbers.meanJacobian = quality.scaledJacobian.mean;
  numbers.volumeError = std::abs(quality.volume / labelVolume - 1.0);
  return numbers;
}

void
writeHeading(std::ostream & os, const std::string & firstColumn, const std::string & lastColumn)
{
  os << "| " << firstColumn << " |";
  for (const Column & column : columns)
  {
    os << ' ' << column.title << " |";
  }
  os << ' ' << lastColumn << " |\n|";
  for (std::size_t column = 0; column < columns.size() + 2; ++column)
  {
    os << " --- |";
  }
  os << '\n';
}

void
writeRow(std::ostream & os, const std::string & name, const MeshNumbers & numbers, const std::string & note)
{
  os << "| " << name << " |";
  for (const Column & column : columns)
  {
    const double value = numbers.*column.value;
    os << ' ' << (column.digits < 0 ? significant(value) : fixed(value, column.digits)) << " |";
  }
  os << ' ' << note << " |\n";
}

void
writeRefusal(std::ostream & os, const std::string & name, const std::string & reason)
{
  os << "| " << name << " |";
  for (std::size_t column = 0; column < columns.size(); ++column)
  {
    os << " - |";
  }
  os << " refused: " << reason << " |\n";
}

MeshNumbers
medianOf(const std::vector<MeshNumbers> & rows)
{
  MeshNumbers median;
  for (const Column & column : columns)
  {
    median.*column.value = medianOf(valuesOf(rows, column));
  }
  return median;
}

MeshNumbers
worstOf(const std::vector<MeshNumbers> & rows)
{
  MeshNumbers worst;
  for (const Column & column : columns)
  {
    const double sign = column.smallIsBad ? -1.0 : 1.0;
    worst.*column.value = sign * largestOf(valuesOf(rows, column, sign));
  }
  return worst;
}

} // namespace moserhex::results
