#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace moserhex
{

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

/** Points of a mesh, one entry per vertex or node, in LPS millimetres unless a function says otherwise. */
using Positions = std::vector<Vector3>;

/** Vertex and node numbers stored in connectivity. */
using VertexIndex = std::int32_t;

} // namespace moserhex
