#pragma once

#include "moserhex/LevelSet/LabelVolume.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/types.h>

namespace moserhex::app
{

/** How a run of the program ended, and what it printed. */
struct Outcome
{
  int         exitCode{ -1 };    ///< -1: ended by a signal
  int         signalNumber{ 0 }; ///< 0: ended by itself
  std::string out;
  std::string error;
};

[[nodiscard]] std::string
contentOf(const std::filesystem::path & path);

/** Starts the program with its streams in files of a folder. `fileSizeLimit` > 0 makes larger files fail like a full
 * disk. */
[[nodiscard]] pid_t
startProgram(const std::vector<std::string> & arguments,
             const std::filesystem::path &    folder,
             rlim_t                           fileSizeLimit = 0);

[[nodiscard]] Outcome
waitForProgram(pid_t child, const std::filesystem::path & folder);

/** One line, at most 200 characters: "error: ... [E_...]". */
void
expectOneLineError(const Outcome & outcome, int exitCode);

/** The same with a certain code at the end. */
void
expectErrorCode(const Outcome & outcome, const std::string & code);

/** Voxels [2,18)^3 of 20^3 with a tunnel of one voxel along k. */
[[nodiscard]] LabelVolume
cubeWithTunnel();

/** A folder for the streams, another for the files of a test, and the sample prostate. */
class CommandTest : public testing::Test
{
protected:
  void
  SetUp() override;
  void
  TearDown() override;

  [[nodiscard]] std::string
  path(const std::string & name) const;

  [[nodiscard]] Outcome
  run(const std::vector<std::string> & arguments, rlim_t fileSizeLimit = 0) const;

  [[nodiscard]] std::size_t
  fileCount() const;

  void
  writeSample() const;

  std::filesystem::path m_Root;
};

} // namespace moserhex::app
