#pragma once

#include "CommandTest.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace moserhex::app
{

/** Where two trees of BatchFolder::treeOf differ. */
[[nodiscard]] testing::AssertionResult
sameTree(const std::map<std::string, std::string> & tree, const std::map<std::string, std::string> & other);

/** Runs of `moserhex batch` on small solids made in code. */
class BatchFolder : public CommandTest
{
protected:
  void
  SetUp() override;

  /** Ellipsoids, each another, as in/case-001.nrrd and so on. */
  void
  writeSolids(int count) const;

  /** A file that is no image, as in/NAME. */
  void
  writeBadFile(const std::string & name) const;

  /** A program for --program that does to some cases what `faults` says: a piece of the input's name -> shell
   * commands; all others are meshed. */
  void
  writeFaultyProgram(const std::map<std::string, std::string> & faults) const;

  /** Of `batch in --output OUT --shells 2 --reproducible` and more. */
  [[nodiscard]] std::vector<std::string>
  batchArguments(const std::vector<std::string> & more = {}, const std::string & out = "out") const;

  [[nodiscard]] Outcome
  batch(const std::vector<std::string> & more = {}, const std::string & out = "out") const;

  /** The files of a folder, with their bytes, by their path in it: all but the journals and locks. */
  [[nodiscard]] std::map<std::string, std::string>
  treeOf(const std::string & out) const;

  /** Entries of the journal that say done, by case. */
  [[nodiscard]] std::map<std::string, int>
  doneEntries(const std::string & out = "out") const;

  /** Files whose names end so. */
  [[nodiscard]] std::size_t
  filesWithEnding(const std::string & out, const std::string & ending) const;
};

} // namespace moserhex::app
