#pragma once

#include "moserhex/Common/Errors.h"

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

} // namespace moserhex::analytic
