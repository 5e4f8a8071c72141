#pragma once

#include "TestFolder.h"

#include <gtest/gtest.h>

#include <string>

namespace moserhex::app
{

/** A folder of its own for each test. */
class BatchTest : public testing::Test
{
protected:
  [[nodiscard]] std::string
  folder() const
  {
    return m_Folder / "";
  }

private:
  TestFolder m_Folder;
};

} // namespace moserhex::app
