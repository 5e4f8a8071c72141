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

/** The text in one line of at most so many bytes: control characters become '?', so that a hostile name or a library's
 * message cannot break the line; what is too long ends with "..." after a whole word, so that no number loses digits.
 */
[[nodiscard]] std::string
oneLine(const std::string & text, std::size_t length);

/** "file: cause; remedy" in one line of at most 200 characters. A file name longer than 60 characters keeps its end,
 * and as little as 24 of them when the cause needs the place; then the cause is cut. */
[[nodiscard]] std::string
fileMessage(const std::string & file, const std::string & cause, const std::string & remedy);

} // namespace moserhex
