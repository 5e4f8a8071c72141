#pragma once

#include "moserhex/Common/Errors.h"

#include <string>

namespace moserhex
{

/** An input file cannot be used: missing, damaged, of another kind, or its content breaks a documented precondition.
 * The message is one line of at most 200 characters: file, cause, remedy. */
class BadInput : public Error
{
public:
  BadInput(const std::string & file, const std::string & cause, const std::string & remedy);
};

/** The operating system failed while a file was read or written: no permission, disk full, device error.
 * The message is one line of at most 200 characters: file, cause, remedy. */
class IOError : public Error
{
public:
  IOError(const std::string & file, const std::string & cause, const std::string & remedy);
};

/** "file: cause; remedy" in one line of at most 200 characters.
 *
 * A file name longer than 60 characters keeps its end; control characters become '?', so that a hostile name or a
 * library's message cannot break the line. */
[[nodiscard]] std::string
fileMessage(const std::string & file, const std::string & cause, const std::string & remedy);

} // namespace moserhex
