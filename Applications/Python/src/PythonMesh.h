#pragma once

#include "ArrayInput.h"

#include "moserhex/CubeTransfer/CubeMap.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace moserhex::python
{

/** A lattice mesh, never changed, with what there is to say of it; arrays in and out are in the caller's space. */
class PythonMesh
{
public:
  PythonMesh(HexMesh mesh, HexMeshFields fields, Space space, std::vector<std::string> warnings, std::string report);
  PythonMesh(const PythonMesh &) = delete;
  PythonMesh &
  operator=(const PythonMesh &) = delete;

  [[nodiscard]] int
  nodesPerSide() const
  {
    return m_Mesh.nodesPerSide;
  }
  [[nodiscard]] int
  paddingLayers() const
  {
    return m_Mesh.paddingLayers;
  }
  [[nodiscard]] Space
  space() const
  {
    return m_Space;
  }
  [[nodiscard]] const std::vector<std::string> &
  warnings() const
  {
    return m_Warnings;
  }
  /** JSON; empty for a mesh from a file. */
  [[nodiscard]] const std::string &
  report() const
  {
    return m_Report;
  }

  /** Nodes x 3, an array that owns its numbers, as do all of these. */
  [[nodiscard]] pybind11::array
  points() const;

  /** Cells x 8, 64-bit integers. */
  [[nodiscard]] pybind11::array
  cells() const;

  /** As JSON. */
  [[nodiscard]] std::string
  quality(unsigned int threads) const;

  /** K x 3; rows of points outside the mesh are NaN. */
  [[nodiscard]] pybind11::array
  cubeCoordinates(const pybind11::object & points, unsigned int threads) const;

  /** K x 3; rows of NaN stay NaN. \throws InvalidInput  a coordinate outside [0,1] */
  [[nodiscard]] pybind11::array
  positions(const pybind11::object & cubeCoordinates) const;

  void
  write(const std::string & fileName) const;

  [[nodiscard]] const HexMesh &
  lattice() const
  {
    return m_Mesh;
  }

  /** How it was made, see MeshRecord.h. */
  [[nodiscard]] const std::vector<NamedArray> &
  record() const
  {
    return m_Fields.meshArrays;
  }

  /** Made when first asked for, by any thread. \throws InvalidInput  a mesh with padding */
  [[nodiscard]] const CubeMap &
  cubeMap() const;

private:
  HexMesh                  m_Mesh; ///< LPS
  HexMeshFields            m_Fields;
  Space                    m_Space;
  std::vector<std::string> m_Warnings;
  std::string              m_Report;

  mutable std::once_flag                 m_MapIsMade;
  mutable std::unique_ptr<const CubeMap> m_Map;
};

} // namespace moserhex::python
