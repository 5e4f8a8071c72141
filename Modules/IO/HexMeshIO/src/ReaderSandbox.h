#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace moserhex
{

/** What a reading process may use. */
struct SandboxLimits
{
  std::uint64_t memoryBytes{ std::uint64_t{ 256 } << 20 }; ///< beyond what the process has mapped at its start
  unsigned int  cpuSeconds{ 120 };
  unsigned int  wallSeconds{ 300 };
};

/** Runs `work` in a forked child process and returns what it returns.
 *
 * The child has the limits given, writes no files and no core (both limited to 0 bytes), prints nowhere, and dies with
 * the thread that started it. A BadInput, IOError or InvalidInput of `work` is thrown here again, same class, code and
 * message.
 *
 * \param fileName  what the messages name
 * \throws BadInput (ReaderFailed)  the child died of a signal, went beyond a limit, or sent less than a whole answer
 * \throws BadInput (TooBig)  `work` ran out of memory
 * \throws IOError   no process could be started
 * \note The child is a copy of the calling thread alone: a lock that another thread holds at that moment stays locked
 * in it. Work that needs such a lock ends at the wall limit, as ReaderFailed. So programs with several busy threads
 *       should read before they start them, or without a sandbox. Under the address and thread sanitizers memory is not
 * limited. Nothing is left behind: no zombie, no descriptor. */
[[nodiscard]] std::string
runInSandbox(const std::string & fileName, const SandboxLimits & limits, const std::function<std::string()> & work);

/** In a child of runInSandbox: lets it map so many bytes beyond what it has mapped now, never more than the limit that
 * it was born with. Called when a header has been checked and its promises are believed. */
void
allowSandboxMemory(std::uint64_t bytes);

} // namespace moserhex
