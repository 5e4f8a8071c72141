#include "moserhex/Common/Parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace moserhex
{

unsigned int
defaultThreadCount()
{
  return std::max(1u, std::thread::hardware_concurrency());
}

void
parallelFor(std::size_t count, unsigned int threads, const std::function<void(std::size_t)> & body)
{
  if (threads == 0)
  {
    threads = defaultThreadCount();
  }
  const std::size_t workers = std::min<std::size_t>(threads, count);
  if (workers <= 1)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      body(i);
    }
    return;
  }

  std::atomic<std::size_t> next{ 0 };
  std::atomic<bool>        failed{ false };
  std::mutex               mutex;
  std::exception_ptr       firstError;
  std::size_t              firstFailure = count;
  const auto               work = [&] {
    for (std::size_t i = next++; i < count && !failed; i = next++)
    {
      try
      {
        body(i);
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        failed = true;
        if (i < firstFailure)
        {
          firstFailure = i;
          firstError = std::current_exception();
        }
      }
    }
  };

  std::vector<std::thread> pool;
  pool.reserve(workers - 1);
  for (std::size_t t = 1; t < workers; ++t)
  {
    pool.emplace_back(work);
  }
  work();
  for (std::thread & thread : pool)
  {
    thread.join();
  }
  if (firstError)
  {
    std::rethrow_exception(firstError);
  }
}

void
parallelForBlocks(std::size_t                                           count,
                  std::size_t                                           blockSize,
                  unsigned int                                          threads,
                  const std::function<void(std::size_t, std::size_t)> & body)
{
  blockSize = std::max<std::size_t>(1, blockSize);
  const std::size_t blocks = (count + blockSize - 1) / blockSize;
  parallelFor(blocks, threads, [&](std::size_t block) {
    const std::size_t begin = block * blockSize;
    body(begin, std::min(count, begin + blockSize));
  });
}

} // namespace moserhex
