#pragma once

#include "moserhex/Analytic/Refusals.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <unistd.h>

namespace moserhex
{

/** A fresh folder that goes with all it holds. */
class TestFolder
{
public:
  TestFolder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "moserhex-XXXXXX").string();
    if (!::mkdtemp(name.data()))
    {
      throw std::runtime_error("cannot make a temporary folder");
    }
    m_Path = name;
  }

  ~TestFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(m_Path, ignored);
  }

  TestFolder(const TestFolder &) = delete;
  TestFolder &
  operator=(const TestFolder &) = delete;

  [[nodiscard]] std::string
  operator/(const std::string & name) const
  {
    return (m_Path / name).string();
  }

  [[nodiscard]] std::size_t
  fileCount() const
  {
    return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator(m_Path), std::filesystem::directory_iterator()));
  }

private:
  std::filesystem::path m_Path;
};

inline std::string
readBytes(const std::string & fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

inline void
writeBytes(const std::string & fileName, const std::string & bytes)
{
  std::ofstream(fileName, std::ios::binary) << bytes;
}

using analytic::codeThrownBy;
using analytic::messageOf;

} // namespace moserhex
