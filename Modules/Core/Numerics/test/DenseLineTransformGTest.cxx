// Memory: what the allocator says, in bytes.
#include "LineTransform.h"

#include "RandomField.h"
#include "moserhex/Common/InstructionSets.h"

#include <gtest/gtest.h>

#include <features.h>

#if defined(__GLIBC_PREREQ) && !MOSERHEX_INSTRUMENTED
#if __GLIBC_PREREQ(2, 33)
#include <malloc.h>
#define HAS_MALLINFO2
#endif
#endif

using namespace moserhex;
using Basis = CubeTransform::Basis;

namespace
{

LinePanel
randomPanel(int n)
{
  return Eigen::Map<const LinePanel>(randomField(linesTogether * n, 1).data(), linesTogether, n);
}

} // namespace

TEST(DenseLineTransform, ACloneGivesTheSameBytesWithoutItsOriginal)
{
  for (const Basis basis : { Basis::Cosine, Basis::Sine })
  {
    for (const int n : { 1, 7, 24, 47, 48 }) // folded once, twice
    {
      auto       original = makeDenseLineTransform(n, basis);
      const auto clone = original->clone();
      LinePanel  expected = randomPanel(n);
      LinePanel  panel = expected;
      original->forward(expected);
      original.reset();
      clone->forward(panel);
      EXPECT_TRUE(panel == expected) << n;
      clone->inverse(panel);
      EXPECT_LE((panel - randomPanel(n)).cwiseAbs().maxCoeff(), 1e-13) << n;
    }
  }
}

TEST(DenseLineTransform, ACloneSharesItsTables)
{
#ifdef HAS_MALLINFO2
  const auto inUse = [] {
    const auto info = mallinfo2();
    return info.uordblks + info.hblkhd;
  };
  constexpr int n = 500;
  const auto    original = makeDenseLineTransform(n, Basis::Cosine);
  const auto    before = inUse();
  const auto    clone = original->clone();
  const auto    after = inUse();
  EXPECT_LT(after - before, 8u * n); // the tables: n^2 and more
#else
  GTEST_SKIP() << "the allocator does not say";
#endif
}
