#include "GmshMesh.h"

#include "moserhex/Common/Stopwatch.h"
#include "moserhex/HexMeshIO/HexCellReader.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <stdexcept>
#include <string>

namespace moserhex::results
{
namespace
{

namespace fs = std::filesystem;

/** A regular tetrahedron of edge e has the volume e^3 / (6 sqrt(2)); gmsh's come out larger by about this factor. */
constexpr double excess = 1.3;

double
edgeOfTetrahedra(double volume, double count)
{
  return std::cbrt(6.0 * std::sqrt(2.0) * volume / (excess * count));
}

/** A folder that is removed at the end. */
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    std::string pattern = (fs::temp_directory_path() / "moserhex_gmsh_XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
    {
      throw std::runtime_error("no temporary folder");
    }
    m_Path = pattern;
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    fs::remove_all(m_Path, ignored);
  }
  TemporaryFolder(const TemporaryFolder &) = delete;
  TemporaryFolder &
  operator=(const TemporaryFolder &) = delete;

  [[nodiscard]] std::string
  file(const std::string & name) const
  {
    return (m_Path / name).string();
  }

private:
  fs::path m_Path;
};

void
writeStl(const std::string & fileName, const TriangleMesh & surface)
{
  std::ofstream os(fileName);
  os << std::setprecision(12) << "solid s\n";
  for (const Triangle & triangle : surface.triangles)
  {
    os << "facet normal 0 0 0\nouter loop\n";
    for (const auto vertex : triangle)
    {
      const Vector3 & p = surface.vertices[vertex];
      os << "vertex " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    }
    os << "endloop\nendfacet\n";
  }
  os << "endsolid s\n";
}

void
writeScript(const std::string & fileName, const std::string & surface, double edge)
{
  std::ofstream os(fileName);
  os << "Merge \"" << surface << "\";\n"
     << "ClassifySurfaces{Pi, 1, 1, Pi};\nCreateGeometry;\n"
     << "Surface Loop(1) = Surface{:};\nVolume(1) = {1};\n"
     << "Mesh.MeshSizeMin = " << edge << ";\nMesh.MeshSizeMax = " << edge << ";\n"
     << "Mesh.SubdivisionAlgorithm = 2;\nMesh.SecondOrderLinear = 1;\n";
}

} // namespace

bool
hasGmsh()
{
  return std::system("command -v gmsh > /dev/null 2>&1") == 0;
}

GmshMesh
gmshHexahedra(const TriangleMesh & surface, double volume, double cells)
{
  const TemporaryFolder folder;
  const std::string     stl = folder.file("surface.stl");
  const std::string     script = folder.file("mesh.geo");
  const std::string     output = folder.file("mesh.msh");
  writeStl(stl, surface);
  writeScript(script, stl, edgeOfTetrahedra(volume, 0.25 * cells));
  const Stopwatch   stopwatch;
  const std::string command =
    "gmsh '" + script + "' -3 -format msh2 -o '" + output + "' > '" + folder.file("log") + "' 2>&1";
  if (std::system(command.c_str()) != 0 || !fs::exists(output))
  {
    throw std::runtime_error("gmsh made no mesh");
  }
  const double seconds = stopwatch.seconds();
  return { readHexCells(output).mesh, seconds };
}

} // namespace moserhex::results
