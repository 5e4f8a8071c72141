#pragma once

#include <string>

namespace moserhex::app
{

/** Keeps a second run away from an output folder, or from a shard of it. The kernel frees it when the last process that
 * holds it has ended, however that happened; the cases' processes inherit it, so a run that was killed is over for its
 * successor only when its cases have ended, too. Runs of different shards do not hinder each other; a run of all cases
 * and one of a shard do. */
class OutputLock
{
public:
  /** Waits up to `patience` seconds for a run that is ending.
   * \param shard  "2-of-5"; empty: all cases
   * \throws IOError  Locked: another run works there, and which; CannotCreate: the folder cannot be written */
  OutputLock(const std::string & outputFolder, const std::string & shard, double patience);
  ~OutputLock();
  OutputLock(const OutputLock &) = delete;
  OutputLock &
  operator=(const OutputLock &) = delete;

private:
  int m_Folder{ -1 };
  int m_Shard{ -1 };
};

} // namespace moserhex::app
