#include "moserhex/Common/Parallel.h"

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace moserhex
{
namespace
{

/** Looks before a thread without work goes to sleep: some 20 us, the time it takes to wake one. */
constexpr int looksBeforeSleep = 64;

/** The process's helping threads. They are started when first asked for and then wait for work; at the end of the
 * process they are left to the system, which a thread asleep does not mind. */
class Crew
{
public:
  static Crew &
  instance()
  {
    Crew * crew = s_Current;
    if (crew == nullptr)
    {
      auto made = std::make_unique<Crew>();
      if (s_Current.compare_exchange_strong(crew, made.get())) // else another thread was first: crew is its crew
      {
        crew = made.release(); // never destroyed: its threads are never joined
      }
    }
    return *crew;
  }

  /** Runs work() here and, as far as there are free ones, on up to `helpers` other threads at the same time, with this
   * thread's floating-point environment; returns when all calls have returned. work() must not throw. May be called
   * from within work(). */
  void
  run(const std::function<void()> & work, std::size_t helpers)
  {
    Task task{ work, helpers };
    offer(task, helpers);
    work();
    withdraw(task);
  }

private:
  struct Task
  {
    Task(const std::function<void()> & work_, std::size_t places_) : work(work_), places(places_)
    {
      std::fegetenv(&environment);
    }

    const std::function<void()> & work;
    std::fenv_t                   environment;  // rounding and the like, of the thread that asks
    std::size_t                   places;       // helpers that may still join; guarded by m_Mutex
    std::atomic<std::size_t>      helpers{ 0 }; // at work
  };

  /** The child of a fork has none of the threads, and the mutex and the conditions as they were: it starts anew. */
  static void
  leaveBehind()
  {
    s_Current = nullptr;
  }

  void
  offer(Task & task, std::size_t places)
  {
    {
      const std::lock_guard<std::mutex> lock(m_Mutex);
      enlist(places);
      m_Tasks.push_back(&task);
      ++m_Offers;
    }
    if (places == 1)
    {
      m_Offered.notify_one();
    }
    else
    {
      m_Offered.notify_all();
    }
  }

  void
  withdraw(Task & task)
  {
    {
      const std::lock_guard<std::mutex> lock(m_Mutex);
      m_Tasks.erase(std::find(m_Tasks.begin(), m_Tasks.end(), &task));
    }
    for (int look = 0; look < looksBeforeSleep && task.helpers > 0; ++look)
    {
      std::this_thread::yield();
    }
    std::unique_lock<std::mutex> lock(m_Mutex);
    m_Left.wait(lock, [&] { return task.helpers == 0; });
  }

  /** Makes the crew at least that large. Where the system gives no more threads those there are have to do; there are
   * none before static initialisation and where a fork would go unnoticed. */
  void
  enlist(std::size_t size)
  {
    try
    {
      for (; s_NoticesForks && m_Size < size; ++m_Size)
      {
        std::thread([this] { help(); }).detach();
      }
    }
    catch (const std::system_error &)
    {}
  }

  [[noreturn]] void
  help()
  {
    for (;;)
    {
      const std::size_t seen = m_Offers;
      for (int look = 0; look < looksBeforeSleep && m_Offers == seen; ++look)
      {
        std::this_thread::yield();
      }
      std::unique_lock<std::mutex> lock(m_Mutex);
      Task *                       task = nullptr;
      m_Offered.wait(lock, [&] {
        const auto open = std::find_if(m_Tasks.begin(), m_Tasks.end(), [](const Task * t) { return t->places > 0; });
        task = open != m_Tasks.end() ? *open : nullptr;
        return task != nullptr;
      });
      --task->places;
      ++task->helpers;
      lock.unlock();
      std::fesetenv(&task->environment);
      task->work();
      lock.lock();
      --task->helpers;
      m_Left.notify_all();
    }
  }

  static std::atomic<Crew *> s_Current;
  static const bool          s_NoticesForks;

  std::mutex               m_Mutex;
  std::condition_variable  m_Offered;
  std::condition_variable  m_Left;
  std::vector<Task *>      m_Tasks;
  std::atomic<std::size_t> m_Offers{ 0 };
  std::size_t              m_Size{ 0 };
};

std::atomic<Crew *> Crew::s_Current{ nullptr };
const bool          Crew::s_NoticesForks = pthread_atfork(nullptr, nullptr, &Crew::leaveBehind) == 0;

} // namespace

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

  // Indices are handed out in order: when one fails all smaller ones have been, and each of them is carried out.
  std::atomic<std::size_t> next{ 0 };
  std::atomic<std::size_t> firstFailure{ count };
  std::mutex               mutex;
  std::exception_ptr       firstError;
  const auto               work = [&] {
    for (std::size_t i = next++; i < firstFailure; i = next++)
    {
      try
      {
        body(i);
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        if (i < firstFailure)
        {
          firstFailure = i;
          firstError = std::current_exception();
        }
      }
    }
  };

  Crew::instance().run(work, workers - 1);
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
