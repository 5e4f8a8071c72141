#pragma once

#include "Seeds.h"

namespace moserhex::fuzz
{

/** A folder for files that a library writes; it goes with all it holds. */
class ScratchFolder
{
public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder &) = delete;
  ScratchFolder &
  operator=(const ScratchFolder &) = delete;

  [[nodiscard]] std::string
  operator/(const std::string & name) const
  {
    return m_Path + "/" + name;
  }

  /** \throws std::runtime_error  there is no such file, or it is empty */
  [[nodiscard]] SeedFile
  take(const std::string & name) const;

private:
  std::string m_Path;
};

void
addSurfaces(std::vector<Seed> & seeds);

void
addMeshes(std::vector<Seed> & seeds);

void
addFields(std::vector<Seed> & seeds);

void
addPoints(std::vector<Seed> & seeds);

} // namespace moserhex::fuzz
