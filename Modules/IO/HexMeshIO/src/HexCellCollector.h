#pragma once

#include "moserhex/HexMeshIO/HexCellReader.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace moserhex
{

/** Takes what a reader finds in a file, whatever its format, and makes the mesh of it. */
class HexCellCollector
{
public:
  using NodeTag = std::int64_t; ///< the file's own node number

  explicit HexCellCollector(std::string fileName);

  /** \throws BadInput  a coordinate is not finite or beyond 1e9 mm (names the node) */
  void
  addNode(NodeTag tag, const Vector3 & position);

  void
  addHexahedron(const std::array<NodeTag, 8> & tags);

  /** Cells of another kind: ignored when their dimension is below 3, refused by finish() otherwise.
   * \param name  in the singular, or the format's own */
  void
  addOther(const std::string & name, int dimension, std::size_t count);

  /** \throws BadInput  as readHexCells */
  [[nodiscard]] HexCellFile
  finish();

private:
  [[noreturn]] void
  refuse(const std::string & cause) const;

  void
  requireHexahedraOnly() const;
  void
  numberNodes();
  void
  dropUnusedNodes(HexCellFile & file) const;

  std::string                         m_FileName;
  std::vector<NodeTag>                m_Tags;
  Positions                           m_Nodes;
  std::vector<std::array<NodeTag, 8>> m_Cells;
  std::map<std::string, std::size_t>  m_Ignored;
  std::map<std::string, std::size_t>  m_Refused;
};

} // namespace moserhex
