// One stage alone, without ITK: an area-preserving map of an octahedron-based ellipsoid to the unit sphere.
#include <moserhex/SphericalMap/AreaPreservingMap.h>

#include <iostream>
#include <map>

namespace
{

/** Splits every triangle into four, new vertices at the middle of the edges. */
moserhex::TriangleMesh
subdivide(const moserhex::TriangleMesh & mesh)
{
  moserhex::TriangleMesh                               fine;
  std::map<std::pair<int, int>, moserhex::VertexIndex> middles;
  fine.vertices = mesh.vertices;
  const auto middle = [&](int a, int b) {
    const auto found = middles.emplace(std::minmax(a, b), static_cast<int>(fine.vertices.size()));
    if (found.second)
    {
      fine.vertices.push_back((0.5 * (mesh.vertices[a] + mesh.vertices[b])).normalized());
    }
    return found.first->second;
  };
  for (const moserhex::Triangle & t : mesh.triangles)
  {
    const int a = middle(t[0], t[1]);
    const int b = middle(t[1], t[2]);
    const int c = middle(t[2], t[0]);
    fine.triangles.insert(fine.triangles.end(), { { t[0], a, c }, { t[1], b, a }, { t[2], c, b }, { a, b, c } });
  }
  return fine;
}

} // namespace

int
main()
{
  moserhex::TriangleMesh surface;
  surface.vertices = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
  surface.triangles = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 },
                        { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 } };
  for (int level = 0; level < 4; ++level)
  {
    surface = subdivide(surface);
  }
  for (moserhex::Vector3 & p : surface.vertices)
  {
    p = p.cwiseProduct(moserhex::Vector3(30.0, 20.0, 10.0)); // semi-axes in mm
  }

  const moserhex::AreaPreservingMapResult map = moserhex::areaPreservingSphereMap(surface);
  std::cout << surface.triangles.size() << " triangles, " << map.quality.flippedTriangles << " flipped, area ratio rms "
            << map.quality.areaRatioRms << ", by " << map.path << '\n';
  return map.quality.flippedTriangles == 0 && map.quality.areaRatioRms < 0.01 ? 0 : 1;
}
