// Exact: text as users and spreadsheets write it.
#include "TextTable.h"

#include "TestFolder.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <gtest/gtest.h>

#include <limits>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

using Cells = std::vector<std::string>;

class TextTableFile : public testing::Test
{
protected:
  [[nodiscard]] TextTable
  table(const std::string & text, const std::string & name = "list.csv") const
  {
    writeBytes(m_Folder / name, text);
    return readTextTable(m_Folder / name);
  }

  [[nodiscard]] std::string
  refusal(const std::string & text, const std::string & name = "list.csv") const
  {
    return messageOf<BadInput>([&] { (void)table(text, name); });
  }

  TestFolder m_Folder;
};

void
expectMentions(const std::string & message, const std::string & part)
{
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

} // namespace

TEST_F(TextTableFile, CommasSeparateColumnsAndLinesAreCounted)
{
  const TextTable read = table("input,label\na.nrrd,1\nb.nrrd,2\n");
  EXPECT_EQ(read.columns, (Cells{ "input", "label" }));
  ASSERT_EQ(read.rows.size(), 2u);
  EXPECT_EQ(read.rows[1].cells, (Cells{ "b.nrrd", "2" }));
  EXPECT_EQ(read.rows[1].line, 3u);
}

TEST_F(TextTableFile, TheLastLineNeedsNoEnd)
{
  EXPECT_EQ(table("a,b\n1,").rows.at(0).cells, (Cells{ "1", "" }));
  EXPECT_EQ(table("a,b\n1,2").rows.at(0).cells, (Cells{ "1", "2" }));
  EXPECT_EQ(table("a,b\n1,\"2\"").rows.at(0).cells, (Cells{ "1", "2" }));
}

TEST_F(TextTableFile, QuotedCellsHoldSeparatorsQuotesAndLines)
{
  const TextTable read = table("a,b\r\n\"x, y\",\"he said \"\"no\"\"\"\r\n\"two\r\nlines\",\"\"\r\nlast,1\r\n");
  ASSERT_EQ(read.rows.size(), 3u);
  EXPECT_EQ(read.rows[0].cells, (Cells{ "x, y", "he said \"no\"" }));
  EXPECT_EQ(read.rows[1].cells, (Cells{ "two\r\nlines", "" }));
  EXPECT_EQ(read.rows[1].line, 3u);
  EXPECT_EQ(read.rows[2].line, 5u);
}

TEST_F(TextTableFile, BlanksAroundCellsAreCutAndThoseInQuotesKept)
{
  const TextTable read = table(" a ,\tb\n x y , \" z \" \n");
  EXPECT_EQ(read.columns, (Cells{ "a", "b" }));
  EXPECT_EQ(read.rows.at(0).cells, (Cells{ "x y", " z " }));
}

TEST_F(TextTableFile, AQuoteInsideACellIsACharacter)
{
  EXPECT_EQ(table("a,b\n5\" nail,c\"d\"\n").rows.at(0).cells, (Cells{ "5\" nail", "c\"d\"" }));
}

TEST_F(TextTableFile, ByteOrderMarkAndCarriageReturnsAreNoText)
{
  const TextTable read = table("\xEF\xBB\xBFinput,label\r\na,1\r\n");
  EXPECT_EQ(read.columns, (Cells{ "input", "label" }));
  EXPECT_EQ(read.rows.at(0).cells, (Cells{ "a", "1" }));
}

TEST_F(TextTableFile, SemicolonsSeparateWhereTheFirstLineHasNoComma)
{
  EXPECT_EQ(table("a;b\n1,5;x\n").rows.at(0).cells, (Cells{ "1,5", "x" }));
  EXPECT_EQ(table("\n\na;b\n1,5;x\n").rows.at(0).cells, (Cells{ "1,5", "x" }));
  EXPECT_EQ(table("a;b,c\n1;2,3\n").columns, (Cells{ "a;b", "c" }));
}

TEST_F(TextTableFile, TabsSeparateInTsvAlone)
{
  EXPECT_EQ(table("a\tb\n1, 2\t\n", "list.tsv").rows.at(0).cells, (Cells{ "1, 2", "" }));
  EXPECT_EQ(table("a;b\tc\n\t2\n", "LIST.TSV").rows.at(0).cells, (Cells{ "", "2" }));
  EXPECT_EQ(table("a\tb\n1\t2\n").columns, (Cells{ "a\tb" }));
}

TEST_F(TextTableFile, EmptyLinesDoNotCountButAreNumbered)
{
  const TextTable read = table("\na,b\n\n  \n,\r\n\"\",\n1,2\n\n");
  ASSERT_EQ(read.rows.size(), 1u);
  EXPECT_EQ(read.rows[0].line, 7u);
}

TEST_F(TextTableFile, ColumnsWithoutNamesOrWithTheSameOneAreRefused)
{
  expectMentions(refusal("a,,c\n"), "line 1: column 2 has no name");
  expectMentions(refusal("a,b,a\n"), "two columns are called a");
  expectMentions(refusal(""), "no column names");
  expectMentions(refusal("\xEF\xBB\xBF\r\n \r\n"), "no column names");
}

