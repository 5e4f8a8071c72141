#pragma once

#include "moserhex/Common/ErrorCode.h"

#include <exception>
#include <functional>
#include <string>

namespace moserhex::app
{

/** What a user is told of an exception. */
struct Failure
{
  ErrorCode   code;
  std::string message;
};

/** Errors of the library as they are; no memory and everything else, which is a fault of the program, in their words.
 */
[[nodiscard]] Failure
describeFailure(const std::exception_ptr & exception);

/** Runs a command that is done when it returns; what it throws becomes a line on the standard error output and an exit
 * code. */
[[nodiscard]] int
runGuarded(const std::function<void()> & command);

/** The same for a command that returns its exit code. */
[[nodiscard]] int
runGuardedForStatus(const std::function<int()> & command);

/** Opens /dev/null for standard streams that were closed, so that no file of ours gets their number. */
void
openMissingStreams();

/** The exit code, or that of a failure when the standard output could not be written. A reader that went away is none.
 */
[[nodiscard]] int
flushOutput(int exitCode);

} // namespace moserhex::app
