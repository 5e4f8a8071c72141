#pragma once

#include "moserhex/Common/EigenAlignment.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

/** The Core, which knows neither ITK nor VTK, and the reading and writing of files (module HexMeshIO). */
namespace moserhex
{

// Matrices cross the library's border. What one side allocates at 16 bytes and the other frees at 32 crashes.
static_assert(EIGEN_MAX_ALIGN_BYTES == eigenMaxAlignBytes && EIGEN_MAX_STATIC_ALIGN_BYTES == eigenMaxStaticAlignBytes,
              "Eigen aligns memory here otherwise than in the MoserHex library: the instruction sets differ. Compile "
              "both with the same -m options, or define EIGEN_MAX_ALIGN_BYTES as eigenMaxAlignBytes in "
              "moserhex/Common/EigenAlignment.h says.");

/** Three numbers; of a point or direction in space: towards the patient's Left, Posterior, Superior (LPS). */
using Vector3 = Eigen::Vector3d;
/** 3 x 3, column major: a rotation, a Jacobian. */
using Matrix3 = Eigen::Matrix3d;

/** Points of a mesh, one entry per vertex or node, in LPS millimetres unless a function says otherwise. */
using Positions = std::vector<Vector3>;

inline constexpr double pi = 3.14159265358979323846; ///< half of a turn [rad]

/** Vertex and node numbers stored in connectivity. */
using VertexIndex = std::int32_t;

} // namespace moserhex
