#include "BatchPlan.h"

#include "MeshArguments.h"
#include "TemplateInputs.h"
#include "Version.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/InputChecksum.h"
#include "moserhex/HexMeshIO/Sha256.h"

#include <algorithm>
#include <filesystem>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;

/** Failures that say nothing about the case. */
bool
isFaultOfMachine(const std::string & code)
{
  return code == nameOf(ErrorCode::InputOutput) || code == nameOf(ErrorCode::CannotCreate) ||
         code == nameOf(ErrorCode::Cancelled);
}

/** Failures that may be for lack of memory, in the reader, too. */
bool
maybeForMemory(const std::string & code)
{
  return code == nameOf(ErrorCode::OutOfMemory) || code == nameOf(ErrorCode::TooBig) ||
         code == nameOf(ErrorCode::ReaderFailed) || code == nameOf(ErrorCode::Crashed);
}

bool
isLimitRaised(const JournalEntry & entry, const CaseLimits & limits)
{
  const bool isUnlimited = limits.mebibytes == 0.0;
  return (entry.code == nameOf(ErrorCode::TimeLimit) && limits.seconds > entry.timeLimit) ||
         (maybeForMemory(entry.code) && entry.memoryLimit > 0.0 &&
          (isUnlimited || limits.mebibytes > entry.memoryLimit));
}

/** The file's checksum; empty where it cannot be read. */
std::string
sha256IfReadable(const std::string & fileName)
{
  try
  {
    return sha256OfFile(fileName);
  }
  catch (const Error &)
  {
    return {};
  }
}

/** "mesh missing", "mesh changed", ...; empty: both are as the journal says. */
std::string
damageOf(const BatchCase & batchCase, const JournalEntry & entry)
{
  const auto damage = [](const std::string & fileName, const std::string & sha256, const std::string & what) {
    std::error_code   ignored;
    const std::string now = sha256IfReadable(fileName);
    if (now == sha256)
    {
      return std::string();
    }
    return what + (now.empty() && !fs::exists(fileName, ignored) ? " missing" : " changed");
  };
  const std::string ofMesh = damage(batchCase.options.output, entry.meshSha256, "mesh");
  return !ofMesh.empty() ? ofMesh : damage(batchCase.options.reportFile, entry.reportSha256, "report");
}

bool
isPageMissing(const MeshCommandOptions & options)
{
  std::error_code ignored;
  return !options.pageFile.empty() && !fs::is_regular_file(options.pageFile, ignored);
}

/** What changed since the entry; empty: nothing. */
std::string
changeSince(const CaseKey & then, const CaseKey & now)
{
  if (then.inputs != now.inputs)
  {
    return "input changed";
  }
  if (then.arguments != now.arguments)
  {
    return "options changed";
  }
  return then.version != now.version ? "another version" : "";
}

PlannedCase
planCase(const BatchCase & batchCase, const JournalContent & journal, const PlanOptions & options)
{
  PlannedCase planned;
  planned.key = caseKey(batchCase.options);
  planned.reason = "new";
  const auto found = journal.last.find(batchCase.name);
  if (found == journal.last.end())
  {
    return planned;
  }
  const JournalEntry & entry = found->second;
  planned.staleMesh = entry.meshSha256;
  planned.reason = changeSince(entry.key, planned.key);
  if (!planned.reason.empty())
  {
    return planned;
  }
  if (entry.done)
  {
    planned.reason = damageOf(batchCase, entry);
    if (planned.reason.empty() && isPageMissing(batchCase.options))
    {
      planned.reason = "page missing";
    }
    planned.action = planned.reason.empty() ? PlannedCase::Action::Done : PlannedCase::Action::Run;
    return planned;
  }
  planned.reason = "failed before: " + entry.code;
  const bool      isToRun = options.retryFailed || isFaultOfMachine(entry.code) || isLimitRaised(entry, options.limits);
  std::error_code ignored;
  if (!isToRun && !fs::exists(batchCase.options.reportFile, ignored))
  {
    planned.reason = "report missing";
    return planned;
  }
  planned.action = isToRun ? PlannedCase::Action::Run : PlannedCase::Action::Failed;
  return planned;
}

std::string
sha256OfText(const std::string & text)
{
  Sha256 sha256;
  sha256.update(text.data(), text.size());
  return sha256.hexDigest();
}

} // namespace

std::string
sha256OfInputs(const MeshCommandOptions & options)
{
  try
  {
    std::string text;
    for (const std::string & input : inputFiles(options))
    {
      text += sha256OfInput(input);
    }
    return sha256OfText(text);
  }
  catch (const Error &)
  {
    return {};
  }
}

CaseKey
caseKey(const MeshCommandOptions & options)
{
  std::string arguments;
  for (const std::string & argument : meshingArguments(options))
  {
    arguments += argument + '\n';
  }
  return { sha256OfInputs(options), sha256OfText(arguments), std::string(version) + " " + gitDescription };
}

std::vector<PlannedCase>
planCases(const std::vector<BatchCase> & cases, const JournalContent & journal, const PlanOptions & options)
{
  std::vector<PlannedCase> plan(cases.size());
  parallelFor(cases.size(), options.threads, [&](std::size_t c) { plan[c] = planCase(cases[c], journal, options); });
  return plan;
}

std::vector<std::string>
damagedCases(const std::vector<BatchCase> & cases, const JournalContent & journal, unsigned int threads)
{
  std::vector<std::string> damages(cases.size());
  parallelFor(cases.size(), threads, [&](std::size_t c) {
    const auto found = journal.last.find(cases[c].name);
    if (found != journal.last.end() && found->second.done)
    {
      const std::string damage = damageOf(cases[c], found->second);
      damages[c] = damage.empty() ? "" : cases[c].name + ": " + damage;
    }
  });
  damages.erase(std::remove(damages.begin(), damages.end(), std::string()), damages.end());
  return damages;
}

} // namespace moserhex::app
