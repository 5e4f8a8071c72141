#pragma once

#include <cstddef>
#include <functional>

namespace moserhex
{

/** Threads to use when an options struct says 0: the hardware's, at least one. */
[[nodiscard]] unsigned int
defaultThreadCount();

/** Runs body(i) for i in [0, count) on up to `threads` threads (0: defaultThreadCount()).
 *
 * Results must not depend on the order of execution: body(i) writes only what belongs to i. Sums over i are made by
 * the caller afterwards, in index order, so that every result is the same for any number of threads.
 * The threads are kept from one call to the next: a call costs some microseconds. body may call parallelFor itself.
 * All of them work with the caller's floating-point environment (rounding, flushing to zero).
 * The child of a fork starts threads of its own, whatever the parent's were doing. One forked within a body may call
 * parallelFor, but must not return from that body: the parent's threads, which have the rest, are not in the child.
 * Work is handed out dynamically, one index at a time: make an index a worthwhile piece of work (see
 * parallelForBlocks). The exception of the smallest failing index is rethrown after all threads have stopped: every
 * index below it is carried out, some above it may not be. */
void
parallelFor(std::size_t count, unsigned int threads, const std::function<void(std::size_t)> & body);

/** Cuts [0, count) into blocks of `blockSize` and runs body(begin, end) for each. The cut depends on count and
 * blockSize only, never on the number of threads. */
void
parallelForBlocks(std::size_t                                           count,
                  std::size_t                                           blockSize,
                  unsigned int                                          threads,
                  const std::function<void(std::size_t, std::size_t)> & body);

} // namespace moserhex
