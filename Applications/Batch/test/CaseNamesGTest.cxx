// Exact: names of files.
#include "CaseNames.h"

#include <gtest/gtest.h>

using namespace moserhex::app;

TEST(CaseNames, EndingsOfInputsAreCutAsAWhole)
{
  EXPECT_EQ(stemOf("p/sub-01_dseg.nii.gz"), "p/sub-01_dseg");
  EXPECT_EQ(stemOf("X.seg.nrrd"), "X");
  EXPECT_EQ(stemOf("X.SEG.NRRD"), "X");
  EXPECT_EQ(stemOf("X.v2.NII"), "X.v2");
  EXPECT_EQ(stemOf("X.stl"), "X");
  EXPECT_EQ(stemOf("mask"), "mask");
  EXPECT_EQ(stemOf("X.seg"), "X.seg");
}

TEST(CaseNames, ReportsStandBesideTheirMeshes)
{
  EXPECT_EQ(reportNameOf("a.b/c.d.vtu"), "a.b/c.d.json");
}

TEST(CaseNames, LabelsStandWhereBidsWantsThem)
{
  EXPECT_EQ(labelledName("sub-01/anat/sub-01_dseg.vtu", "GM"), "sub-01/anat/sub-01_label-GM_dseg.vtu");
  EXPECT_EQ(labelledName("sub-01_ses-2_space-T1w_res-2_dseg.vtu", "3"),
            "sub-01_ses-2_space-T1w_res-2_label-3_dseg.vtu");
  EXPECT_EQ(labelledName("sub-01_desc-manual_dseg.vtu", "3"), "sub-01_label-3_desc-manual_dseg.vtu");
  EXPECT_EQ(labelledName("sub-01_label-GM_desc-x_mask.vtu", "3"), "sub-01_label-GM+3_desc-x_mask.vtu");
}

TEST(CaseNames, ExtendedLabelsAreBidsNames)
{
  EXPECT_EQ(labelledName("sub-01_label-GM+WM_mask.vtu", "3"), "sub-01_label-GM+WM+3_mask.vtu");
}

TEST(CaseNames, LabelsStandAtTheEndOfOtherNames)
{
  EXPECT_EQ(labelledName("atlas.vtu", "3"), "atlas_label-3.vtu");
  EXPECT_EQ(labelledName("sub-01_dseg/atlas.v1.vtu", "3"), "sub-01_dseg/atlas.v1_label-3.vtu");
  for (const std::string stem : { "sub-01",
                                  "sub-_dseg",
                                  "sub-01_",
                                  "sub-01_T1w_dseg",
                                  "sub-01__dseg",
                                  "sub-01_run-_dseg",
                                  "sub-01_d.seg",
                                  "01_dseg" })
  {
    EXPECT_EQ(labelledName(stem + ".vtu", "3"), stem + "_label-3.vtu");
  }
}

TEST(CaseNames, WhatTheBatchKeepsIsKnownInAnyCase)
{
  for (const char * name :
       { "summary.csv", "Summary.JSON", "summary.html", "journal.jsonl", "journal-2.jsonl", ".lock", ".lock-1" })
  {
    EXPECT_TRUE(isNameOfBatch(name)) << name;
  }
  for (const char * name : { "summary.vtu", "a-summary.csv", "journal.json", "journal", "lock" })
  {
    EXPECT_FALSE(isNameOfBatch(name)) << name;
  }
}

TEST(CaseNames, PathsAreComparedWithoutNeedlessParts)
{
  EXPECT_EQ(normalPath("/a/./b//c/../"), "/a/b");
  EXPECT_EQ(normalPath("/"), "/");
  EXPECT_EQ(normalPath(""), std::filesystem::current_path());
  EXPECT_EQ(normalPath("x"), std::filesystem::current_path() / "x");
  EXPECT_TRUE(staysBelow("a/b"));
  EXPECT_TRUE(staysBelow("..a"));
  EXPECT_FALSE(staysBelow("../a"));
  EXPECT_FALSE(staysBelow("/a"));
  EXPECT_FALSE(staysBelow(""));
}

TEST(CaseNames, TheCommonFolderEndsAtAWholeName)
{
  EXPECT_EQ(commonFolder({ "/d/sub-1/a.nrrd" }), "/d/sub-1");
  EXPECT_EQ(commonFolder({ "/d/sub-1/a.nrrd", "/d/sub-10/a.nrrd" }), "/d");
  EXPECT_EQ(commonFolder({ "/d/x/a.nrrd", "/d/x/y/../b.nrrd" }), "/d/x");
  EXPECT_EQ(commonFolder({ "/d/a.nrrd", "/e/a.nrrd" }), "/");
}
