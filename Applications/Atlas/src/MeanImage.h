#pragma once

#include "AtlasOptions.h"
#include "AtlasSubjects.h"
#include "SubjectMeshes.h"
#include "moserhex/HexMeshIO/FieldValues.h"
#include "moserhex/LevelSet/FieldVolume.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace moserhex::app
{

/** Images of many subjects in the cube. */
struct MeanImage
{
  FieldVolume              mean;      ///< on cubeGrid; of images of several components each by itself
  FieldVolume              deviation; ///< standard deviation over the subjects, divisor N - 1
  FieldValues              kind{ FieldValues::Numbers }; ///< of the subjects' images, as the first one's file says
  std::size_t              subjects{ 0 };
  std::vector<std::string> leftOut; ///< names of the other subjects
  std::vector<bool>        isKnown; ///< of every subject: is in the mean
  /** A row a subject: its image, zeros where it is left out. Nothing where no test is asked for, or samples are no
   * cells of the lattice, or have more than three components. */
  std::unique_ptr<SubjectFile> values;
  std::vector<std::string>     warnings;
};

/** Carries every subject's image to the cube by its own mesh, as `moserhex transfer --to-cube` does, and adds it to the
 * mean. One image at a time is in memory; where it is to be tested, all lie in a file without a name. Left out, with a
 * warning each: subjects without an image in the table, with one that does not cover the whole mesh, is not a number
 * somewhere in it, or, where it is to be normalised, constant in it.
 *
 * With options.normaliseImages every component c is made (c - mean) / deviation first, both over the organ's volume.
 *
 * \param meshes  as read, not aligned: they lie where the images do
 * \param done    is told the part done, in [0,1]
 * \throws BadInput  as readFieldImage; images of other than the first one's number of components; meshes with padding,
 * whose lattices end inside the organ; a cell without positive volume; fewer than two images are left; IOError */
[[nodiscard]] MeanImage
meanImage(const AtlasSubjects &               subjects,
          const SubjectMeshes &               meshes,
          const AtlasOptions &                options,
          const std::function<void(double)> & done);

/** An image of the cube on voxels, linear between its samples, 0 where a centre is not in the mesh: as `moserhex
 * transfer --to-image` does. \throws InvalidInput  as CubeMap and gridSamples */
[[nodiscard]] FieldVolume
imageInMesh(const FieldVolume & cube, const HexMesh & mesh, const VoxelGrid & grid, unsigned int threads);

/** Finds what would stop meanImage before any work is done.
 * \throws UsageError  the sampling is none; BadInput  no such column, or an image that is not there */
void
requireImages(const AtlasSubjects & subjects, const AtlasOptions & options);

} // namespace moserhex::app
