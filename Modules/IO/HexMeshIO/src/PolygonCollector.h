#pragma once

#include "SurfaceFormats.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace moserhex
{

class FileText;

/** A word as the number of a vertex, whatever its range. \throws BadInput  SurfaceIndex for a whole number beyond 64
 * bits, else Format */
[[nodiscard]] std::int64_t
vertexNumberOf(const FileText & text, std::string_view word);

/** Vertices and polygons in the order of a file, checked, cut into triangles. */
class PolygonCollector
{
public:
  /** \param firstIndex  of a vertex in the file's own counting, for messages */
  explicit PolygonCollector(std::string fileName, int firstIndex = 0)
    : m_FileName(std::move(fileName)), m_FirstIndex(firstIndex)
  {}

  void
  addVertex(const Vector3 & position)
  {
    m_Surface.mesh.vertices.push_back(position);
  }

  [[nodiscard]] std::size_t
  vertexCount() const
  {
    return m_Surface.mesh.vertices.size();
  }

  /** Corners count from 0; their vertices may be added later. */
  void
  addPolygon(const std::vector<std::int64_t> & corners);

  /** \throws BadInput  no polygons (Empty), a coordinate that is not finite (SurfaceNaN), a corner that is no vertex
   * (SurfaceIndex), a polygon of fewer than three corners or one that no fan from a corner fills (Unsupported) */
  [[nodiscard]] RawSurface
  finish();

private:
  void
  requireFinite() const;

  void
  requireIndices(std::size_t polygon) const;

  void
  addTriangles(std::size_t polygon);

  std::string               m_FileName;
  int                       m_FirstIndex;
  RawSurface                m_Surface;
  std::vector<std::size_t>  m_Ends; ///< of every polygon in m_Corners
  std::vector<std::int64_t> m_Corners;
};

} // namespace moserhex
