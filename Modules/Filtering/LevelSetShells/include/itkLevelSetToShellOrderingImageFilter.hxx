#ifndef itkLevelSetToShellOrderingImageFilter_hxx
#define itkLevelSetToShellOrderingImageFilter_hxx

#include "itkLevelSetToShellOrderingImageFilter.h"

#include "itkChanVeseArrivalImageFilter.h"
#include "itkCoreAlgorithm.h"
#include "itkLevelSetConversion.h"

#include "moserhex/Common/Stopwatch.h"

#include <itkEventObject.h>

#include <algorithm>
#include <sstream>

namespace itk
{

template <typename TImage>
void
LevelSetToShellOrderingImageFilter<TImage>::GenerateInputRequestedRegion()
{
  Superclass::GenerateInputRequestedRegion();
  if (auto * input = const_cast<ImageType *>(this->GetInput()))
  {
    input->SetRequestedRegionToLargestPossibleRegion();
  }
}

template <typename TImage>
void
LevelSetToShellOrderingImageFilter<TImage>::EnlargeOutputRequestedRegion(DataObject * output)
{
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TImage>
moserhex::LevelSet
LevelSetToShellOrderingImageFilter<TImage>::ChanVeseArrival(const moserhex::LevelSet &         phi,
                                                            const moserhex::LevelSet &         weight,
                                                            std::size_t                        seed,
                                                            const moserhex::ProgressCallback & progress)
{
  using FrontImage = Image<double, 3>;
  moserhex::LevelSet front{ phi.grid, std::vector<double>(phi.values.size()) };
  moserhex::LevelSet feature{ phi.grid, std::vector<double>(phi.values.size()) };
  const auto         centre = phi.grid.indexOf(seed);
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    const auto index = phi.grid.indexOf(node);
    const auto toSeed = moserhex::Vector3(index[0] - centre[0], index[1] - centre[1], index[2] - centre[2]);
    front.values[node] = toSeed.norm() - m_Options.seedRadius;
    feature.values[node] = phi.values[node] < 0.0 ? 1.0 : 0.0;
  }

  auto       solver = ChanVeseArrivalImageFilter<FrontImage>::New();
  const bool coupled = m_Options.method == ShellMethod::ChanVese;
  solver->SetInput(ImageFromLevelSet<FrontImage>(front));
  solver->SetFeatureImage(ImageFromLevelSet<FrontImage>(feature));
  solver->SetWeightImage(ImageFromLevelSet<FrontImage>(weight));
  solver->SetCurvatureWeight(m_Options.curvatureWeight);
  solver->SetHeavisideWidth(m_Options.heavisideWidth);
  solver->SetReachedFraction(coupled ? m_Options.reachedFraction : m_Options.snapshotFraction);
  solver->SetNumberOfIterations(m_Options.maximumIterations);
  solver->SetStallIterations(m_Options.stallIterations);

  solver->AddObserver(ProgressEvent(), [&](const EventObject &) {
    if (progress && !progress(solver->GetProgress()))
    {
      solver->AbortGenerateDataOn();
    }
  });
  solver->Update();

  // An uncoupled front stops by itself where it meets the surface, short of sharp edges.
  m_Report.converged = solver->GetConverged() || (!coupled && solver->GetPassedFraction() >= m_Options.reachedFraction);
  m_Report.iterations = static_cast<unsigned int>(solver->GetElapsedIterations());
  m_Report.passedFraction = solver->GetPassedFraction();
  m_Report.meanInside = solver->GetMeanInside();
  m_Report.meanOutside = solver->GetMeanOutside();
  return LevelSetFromImage(solver->GetOutput());
}

template <typename TImage>
moserhex::LevelSet
LevelSetToShellOrderingImageFilter<TImage>::EikonalArrival(const moserhex::LevelSet & phi,
                                                           const moserhex::LevelSet & weight,
                                                           std::size_t                seed)
{
  auto arrival = moserhex::eikonalArrival(phi, weight, seed, m_Options.eikonal);
  m_Report.converged = arrival.report.converged;
  m_Report.iterations = static_cast<unsigned int>(arrival.report.steps);
  m_Report.passedFraction = 1.0;
  return std::move(arrival.levelSet);
}

template <typename TImage>
void
LevelSetToShellOrderingImageFilter<TImage>::GenerateData()
{
  const moserhex::Stopwatch watch;
  m_Report = {};
  m_VolumeFractions.clear();
  const bool snapshots = m_Options.method == ShellMethod::Snapshots;

  const auto ordering = RunCoreAlgorithm(this, [&](const moserhex::ProgressCallback & progress) {
    const moserhex::LevelSet phi = LevelSetFromImage(this->GetInput());
    moserhex::FrontWeight    front;
    if (snapshots)
    {
      const auto deepest = std::min_element(phi.values.begin(), phi.values.end());
      front.seed = static_cast<std::size_t>(deepest - phi.values.begin());
      front.weight = { phi.grid, std::vector<double>(phi.values.size(), 1.0) };
    }
    else
    {
      front = moserhex::frontWeight(phi, m_Options.weight);
      m_Report.torsionIterations = static_cast<unsigned int>(front.torsion.steps);
    }
    moserhex::reportProgress(progress, 0.2);
    moserhex::LevelSet arrival =
      m_Options.method == ShellMethod::Eikonal
        ? this->EikonalArrival(phi, front.weight, front.seed)
        : this->ChanVeseArrival(phi, front.weight, front.seed, moserhex::progressBetween(progress, 0.2, 0.8));
    moserhex::reportProgress(progress, 0.8);
    moserhex::ShellOrderingOptions options = m_Options.ordering;
    m_VolumeFractions = moserhex::cubeVolumeFractions(m_Options.shells);
    if (snapshots)
    {
      auto taken = moserhex::separatedSnapshots(phi, arrival, m_Options.shells, m_Options.snapshots);
      arrival = std::move(taken.arrival);
      m_VolumeFractions = std::move(taken.volumeFractions);
      options.smoothing = m_Options.snapshotSmoothing;
    }
    return moserhex::shellOrdering(phi, arrival, front.seed, options);
  });

  m_Report.unreached = ordering.unreached;
  m_Report.raised = ordering.raised;
  m_Report.seconds = watch.seconds();
  if (!m_Report.converged)
  {
    std::ostringstream message;
    message << "the Chan-Vese front stopped early: it passed " << m_Report.passedFraction << " of the organ in "
            << m_Report.iterations << " iterations; the rest is ordered by depth";
    m_Report.warnings.push_back(message.str());
  }
  this->GetOutput()->Graft(ImageFromLevelSet<ImageType>(ordering.levelSet));
  this->UpdateProgress(1.0f);
}

template <typename TImage>
void
LevelSetToShellOrderingImageFilter<TImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << static_cast<int>(m_Options.method) << std::endl;
  os << indent << "NumberOfShells: " << m_Options.shells << std::endl;
  os << indent << "CurvatureWeight: " << m_Options.curvatureWeight << std::endl;
  os << indent << "Iterations: " << m_Report.iterations << std::endl;
  os << indent << "PassedFraction: " << m_Report.passedFraction << std::endl;
}

} // namespace itk

#endif
