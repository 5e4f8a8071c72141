#pragma once

#include "moserhex/Common/Errors.h"

#include <string>

namespace moserhex
{

/** "CODE message" of the error of this library that `call` throws; "no error" when it throws none. */
template <typename TCall>
std::string
errorOf(const TCall & call)
{
  try
  {
    call();
  }
  catch (const Error & error)
  {
    return std::string(nameOf(error.code())) + ' ' + error.what();
  }
  return "no error";
}

} // namespace moserhex
