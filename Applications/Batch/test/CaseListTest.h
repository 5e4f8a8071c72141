#pragma once

#include "CaseList.h"
#include "CommandErrors.h"
#include "TestFolder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace moserhex::app
{

/** A folder with empty files, and lists of cases of it whose outputs go to its folder `out`. */
class CaseListTest : public testing::Test
{
protected:
  [[nodiscard]] std::string
  path(const std::string & name) const
  {
    return m_Folder / name;
  }

  void
  write(const std::string & name, const std::string & text) const
  {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    writeBytes(path(name), text);
  }

  void
  touch(const std::vector<std::string> & names) const
  {
    for (const std::string & name : names)
    {
      write(name, "");
    }
  }

  /** \param inputs  in the folder */
  [[nodiscard]] CaseListOptions
  optionsFor(const std::vector<std::string> & inputs) const
  {
    CaseListOptions options;
    for (const std::string & input : inputs)
    {
      options.inputs.push_back(path(input));
    }
    options.outputFolder = path("out");
    options.defaults.input.sandbox = false;
    return options;
  }

  [[nodiscard]] CaseList
  listOf(const std::vector<std::string> & inputs) const
  {
    return listCases(optionsFor(inputs));
  }

  [[nodiscard]] static std::vector<std::string>
  namesOf(const CaseList & list)
  {
    std::vector<std::string> names;
    for (const BatchCase & one : list.cases)
    {
      names.push_back(one.name);
    }
    return names;
  }

  [[nodiscard]] std::vector<std::string>
  names(const std::vector<std::string> & inputs) const
  {
    return namesOf(listOf(inputs));
  }

  /** The message of the usage error; it must fit into the line that is printed. */
  [[nodiscard]] static std::string
  refusal(const CaseListOptions & options)
  {
    const std::string message = messageOf<UsageError>([&] { (void)listCases(options); });
    EXPECT_LE(message.size(), 183u) << message;
    return message;
  }

  [[nodiscard]] std::string
  refusalOf(const std::vector<std::string> & inputs) const
  {
    return refusal(optionsFor(inputs));
  }

  TestFolder m_Folder;
};

inline void
expectMentions(const std::string & message, const std::string & part)
{
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

using Names = std::vector<std::string>;

} // namespace moserhex::app
