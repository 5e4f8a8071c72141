// Exact: what becomes of an exception.
#include "Guard.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

template <typename TException>
Failure
failureOf(const TException & exception)
{
  return describeFailure(std::make_exception_ptr(exception));
}

} // namespace

TEST(Guard, ErrorsOfTheLibraryKeepTheirCodesAndMessages)
{
  EXPECT_EQ(failureOf(InvalidInput("x")).code, ErrorCode::Precondition);
  EXPECT_EQ(failureOf(NotConverged("steps ran out", {})).code, ErrorCode::NotConverged);
  EXPECT_EQ(failureOf(Cancelled()).code, ErrorCode::Cancelled);
  const Failure failure = failureOf(BadInput(ErrorCode::Truncated, "a.nrrd", "ends early", "copy it again"));
  EXPECT_EQ(failure.code, ErrorCode::Truncated);
  EXPECT_EQ(failure.message, "a.nrrd: ends early; copy it again");
}

TEST(Guard, WantOfMemoryHasARemedy)
{
  const Failure failure = failureOf(std::bad_alloc());
  EXPECT_EQ(failure.code, ErrorCode::OutOfMemory);
  EXPECT_NE(failure.message.find("fewer shells"), std::string::npos);
}

TEST(Guard, EverythingElseIsAFaultOfTheProgram)
{
  const Failure failure = failureOf(std::logic_error("index 7"));
  EXPECT_EQ(failure.code, ErrorCode::Internal);
  EXPECT_EQ(failure.message, "index 7; please report this");
}

TEST(Guard, ACommandThatEndsWellExitsWithZeroAndAnotherWithTheStatusOfItsCode)
{
  EXPECT_EQ(runGuarded([] {}), 0);
  EXPECT_EQ(runGuarded([] { throw InvalidInput(ErrorCode::Topology, "x"); }), 3);
  EXPECT_EQ(runGuarded([] { throw std::bad_alloc(); }), 4);
  EXPECT_EQ(runGuarded([] { throw std::logic_error("x"); }), 70);
}

TEST(Guard, ACommandMayReturnItsExitCode)
{
  EXPECT_EQ(runGuardedForStatus([] { return 1; }), 1);
  EXPECT_EQ(runGuardedForStatus([]() -> int { throw InvalidInput(ErrorCode::Topology, "x"); }), 3);
}
