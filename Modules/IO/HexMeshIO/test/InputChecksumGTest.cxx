// Exact: what belongs to an input.
#include "moserhex/HexMeshIO/InputChecksum.h"

#include "TestFolder.h"
#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/HexMeshIO/Sha256.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace moserhex;

namespace
{

class InputChecksum : public testing::Test
{
protected:
  void
  write(const std::string & name, const std::string & content) const
  {
    std::ofstream(m_Folder / name, std::ios::binary) << content;
  }

  [[nodiscard]] std::string
  checksum(const std::string & name) const
  {
    return sha256OfInput(m_Folder / name);
  }

  TestFolder m_Folder;
};

const std::string header = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n"
                           "space: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"
                           "space origin: (0,0,0)\n";

} // namespace

TEST_F(InputChecksum, OfOneFileIsTheFilesOwn)
{
  write("a.nrrd", header + "\n12345678");
  EXPECT_EQ(checksum("a.nrrd"), sha256OfFile(m_Folder / "a.nrrd"));
  write("surface.stl", "solid");
  EXPECT_EQ(checksum("surface.stl"), sha256OfFile(m_Folder / "surface.stl"));
}

TEST_F(InputChecksum, SeparateVoxelsCount)
{
  write("a.nhdr", header + "data file: a.raw\n");
  write("a.raw", "12345678");
  const std::string before = checksum("a.nhdr");
  EXPECT_NE(before, sha256OfFile(m_Folder / "a.nhdr"));
  write("a.raw", "12345679");
  EXPECT_NE(checksum("a.nhdr"), before);
  write("a.raw", "12345678");
  EXPECT_EQ(checksum("a.nhdr"), before);
}

TEST_F(InputChecksum, AHeaderThatWillBeRefusedIsOneFile)
{
  write("a.nhdr", header + "data file: /etc/passwd\n");
  EXPECT_EQ(checksum("a.nhdr"), sha256OfFile(m_Folder / "a.nhdr"));
}

TEST_F(InputChecksum, AMissingFileIsRefused)
{
  EXPECT_THROW((void)checksum("missing.nrrd"), BadInput);
}
