// Exact comparisons of text.
#include "moserhex/HexMeshIO/FileErrors.h"

#include <gtest/gtest.h>

using namespace moserhex;

TEST(FileMessage, NamesFileCauseAndRemedy)
{
  EXPECT_EQ(fileMessage("a.nrrd", "is empty", "export it again"), "a.nrrd: is empty; export it again");
}

TEST(FileMessage, IsOneLineOfAtMost200Characters)
{
  const std::string message =
    fileMessage(std::string(500, 'x') + "\n.nrrd", std::string(500, 'y') + "\r\n", std::string(500, 'z'));
  EXPECT_LE(message.size(), 200u);
  EXPECT_EQ(message.find_first_of("\r\n"), std::string::npos);
}

TEST(FileMessage, KeepsTheEndOfALongName)
{
  EXPECT_NE(fileMessage("/folder/" + std::string(300, 'x') + "/case.nrrd", "c", "r").find("/case.nrrd: c; r"),
            std::string::npos);
}

TEST(FileMessage, NeverCutsACharacterInTwo)
{
  std::string name;
  for (int i = 0; i < 100; ++i)
  {
    name += "\xC3\xBC"; // u umlaut
  }
  for (std::size_t shift = 0; shift < 2; ++shift)
  {
    const std::string message = fileMessage(name + std::string(shift, 'a'), "cause", "remedy");
    EXPECT_EQ(message.compare(0, 5, "...\xC3\xBC"), 0) << message;
  }
}

TEST(FileMessage, GivesTheNamesPlaceToALongCause)
{
  const std::string cause(100, 'c');
  const std::string message = fileMessage(std::string(60, 'x') + "/case.nrrd", cause, "try another number of shells");
  EXPECT_NE(message.find("/case.nrrd: " + cause + "; try another number of shells"), std::string::npos) << message;
}

TEST(OneLine, CutsAtTheEndOfAWordSoThatNoNumberLosesDigits)
{
  const std::string text = "the boundary is up to 123.456 mm off";
  EXPECT_EQ(oneLine(text, text.size()), text);
  EXPECT_EQ(oneLine(text, text.size() - 1), "the boundary is up to 123.456 mm...");
  EXPECT_EQ(oneLine(text, 29), "the boundary is up to...");
  EXPECT_EQ(oneLine(std::string(100, 'x'), 50), std::string(47, 'x') + "...");
}

TEST(FileErrors, AreErrorsOfDifferentKinds)
{
  EXPECT_THROW(throw BadInput(ErrorCode::Header, "f", "c", "r"), Error);
  EXPECT_THROW(throw IOError(ErrorCode::InputOutput, "f", "c", "r"), Error);
}
