// Real labelmaps, from the folder MoserHex_DEVELOPMENT_DATA; skipped where it is empty. Topology is exact; the Dice
// coefficients are those of smoothing slices of 3 to 3.6 mm, measured 0.987 to 0.997, and 0.978 with long thin parts.
#include "itkLabelConditioningImageFilter.h"
#include "itkLevelSetConversion.h"

#include "moserhex/Geometry/TriangleTopology.h"
#include "moserhex/LevelSet/MarchingTetrahedra.h"

#include <itkImageFileReader.h>
#include <itkNiftiImageIO.h>
#include <itksys/Directory.hxx>
#include <itksys/SystemTools.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace
{

using LabelImage = itk::Image<unsigned char, 3>;
using Filter = itk::LabelConditioningImageFilter<LabelImage>;

const std::string developmentData = MOSERHEX_DEVELOPMENT_DATA;

Filter::Pointer
filterFor(const std::string & path)
{
  const auto reader = itk::ImageFileReader<LabelImage>::New();
  reader->SetImageIO(itk::NiftiImageIO::New());
  reader->SetFileName(path);
  reader->Update();
  const auto filter = Filter::New();
  filter->SetInput(reader->GetOutput());
  return filter;
}

std::vector<std::string>
filesIn(const std::string & folder)
{
  std::vector<std::string> files;
  itksys::Directory        directory;
  directory.Load(folder);
  for (unsigned long n = 0; n < directory.GetNumberOfFiles(); ++n)
  {
    const std::string name = directory.GetFile(n);
    if (name.find(".nii") != std::string::npos)
    {
      files.push_back(folder + "/" + name);
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

void
expectBall(const std::string & path, unsigned char label = 1, double smallestDice = 0.98)
{
  const auto filter = filterFor(path);
  filter->SetLabel(label);
  ASSERT_NO_THROW(filter->Update()) << path;
  const moserhex::LevelSet phi = itk::LevelSetFromImage(filter->GetOutput());
  for (const double level : { -0.2, 0.0, 0.2 })
  {
    const auto mesh = moserhex::marchingTetrahedra(phi, level * phi.grid.spacing);
    EXPECT_TRUE(moserhex::summarizeTopology(mesh).isSphere()) << path << " level " << level;
  }
  EXPECT_LT(std::abs(filter->GetReport().volumeError), 1e-4) << path;
  EXPECT_GT(filter->GetReport().dice, smallestDice) << path;
}

void
expectRejected(const std::string & path, const std::string & message)
{
  const auto filter = filterFor(path);
  filter->SetTopologyPolicy(moserhex::TopologyPolicy::Reject);
  try
  {
    filter->Update();
    FAIL() << path << " accepted";
  }
  catch (const itk::InvalidInputError & error)
  {
    EXPECT_EQ(std::string(error.GetDescription()), message) << path;
  }
}

class RealLabels : public testing::Test
{
protected:
  void
  SetUp() override
  {
    if (developmentData.empty() || !itksys::SystemTools::FileExists(developmentData + "/dev"))
    {
      GTEST_SKIP() << "MoserHex_DEVELOPMENT_DATA does not name a folder of labelmaps";
    }
  }
};

} // namespace

TEST_F(RealLabels, EveryDevelopmentProstateBecomesABall)
{
  const auto files = filesIn(developmentData + "/dev/Bosma22b");
  EXPECT_EQ(files.size(), 15u);
  for (const std::string & file : files)
  {
    expectBall(file);
  }
}

TEST_F(RealLabels, ProstatesWithHolesInSlicesAndNonManifoldEdgesBecomeBalls)
{
  const std::string folder = developmentData + "/nasty/picai_Bosma22b/";
  for (const char * name : { "10012_1000012", "10183_1000186", "10591_1000605", "11408_1001432" })
  {
    expectBall(folder + name + ".nii.gz");
  }
}

TEST_F(RealLabels, LabelsWithHandlesAreRejectedWithTheirNumbers)
{
  expectRejected(developmentData + "/nasty/picai_Bosma22b/11050_1001070.nii.gz",
                 "label 1: 2 handles, V-E+F = -2, need 2 (genus 0)");
  expectRejected(developmentData + "/classic/squirrel_vhacd.nii.gz",
                 "label 1: 2 components, 1 handle, V-E+F = 2, need 2 (genus 0)");
  expectRejected(developmentData + "/classic/femur_cgal.nii.gz",
                 "label 1: 1 cavity, 3 handles, V-E+F = -2, need 2 (genus 0)");
}

TEST_F(RealLabels, LabelsWithHandlesAreRepaired)
{
  expectBall(developmentData + "/nasty/picai_Bosma22b/11050_1001070.nii.gz", 1, 0.97);
  const std::string folder = developmentData + "/dev/zonal_Yuan23";
  for (const std::string & file : filesIn(folder))
  {
    expectBall(file, 2); // transition zone
  }
}
