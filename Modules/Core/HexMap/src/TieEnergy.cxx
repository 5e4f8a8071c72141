#include "TieEnergy.h"

#include "DisplacementEnergy.h"
#include "ImageEnergy.h"
#include "LandmarkEnergy.h"

#include <utility>

namespace moserhex
{

TieEnergy::TieEnergy(const LatticeLayout & layout, LatticeTies ties, const Vector3 & origin, double unit)
  : m_Ties(std::move(ties))
{
  if (!m_Ties.reference.empty())
  {
    m_Reference = latticeVector(layout, m_Ties.reference, origin, unit);
    m_Ties.reference = {};
  }
  if (!m_Ties.rest.empty())
  {
    m_Rest = latticeVector(layout, m_Ties.rest, origin, unit);
    m_Ties.rest = {};
  }
  for (LatticeLandmark & landmark : m_Ties.landmarks)
  {
    landmark.position = (landmark.position - origin) / unit;
  }
  if (m_Ties.image)
  {
    m_Ties.image->image = [image = std::move(m_Ties.image->image), origin, unit](const Vector3 & x) {
      ValueAndGradient found = image(origin + unit * x);
      found.gradient *= unit;
      return found;
    };
  }
}

double
TieEnergy::add(const LatticeLayout &   layout,
               const Eigen::VectorXd & x,
               unsigned int            threads,
               Eigen::VectorXd &       gradient) const
{
  double                    energy = 0.0;
  const DisplacementWeights reference{ m_Ties.referenceWeight, m_Ties.boundaryWeight };
  if (m_Reference.size() > 0 && (reference.bending > 0.0 || reference.boundary > 0.0))
  {
    energy += addDisplacementEnergy(layout, x, m_Reference, reference, threads, gradient);
  }
  if (!m_Ties.landmarks.empty() && m_Ties.landmarkWeight > 0.0)
  {
    energy += addLandmarkEnergy(layout, x, m_Ties.landmarks, m_Ties.landmarkWeight, gradient);
  }
  if (m_Ties.image && m_Ties.imageWeight > 0.0)
  {
    energy += addImageEnergy(layout, x, *m_Ties.image, m_Ties.imageWeight, threads, gradient);
  }
  return energy;
}

} // namespace moserhex
