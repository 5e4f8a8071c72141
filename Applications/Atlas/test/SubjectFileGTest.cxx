// Exact: numbers come back bit for bit.
#include "SubjectFile.h"

#include "TestFolder.h"
#include "moserhex/Analytic/Refusals.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::app;

TEST(SubjectFile, RowsAndSlabsComeBack)
{
  const TestFolder folder;
  SubjectFile      file(folder / "", 5, 12);
  Eigen::MatrixXd  values(5, 12);
  for (Eigen::Index row = 0; row < 5; ++row)
  {
    values.row(row) = Eigen::RowVectorXd::LinSpaced(12, row / 3.0, row + 7.0);
    file.writeSubject(static_cast<std::size_t>(row), values.row(row).transpose());
  }
  EXPECT_EQ(file.read(3, 5), values.middleCols(3, 5));
  EXPECT_EQ(file.readSubject(4), values.row(4).transpose());
  Eigen::MatrixXd chosen(2, 12);
  chosen << values.row(4), values.row(1);
  EXPECT_EQ(ChosenSubjects(file, { 4, 1 }).read(0, 12), chosen);
  EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(SubjectFile, AFolderThatIsNotThereIsRefused)
{
  EXPECT_NE(analytic::messageOf<Error>([] { SubjectFile("/no/such/folder", 2, 3); }).find("cannot make"),
            std::string::npos);
}
