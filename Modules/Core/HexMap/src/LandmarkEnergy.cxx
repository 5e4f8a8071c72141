#include "LandmarkEnergy.h"

namespace moserhex
{

double
addLandmarkEnergy(const LatticeLayout &                layout,
                  const Eigen::VectorXd &              x,
                  const std::vector<LatticeLandmark> & landmarks,
                  double                               weight,
                  Eigen::VectorXd &                    gradient)
{
  double energy = 0.0;
  for (const LatticeLandmark & landmark : landmarks)
  {
    Vector3 away = -landmark.position;
    for (std::size_t a = 0; a < landmark.nodes.size(); ++a)
    {
      away += landmark.weights[a] * layout.at(x, landmark.nodes[a]);
    }
    energy += 0.5 * weight * away.squaredNorm();
    for (std::size_t a = 0; a < landmark.nodes.size(); ++a)
    {
      layout.add(gradient, landmark.nodes[a], weight * landmark.weights[a] * away);
    }
  }
  return energy;
}

} // namespace moserhex
