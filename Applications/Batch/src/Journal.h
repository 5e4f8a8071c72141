#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace moserhex::app
{

/** What a case depends on. Two that are equal lead to the same mesh. */
struct CaseKey
{
  std::string
    inputs; ///< SHA-256 over the input's bytes, those of its voxels' file and of the density; empty: unreadable
  std::string arguments; ///< SHA-256 of the options' command line
  std::string version;   ///< of the program
};

[[nodiscard]] bool
operator==(const CaseKey & a, const CaseKey & b);

/** One case that came to an end. */
struct JournalEntry
{
  std::string name; ///< of the case
  CaseKey     key;
  bool        done{ false };
  std::string meshSha256;         ///< of a mesh that was made
  std::string reportSha256;       ///< of its report
  std::string code;               ///< of a failure: E_TOPOLOGY and so on
  double      timeLimit{ 0.0 };   ///< under which it failed [s]
  double      memoryLimit{ 0.0 }; ///< likewise [MiB]
};

/** How the journals of a folder were read. */
struct JournalContent
{
  std::unordered_map<std::string, JournalEntry> last; ///< the last entry of each case, by its name
  std::size_t                                   entries{ 0 };
  std::size_t                                   damaged{ 0 }; ///< lines that do not count: torn or changed
};

/** Reads all journals of an output folder: journal.jsonl and those of shards, journal.K-of-M.jsonl. A line counts only
 * if its checksum is right; nothing else can make a case count as done.
 * \throws IOError  a journal that cannot be read */
[[nodiscard]] JournalContent
readJournals(const std::string & outputFolder);

/** Appends to a journal. Every line is on the disk when append() returns, and has the checksum of its content before
 * it. One process at a time: see OutputLock. */
class JournalWriter
{
public:
  /** \throws IOError  the file cannot be created */
  explicit JournalWriter(const std::string & fileName);
  ~JournalWriter();
  JournalWriter(const JournalWriter &) = delete;
  JournalWriter &
  operator=(const JournalWriter &) = delete;

  /** \throws IOError  the line is not on the disk, for example because that is full */
  void
  append(const JournalEntry & entry);

private:
  std::string m_FileName;
  int         m_File{ -1 };
  bool        m_LineIsTorn{ false }; ///< the file does not end with a line's end
};

/** The journal of a run: of all cases, or of shard `shard` ("2-of-5"). */
[[nodiscard]] std::string
journalName(const std::string & outputFolder, const std::string & shard);

} // namespace moserhex::app
