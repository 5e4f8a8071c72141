#pragma once

#include "CasePage.h"
#include "moserhex/Analytic/Lattices.h"
#include "moserhex/LevelSet/LabelVolume.h"

#include <cstddef>
#include <string>

namespace moserhex::app
{

/** A run of which nothing is to be said against. */
inline RunReport
goodReport()
{
  RunReport report;
  report.input.file = "folder/organ.nrrd";
  report.input.sha256 = "00ff";
  report.input.labels = { 1 };
  report.input.spacing = Vector3(1.0, 1.0, 1.0);
  report.input.voxels = 1000;
  report.input.volume = 1000.0;
  report.parameters.shells = 2;
  report.parameters.stage = "exact";
  report.conditioning = RunReport::Conditioning{};
  report.conditioning->dice = 0.995;
  report.conditioning->voxelVolume = 1.0;
  report.stages = { { "exact", 1.5, StageQuality{ 1e-26, 0.0, 0.25, 0.75, 0.5 }, "3 steps" } };
  report.mesh = { "folder/organ.vtu", 64, 27, 1000.0 };
  report.surface = RunReport::Surface{ 0.1, 0.5 };
  report.exact = RunReport::Exact{};
  report.exact->reached = report.exact->certified = true;
  report.exact->variance = 1e-28;
  report.versions = { "1.2.3", "abc", "5.2", "9.1", "3.3" };
  return report;
}

/** A template with all that can be known of it. */
inline RunReport::Template
tieToTemplate()
{
  return { { { "mesh", "folder/base.vtu", "aa" },
             { "landmarks", "points.csv", "bb" },
             { "template_landmarks", "base.csv", "cc" },
             { "image", "t2.nrrd", "dd" },
             { "template_image", "base_t2.nrrd", "ee" } },
           "affine",
           RunReport::Alignment{ 4.0, 12.5, 3.5 },
           RunReport::Placement{ 1.02, 0.25, 0.125 },
           "template",
           RunReport::Residual{ 2.75, 0.375 },
           RunReport::Residual{ 1.25, 0.5 },
           {} };
}

/** A box of 4 x 6 x 8 voxels of 1 x 1 x 2 mm, voxel (3,3,3) the first of them, in an image of 12^3 voxels. */
inline LabelVolume
boxLabel()
{
  LabelVolume label;
  label.size = { 12, 12, 12 };
  label.spacing = Vector3(1.0, 1.0, 2.0);
  label.origin = Vector3(-5.0, 10.0, 100.0);
  label.inside.assign(label.gridVoxels(), 0);
  for (int k = 3; k < 11; ++k)
  {
    for (int j = 3; j < 9; ++j)
    {
      for (int i = 3; i < 7; ++i)
      {
        label.inside[label.voxelNumber(i, j, k)] = 1;
      }
    }
  }
  return label;
}

inline std::size_t
timesIn(const std::string & text, const std::string & what)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + what.size()))
  {
    ++count;
  }
  return count;
}

} // namespace moserhex::app
