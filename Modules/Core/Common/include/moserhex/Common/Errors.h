#pragma once

#include "moserhex/Common/StepReport.h"

#include <stdexcept>
#include <string>

namespace moserhex
{

/** Base of everything the Core layer throws on purpose. */
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** The caller's data break a documented precondition. The message names the quantity, its value and the allowed
 * range, and the label, vertex or cell where it was found. */
class InvalidInput : public Error
{
public:
  using Error::Error;
};

/** A factorisation or an iteration did not reach what it promises. Carries the report of the steps made. */
class NotConverged : public Error
{
public:
  NotConverged(const std::string & message, StepReport stepReport) : Error(message), report(std::move(stepReport))
  {}

  StepReport report;
};

/** The caller's progress callback asked for a stop. Not a failure: nothing was produced. */
class Cancelled : public Error
{
public:
  Cancelled() : Error("cancelled by the caller")
  {}
};

} // namespace moserhex
