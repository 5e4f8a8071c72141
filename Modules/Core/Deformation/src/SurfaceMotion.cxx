#include "moserhex/Deformation/SurfaceMotion.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Deformation/LatticeAlignment.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/Geometry/SignedDistance.h"

#include <algorithm>
#include <string>

namespace moserhex
{
namespace
{

constexpr std::size_t blockSize = 64;

/** Area of each quadrilateral: of the four triangles about its centre. */
std::vector<double>
quadAreas(const TriangleMesh & surface)
{
  const std::vector<double> triangles = triangleAreas(surface);
  std::vector<double>       areas(triangles.size() / 4, 0.0);
  for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle)
  {
    areas[triangle / 4] += triangles[triangle];
  }
  return areas;
}

std::vector<double>
ratios(const std::vector<double> & after, const std::vector<double> & before)
{
  std::vector<double> result(before.size());
  for (std::size_t quad = 0; quad < before.size(); ++quad)
  {
    if (!(before[quad] > 0.0))
    {
      throw InvalidInput("boundary quadrilateral " + std::to_string(quad) + " of the baseline has no area");
    }
    result[quad] = after[quad] / before[quad];
  }
  return result;
}

std::vector<double>
signedDistances(const HexMesh &                  mesh,
                const std::vector<std::size_t> & nodes,
                const TriangleMesh &             surface,
                unsigned int                     threads)
{
  const SignedDistance distance(surface);
  std::vector<double>  result(nodes.size());
  parallelForBlocks(nodes.size(), blockSize, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b)
    {
      result[b] = distance(mesh.nodes[nodes[b]]);
    }
  });
  return result;
}

} // namespace

std::vector<Quadrilateral>
outwardQuads(const HexMesh & mesh)
{
  requireLattice(mesh);
  std::vector<Quadrilateral> quads = boundaryQuads(mesh);
  const std::size_t          aFace = quads.size() / 6;
  for (std::size_t quad = 0; quad < quads.size(); ++quad)
  {
    if (quad / aFace % 2 == 0) // the side 0 of an axis
    {
      std::swap(quads[quad][1], quads[quad][3]);
    }
  }
  return quads;
}

TriangleMesh
latticeSurface(const HexMesh & mesh)
{
  const std::vector<Quadrilateral> quads = outwardQuads(mesh);
  const std::vector<std::size_t>   nodes = boundaryNodes(mesh);
  std::vector<VertexIndex>         vertexOfNode(mesh.nodes.size(), -1);
  TriangleMesh                     surface;
  for (const std::size_t node : nodes)
  {
    vertexOfNode[node] = static_cast<VertexIndex>(surface.vertices.size());
    surface.vertices.push_back(mesh.nodes[node]);
  }
  for (const Quadrilateral & quad : quads)
  {
    const auto centre = static_cast<VertexIndex>(surface.vertices.size());
    surface.vertices.push_back(0.25 *
                               (mesh.nodes[quad[0]] + mesh.nodes[quad[1]] + mesh.nodes[quad[2]] + mesh.nodes[quad[3]]));
    for (std::size_t side = 0; side < 4; ++side)
    {
      surface.triangles.push_back({ vertexOfNode[quad[side]], vertexOfNode[quad[(side + 1) % 4]], centre });
    }
  }
  return surface;
}

SurfaceMotion
surfaceMotion(const HexMesh & baseline, const HexMesh & followUp, unsigned int threads)
{
  requireComparable(baseline, followUp);
  const TriangleMesh before = latticeSurface(baseline);
  SurfaceMotion      result;
  result.nodes = boundaryNodes(baseline);
  result.normals = vertexNormals(before);
  result.normals.resize(result.nodes.size());
  result.area = quadAreas(before);
  const TriangleMesh after = latticeSurface(followUp);
  result.areaRatio = ratios(quadAreas(after), result.area);
  for (std::size_t b = 0; b < result.nodes.size(); ++b)
  {
    const std::size_t node = result.nodes[b];
    result.normalMotion.push_back((followUp.nodes[node] - baseline.nodes[node]).dot(result.normals[b]));
  }
  result.signedDistance = signedDistances(followUp, result.nodes, before, threads);
  for (const double distance : signedDistances(baseline, result.nodes, after, threads))
  {
    result.baselineSignedDistance.push_back(0.0 - distance); // no negative zeros
  }
  return result;
}

} // namespace moserhex
