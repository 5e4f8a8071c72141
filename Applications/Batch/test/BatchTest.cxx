#include "BatchTest.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace moserhex::app
{

namespace fs = std::filesystem;

std::string
contentOf(const fs::path & path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

void
BatchTest::SetUp()
{
  m_Folder = (fs::temp_directory_path() / "moserhex-batch-XXXXXX").string();
  ASSERT_TRUE(::mkdtemp(m_Folder.data()));
}

void
BatchTest::TearDown()
{
  fs::remove_all(m_Folder);
}

} // namespace moserhex::app
