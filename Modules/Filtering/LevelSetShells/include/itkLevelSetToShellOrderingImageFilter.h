#ifndef itkLevelSetToShellOrderingImageFilter_h
#define itkLevelSetToShellOrderingImageFilter_h

#include "itkMoserHexMacros.h"

#include "moserhex/LevelSet/EikonalArrival.h"
#include "moserhex/LevelSet/LevelSet.h"
#include "moserhex/LevelSet/ShellOrdering.h"

#include <itkImageToImageFilter.h>

#include <string>
#include <vector>

namespace itk
{

/** How the shells of an organ are found. */
enum class ShellMethod
{
  /** Coupled Chan-Vese front: slowed so that all its parts arrive together; shells by volume. */
  ChanVese,
  /** Uncoupled Chan-Vese front (w = 1); shells are snapshots at equal steps of time, as in the paper. Where the front
   * has arrived they would touch and are held a part of a node apart (moserhex::separatedSnapshots). */
  Snapshots,
  /** |grad T| w = 1 with the coupled weight: the front without curvature, by fast sweeping; shells by volume. */
  Eikonal
};

/** As the command line has it. */
inline const char *
NameOf(ShellMethod method)
{
  switch (method)
  {
    case ShellMethod::Snapshots:
      return "snapshots";
    case ShellMethod::Eikonal:
      return "eikonal";
    default:
      return "chan-vese";
  }
}

/** Options of LevelSetToShellOrderingImageFilter. Lengths are in nodes of the grid. */
struct ShellOrderingFilterOptions
{
  ShellMethod  method{ ShellMethod::ChanVese }; ///< how the shells are found
  int          shells{ 10 };                    ///< N >= 1
  double       curvatureWeight{ 0.1 };          ///< nu, in units of the region force [nodes]
  double       heavisideWidth{ 1.5 };           ///< epsilon of the regularised Heaviside [nodes]
  double       seedRadius{ 1.2 };               ///< of the first front [nodes]
  double       reachedFraction{ 0.95 };  ///< coupled front stops here, the rest follows by depth; uncoupled: least [1]
  double       snapshotFraction{ 0.98 }; ///< uncoupled front stops here at the latest [1]
  unsigned int stallIterations{ 30 };    ///< iterations without growth after which a front has stopped [1]
  moserhex::SnapshotOptions      snapshots;                 ///< for Snapshots
  unsigned int                   maximumIterations{ 1500 }; ///< of a Chan-Vese front [1]
  moserhex::FrontWeightOptions   weight;                    ///< of the coupled methods
  moserhex::ShellOrderingOptions ordering;                  ///< of the coupled methods
  double                         snapshotSmoothing{
    0.5
  }; ///< sigma of the ordering for Snapshots: more would press touching shells together [nodes]
  moserhex::EikonalArrivalOptions eikonal; ///< for Eikonal
};

/** What the filter did. */
struct ShellOrderingFilterReport
{
  bool                     converged{ false };     ///< the front passed the fraction asked for
  unsigned int             iterations{ 0 };        ///< of the front (sweeps for Eikonal)
  unsigned int             torsionIterations{ 0 }; ///< conjugate-gradient steps; 0 for Snapshots
  double                   passedFraction{ 0.0 };  ///< of the nodes inside, when the front stopped [1]
  double                   meanInside{ 0.0 };      ///< mu_in at the end; 0 for Eikonal
  double                   meanOutside{ 0.0 };     ///< mu_out at the end; 0 for Eikonal
  std::size_t              unreached{ 0 };         ///< nodes ordered by depth because the front did not pass them
  std::size_t              raised{ 0 };            ///< nodes moved back so that every level set is a sphere
  double                   seconds{ 0.0 };         ///< wall time [s]
  std::vector<std::string> warnings;               ///< one line each
};

/** \class LevelSetToShellOrderingImageFilter
 * \brief From the level set of an organ (phi < 0 inside) to the ordering whose level sets are its shells.
 *
 * A front starts at the deepest point (the maximum of the torsion function; for Snapshots the minimum of phi) and moves
 * to the surface. The time T at which it passes a node becomes the ordering
 *
 *   s = (enclosed volume fraction)^(2/3)
 *
 * (moserhex::shellOrdering): every level set of s is one sphere, and level sets of one function are nested and
 * disjoint. Shell k of N is the level set of s that encloses GetVolumeFractions()[k-1] of the volume: for the coupled
 * methods ((2k-1)/(2N-1))^3, for Snapshots what the front had passed at the k-th of N equal steps of time.
 *
 * Input: isotropic image (spacing equal within 1e-6), border outside. Output: same grid.
 * \throws InvalidInputError   see moserhex::frontWeight, shellOrdering; number of shells < 1
 * \throws NotConvergedError   the linear solve or the sweeping
 */
template <typename TImage>
class ITK_TEMPLATE_EXPORT LevelSetToShellOrderingImageFilter : public ImageToImageFilter<TImage, TImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LevelSetToShellOrderingImageFilter);

  using Self = LevelSetToShellOrderingImageFilter;
  using Superclass = ImageToImageFilter<TImage, TImage>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;
  using ImageType = TImage;       ///< of input and output
  using MethodEnum = ShellMethod; ///< how the shells are found

  // The parts of itkNewMacro, which in ITK 5.2 leaves a second semicolon behind.
  itkSimpleNewMacro(Self);
  itkCreateAnotherMacro(Self);
  itkCloneMacro(Self);
  itkOverrideGetNameOfClassMacro(LevelSetToShellOrderingImageFilter);

  /** How the shells are found. */
  itkOptionMacro(Method, ShellMethod, method);

  /** N >= 1. */
  itkOptionMacro(NumberOfShells, int, shells);

  /** ShellOrderingFilterOptions::curvatureWeight. */
  itkOptionMacro(CurvatureWeight, double, curvatureWeight);

  /** ShellOrderingFilterOptions::heavisideWidth. */
  itkOptionMacro(HeavisideWidth, double, heavisideWidth);

  /** ShellOrderingFilterOptions::seedRadius. */
  itkOptionMacro(SeedRadius, double, seedRadius);

  /** ShellOrderingFilterOptions::reachedFraction. */
  itkOptionMacro(ReachedFraction, double, reachedFraction);

  /** ShellOrderingFilterOptions::snapshotFraction. */
  itkOptionMacro(SnapshotFraction, double, snapshotFraction);

  /** moserhex::SnapshotOptions::gap. */
  itkOptionMacro(SnapshotGap, double, snapshots.gap);

  /** ShellOrderingFilterOptions::maximumIterations. */
  itkOptionMacro(MaximumNumberOfIterations, unsigned int, maximumIterations);

  /** moserhex::FrontWeightOptions::depthPower. */
  itkOptionMacro(DepthPower, double, weight.depthPower);

  /** moserhex::FrontWeightOptions::smallestSlope. */
  itkOptionMacro(SmallestSlope, double, weight.smallestSlope);

  /** ShellOrderingFilterOptions::snapshotSmoothing. */
  itkOptionMacro(SnapshotSmoothing, double, snapshotSmoothing);

  /** moserhex::ShellOrderingOptions::smoothing. */
  itkOptionMacro(Smoothing, double, ordering.smoothing);

  /** After Update(): volume fraction of each shell, entry k-1 for shell k. */
  const std::vector<double> &
  GetVolumeFractions() const
  {
    return m_VolumeFractions;
  }

  /** After Update(): what was done. */
  const ShellOrderingFilterReport &
  GetReport() const
  {
    return m_Report;
  }

protected:
  LevelSetToShellOrderingImageFilter() = default;
  ~LevelSetToShellOrderingImageFilter() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  /** The whole input: a front comes everywhere. */
  void
  GenerateInputRequestedRegion() override;

  /** The whole output: it is made in one piece. */
  void
  EnlargeOutputRequestedRegion(DataObject * output) override;

  void
  GenerateData() override;

private:
  /** Times of a Chan-Vese front on `phi` with the given weight, from a ball around the seed. */
  moserhex::LevelSet
  ChanVeseArrival(const moserhex::LevelSet &         phi,
                  const moserhex::LevelSet &         weight,
                  std::size_t                        seed,
                  const moserhex::ProgressCallback & progress);

  moserhex::LevelSet
  EikonalArrival(const moserhex::LevelSet & phi, const moserhex::LevelSet & weight, std::size_t seed);

  ShellOrderingFilterOptions m_Options;
  ShellOrderingFilterReport  m_Report;
  std::vector<double>        m_VolumeFractions;
};

} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#include "itkLevelSetToShellOrderingImageFilter.hxx"
#endif

#endif
