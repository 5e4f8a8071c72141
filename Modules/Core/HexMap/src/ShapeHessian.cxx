#include "ShapeHessian.h"

#include "CellKernels.h"
#include "moserhex/Common/Errors.h"

#include <string>

namespace moserhex
{
namespace
{

/** The volume term of a cell: the product of its Hessian with the motion of its corners. */
MOSERHEX_INLINE void
volumeProduct(const LaneVector * corners,
              const LaneVector * motion,
              Lanes              target,
              Lanes              weight,
              bool               full,
              LaneVector *       product)
{
  LaneVector gradients[8];
  volumeGradients(corners, gradients);
  Lanes change{}; // 12 dv
  for (std::size_t a = 1; a < 8; ++a)
  {
    change += dot(motion[a], gradients[a]);
  }
  const Lanes rankOne = weight * change / (144.0 * target * target);
  for (std::size_t a = 0; a < 8; ++a)
  {
    product[a] = rankOne * gradients[a];
  }
  if (full)
  {
    const Lanes pressure = weight * (volumesOf(corners, gradients) / target - 1.0) / (12.0 * target);
    LaneVector  derivatives[8];
    volumeGradientsAlong(corners, motion, derivatives);
    for (std::size_t a = 0; a < 8; ++a)
    {
      product[a] += pressure * derivatives[a];
    }
  }
}

/** The mean ratio of one corner of the cells, times 1/8: the product of its Hessian with the motion of its edges. */
MOSERHEX_INLINE void
addCornerProduct(const CellEdges & edges,
                 const CellEdges & motion,
                 std::size_t       corner,
                 LaneMask          cells,
                 double            epsilon,
                 bool              full,
                 CellEdges &       product)
{
  const CornerEdges  at = edgesAt(corner);
  const CornerFrame  J(edges, at);
  const LaneVector & da = motion.i[at.i];
  const LaneVector & db = motion.j[at.j];
  const LaneVector & dc = motion.k[at.k];

  const Lanes                  share = select(cells, allLanes(0.125), Lanes{});
  const Lanes                  determinant = select(cells, dot(J.a, J.bc), allLanes(1.0));
  const RegularisedDeterminant regular = regularised(determinant, epsilon);
  const Lanes                  root = inverseCubeRoot(regular.chi);
  const Lanes                  chiPower = root * root; // t
  const Lanes                  inverseR = 1.0 / regular.r;
  const Lanes                  meanRatio = (dot(J.a, J.a) + dot(J.b, J.b) + dot(J.c, J.c)) * chiPower * (1.0 / 3.0);
  const Lanes                  edgeChange = dot(J.a, da) + dot(J.b, db) + dot(J.c, dc);           // J:D
  const Lanes                  determinantChange = dot(J.bc, da) + dot(J.ca, db) + dot(J.ab, dc); // C:D

  const Lanes alpha = share * chiPower * (2.0 / 3.0);
  const Lanes beta = share * chiPower * inverseR * (-4.0 / 9.0);
  const Lanes curvature = full ? 4.0 / 9.0 + (2.0 / 3.0) * determinant * inverseR : allLanes(10.0 / 9.0);
  const Lanes gamma = share * meanRatio * inverseR * inverseR * curvature;
  const Lanes alongEdges = beta * determinantChange;
  const Lanes alongCofactors = beta * edgeChange + gamma * determinantChange;
  product.i[at.i] += alpha * da + alongEdges * J.a + alongCofactors * J.bc;
  product.j[at.j] += alpha * db + alongEdges * J.b + alongCofactors * J.ca;
  product.k[at.k] += alpha * dc + alongEdges * J.c + alongCofactors * J.ab;
  if (full)
  {
    const Lanes slope = share * meanRatio * inverseR * (-2.0 / 3.0); // f_d
    product.i[at.i] += slope * (cross(db, J.c) + cross(J.b, dc));
    product.j[at.j] += slope * (cross(dc, J.a) + cross(J.c, da));
    product.k[at.k] += slope * (cross(da, J.b) + cross(J.a, db));
  }
}

/** The product of the Hessian of the cells that begin in [begin, end), added. */
MOSERHEX_KERNEL void
addSlabProduct(const LatticeLayout &      layout,
               const double *             x,
               const double *             direction,
               const double *             targetVolumes,
               const ShapeEnergyWeights & weights,
               bool                       full,
               std::size_t                begin,
               std::size_t                end,
               double *                   product)
{
  for (std::size_t p = begin; p < end; p += laneCount)
  {
    const LaneMask cells = existing(targetVolumes, p, end);
    const Lanes    target = select(cells, loadLanes(targetVolumes + p), allLanes(1.0));
    const Lanes    volumeWeight = select(cells, allLanes(weights.volume), Lanes{});
    LaneVector     corners[8];
    LaneVector     motion[8];
    LaneVector     products[8];
    loadCorners(layout, x, p, corners);
    loadCorners(layout, direction, p, motion);
    volumeProduct(corners, motion, target, volumeWeight, full, products);

    CellEdges edges;
    CellEdges edgeMotion;
    CellEdges edgeProducts{};
    edgesOf(corners, edges);
    edgesOf(motion, edgeMotion);
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      addCornerProduct(edges, edgeMotion, corner, cells, weights.regularisation, full, edgeProducts);
    }
    addEdgeGradients(edgeProducts, products);
    addToCorners(layout, product, p, products);
  }
}

} // namespace

void
addShapeHessianProduct(const LatticeLayout &      layout,
                       const Eigen::VectorXd &    x,
                       const Eigen::VectorXd &    direction,
                       const Eigen::VectorXd &    targetVolumes,
                       const ShapeEnergyWeights & weights,
                       HessianForm                form,
                       unsigned int               threads,
                       Eigen::VectorXd &          product)
{
  if (weights.power != 1)
  {
    throw InvalidInput("Hessian of the shape energy: the power is " + std::to_string(weights.power) + ", must be 1");
  }
  if (layout.paddingLayers > 0)
  {
    throw InvalidInput("Hessian of the shape energy: no product is written for pillow cells");
  }
  const bool full = form == HessianForm::Full;
  forEachSlab(layout, threads, [&](std::size_t, std::size_t begin, std::size_t end) {
    addSlabProduct(layout, x.data(), direction.data(), targetVolumes.data(), weights, full, begin, end, product.data());
  });
  layout.clearPadding(product);
}

} // namespace moserhex