TEST_F(TextTableFile, RowsOfOtherLengthsAreRefusedWithTheirLine)
{
  expectMentions(refusal("a,b\n1,2\n1\n"), "list.csv: line 3: 1 cells for 2 columns");
  expectMentions(refusal("a,b\n1,2,3\n"), "line 2: 3 cells for 2 columns");
}

TEST_F(TextTableFile, OpenQuotesAndTextBehindQuotesAreRefused)
{
  expectMentions(refusal("a,b\n1,2\n\"x,1\ny,2\n"), "line 3: a quote is not closed");
  expectMentions(refusal("a,b\n\"x\"y,1\n"), "line 2: text behind a closing quote");
}

TEST_F(TextTableFile, OtherEncodingsAndEndsOfLinesAreRefused)
{
  expectMentions(refusal("a,b\rc,d\r"), "line 1: a carriage return");
  expectMentions(refusal(std::string("a,b\nc\0,d\n", 9)), "line 2: a zero byte");
  expectMentions(refusal(std::string("\xFF\xFE"
                                     "a\0,\0",
                                     6)),
                 "UTF-8");
}

TEST_F(TextTableFile, MissingFilesAndFoldersAreNoTables)
{
  EXPECT_EQ(codeThrownBy([&] { (void)readTextTable(m_Folder / "none.csv"); }), ErrorCode::NoInput);
  EXPECT_EQ(codeThrownBy([&] { (void)readTextTable(m_Folder / ""); }), ErrorCode::NoInput);
}

TEST_F(TextTableFile, LinesAreCellsWhateverTheyHold)
{
  writeBytes(m_Folder / "list.txt", "\xEF\xBB\xBF#1, \"a\".nrrd\r\n\n  b.nrrd \t\n\tc d.nrrd");
  const TextTable read = readTextLines(m_Folder / "list.txt", "input");
  EXPECT_EQ(read.columns, (Cells{ "input" }));
  ASSERT_EQ(read.rows.size(), 3u);
  EXPECT_EQ(read.rows[0].cells, (Cells{ "#1, \"a\".nrrd" }));
  EXPECT_EQ(read.rows[1].cells, (Cells{ "b.nrrd" }));
  EXPECT_EQ(read.rows[1].line, 3u);
  EXPECT_EQ(read.rows[2].cells, (Cells{ "c d.nrrd" }));
  writeBytes(m_Folder / "list.txt", "a\rb\r");
  expectMentions(messageOf<BadInput>([&] { (void)readTextLines(m_Folder / "list.txt", "input"); }), "carriage return");
}

TEST(TableLine, QuotesWhatWouldBeReadDifferently)
{
  EXPECT_EQ(tableLine({ "a", "b c", "" }, ','), "a,b c,\n");
  EXPECT_EQ(tableLine({ "a,b", "c\"d", "e\nf", "g\rh", " i", "j\t" }, ','),
            "\"a,b\",\"c\"\"d\",\"e\nf\",\"g\rh\",\" i\",\"j\t\"\n");
  EXPECT_EQ(tableLine({ "a,b", "c\td" }, '\t'), "a,b\t\"c\td\"\n");
}

TEST(TableLine, FormulasAreDefusedAndNumbersAreNot)
{
  EXPECT_EQ(tableLine({ "=1+1", "@SUM(A1)", "+A1", "-A1", "-", "-1+1|cmd" }, '\t'),
            "'=1+1\t'@SUM(A1)\t'+A1\t'-A1\t'-\t'-1+1|cmd\n");
  EXPECT_EQ(tableLine({ "=HYPERLINK(\"x\",\"y\")" }, ','), "\"'=HYPERLINK(\"\"x\"\",\"\"y\"\")\"\n");
  EXPECT_EQ(tableLine({ "\t=1", "\r=1" }, ','), "'\t=1,\"'\r=1\"\n");
  EXPECT_EQ(tableLine({ "-1", "+2.5", "-.5e-3", "-1e999", "3" }, ','), "-1,+2.5,-.5e-3,-1e999,3\n");
  EXPECT_EQ(tableLine({ "-inf", "+-1", "-0x1" }, ','), "'-inf,'+-1,'-0x1\n");
}

TEST(TableLine, ExactLinesKeepWhatLooksLikeAFormula)
{
  EXPECT_EQ(exactLine({ "=1+1", "-", "a,b", "+L1" }, ','), "=1+1,-,\"a,b\",+L1\n");
}

TEST_F(TextTableFile, LinesComeBackAsTheyWere)
{
  const Cells cells{ "a,b", "\"", "\"\"x", "two\r\nlines", " blank ", "\xC3\xB6", "x\ty", "1;2", "" };
  for (const auto & [separator, name] : { std::pair(',', "list.csv"), std::pair('\t', "list.tsv") })
  {
    const std::string names = tableLine({ "a", "b", "c", "d", "e", "f", "g", "h", "i" }, separator);
    EXPECT_EQ(table(names + tableLine(cells, separator), name).rows.at(0).cells, cells);
  }
}

TEST(TextTable, NumbersComeBackAsTheyWere)
{
  EXPECT_EQ(numberText(0.1), "0.1");
  EXPECT_EQ(numberText(1e12), "1000000000000");
  EXPECT_EQ(numberText(-3.0), "-3");
  EXPECT_EQ(numberText(std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_EQ(std::stod(numberText(1.0 / 3.0)), 1.0 / 3.0);
}
