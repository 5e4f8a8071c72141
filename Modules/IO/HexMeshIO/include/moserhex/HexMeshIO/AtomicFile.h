#pragma once

#include <string>
#include <vector>

namespace moserhex
{

/** A file that appears under its final name complete or not at all.
 *
 * Write to partName(), then commit(): the part is flushed to the disk, renamed over the final name, and the folder is
 * flushed. Without commit() the destructor removes the part; after a kill only the part is left.
 * The part lies in the same folder and ends with the final file's own extension, because writers look at it. */
class AtomicFile
{
public:
  /** \throws IOError  the folder does not exist or cannot be written, or finalName is a folder */
  explicit AtomicFile(const std::string & finalName);
  ~AtomicFile();
  AtomicFile(const AtomicFile &) = delete;
  AtomicFile &
  operator=(const AtomicFile &) = delete;

  /** Where to write: in the same folder, the same ending. */
  [[nodiscard]] const std::string &
  partName() const
  {
    return m_PartName;
  }

  /** As given to the constructor. */
  [[nodiscard]] const std::string &
  finalName() const
  {
    return m_FinalName;
  }

  /** Makes the text the content of the part. \throws IOError */
  void
  writeText(const std::string & text) const;

  /** \throws IOError  the part is missing, or flushing or renaming failed; then the final name is as before */
  void
  commit();

private:
  std::string m_FinalName;
  std::string m_PartName;
  bool        m_Committed{ false };
};

/** Writes a whole text by AtomicFile. \throws IOError */
void
writeTextFile(const std::string & fileName, const std::string & text);

/** Removes what a process that was killed left of a file it was writing. */
void
removePartOf(const std::string & finalName, long process) noexcept;

/** Removes what processes that are no more left of these files. Only for files that no other machine is writing, whose
 * processes cannot be seen. */
void
removeAbandonedParts(const std::vector<std::string> & finalNames);

/** Makes a folder and those above it, as far as they are missing. \throws IOError (CannotCreate) */
void
makeFolder(const std::string & folder);

/** Removes the parts of all files being written: for a handler of SIGINT and SIGTERM, where destructors do not run.
 * Async-signal-safe. */
void
removeUnfinishedFiles() noexcept;

} // namespace moserhex
