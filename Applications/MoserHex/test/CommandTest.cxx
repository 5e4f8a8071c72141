#include "CommandTest.h"

#include "SampleProstate.h"
#include "moserhex/HexMeshIO/LabelImageWriter.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace moserhex::app
{

namespace fs = std::filesystem;

std::string
contentOf(const fs::path & path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

pid_t
startProgram(const std::vector<std::string> & arguments, const fs::path & folder, rlim_t fileSizeLimit)
{
  const pid_t child = ::fork();
  if (child == 0)
  {
    std::vector<char *> argv{ const_cast<char *>(MOSERHEX_EXECUTABLE) };
    for (const std::string & argument : arguments)
    {
      argv.push_back(const_cast<char *>(argument.c_str()));
    }
    argv.push_back(nullptr);
    ::dup2(::open((folder / "out.txt").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), STDOUT_FILENO);
    ::dup2(::open((folder / "error.txt").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), STDERR_FILENO);
    if (fileSizeLimit > 0)
    {
      const rlimit limit{ fileSizeLimit, fileSizeLimit };
      ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ::execv(MOSERHEX_EXECUTABLE, argv.data());
    ::_exit(127);
  }
  return child;
}

Outcome
waitForProgram(pid_t child, const fs::path & folder)
{
  int status = 0;
  ::waitpid(child, &status, 0);
  return { WIFEXITED(status) ? WEXITSTATUS(status) : -1,
           WIFSIGNALED(status) ? WTERMSIG(status) : 0,
           contentOf(folder / "out.txt"),
           contentOf(folder / "error.txt") };
}

void
expectOneLineError(const Outcome & outcome, int exitCode)
{
  EXPECT_EQ(outcome.exitCode, exitCode) << outcome.error;
  EXPECT_EQ(outcome.error.compare(0, 7, "error: "), 0) << outcome.error;
  EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
  EXPECT_NE(outcome.error.find(" [E_"), std::string::npos) << outcome.error;
  EXPECT_EQ(outcome.error.rfind("]\n"), outcome.error.size() - 2) << outcome.error;
  EXPECT_LE(outcome.error.size(), 201u) << outcome.error;
}

void
expectErrorCode(const Outcome & outcome, const std::string & code)
{
  EXPECT_NE(outcome.exitCode, 0);
  EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
  EXPECT_LE(outcome.error.size(), 201u) << outcome.error;
  EXPECT_NE(outcome.error.find(" [" + code + "]\n"), std::string::npos) << outcome.error;
}

LabelVolume
cubeWithTunnel()
{
  LabelVolume label;
  label.size = { { 20, 20, 20 } };
  for (int voxel = 0; voxel < 20 * 20 * 20; ++voxel)
  {
    const int  i = voxel % 20;
    const int  j = voxel / 20 % 20;
    const int  k = voxel / 400;
    const bool isInCube = std::min({ i, j, k }) >= 2 && std::max({ i, j, k }) < 18;
    label.inside.push_back(isInCube && !(i == 9 && j == 9) ? 1 : 0);
  }
  return label;
}

void
CommandTest::SetUp()
{
  std::string name = (fs::temp_directory_path() / "moserhex-XXXXXX").string();
  ASSERT_TRUE(::mkdtemp(name.data()));
  m_Root = name;
  fs::create_directory(m_Root / "files");
  fs::create_directory(m_Root / "streams");
}

void
CommandTest::TearDown()
{
  fs::remove_all(m_Root);
}

std::string
CommandTest::path(const std::string & name) const
{
  return (m_Root / "files" / name).string();
}

Outcome
CommandTest::run(const std::vector<std::string> & arguments, rlim_t fileSizeLimit) const
{
  return waitForProgram(startProgram(arguments, m_Root / "streams", fileSizeLimit), m_Root / "streams");
}

std::size_t
CommandTest::fileCount() const
{
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_Root / "files"), fs::directory_iterator()));
}

void
CommandTest::writeSample() const
{
  writeLabelImage(path("prostate.nrrd"), makeSampleProstate().gland);
}

} // namespace moserhex::app
