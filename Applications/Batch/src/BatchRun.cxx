#include "BatchRun.h"

#include "BatchProgress.h"
#include "CaseFailure.h"
#include "CaseNames.h"
#include "MeshArguments.h"
#include "OutputRoom.h"
#include "StopSignals.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/HexMeshIO/Sha256.h"

#include <poll.h>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;

struct RunningCase
{
  std::size_t                  index{ 0 };
  std::unique_ptr<CaseProcess> process;
  pid_t                        id{ -1 };
};

class Runner
{
public:
  Runner(const std::vector<BatchCase> & cases, const std::vector<PlannedCase> & plan, const BatchRunOptions & options)
    : m_Cases(cases), m_Plan(plan), m_Options(options), m_Journal(options.journal)
  {
    for (std::size_t c = 0; c < plan.size(); ++c)
    {
      if (plan[c].action == PlannedCase::Action::Run)
      {
        m_Waiting.push_back(c);
      }
    }
    std::reverse(m_Waiting.begin(), m_Waiting.end()); // taken from the end
    m_Progress = std::make_unique<BatchProgress>(m_Waiting.size(), options.quiet);
  }

  BatchRunResult
  run()
  {
    while (!m_Running.empty() || (!m_Waiting.empty() && m_Result.stop == BatchStop::None))
    {
      startCases();
      waitForNews();
      if (m_Signals.received() != 0 && m_Result.stop != BatchStop::Signal)
      {
        stopForSignal();
      }
      collectEnded();
      m_Progress->show(m_Result.done + m_Result.failed, m_Result.failed);
    }
    m_Result.notRun += m_Waiting.size();
    return m_Result;
  }

private:
  void
  startCases()
  {
    while (m_Running.size() < m_Options.jobs && !m_Waiting.empty() && m_Result.stop == BatchStop::None)
    {
      const MeshCommandOptions & options = m_Cases[m_Waiting.back()].options;
      const std::uint64_t        bytes = bytesOfCase(options.shells, options.padding) * (m_Running.size() + 1);
      if (!hasRoom(m_Options.outputFolder, bytes, false))
      {
        stopForLackOfRoom();
        return;
      }
      if (!start(m_Waiting.back()))
      {
        return;
      }
      m_Waiting.pop_back();
    }
  }

  /** False where the system has no process left, and one of ours will end. */
  bool
  start(std::size_t index)
  {
    const BatchCase & batchCase = m_Cases[index];
    makeFolder(fs::path(batchCase.options.output).parent_path().string());
    std::vector<std::string> command = m_Options.program;
    for (const std::string & argument : meshingArguments(batchCase.options))
    {
      command.push_back(argument);
    }
    command.push_back("--report=" + batchCase.options.reportFile);
    if (!batchCase.options.pageFile.empty())
    {
      command.push_back("--report=" + batchCase.options.pageFile);
    }
    command.push_back("--threads=" + std::to_string(m_Options.threadsOfCase));
    command.emplace_back("--quiet");
    if (m_Options.reproducible)
    {
      command.emplace_back("--reproducible");
    }
    command.insert(command.end(), { "--", batchCase.options.input.file, batchCase.options.output });
    try
    {
      auto        process = std::make_unique<CaseProcess>(command, m_Options.limits);
      const pid_t id = process->id();
      m_Running.push_back({ index, std::move(process), id });
      return true;
    }
    catch (const IOError &)
    {
      if (m_Running.empty())
      {
        throw;
      }
      return false;
    }
  }

  /** Sleeps until a process says something, ends, or is due to be ended, or a signal arrives. */
  void
  waitForNews() const
  {
    std::vector<struct pollfd> waiting{ { m_Signals.descriptor(), POLLIN, 0 } };
    auto                       wakeUp = CaseProcess::Clock::now() + std::chrono::seconds(1);
    for (const RunningCase & running : m_Running)
    {
      waiting.push_back({ running.process->messages(), POLLIN, 0 }); // -1 is passed over
      wakeUp = std::min(wakeUp, running.process->nextDeadline());
    }
    const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(wakeUp - CaseProcess::Clock::now()).count() + 1;
    (void)::poll(waiting.data(), waiting.size(), static_cast<int>(std::max<long long>(left, 0)));
  }

  void
  collectEnded()
  {
    for (std::size_t r = 0; r < m_Running.size();)
    {
      const std::optional<CaseEnd> end = m_Running[r].process->poll();
      if (!end)
      {
        ++r;
        continue;
      }
      const RunningCase ended = std::move(m_Running[r]);
      m_Running.erase(m_Running.begin() + static_cast<std::ptrdiff_t>(r));
      finish(ended, *end);
    }
  }

