#pragma once

#include "moserhex/Common/Errors.h"

#include <string>

namespace moserhex
{

/** A message that another process has already put together. */
struct FinishedMessage
{
  std::string text; ///< what() of the error
};

/** A fault of a file. The message is one line: file, cause, remedy; with "error: " before it and " [code]" behind, it
 * has at most 200 characters. */
class FileError : public Error
{
public:
  /** With a message of file, cause and remedy, see fileMessage. \param remedy  what the user can do */
  FileError(ErrorCode code, const std::string & file, const std::string & cause, const std::string & remedy);

  /** With the message as it is, of an error of this class in another process. */
  FileError(ErrorCode code, const FinishedMessage & message) : Error(code, message.text)
  {}
};

/** An input file cannot be used: missing, damaged, of another kind, or its content breaks a documented precondition. */
class BadInput : public FileError
{
public:
  using FileError::FileError;
};

/** The operating system failed while a file was read or written: no permission, disk full, device error. */
class IOError : public FileError
{
public:
  using FileError::FileError;
};

/** The text in one line of at most so many bytes: control characters become '?', so that a hostile name or a library's
 * message cannot break the line; what is too long ends with "..." after a whole word, so that no number loses digits.
 */
[[nodiscard]] std::string
oneLine(const std::string & text, std::size_t length);

/** "file: cause; remedy" in one line of at most `longest` bytes (at least 120). A file name longer than 60 characters
 * keeps its end, and as little as 24 of them when the cause needs the place; then the cause is cut. */
[[nodiscard]] std::string
fileMessage(const std::string & file, const std::string & cause, const std::string & remedy, std::size_t longest = 200);

/** The refusal of an input that could not be opened, for the system's reason `cause` (errno).
 * \throws BadInput (NoInput)  it may not be read; IOError  any other reason */
[[noreturn]] void
throwUnopened(const std::string & fileName, int cause);

} // namespace moserhex
