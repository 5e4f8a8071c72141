#pragma once

#include "moserhex/Common/ErrorCode.h"
#include "moserhex/Common/StepReport.h"

#include <stdexcept>
#include <string>

namespace moserhex
{

/** Base of everything this library throws on purpose. */
class Error : public std::runtime_error
{
public:
  /** \param message  for people: what() returns it */
  Error(ErrorCode code, const std::string & message) : std::runtime_error(message), m_Code(code)
  {}

  /** The kind of fault, for programs. */
  [[nodiscard]] ErrorCode
  code() const
  {
    return m_Code;
  }

private:
  ErrorCode m_Code;
};

/** The caller's data break a documented precondition. The message names the quantity, its value and the allowed
 * range, and the label, vertex or cell where it was found. */
class InvalidInput : public Error
{
public:
  /** Of the code ErrorCode::Precondition. */
  explicit InvalidInput(const std::string & message) : Error(ErrorCode::Precondition, message)
  {}

  /** Of a more special code, as ErrorCode::Topology. */
  InvalidInput(ErrorCode code, const std::string & message) : Error(code, message)
  {}
};

/** A factorisation or an iteration did not reach what it promises. Carries the report of the steps made. */
class NotConverged : public Error
{
public:
  /** Of the code ErrorCode::NotConverged. */
  NotConverged(const std::string & message, StepReport stepReport)
    : NotConverged(ErrorCode::NotConverged, message, std::move(stepReport))
  {}

  /** Of a more special code, as ErrorCode::NotExact. */
  NotConverged(ErrorCode code, const std::string & message, StepReport stepReport)
    : Error(code, message), report(std::move(stepReport))
  {}

  StepReport report; ///< the steps made until then
};

/** The caller's progress callback asked for a stop. Not a failure: nothing was produced. */
class Cancelled : public Error
{
public:
  Cancelled() : Error(ErrorCode::Cancelled, "cancelled by the caller")
  {}
};

} // namespace moserhex
