#pragma once

#include "moserhex/Common/Errors.h"

#include <stdexcept>
#include <string>

namespace moserhex::analytic
{

/** What the exception of type TError that `call` throws says; "accepted" when it throws none. */
template <typename TError = InvalidInput, typename TCall>
[[nodiscard]] std::string
messageOf(const TCall & call)
{
  try
  {
    call();
  }
  catch (const TError & error)
  {
    return error.what();
  }
  return "accepted";
}

/** The code of the Error that `call` throws. \throws std::runtime_error  it throws none */
template <typename TCall>
[[nodiscard]] ErrorCode
codeThrownBy(const TCall & call)
{
  try
  {
    call();
  }
  catch (const Error & error)
  {
    return error.code();
  }
  throw std::runtime_error("accepted");
}

} // namespace moserhex::analytic
