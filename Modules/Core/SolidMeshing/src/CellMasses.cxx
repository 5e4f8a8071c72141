#include "CellMasses.h"

#include "moserhex/HexMap/CellMeasure.h"

#include <sstream>

namespace moserhex
{

CellMasses::CellMasses(const SolidMeshingOptions & options, const HexMesh & equalVolumes)
  : m_Options(options)
  , m_Measure(*options.density,
              chooseMassQuadrature(equalVolumes, *options.density, options.densityAccuracy, options.threads).options)
{}

void
CellMasses::report(SolidMeshingResult & result) const
{
  result.mass = MassReport{ measureEquality(result.mesh, m_Measure, m_Options.threads).variance,
                            m_Measure.estimateError(result.mesh, m_Options.threads) };
  if (result.mass->quadratureError > m_Options.densityAccuracy)
  {
    std::ostringstream text;
    text << "masses are integrated to " << result.mass->quadratureError << " of the mean mass only, wanted "
         << m_Options.densityAccuracy << ": the density is rougher than the cells";
    result.warnings.push_back(text.str());
  }
}

} // namespace moserhex
