#include "ShellCutting.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/LevelSet/HomotopicGrowth.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace moserhex
{
namespace
{

/** Marching tetrahedra makes about three times as many triangles as remeshing keeps when the grid is this many edge
 * lengths wide. */
constexpr double gridSpacingInEdgeLengths = 1.3;
/** Nodes around the shell in its local grid: two for the spline, one for the growth of the level. */
constexpr int localMargin = 3;
/** A vertex moves at most this part of the grid spacing, and this many edge lengths, per Newton step. */
constexpr double stepInSpacings = 0.5;
constexpr double stepInEdgeLengths = 1.0;
constexpr int    newtonSteps = 2;
/** Relaxation between two shifts of the level. */
constexpr double shiftRelaxation = 0.3;

LevelOfVolumeOptions
roughLevel()
{
  LevelOfVolumeOptions options;
  options.relativeTolerance = 1e-4; // the shifts of the level do the rest
  return options;
}

/** Closed manifold as marching tetrahedra makes it: E = 3 F / 2, so V - F / 2 and the components decide. */
bool
isOneSphere(const TriangleMesh & mesh)
{
  if (mesh.triangles.empty() || 2 * mesh.vertices.size() != mesh.triangles.size() + 4)
  {
    return false;
  }
  std::vector<VertexIndex> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](VertexIndex v) {
    while (parent[v] != v)
    {
      parent[v] = parent[parent[v]];
      v = parent[v];
    }
    return v;
  };
  for (const Triangle & t : mesh.triangles)
  {
    parent[root(t[0])] = root(t[1]);
    parent[root(t[1])] = root(t[2]);
  }
  std::size_t components = 0;
  for (std::size_t v = 0; v < parent.size(); ++v)
  {
    components += root(static_cast<VertexIndex>(v)) == static_cast<VertexIndex>(v) ? 1 : 0;
  }
  return components == 1;
}

/** The part of the grid around {f < level}, `refinement` times finer; values by Catmull-Rom. */
LevelSet
resampledAround(const ShellFunction & f, double level, int refinement)
{
  const RegularGrid & grid = f.levelSet.grid;
  RegularGrid::Index  lower = grid.size;
  RegularGrid::Index  upper{ { 0, 0, 0 } };
  for (std::size_t node = 0; node < f.levelSet.values.size(); ++node)
  {
    if (f.levelSet.values[node] < level)
    {
      const RegularGrid::Index index = grid.indexOf(node);
      for (std::size_t a = 0; a < 3; ++a)
      {
        lower[a] = std::min(lower[a], index[a]);
        upper[a] = std::max(upper[a], index[a]);
      }
    }
  }
  LevelSet local{ grid, {} };
  for (std::size_t a = 0; a < 3; ++a)
  {
    lower[a] = std::max(0, lower[a] - localMargin);
    upper[a] = std::min(grid.size[a] - 1, upper[a] + localMargin);
    local.grid.size[a] = (upper[a] - lower[a]) * refinement + 1;
  }
  local.grid.spacing = grid.spacing / refinement;
  local.grid.origin = grid.point(lower[0], lower[1], lower[2]);
  local.values.resize(local.grid.nodeCount());
  for (std::size_t node = 0; node < local.values.size(); ++node)
  {
    local.values[node] = f.interpolator.value(local.grid.point(node));
  }
  return local;
}

/** Surface of {f < level} that encloses `volume`, one sphere. The spline may add specks to the piecewise linear
 * function; growth from its smallest value removes them. */
TriangleMesh
sphereOfVolume(LevelSet f, double volume)
{
  const auto   cut = [&] { return marchingTetrahedra(f, levelOfVolume(f, volume, roughLevel())); };
  TriangleMesh mesh = cut();
  if (!isOneSphere(mesh))
  {
    const auto             smallest = std::min_element(f.values.begin(), f.values.end());
    const auto             largest = std::max_element(f.values.begin(), f.values.end());
    HomotopicGrowthOptions options;
    options.valueOfOthers = *largest;
    f = homotopicGrowth(f, static_cast<std::size_t>(smallest - f.values.begin()), options).levelSet;
    mesh = cut();
  }
  return mesh;
}

/** Edge length to ask the remesher for so that a surface of this area gets `count` triangles: equilateral ones have
 * sqrt(3)/4 L^2, and the remesher's mean edge is a little longer than L. */
double
edgeLengthFor(double area, double count)
{
  constexpr double meanEdgeOverTarget = 1.033;
  return std::sqrt(area / count * 4.0 / std::sqrt(3.0)) / meanEdgeOverTarget;
}

/** integral dA / |grad f|: how fast the enclosed volume grows with the level. */
double
volumePerLevel(const TriangleMesh & mesh, const CubicInterpolator & f)
{
  double sum = 0.0;
  for (const Triangle & t : mesh.triangles)
  {
    const Vector3 & a = mesh.vertices[t[0]];
    const Vector3 & b = mesh.vertices[t[1]];
    const Vector3 & c = mesh.vertices[t[2]];
    const double    slope = f.at((a + b + c) / 3).gradient.norm();
    if (slope > 0.0)
    {
      sum += triangleArea(a, b, c) / slope;
    }
  }
  return sum;
}

/** First surface of a shell: level by volume on the grid, or on a finer one around a small shell. */
TriangleMesh
roughSurface(const ShellFunction & f, double volume, double triangles)
{
  // Area of the shell by the ball of its volume: good enough to choose the grid.
  const double area = std::cbrt(36.0 * pi * volume * volume);
  const double h = f.levelSet.grid.spacing;
  const int    refinement =
    std::max(1, static_cast<int>(std::ceil(h / (gridSpacingInEdgeLengths * edgeLengthFor(area, triangles)))));
  if (refinement == 1)
  {
    const TriangleMesh mesh = marchingTetrahedra(f.levelSet, levelOfVolume(f.volumes, volume, roughLevel()));
    return isOneSphere(mesh) ? mesh : sphereOfVolume(f.levelSet, volume);
  }
  // The coarse grid knows the volume of a small shell within a few cells only.
  const double wide = levelOfVolume(f.volumes, 1.5 * volume + 30.0 * h * h * h, roughLevel());
  return sphereOfVolume(resampledAround(f, wide, refinement), volume);
}

class ShellCutter
{
public:
  ShellCutter(const ShellFunction & f, double volume, double triangles, const ShellSurfaceOptions & options)
    : m_Function(f), m_Volume(volume), m_Triangles(triangles), m_Options(options)
  {}

  ShellSurface
  cut()
  {
    const Stopwatch    watch;
    const TriangleMesh rough = roughSurface(m_Function, m_Volume, m_Triangles);
    const double       edge = edgeLengthFor(surfaceArea(rough), m_Triangles);
    const double       h = m_Function.levelSet.grid.spacing;
    m_Level = meanValue(rough);
    m_LargestStep = std::min(stepInSpacings * h, stepInEdgeLengths * edge);

    SurfaceRemeshingOptions remeshing;
    remeshing.targetEdgeLength = edge;
    remeshing.sizingRounds = m_Options.sizingRounds;
    remeshing.smoothingRounds = m_Options.smoothingRounds;
    ShellSurface shell;
    shell.mesh = remeshed(rough, remeshing);
    remeshing.sizingRounds = 0;
    remeshing.smoothingRounds = 1;
    remeshing.relaxation = shiftRelaxation;
    shiftToVolume(shell, remeshing);

    shell.targetVolume = m_Volume;
    shell.level = m_Level;
    shell.remeshing.seconds = watch.seconds();
    return shell;
  }

private:
  /** Level of the spline on the rough surface, which was cut from the piecewise linear function. */
  [[nodiscard]] double
  meanValue(const TriangleMesh & mesh) const
  {
    double sum = 0.0;
    for (const Vector3 & p : mesh.vertices)
    {
      sum += m_Function.interpolator.value(p);
    }
    return sum / static_cast<double>(mesh.vertices.size());
  }

  [[nodiscard]] TriangleMesh
  remeshed(const TriangleMesh & mesh, const SurfaceRemeshingOptions & remeshing) const
  {
    return remeshSurface(mesh,
                         remeshing,
                         [this](const Vector3 & p) {
                           return projectToLevel(m_Function.interpolator, p, m_Level, m_LargestStep, newtonSteps);
                         })
      .mesh;
  }

  void
  shiftToVolume(ShellSurface & shell, const SurfaceRemeshingOptions & remeshing)
  {
    const auto error = [&] {
      shell.volume = enclosedVolume(shell.mesh);
      return std::abs(shell.volume / m_Volume - 1.0);
    };
    shell.remeshing.residual = error();
    while (shell.remeshing.residual > m_Options.volumeTolerance &&
           shell.remeshing.steps < m_Options.maximumVolumeShifts)
    {
      m_Level += (m_Volume - shell.volume) / volumePerLevel(shell.mesh, m_Function.interpolator);
      shell.mesh = remeshed(shell.mesh, remeshing);
      shell.remeshing.residual = error();
      ++shell.remeshing.steps;
    }
    shell.remeshing.converged = shell.remeshing.residual <= m_Options.volumeTolerance;
  }

  const ShellFunction &       m_Function;
  double                      m_Volume;
  double                      m_Triangles;
  const ShellSurfaceOptions & m_Options;
  double                      m_Level{ 0.0 };
  double                      m_LargestStep{ 0.0 };
};

/** What is wrong with a shell; empty when it keeps the contract. */
std::string
faultOf(const ShellSurface & shell, const ShellSurfaceOptions & options)
{
  std::ostringstream           message;
  const SurfaceTopologySummary topology = summarizeTopology(shell.mesh);
  if (!topology.isSphere())
  {
    message << "V-E+F = " << topology.eulerCharacteristic << " in " << topology.components
            << " components, need 2 in 1 (genus 0)";
  }
  else if (!(shell.remeshing.residual <= options.acceptedVolumeError))
  {
    message << "encloses " << shell.volume << " mm^3, need " << shell.targetVolume << " within "
            << 100 * options.acceptedVolumeError << " %";
  }
  return message.str();
}

} // namespace

ShellSurface
cutShell(const ShellFunction &       f,
         double                      volume,
         double                      triangles,
         const std::string &         name,
         const ShellSurfaceOptions & options)
{
  constexpr int    finestAttempt = 2;
  constexpr double moreTriangles = 4.0;
  for (int attempt = 0;; ++attempt)
  {
    ShellSurface      shell = ShellCutter(f, volume, triangles, options).cut();
    const std::string fault = faultOf(shell, options);
    if (fault.empty())
    {
      if (attempt > 0)
      {
        shell.remeshing.note = std::to_string(shell.mesh.triangles.size()) + " triangles were needed";
      }
      return shell;
    }
    if (attempt == finestAttempt)
    {
      throw NotConverged(name + ": " + fault, shell.remeshing);
    }
    triangles *= moreTriangles;
  }
}

} // namespace moserhex
