#include "moserhex/Deformation/LatticeLines.h"

#include <array>
#include <limits>

namespace moserhex
{
namespace
{

/** Whether a line across (a, b) of the other two axes lies in a face of the cube. */
bool
isInFace(const HexMesh & mesh, int a, int b)
{
  const int last = mesh.nodesPerSide - 1;
  return a == 0 || a == last || b == 0 || b == last;
}

/** Writes the length of the line along `axis` through the node with entry `axis` = 0 at every node of the line. */
void
measureLine(const HexMesh & mesh, std::size_t axis, std::array<int, 3> at, Positions & lengths)
{
  const int  n = mesh.nodesPerSide;
  const auto node = [&](int place) {
    at[axis] = place;
    return mesh.nodeNumber(at[0], at[1], at[2]);
  };
  double length = 0.0;
  for (int place = 1; place < n; ++place)
  {
    length += (mesh.nodes[node(place)] - mesh.nodes[node(place - 1)]).norm();
  }
  for (int place = 0; place < n; ++place)
  {
    lengths[node(place)][static_cast<Eigen::Index>(axis)] = length;
  }
}

} // namespace

Positions
latticeLineLengths(const HexMesh & mesh)
{
  requireLattice(mesh);
  Positions lengths(mesh.nodes.size(), Vector3::Constant(std::numeric_limits<double>::quiet_NaN()));
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (int b = 0; b < mesh.nodesPerSide; ++b)
    {
      for (int a = 0; a < mesh.nodesPerSide; ++a)
      {
        std::array<int, 3> at{};
        at[(axis + 1) % 3] = a;
        at[(axis + 2) % 3] = b;
        if (!isInFace(mesh, a, b))
        {
          measureLine(mesh, axis, at, lengths);
        }
      }
    }
  }
  return lengths;
}

} // namespace moserhex
