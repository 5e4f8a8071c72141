// Core alone: the quality of a cube of equal cells is perfect.
#include <moserhex/Quality/HexQuality.h>

#include <cmath>
#include <cstdio>

int
main()
{
  moserhex::HexMesh mesh;
  mesh.nodesPerSide = 4;
  for (int k = 0; k < 4; ++k)
  {
    for (int j = 0; j < 4; ++j)
    {
      for (int i = 0; i < 4; ++i)
      {
        mesh.nodes.emplace_back(i, j, k);
      }
    }
  }
  const moserhex::HexQualitySummary quality = moserhex::summarizeQuality(mesh);
  std::printf("volume %g mm^3, variance %g, scaled Jacobian %g\n",
              quality.volume,
              quality.volumeVariance,
              quality.scaledJacobian.minimum);
  const bool right =
    std::abs(quality.volume - 27.0) < 1e-12 && quality.volumeVariance < 1e-24 && quality.scaledJacobian.minimum > 0.999;
  return right ? 0 : 1;
}
