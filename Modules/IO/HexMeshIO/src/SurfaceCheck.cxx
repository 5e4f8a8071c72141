#include "SurfaceCheck.h"

#include "VtkSpace.h"
#include "moserhex/Geometry/SelfIntersection.h"
#include "moserhex/Geometry/SurfaceRepair.h"
#include "moserhex/Geometry/TriangleTopology.h"
#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/HexMeshIO/SurfaceVoxelisation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace moserhex
{
namespace
{

constexpr double      farthest = 1e6;      // [mm]
constexpr double      smallestUsual = 1.0; // longest side of the box [mm]
constexpr double      largestUsual = 1000.0;
constexpr double      mostOverlap = 0.05;         // of the volume covered
constexpr int         mostParts = 100;            // looked at
constexpr std::size_t mostIntersections = 100000; // looked at
constexpr double      smallestVolumeOfBox = 1e-9; // [1]

/** "1 triangle", "2 triangles". */
std::string
counted(std::size_t count, const std::string & thing)
{
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::string
inMillilitres(double cubicMillimetres)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.4g mL", cubicMillimetres / 1000.0);
  return text;
}

class SurfaceCheck
{
public:
  SurfaceCheck(const std::string & fileName, RawSurface raw) : m_FileName(fileName), m_Raw(std::move(raw))
  {}

  SurfaceFile
  run()
  {
    weld();
    requireClosed();
    orient();
    requireVolume();
    warnOfSize();
    m_Intersections = findSelfIntersections(m_File.mesh, mostIntersections);
    requireOneSolid();
    turnOutwards();
    warnOfTopology();
    judgeIntersections();
    return std::move(m_File);
  }

private:
  [[noreturn]] void
  refuse(ErrorCode code, const std::string & cause, const std::string & remedy) const
  {
    throw BadInput(code, m_FileName, cause, remedy);
  }

  void
  warn(const std::string & text)
  {
    m_File.warnings.push_back(text);
  }

  void
  weld()
  {
    if (m_Raw.isRas)
    {
      turnRasIntoLps(m_Raw.mesh.vertices);
    }
    WeldedSurface welded = weldSurface(m_Raw.mesh);
    if (welded.mesh.triangles.empty())
    {
      refuse(ErrorCode::SurfaceDegenerate,
             "all " + counted(m_Raw.mesh.triangles.size(), "triangle") + " have two corners in one place",
             "move the surface to the origin or store it in double precision");
    }
    for (const Vector3 & vertex : welded.mesh.vertices)
    {
      if (!(vertex.array().abs() <= farthest).all())
      {
        refuse(ErrorCode::Geometry, "a vertex lies beyond 1e6 mm", "export the surface again, in millimetres");
      }
    }
    if (m_Raw.splitPolygons > 0)
    {
      warn(counted(m_Raw.splitPolygons, "polygon") + " cut into triangles");
    }
    if (welded.collapsedTriangles > 0)
    {
      warn(counted(welded.collapsedTriangles, "degenerate triangle") + " removed (two corners in one place)");
    }
    if (welded.duplicateTriangles > 0)
    {
      warn(counted(welded.duplicateTriangles, "duplicate triangle") + " removed");
    }
    m_File.mesh = std::move(welded.mesh);
  }

  void
  requireClosed()
  {
    const SurfaceEdgeCounts edges = countSurfaceEdges(m_File.mesh);
    if (edges.boundaryEdges > 0)
    {
      refuse(ErrorCode::SurfaceOpen,
             "the surface is open: " + counted(edges.boundaryLoops, "boundary loop") + " of " +
               counted(edges.boundaryEdges, "edge") + (edges.boundaryLoops > 1 ? " in all" : ""),
             "close its holes");
    }
    if (edges.overusedEdges > 0)
    {
      requireVolume(); // a sheet folded onto itself has such edges, too
      refuse(ErrorCode::SurfaceNonManifold,
             counted(edges.overusedEdges, "non-manifold edge") + " (more than two triangles on an edge)",
             "repair the surface");
    }
  }

  void
  orient()
  {
    m_Oriented = orientSurface(m_File.mesh);
    if (!m_Oriented.orientable)
    {
      refuse(ErrorCode::SurfaceNonManifold,
             "the surface is not orientable: it has no inside",
             "give the boundary of a solid");
    }
    if (m_Oriented.turnedTriangles > 0)
    {
      warn(counted(m_Oriented.turnedTriangles, "triangle") + " turned to agree with the others");
    }
    m_File.mesh = m_Oriented.mesh;
  }

  void
  requireVolume()
  {
    m_Volume = enclosedVolume(m_File.mesh);
    const BoundingBox box = boundingBox(m_File.mesh.vertices);
    if (!(std::abs(m_Volume) > smallestVolumeOfBox * (box.upper - box.lower).prod()))
    {
      refuse(ErrorCode::SurfaceDegenerate, "the surface encloses no volume", "give a closed surface of a solid");
    }
  }

  void
  warnOfSize()
  {
    const BoundingBox box = boundingBox(m_File.mesh.vertices);
    const double      longest = (box.upper - box.lower).maxCoeff();
    if (longest < smallestUsual || longest > largestUsual)
    {
      char text[80];
      std::snprintf(text, sizeof text, "the surface is %.3g mm long: are its coordinates millimetres?", longest);
      warn(text);
    }
  }

  /** Parts that overlap count as one; a part inside another is a cavity when it is oriented the other way. */
  void
  requireOneSolid()
  {
    if (m_Oriented.parts == 1)
    {
      return;
    }
    if (m_Oriented.parts > mostParts)
    {
      refuseParts(m_Oriented.parts);
    }
    const std::vector<TriangleMesh> parts = partsOf(m_Oriented);
    std::vector<double>             volumes(parts.size());
    std::transform(parts.begin(), parts.end(), volumes.begin(), enclosedVolume);
    const auto outer = static_cast<std::size_t>(
      std::max_element(volumes.begin(), volumes.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      volumes.begin());
    const std::vector<bool> isJoined = partsJoinedTo(outer);
    std::size_t             separate = 1;
    std::size_t             cavities = 0;
    for (std::size_t part = 0; part < parts.size(); ++part)
    {
      if (isJoined[part])
      {
        requireSameSense(volumes[part], volumes[outer]);
        continue;
      }
      if (std::abs(windingNumber(parts[outer], parts[part].vertices[0])) < 0.5)
      {
        ++separate;
        continue;
      }
      ++cavities;
      const bool isTurned = (volumes[part] > 0.0) != (volumes[outer] > 0.0);
      if (!isTurned || !liesInSolid(parts, part))
      {
        refuse(ErrorCode::Topology,
               isTurned ? "a shell inside a cavity"
                        : "a shell inside another has the same orientation: it is neither a cavity nor a part",
               "remove the inner shell or turn it");
      }
    }
    if (separate > 1)
    {
      refuseParts(static_cast<int>(separate));
    }
    if (cavities > 0)
    {
      warn("the surface has " + std::to_string(cavities) + (cavities == 1 ? " cavity" : " cavities"));
    }
  }

  /** Whether the winding number around a part, of all the others, is 1 or -1. */
  [[nodiscard]] static bool
  liesInSolid(const std::vector<TriangleMesh> & parts, std::size_t part)
  {
    double winding = 0.0;
    for (std::size_t other = 0; other < parts.size(); ++other)
    {
      winding += other == part ? 0.0 : windingNumber(parts[other], parts[part].vertices[0]);
    }
    return std::abs(std::abs(winding) - 1.0) < 0.5;
  }

  /** Which parts hang together with this one through parts that cut one another. */
  [[nodiscard]] std::vector<bool>
  partsJoinedTo(std::size_t outer) const
  {
    std::vector<bool> isJoined(static_cast<std::size_t>(m_Oriented.parts), false);
    isJoined[outer] = true;
    for (bool grew = true; grew;)
    {
      grew = false;
      for (const auto & [s, t] : m_Intersections)
      {
        const auto p = static_cast<std::size_t>(m_Oriented.part[static_cast<std::size_t>(s)]);
        const auto q = static_cast<std::size_t>(m_Oriented.part[static_cast<std::size_t>(t)]);
        if (isJoined[p] != isJoined[q])
        {
          isJoined[p] = true;
          isJoined[q] = true;
          grew = true;
        }
      }
    }
    return isJoined;
  }

  void
  requireSameSense(double volume, double outer) const
  {
    if ((volume > 0.0) != (outer > 0.0))
    {
      refuse(ErrorCode::SurfaceIntersects,
             "two parts of opposite orientation cut one another",
             "unite the parts and orient them outwards");
    }
  }

  [[noreturn]] void
  refuseParts(int parts) const
  {
    refuse(
      ErrorCode::Topology, std::to_string(parts) + " separate parts, need one solid", "keep one part, or join them");
  }

  void
  turnOutwards()
  {
    if (m_Volume > 0.0)
    {
      return;
    }
    for (Triangle & triangle : m_File.mesh.triangles)
    {
      std::swap(triangle[1], triangle[2]);
    }
    m_Volume = -m_Volume;
    warn("the surface faced inwards and was turned");
  }

  void
  warnOfTopology()
  {
    const SurfaceTopologySummary summary = summarizeTopology(m_File.mesh);
    if (summary.nonManifoldVertices > 0)
    {
      warn("the surface touches itself at " + std::to_string(summary.nonManifoldVertices) +
           (summary.nonManifoldVertices == 1 ? " vertex" : " vertices"));
      return; // its Euler characteristic says nothing about handles
    }
    const long handles = m_Oriented.parts - summary.eulerCharacteristic / 2;
    if (handles > 0)
    {
      warn("the surface has " + counted(static_cast<std::size_t>(handles), "handle") + " (genus " +
           std::to_string(handles) + ")");
    }
  }

  /** The inside is where the winding number is not zero. That is what the surface means as long as what it covers and
   * the volume by its orientation, where overlaps count twice, are about the same. */
  void
  judgeIntersections()
  {
    if (m_Intersections.empty())
    {
      return;
    }
    const std::string pairs = (m_Intersections.size() < mostIntersections ? "" : "at least ") +
                              counted(m_Intersections.size(), "pair") + " of triangles cut one another";
    const LabelVolume voxels = voxelisedForCheck();
    const double      covered = static_cast<double>(voxelCount(voxels)) * voxels.spacing.prod();
    if (std::abs(covered - m_Volume) > mostOverlap * covered)
    {
      refuse(ErrorCode::SurfaceIntersects,
             pairs + ": " + inMillilitres(covered) + " are covered, the orientation says " + inMillilitres(m_Volume),
             "remove the self-intersections");
    }
    const Vector3 & place = m_File.mesh.vertices[static_cast<std::size_t>(
      m_File.mesh.triangles[static_cast<std::size_t>(m_Intersections.front()[0])][0])];
    char            text[60];
    std::snprintf(text, sizeof text, " (%.6g %.6g %.6g)", place.x(), place.y(), place.z());
    warn(pairs + ", the first near" + text);
  }

  [[nodiscard]] LabelVolume
  voxelisedForCheck() const
  {
    try
    {
      SurfaceVoxelisationOptions options;
      options.voxelsInBox = 1e5; // some 1 % of the volume is enough here
      return voxelise(m_File.mesh, options);
    }
    catch (const InvalidInput & error)
    {
      refuse(error.code(), error.what(), "give a surface of a compact solid");
    }
  }

  const std::string &       m_FileName;
  RawSurface                m_Raw;
  OrientedSurface           m_Oriented;
  double                    m_Volume{ 0.0 };
  std::vector<TrianglePair> m_Intersections;
  SurfaceFile               m_File;
};

} // namespace

SurfaceFile
checkedSurface(const std::string & fileName, RawSurface raw)
{
  return SurfaceCheck(fileName, std::move(raw)).run();
}

} // namespace moserhex
