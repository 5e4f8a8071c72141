#include "Journal.h"

#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/HexMeshIO/Sha256.h"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t checksumLength = 16; // hexadecimal digits: 64 bits

std::string
checksumOf(const std::string & text)
{
  Sha256 sha256;
  sha256.update(text.data(), text.size());
  return sha256.hexDigest().substr(0, checksumLength);
}

std::string
lineOf(const JournalEntry & entry)
{
  Json json{ { "case", entry.name },
             { "status", entry.done ? "done" : "failed" },
             { "inputs", entry.key.inputs },
             { "arguments", entry.key.arguments },
             { "version", entry.key.version } };
  if (entry.done)
  {
    json["mesh_sha256"] = entry.meshSha256;
    json["report_sha256"] = entry.reportSha256;
  }
  else
  {
    json["code"] = entry.code;
    json["time_limit"] = entry.timeLimit;
    json["memory_limit"] = entry.memoryLimit;
  }
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return checksumOf(text) + " " + text + "\n";
}

/** Nothing for a line that does not count. */
std::optional<JournalEntry>
entryOf(const std::string & line)
{
  if (line.size() < checksumLength + 2 || line[checksumLength] != ' ')
  {
    return std::nullopt;
  }
  const std::string text = line.substr(checksumLength + 1);
  if (line.compare(0, checksumLength, checksumOf(text)) != 0)
  {
    return std::nullopt;
  }
  try
  {
    const Json   json = Json::parse(text);
    JournalEntry entry;
    entry.name = json.at("case").get<std::string>();
    entry.done = json.at("status").get<std::string>() == "done";
    entry.key = { json.at("inputs").get<std::string>(),
                  json.at("arguments").get<std::string>(),
                  json.at("version").get<std::string>() };
    entry.meshSha256 = json.value("mesh_sha256", "");
    entry.reportSha256 = json.value("report_sha256", "");
    entry.code = json.value("code", "");
    entry.timeLimit = json.value("time_limit", 0.0);
    entry.memoryLimit = json.value("memory_limit", 0.0);
    return entry;
  }
  catch (const Json::exception &)
  {
    return std::nullopt;
  }
}

bool
isJournalName(const std::string & name)
{
  const std::string begin = "journal.";
  const std::string end = "jsonl";
  return name.size() >= begin.size() + end.size() && name.compare(0, begin.size(), begin) == 0 &&
         name.compare(name.size() - end.size(), end.size(), end) == 0;
}

[[noreturn]] void
throwFailed(const std::string & fileName, const char * what)
{
  throw IOError(ErrorCode::InputOutput,
                fileName,
                std::string(what) + " (" + std::strerror(errno) + ")",
                "free some space or check the folder, then run again");
}

void
readJournal(const std::string & fileName, JournalContent & content)
{
  std::ifstream file(fileName, std::ios::binary);
  if (!file)
  {
    throwFailed(fileName, "cannot open the journal");
  }
  for (std::string line; std::getline(file, line);)
  {
    std::optional<JournalEntry> entry = entryOf(line);
    if (!entry)
    {
      content.damaged += line.empty() ? 0 : 1;
      continue;
    }
    ++content.entries;
    std::string name = entry->name;
    content.last[std::move(name)] = std::move(*entry);
  }
  if (file.bad())
  {
    throwFailed(fileName, "cannot read the journal");
  }
}

} // namespace

bool
operator==(const CaseKey & a, const CaseKey & b)
{
  return a.inputs == b.inputs && a.arguments == b.arguments && a.version == b.version;
}

JournalContent
readJournals(const std::string & outputFolder)
{
  std::vector<std::pair<fs::file_time_type, std::string>> journals;
  std::error_code                                         failed;
  for (const fs::directory_entry & entry : fs::directory_iterator(outputFolder, failed))
  {
    if (isJournalName(entry.path().filename().string()))
    {
      std::error_code ignored;
      journals.emplace_back(entry.last_write_time(ignored), entry.path().string());
    }
  }
  std::sort(journals.begin(), journals.end()); // where two tell of one case, the one written to last counts
  JournalContent content;
  for (const auto & [time, name] : journals)
  {
    readJournal(name, content);
  }
  return content;
}

JournalWriter::JournalWriter(const std::string & fileName)
  : m_FileName(fileName), m_File(::open(fileName.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666))
{
  if (m_File < 0)
  {
    throw IOError(ErrorCode::CannotCreate,
                  fileName,
                  std::string("cannot write the journal (") + std::strerror(errno) + ")",
                  "choose a writable folder");
  }
  const off_t size = ::lseek(m_File, 0, SEEK_END);
  char        last = '\n';
  m_LineIsTorn = size > 0 && (::pread(m_File, &last, 1, size - 1) != 1 || last != '\n');
}

JournalWriter::~JournalWriter()
{
  if (m_File >= 0)
  {
    ::close(m_File);
  }
}

void
JournalWriter::append(const JournalEntry & entry)
{
  const std::string line = (m_LineIsTorn ? "\n" : "") + lineOf(entry);
  std::size_t       written = 0;
  m_LineIsTorn = true;
  while (written < line.size())
  {
    const ssize_t count = ::write(m_File, line.data() + written, line.size() - written);
    if (count < 0 && errno != EINTR)
    {
      throwFailed(m_FileName, "cannot write the journal");
    }
    written += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  m_LineIsTorn = false;
  if (::fsync(m_File) != 0 && errno != EINVAL)
  {
    throwFailed(m_FileName, "cannot flush the journal to the disk");
  }
}

std::string
journalName(const std::string & outputFolder, const std::string & shard)
{
  return (fs::path(outputFolder) / ("journal." + (shard.empty() ? "" : shard + ".") + "jsonl")).string();
}

} // namespace moserhex::app
