#pragma once

#include <string>
#include <vector>

namespace moserhex::fuzz
{

enum class SeedUse
{
  Labelmap,
  Surface,
  Hexahedra,
  Field, ///< an image of several numbers per voxel
  Points
};

struct SeedFile
{
  std::string name; ///< with its ending
  std::string bytes;
};

/** A valid file, made in code, and what it needs beside it. */
struct Seed
{
  SeedUse               use{ SeedUse::Labelmap };
  std::string           format;     ///< "nrrd-raw": one row of the mutation driver's table
  SeedFile              file;       ///< what is changed
  std::vector<SeedFile> companions; ///< left as they are
};

/** Small valid files of every format that the library reads: a labelled ball of 12^3 voxels, triangulated cubes and
 * spheres, hexahedral blocks, vectors and tensors on 5^3 voxels, lists of points. The same bytes every time.
 * \throws std::runtime_error  the temporary folder cannot be used */
[[nodiscard]] std::vector<Seed>
makeSeeds();

} // namespace moserhex::fuzz
