#pragma once

#include "moserhex/Common/Stopwatch.h"
#include "moserhex/SolidMeshing/SolidMeshing.h"

#include <string>
#include <vector>

namespace moserhex
{

/** Keeps the time and the mesh quality of the stages. */
class StageLog
{
public:
  explicit StageLog(std::vector<MeshingStageReport> & stages) : m_Stages(stages)
  {}

  void
  add(const std::string & name, const std::string & note = {})
  {
    m_Stages.push_back({ name, m_Stopwatch.seconds(), {}, note });
    m_Stopwatch = {};
  }

  void
  add(const std::string & name, const HexMesh & mesh, const std::string & note = {})
  {
    const double seconds = m_Stopwatch.seconds();
    m_Stages.push_back({ name, seconds, summarizeQuality(mesh), note });
    m_Stopwatch = {};
  }

private:
  std::vector<MeshingStageReport> & m_Stages;
  Stopwatch                         m_Stopwatch;
};

} // namespace moserhex
