#include "PanelKernels.h"

#include "LineTransform.h"

#include "moserhex/Common/Lanes.h"

#include <algorithm>
#include <cstring>

namespace moserhex
{
namespace
{

static_assert(linesTogether % static_cast<Eigen::Index>(laneCount) == 0, "kernels take eight lines at a time");

/** Results summed at the same time: they fit the registers of AVX2. */
constexpr std::size_t widest = 6;

/** TWidth results of eight lines. */
template <std::size_t TWidth>
MOSERHEX_INLINE void
multiplyBlock(const double * factors,
              std::size_t    terms,
              const double * in,
              std::size_t    inStride,
              double *       out,
              std::size_t    outStride)
{
  Lanes sums[TWidth]{};
  for (std::size_t k = 0; k < terms; ++k)
  {
    const Lanes value = loadLanes(in + k * inStride);
    for (std::size_t a = 0; a < TWidth; ++a)
    {
      sums[a] += factors[a * terms + k] * value;
    }
  }
  for (std::size_t a = 0; a < TWidth; ++a)
  {
    storeLanes(out + a * outStride, sums[a]);
  }
}

MOSERHEX_KERNEL void
multiply(const double * factors,
         std::size_t    results,
         std::size_t    terms,
         const double * in,
         std::size_t    inStride,
         double *       out,
         std::size_t    outStride,
         std::size_t    lanes)
{
  const std::size_t blocks = (results + widest - 1) / widest;
  for (std::size_t block = 0; block < blocks; ++block)
  {
    const std::size_t first = block * results / blocks;
    const std::size_t width = (block + 1) * results / blocks - first;
    const double *    rows = factors + first * terms;
    double *          to = out + first * outStride;
    for (std::size_t lane = 0; lane < lanes; lane += laneCount)
    {
      switch (width)
      {
        case 1:
          multiplyBlock<1>(rows, terms, in + lane, inStride, to + lane, outStride);
          break;
        case 2:
          multiplyBlock<2>(rows, terms, in + lane, inStride, to + lane, outStride);
          break;
        case 3:
          multiplyBlock<3>(rows, terms, in + lane, inStride, to + lane, outStride);
          break;
        case 4:
          multiplyBlock<4>(rows, terms, in + lane, inStride, to + lane, outStride);
          break;
        case 5:
          multiplyBlock<5>(rows, terms, in + lane, inStride, to + lane, outStride);
          break;
        default:
          multiplyBlock<widest>(rows, terms, in + lane, inStride, to + lane, outStride);
          break;
      }
    }
  }
}

constexpr std::size_t tile = 4;
using TileRow = double __attribute__((vector_size(8 * tile)));

/** The chosen values of a and b, counted through. */
template <int... TFrom>
MOSERHEX_INLINE TileRow
shuffled(TileRow a, TileRow b)
{
#if defined(__clang__) || __GNUC__ >= 12
  return __builtin_shufflevector(a, b, TFrom...);
#else
  using Order = long long __attribute__((vector_size(8 * tile)));
  return __builtin_shuffle(a, b, Order{ TFrom... });
#endif
}

MOSERHEX_INLINE TileRow
loadTileRow(const double * from)
{
  TileRow row;
  std::memcpy(&row, from, sizeof row);
  return row;
}

MOSERHEX_INLINE void
transposeTile(const double * from, std::size_t fromStride, double * to, std::size_t toStride)
{
  const TileRow a = loadTileRow(from);
  const TileRow b = loadTileRow(from + fromStride);
  const TileRow c = loadTileRow(from + 2 * fromStride);
  const TileRow d = loadTileRow(from + 3 * fromStride);
  const TileRow abEvens = shuffled<0, 4, 2, 6>(a, b);
  const TileRow abOdds = shuffled<1, 5, 3, 7>(a, b);
  const TileRow cdEvens = shuffled<0, 4, 2, 6>(c, d);
  const TileRow cdOdds = shuffled<1, 5, 3, 7>(c, d);
  const TileRow columns[tile] = { shuffled<0, 1, 4, 5>(abEvens, cdEvens),
                                  shuffled<0, 1, 4, 5>(abOdds, cdOdds),
                                  shuffled<2, 3, 6, 7>(abEvens, cdEvens),
                                  shuffled<2, 3, 6, 7>(abOdds, cdOdds) };
  for (std::size_t i = 0; i < tile; ++i)
  {
    std::memcpy(to + i * toStride, &columns[i], sizeof columns[i]);
  }
}

MOSERHEX_KERNEL void
transpose(const double * from,
          std::size_t    fromStride,
          std::size_t    lines,
          std::size_t    n,
          double *       to,
          std::size_t    toStride)
{
  const std::size_t tiledLines = lines / tile * tile;
  const std::size_t tiledLength = n / tile * tile;
  for (std::size_t line = 0; line < tiledLines; line += tile)
  {
    for (std::size_t i = 0; i < tiledLength; i += tile)
    {
      transposeTile(from + line * fromStride + i, fromStride, to + i * toStride + line, toStride);
    }
  }
  for (std::size_t line = 0; line < lines; ++line)
  {
    for (std::size_t i = line < tiledLines ? tiledLength : 0; i < n; ++i)
    {
      to[i * toStride + line] = from[line * fromStride + i];
    }
  }
}

/** Of whole columns. */
MOSERHEX_KERNEL void
sumAndDifference(const double * a,
                 const double * b,
                 double         sumScale,
                 double         differenceScale,
                 double *       sum,
                 double *       difference,
                 std::size_t    lanes)
{
  for (std::size_t lane = 0; lane < lanes; lane += laneCount)
  {
    const Lanes x = loadLanes(a + lane);
    const Lanes y = loadLanes(b + lane);
    storeLanes(sum + lane, sumScale * (x + y));
    storeLanes(difference + lane, differenceScale * (x - y));
  }
}

MOSERHEX_KERNEL void
weightedSumAndDifference(const double * a,
                         const double * b,
                         double         aScale,
                         double         bScale,
                         double *       sum,
                         double *       difference,
                         std::size_t    lanes)
{
  for (std::size_t lane = 0; lane < lanes; lane += laneCount)
  {
    const Lanes x = aScale * loadLanes(a + lane);
    const Lanes y = bScale * loadLanes(b + lane);
    storeLanes(sum + lane, x + y);
    storeLanes(difference + lane, x - y);
  }
}

double *
column(const PanelColumns & columns, std::size_t i)
{
  return columns.values + i * columns.stride;
}

} // namespace

void
multiplyColumns(const FactorMatrix & factors, const PanelColumns & in, const PanelColumns & out, std::size_t lanes)
{
  multiply(factors.data(),
           static_cast<std::size_t>(factors.rows()),
           static_cast<std::size_t>(factors.cols()),
           in.values,
           in.stride,
           out.values,
           out.stride,
           lanes);
}

void
transposeLines(const double * from,
               std::size_t    fromStride,
               std::size_t    lines,
               std::size_t    n,
               double *       to,
               std::size_t    toStride)
{
  transpose(from, fromStride, lines, n, to, toStride);
}

void
foldColumns(const PanelColumns & lines,
            std::size_t          n,
            std::size_t          lanes,
            const FoldScales &   scales,
            const PanelColumns & even,
            const PanelColumns & odd)
{
  for (std::size_t i = 0; i < n / 2; ++i)
  {
    sumAndDifference(
      column(lines, i), column(lines, n - 1 - i), scales.even, scales.odd, column(even, i), column(odd, i), lanes);
  }
  if (n % 2 == 1)
  {
    std::copy_n(column(lines, n / 2), lanes, column(even, n / 2));
  }
}

void
unfoldColumns(const PanelColumns & even,
              const PanelColumns & odd,
              std::size_t          n,
              std::size_t          lanes,
              const FoldScales &   scales,
              const PanelColumns & lines)
{
  for (std::size_t i = 0; i < n / 2; ++i)
  {
    weightedSumAndDifference(
      column(even, i), column(odd, i), scales.even, scales.odd, column(lines, i), column(lines, n - 1 - i), lanes);
  }
  if (n % 2 == 1)
  {
    std::copy_n(column(even, n / 2), lanes, column(lines, n / 2));
  }
}

} // namespace moserhex
