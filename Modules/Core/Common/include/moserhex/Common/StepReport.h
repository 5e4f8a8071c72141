#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <thread>

namespace moserhex
{

/** What an iteration did. Every iterative algorithm returns one; nothing that failed is silent. */
struct StepReport
{
  bool        converged{ false }; ///< the algorithm's own criterion was met
  int         steps{ 0 };         ///< iterations made [1]
  double      residual{ 0.0 };    ///< value of the criterion at the end, unit stated by the algorithm
  double      seconds{ 0.0 };     ///< wall time
  std::string note;               ///< which way was taken, or why it stopped; empty when there is nothing to say
};

/** Called now and then with the fraction done in [0,1]; returning false asks the algorithm to stop.
 * An empty function is allowed everywhere and means "never stop". Never called from a worker thread. */
using ProgressCallback = std::function<bool(double fraction)>;

/** Reports progress; throws Cancelled when the callback returns false. */
void
reportProgress(const ProgressCallback & callback, double fraction);

/** The part [from, to] of a larger task, as a callback for a sub-task. */
[[nodiscard]] ProgressCallback
progressBetween(const ProgressCallback & callback, double from, double to);

/** The part number `part`, from 0, of `parts` equal parts of a larger task. */
[[nodiscard]] ProgressCallback
progressOfPart(const ProgressCallback & callback, std::size_t part, std::size_t parts);

/** Progress of equal parts that are done in parallel.
 *
 *   ParallelProgress shared(progress, count);
 *   parallelFor(count, threads, [&](std::size_t i) {
 *     results[i] = algorithm(inputs[i], options, shared.callback());
 *     shared.endPart();
 *   });
 *
 * The callback is called on the thread that made the object only, which parallelFor gives parts, too; when it asks for
 * a stop, the algorithms of all threads are stopped. */
class ParallelProgress
{
public:
  /** \param callback  must outlive the object */
  ParallelProgress(const ProgressCallback & callback, std::size_t parts);

  /** For the algorithm of a part; its own fraction does not count. */
  [[nodiscard]] ProgressCallback
  callback();

  /** \throws Cancelled */
  void
  endPart();

private:
  [[nodiscard]] bool
  goOn();

  const ProgressCallback & m_Callback;
  std::size_t              m_Parts;
  std::thread::id          m_Thread;
  std::atomic<std::size_t> m_Done{ 0 };
  std::atomic<bool>        m_Stopped{ false };
};

} // namespace moserhex
