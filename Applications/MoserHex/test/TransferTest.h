#pragma once

#include "CommandTest.h"

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/HexMeshIO/FieldImageWriter.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** A bent, tapered bar in [0,40] x [0,40] x [0,20], roughly, of 8^3 nodes. */
[[nodiscard]] HexMesh
bentBar(double bend);

/** A smooth positive function. */
[[nodiscard]] double
smoothDensity(const Vector3 & p);

/** Voxels around every bar. */
[[nodiscard]] VoxelGrid
gridAroundBars();

/** An image around every bar; f(position, values) appends the numbers of a voxel. */
template <typename TFunction>
[[nodiscard]] FieldVolume
imageOf(int components, const TFunction & f)
{
  FieldVolume image{ gridAroundBars(), components, {} };
  for (int k = 0; k < image.size[2]; ++k)
  {
    for (int j = 0; j < image.size[1]; ++j)
    {
      for (int i = 0; i < image.size[0]; ++i)
      {
        f(image.point(i, j, k), image.values);
      }
    }
  }
  return image;
}

/** An image of the same numbers everywhere. */
[[nodiscard]] FieldVolume
constantImage(const std::vector<double> & numbers);

/** Positions as vectors. */
[[nodiscard]] FieldVolume
imageOfPositions();

[[nodiscard]] double
sumOfValues(const FieldVolume & image);

/** Two bars, a.vtu and b.vtu, a smooth density, smooth.nrrd, and `moserhex transfer` of files of the test's folder. */
class TransferCommand : public CommandTest
{
protected:
  void
  SetUp() override;

  [[nodiscard]] FieldVolume
  image(const std::string & name) const;

  /** moserhex transfer INPUT --mesh a.vtu OPTIONS */
  [[nodiscard]] Outcome
  transferOf(const std::string & input, const std::vector<std::string> & options) const;

  /** The same, which must succeed without a warning. */
  void
  transfer(const std::string & input, const std::vector<std::string> & options) const;

  HexMesh m_Mesh; ///< a.vtu
};

} // namespace moserhex::app
