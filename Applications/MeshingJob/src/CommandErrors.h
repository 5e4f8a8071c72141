#pragma once

#include "moserhex/HexMeshIO/FileErrors.h"

#include <string>

namespace moserhex::app
{

/** The command line contradicts itself; found before any work. */
class UsageError : public Error
{
public:
  explicit UsageError(const std::string & message) : Error(ErrorCode::Usage, message)
  {}
};

/** No valid mesh came out: a stage did not reach what it promises. */
class NoMeshError : public FileError
{
public:
  using FileError::FileError;
};

} // namespace moserhex::app
