#include "BoxIntegrator.h"

#include "TrilinearCell.h"
#include "moserhex/Common/Errors.h"

#include <Eigen/LU>

#include <algorithm>
#include <string>

namespace moserhex
{
namespace
{

/** Calls visit(point, weight) for the Gauss points of a part of a cell, weights times det J [mm^3]. */
template <typename TVisit>
void
forGaussPoints(const HexMesh &   mesh,
               std::size_t       cell,
               const Vector3 &   lower,
               const Vector3 &   sides,
               const GaussRule & rule,
               const TVisit &    visit)
{
  const double     cells = mesh.nodesPerSide - 1;
  const HexCorners corners = cellCorners(mesh, cell);
  const Vector3    index = cubePoint(mesh, { cell, Vector3::Zero() }).cube * cells;
  for (std::size_t c = 0; c < rule.weights.size(); ++c)
  {
    for (std::size_t b = 0; b < rule.weights.size(); ++b)
    {
      for (std::size_t a = 0; a < rule.weights.size(); ++a)
      {
        const Vector3 xi = lower + sides.cwiseProduct(Vector3(rule.abscissae[a], rule.abscissae[b], rule.abscissae[c]));
        const Matrix3 tangents = trilinearTangents(corners, xi);
        const double  weight =
          rule.weights[a] * rule.weights[b] * rule.weights[c] * sides.prod() * tangents.determinant();
        visit(CubePoint{ (index + xi) / cells, trilinear(corners, xi), tangents * cells }, weight);
      }
    }
  }
}

} // namespace

BoxIntegrator::BoxIntegrator(const HexMesh & mesh, const CubeFunction & f, int components, int boxesPerAxis)
  : m_Mesh(mesh)
  , m_Function(f)
  , m_Components(static_cast<std::size_t>(components))
  , m_Parts(partsInCells(boxesPerAxis, mesh.nodesPerSide - 1))
{}

double
BoxIntegrator::addIntegral(std::size_t box, const GaussRule & rule, double * sums) const
{
  std::vector<double> values(m_Components);
  double              volume = 0.0;
  forPartsOfBox(
    m_Parts, box, m_Mesh.nodesPerSide - 1, [&](std::size_t cell, const Vector3 & lower, const Vector3 & sides) {
      forGaussPoints(m_Mesh, cell, lower, sides, rule, [&](const CubePoint & point, double weight) {
        m_Function(point, values.data());
        volume += weight;
        std::transform(
          values.begin(), values.end(), sums, sums, [weight](double v, double sum) { return sum + weight * v; });
      });
    });
  if (!(volume > 0.0))
  {
    throw InvalidInput("cell means: cell " + std::to_string(box) + " has no positive volume");
  }
  return volume;
}

double
BoxIntegrator::pointCount(std::size_t box, int pointsPerAxis) const
{
  const std::size_t n = m_Parts.size();
  const double      parts =
    static_cast<double>(m_Parts[box % n].size() * m_Parts[box / n % n].size() * m_Parts[box / (n * n)].size());
  return parts * pointsPerAxis * pointsPerAxis * pointsPerAxis;
}

} // namespace moserhex
