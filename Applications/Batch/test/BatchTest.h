#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace moserhex::app
{

[[nodiscard]] std::string
contentOf(const std::filesystem::path & path);

/** A folder of its own for each test. */
class BatchTest : public testing::Test
{
protected:
  void
  SetUp() override;
  void
  TearDown() override;

  [[nodiscard]] const std::string &
  folder() const
  {
    return m_Folder;
  }

private:
  std::string m_Folder;
};

} // namespace moserhex::app