  /** The disk may fill up while the outcome is written down; then the case is left for the next run. */
  void
  finish(const RunningCase & ended, const CaseEnd & end)
  {
    const BatchCase & batchCase = m_Cases[ended.index];
    removePartOf(batchCase.options.output, ended.id);
    removePartOf(batchCase.options.reportFile, ended.id);
    removePartOf(pageNameOf(batchCase.options.reportFile), ended.id);
    try
    {
      if (end.wasStopped && end.exitStatus != 0)
      {
        ++m_Result.notRun;
        return;
      }
      std::optional<CaseFailure> failure = failureOf(end, m_Options.limits);
      if (!failure && sha256OfInputs(batchCase.options) != m_Plan[ended.index].key.inputs)
      {
        failure =
          CaseFailure{ { ErrorCode::InputOutput, "the input changed during the run; run again when it is complete" },
                       false };
      }
      if (failure && isForLackOfRoom(batchCase, failure->failure.code))
      {
        stopForLackOfRoom();
        ++m_Result.notRun;
        return;
      }
      failure ? writeDown(ended.index, *failure, end) : writeDown(ended.index);
    }
    catch (const Error & error)
    {
      stop(BatchStop::NoRoom, error.what());
      ++m_Result.notRun;
    }
  }

  /** A case that is done. */
  void
  writeDown(std::size_t index)
  {
    const BatchCase & batchCase = m_Cases[index];
    JournalEntry      entry;
    entry.name = batchCase.name;
    entry.key = m_Plan[index].key;
    entry.done = true;
    entry.meshSha256 = sha256OfFile(batchCase.options.output);
    entry.reportSha256 = sha256OfFile(batchCase.options.reportFile);
    m_Journal.append(entry);
    ++m_Result.done;
  }

  /** A case that failed. */
  void
  writeDown(std::size_t index, const CaseFailure & failure, const CaseEnd & end)
  {
    const BatchCase & batchCase = m_Cases[index];
    if (!failure.isReported)
    {
      writeFailureReport(batchCase, failure.failure, end, m_Options.reproducible);
    }
    removeStaleMesh(index);
    JournalEntry entry;
    entry.name = batchCase.name;
    entry.key = m_Plan[index].key;
    entry.code = nameOf(failure.failure.code);
    entry.timeLimit = m_Options.limits.seconds;
    entry.memoryLimit = m_Options.limits.mebibytes;
    m_Journal.append(entry);
    ++m_Result.failed;
    m_Progress->warn(failure.failure.code, batchCase.name + ": " + failure.failure.message);
  }

  /** A mesh of other inputs or options must not pass for this case's. */
  void
  removeStaleMesh(std::size_t index)
  {
    const std::string & mesh = m_Cases[index].options.output;
    std::error_code     ignored;
    if (!fs::exists(mesh, ignored))
    {
      return;
    }
    if (!m_Plan[index].staleMesh.empty() && sha256OfFile(mesh) == m_Plan[index].staleMesh)
    {
      fs::remove(mesh, ignored);
      return;
    }
    m_Progress->warn(m_Cases[index].name + ": a mesh that no run of this folder made lies there and stays");
  }

  [[nodiscard]] bool
  isForLackOfRoom(const BatchCase & batchCase, ErrorCode code) const
  {
    const bool maybe = code == ErrorCode::InputOutput || code == ErrorCode::CannotCreate;
    return maybe && !hasRoom(fs::path(batchCase.options.output).parent_path().string(),
                             bytesOfCase(batchCase.options.shells, batchCase.options.padding),
                             true);
  }

  void
  stopForLackOfRoom()
  {
    stop(BatchStop::NoRoom, m_Options.outputFolder + ": no room for more meshes; free some space, then run again");
  }

  void
  stop(BatchStop why, const std::string & reason)
  {
    if (m_Result.stop == BatchStop::None)
    {
      m_Result.stop = why;
      m_Result.stopReason = reason;
    }
  }

  void
  stopForSignal()
  {
    m_Result.stop = BatchStop::Signal;
    m_Result.signalNumber = m_Signals.received();
    m_Result.stopReason = "stopped by a signal; run again to go on";
    for (const RunningCase & running : m_Running)
    {
      running.process->stop();
    }
  }

  const std::vector<BatchCase> &   m_Cases;
  const std::vector<PlannedCase> & m_Plan;
  const BatchRunOptions &          m_Options;
  JournalWriter                    m_Journal;
  StopSignals                      m_Signals;
  std::unique_ptr<BatchProgress>   m_Progress;
  std::vector<std::size_t>         m_Waiting; ///< the next one last
  std::vector<RunningCase>         m_Running;
  BatchRunResult                   m_Result;
};

} // namespace

BatchRunResult
runCases(const std::vector<BatchCase> & cases, const std::vector<PlannedCase> & plan, const BatchRunOptions & options)
{
  return Runner(cases, plan, options).run();
}

} // namespace moserhex::app
