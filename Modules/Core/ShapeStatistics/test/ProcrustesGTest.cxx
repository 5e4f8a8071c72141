// Copies of one shape to round-off: 1e-9 mm of some 20 mm, the tolerance's share. Determinism: bit for bit.
#include "moserhex/ShapeStatistics/Procrustes.h"

#include "TestShapes.h"
#include "moserhex/Analytic/Refusals.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{

/** Subjects of one shape, turned, moved, of other sizes, and `noise` mm off at every point. */
std::vector<Positions>
subjectsOf(std::size_t count, double largestTurn, double noise)
{
  Random                 random(7);
  const Positions        shape = softCube(4).nodes;
  std::vector<Positions> subjects;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vector3             axis(normalNumber(random), normalNumber(random), normalNumber(random));
    const SimilarityTransform place{ random.uniform(0.8, 1.2),
                                     turnOf(random.uniform(0.0, largestTurn), axis),
                                     5.0 * axis };
    subjects.push_back(transformed(shape, place));
    for (Vector3 & p : subjects.back())
    {
      p += noise * Vector3(normalNumber(random), normalNumber(random), normalNumber(random));
    }
  }
  return subjects;
}

ProcrustesResult
procrustes(const std::vector<Positions> & subjects, AlignmentKind kind, unsigned int threads = 1)
{
  ProcrustesOptions options;
  options.kind = kind;
  options.threads = threads;
  return generalisedProcrustes(
    subjects.size(), [&](std::size_t subject) { return subjects[subject]; }, options);
}

} // namespace

TEST(Procrustes, CopiesOfOneShapeFallTogether)
{
  const auto             subjects = subjectsOf(20, 0.8, 0.0);
  const ProcrustesResult result = procrustes(subjects, AlignmentKind::Similarity);
  EXPECT_TRUE(result.report.converged) << result.report.note;
  EXPECT_LT(result.deviation, 1e-6); // a difference of squares
  for (std::size_t i = 0; i < subjects.size(); ++i)
  {
    const Positions aligned = transformed(subjects[i], result.transforms[i]);
    for (std::size_t a = 0; a < aligned.size(); ++a)
    {
      EXPECT_LT((aligned[a] - result.mean[a]).norm(), 1e-8);
    }
  }
}

TEST(Procrustes, SubjectsTurnedAnyhowFallTogether)
{
  const ProcrustesResult result = procrustes(subjectsOf(12, 3.1, 0.0), AlignmentKind::Similarity);
  EXPECT_TRUE(result.report.converged);
  EXPECT_LT(result.deviation, 1e-6);
}

TEST(Procrustes, SimilarityGivesAllSubjectsTheMeanSize)
{
  const auto             subjects = subjectsOf(9, 0.5, 0.5);
  const ProcrustesResult result = procrustes(subjects, AlignmentKind::Similarity);
  double                 sizes = 0.0;
  for (std::size_t i = 0; i < subjects.size(); ++i)
  {
    sizes += centroidSize(subjects[i]) / 9.0;
    EXPECT_NEAR(centroidSize(transformed(subjects[i], result.transforms[i])), result.size, 1e-9);
  }
  EXPECT_NEAR(result.size, sizes, 1e-10);
}

TEST(Procrustes, TheDeviationIsThatOfTheNoise)
{
  // sqrt(3) mm at every point, less the few degrees of freedom that alignment and mean take.
  EXPECT_NEAR(procrustes(subjectsOf(30, 0.5, 1.0), AlignmentKind::Similarity).deviation, std::sqrt(3.0), 0.1);
}

TEST(Procrustes, TheMeanIsThatOfTheAlignedSubjects)
{
  const auto             subjects = subjectsOf(5, 0.5, 1.0);
  const ProcrustesResult result = procrustes(subjects, AlignmentKind::Rigid);
  Vector3                sum = Vector3::Zero();
  for (std::size_t i = 0; i < subjects.size(); ++i)
  {
    EXPECT_EQ(result.transforms[i].scale, 1.0);
    sum += result.transforms[i](subjects[i][10]) / 5.0;
  }
  EXPECT_LT((sum - result.mean[10]).norm(), 1e-12 * 40.0);
}

TEST(Procrustes, TheOrderOfTheSubjectsDoesNotMatter)
{
  auto                   subjects = subjectsOf(10, 0.5, 1.0);
  const ProcrustesResult there = procrustes(subjects, AlignmentKind::Rigid);
  std::reverse(subjects.begin(), subjects.end());
  const ProcrustesResult back = procrustes(subjects, AlignmentKind::Rigid);
  for (std::size_t a = 0; a < there.mean.size(); ++a)
  {
    EXPECT_LT((there.mean[a] - back.mean[a]).norm(), 1e-7);
  }
}

TEST(Procrustes, NoneIsThePlainMean)
{
  const auto             subjects = subjectsOf(4, 0.5, 1.0);
  const ProcrustesResult result = procrustes(subjects, AlignmentKind::None);
  const Vector3          plain = 0.25 * (subjects[0][3] + subjects[1][3] + subjects[2][3] + subjects[3][3]);
  EXPECT_LT((result.mean[3] - plain).norm(), 1e-13 * 40.0);
  EXPECT_EQ(result.report.steps, 1);
}

TEST(Procrustes, TheSameForAnyNumberOfThreads)
{
  const auto             subjects = subjectsOf(40, 0.5, 1.0);
  const ProcrustesResult one = procrustes(subjects, AlignmentKind::Similarity, 1);
  const ProcrustesResult three = procrustes(subjects, AlignmentKind::Similarity, 3);
  EXPECT_TRUE(std::equal(one.mean.begin(), one.mean.end(), three.mean.begin()));
}

TEST(Procrustes, RefusalsNameTheSubject)
{
  auto subjects = subjectsOf(4, 0.5, 1.0);
  subjects[2].pop_back();
  EXPECT_EQ(analytic::messageOf([&] { (void)procrustes(subjects, AlignmentKind::Rigid); }),
            "Procrustes: subject 2 has 63 points, those before it 64");
  subjects[2].assign(64, Vector3::Ones());
  EXPECT_EQ(analytic::messageOf([&] { (void)procrustes(subjects, AlignmentKind::Rigid); }).substr(0, 10), "subject 2:");
  EXPECT_EQ(analytic::messageOf([&] { (void)procrustes({}, AlignmentKind::Rigid); }), "Procrustes: no subject");
}
