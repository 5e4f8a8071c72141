#include "moserhex/LevelSet/LabelDiagnosis.h"

#include "VoxelParts.h"
#include "moserhex/LevelSet/SignedDistance.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace moserhex
{
namespace
{

/** Where the first voxel of a tight box is in the image it was cut out of. */
std::array<int, 3>
indexInImage(const LabelVolume & image, const LabelVolume & tight)
{
  const Vector3 index = image.continuousIndex(tight.origin);
  return { { static_cast<int>(std::lround(index.x())),
             static_cast<int>(std::lround(index.y())),
             static_cast<int>(std::lround(index.z())) } };
}

ImageBorders
bordersOf(const LabelVolume & image, const std::array<int, 3> & first, const std::array<int, 3> & last)
{
  ImageBorders borders;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    borders.touched[2 * axis] = first[axis] == 0;
    borders.touched[2 * axis + 1] = last[axis] == image.size[axis] - 1;
  }
  return borders;
}

std::array<int, 3>
lastOf(const std::array<int, 3> & first, const LabelVolume & tight)
{
  return { { first[0] + tight.size[0] - 1, first[1] + tight.size[1] - 1, first[2] + tight.size[2] - 1 } };
}

/** Edges along each axis where two voxels of four meet that share no face. The label has an empty margin. */
std::size_t
nonManifoldEdges(const LabelVolume & padded)
{
  const std::array<std::size_t, 3> strides{ { 1, padded.voxelNumber(0, 1, 0), padded.voxelNumber(0, 0, 1) } };
  const auto &                     in = padded.inside;
  std::size_t                      edges = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t a = strides[axis];
    const std::size_t b = strides[(axis + 1) % 3];
    for (std::size_t v = 0; v + a + b < in.size(); ++v)
    {
      edges += in[v] == in[v + a + b] && in[v + a] == in[v + b] && in[v] != in[v + a] ? 1 : 0;
    }
  }
  return edges;
}

/** Corners of voxels where two opposite ones of eight are inside and no other, or outside and no other. */
std::size_t
nonManifoldVertices(const LabelVolume & padded)
{
  const std::size_t                x = 1;
  const std::size_t                y = padded.voxelNumber(0, 1, 0);
  const std::size_t                z = padded.voxelNumber(0, 0, 1);
  const std::array<std::size_t, 8> corners{ { 0, x, y, x + y, z, x + z, y + z, x + y + z } };
  std::size_t                      vertices = 0;
  for (std::size_t v = 0; v + corners[7] < padded.inside.size(); ++v)
  {
    int count = 0;
    for (const std::size_t corner : corners)
    {
      count += padded.inside[v + corner];
    }
    if (count != 2 && count != 6)
    {
      continue;
    }
    const int alone = count == 2 ? 1 : 0;
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      vertices +=
        padded.inside[v + corners[corner]] == alone && padded.inside[v + corners[7 - corner]] == alone ? 1 : 0;
    }
  }
  return vertices;
}

} // namespace

int
ImageBorders::count() const
{
  return static_cast<int>(std::count(touched.begin(), touched.end(), true));
}

bool
ImageBorders::any() const
{
  return count() > 0;
}

std::string
ImageBorders::names() const
{
  const std::array<const char *, 6> all{ { "first i", "last i", "first j", "last j", "first k", "last k" } };
  std::string                       text;
  for (std::size_t border = 0; border < 6; ++border)
  {
    if (touched[border])
    {
      text += text.empty() ? all[border] : std::string(", ") + all[border];
    }
  }
  return text;
}

ImageBorders
imageBordersTouched(const LabelVolume & label)
{
  const LabelVolume        tight = cropAndPad(label, { { 0, 0, 0 } });
  const std::array<int, 3> first = indexInImage(label, tight);
  return bordersOf(label, first, lastOf(first, tight));
}

LabelDiagnosis
diagnoseLabel(const LabelVolume & label, unsigned int threads)
{
  LabelDiagnosis    diagnosis;
  const LabelVolume tight = cropAndPad(label, { { 0, 0, 0 } });
  diagnosis.firstIndex = indexInImage(label, tight);
  diagnosis.lastIndex = lastOf(diagnosis.firstIndex, tight);
  diagnosis.borders = bordersOf(label, diagnosis.firstIndex, diagnosis.lastIndex);

  LabelVolume padded = cropAndPad(tight, { { 1, 1, 1 } });
  diagnosis.voxels = voxelCount(padded);
  diagnosis.volume = static_cast<double>(diagnosis.voxels) * padded.voxelVolume();
  diagnosis.topology = voxelTopology(padded);
  diagnosis.componentVoxels = detail::connectedParts(padded, true, detail::Adjacency::Faces).voxels;
  std::sort(diagnosis.componentVoxels.begin(), diagnosis.componentVoxels.end(), std::greater<std::size_t>());
  diagnosis.nonManifoldEdges = nonManifoldEdges(padded);
  diagnosis.nonManifoldVertices = nonManifoldVertices(padded);
  const std::vector<double> distance = voxelSignedDistance(padded, { { true, true, true } }, threads);
  diagnosis.depth = -*std::min_element(distance.begin(), distance.end());

  LabelVolume filled = padded;
  diagnosis.cavityVoxels = fillCavitiesInPlace(filled).voxels;
  keepLargestComponentInPlace(padded);
  fillCavitiesInPlace(padded);
  diagnosis.largestComponent = voxelTopology(padded);
  return diagnosis;
}

} // namespace moserhex
