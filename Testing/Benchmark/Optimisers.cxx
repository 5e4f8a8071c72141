// moserhex_optimisers OUTPUT.md [FOLDER [K]]
//
// Writes Documentation/Optimisers.md: ways to minimise the energy of stage J from one start lattice, on shapes made in
// code and, when a folder is given, on K of the labelmaps in it (3 unless told).
#include "OptimiserMethods.h"
#include "ResultsRun.h"

#include "moserhex/Analytic/SolidShapes.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

#include <algorithm>
#include <iostream>
#include <sstream>

namespace
{

using namespace moserhex;
using namespace moserhex::optimisers;
using results::fixed;

constexpr int shells = 10;

/** The initial map of a label, and the level set it is held on. */
Case
caseOf(const std::string & name, const LabelImage & image)
{
  results::RunOptions options;
  options.shells = shells;
  options.lastStage = MeshingStage::Initial;
  const results::Run run = results::runPipeline(image, options);

  results::LabelSolid solid = results::conditionedSolid(image, shells);
  return { name, run.pipeline->GetHexMesh(), std::make_shared<LevelSet>(std::move(solid.phi)), solid.volume };
}

Case
caseOf(const std::string & name, const analytic::Solid & solid)
{
  return caseOf(name, results::labelImageOf(solid));
}

std::vector<Case>
collectCases(const std::string & folder, std::size_t atMost)
{
  std::vector<Case> cases{ caseOf("ball", analytic::ball()),
                           caseOf("banana", analytic::banana()),
                           caseOf("ellipsoid 5:1", analytic::ellipsoid(Vector3(50.0, 10.0, 10.0))) };
  if (!folder.empty())
  {
    for (const auto & file : results::imagesIn(folder, atMost))
    {
      cases.push_back(caseOf(results::caseName(file), readLabelImage(file.string())));
    }
  }
  return cases;
}

void
writePreamble(std::ostream & os)
{
  const int n = 2 * shells;
  os << "# Optimisers\n\n"
        "Written by `moserhex_optimisers Documentation/Optimisers.md FOLDER` (preset `bench`); do not edit by hand.\n\n"
        "Ways to minimise the energy of stage J, shape + volume + surface (`Modules/Core/HexMap/README.md`), on "
     << n * n * n
     << " nodes,\nall from the same initial map, before any projection onto equal volumes. One thread, the shortest of "
        "two runs.\n\n"
        "- L-BFGS: at most 100 steps with epsilon 0.05, w_v 20, then 100 with 0.02, 50; w_s 80.\n"
        "- block Jacobi: inverses of the 3x3 diagonal blocks of the Gauss-Newton Hessian at the start of each stage.\n"
        "- cosine Laplacian: (L + 0.3)^-1 of the lattice's graph Laplacian by cosine transforms.\n"
        "- truncated Newton: Gauss-Newton Hessian, at most 12 and 8 steps of at most 60 conjugate gradients each.\n"
        "- coarse to fine: the start is taken to 6 nodes a side and back, the way and the stages of the product.\n\n"
        "*Evaluations* are of the energy with its gradient, *products* of the Hessian with a vector, both on the "
        "finest\n"
        "lattice only. *Energy* is that of the last stage over the number of cells; a regular lattice has 1.\n";
}

void
writeRow(std::ostream & os, const std::string & first, const Outcome & o)
{
  os << "| " << first << " | " << fixed(o.seconds, 2) << " | " << o.evaluations << " | " << o.hessianProducts << " | "
     << fixed(o.energy, 3) << " | " << fixed(o.smallestJacobian, 3) << " | " << o.concaveCells << " | "
     << results::significant(o.variance) << " |\n";
}

void
writeHeading(std::ostream & os, const std::string & first)
{
  os << "| " << first
     << " | seconds | evaluations | products | energy | SJ min | concave cells | vol. var. |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
}

/** Sums of times and counts, the mean energy and variance, the smallest Jacobian. */
Outcome
total(const std::vector<Outcome> & outcomes)
{
  Outcome    sum;
  const auto count = static_cast<double>(outcomes.size());
  sum.smallestJacobian = 1.0;
  for (const Outcome & o : outcomes)
  {
    sum.seconds += o.seconds;
    sum.evaluations += o.evaluations;
    sum.hessianProducts += o.hessianProducts;
    sum.energy += o.energy / count;
    sum.variance += o.variance / count;
    sum.smallestJacobian = std::min(sum.smallestJacobian, o.smallestJacobian);
    sum.concaveCells += o.concaveCells;
  }
  return sum;
}

void
writeTables(std::ostream & os, const std::vector<Case> & cases)
{
  std::vector<std::vector<Outcome>> byMethod;
  std::ostringstream                details;
  const std::vector<Method>         all = methods();
  byMethod.resize(all.size());
  for (const Case & organ : cases)
  {
    const HexQualitySummary start = summarizeQuality(organ.start);
    details << "\n## " << organ.name << "\n\nStart: SJ min " << fixed(start.scaledJacobian.minimum, 3) << ", "
            << start.concaveCells << " concave cells, vol. var. " << results::significant(start.volumeVariance)
            << ".\n\n";
    writeHeading(details, "method");
    for (std::size_t m = 0; m < all.size(); ++m)
    {
      std::cerr << organ.name << ": " << all[m].name << std::endl;
      byMethod[m].push_back(all[m].run(organ));
      writeRow(details, all[m].name, byMethod[m].back());
    }
  }
  os << "\n## All " << cases.size() << " shapes\n\n"
     << "Seconds, evaluations, products and concave cells summed, energy and variance averaged, the worst SJ.\n\n";
  writeHeading(os, "method");
  for (std::size_t m = 0; m < all.size(); ++m)
  {
    writeRow(os, all[m].name, total(byMethod[m]));
  }
  os << details.str();
}

} // namespace

int
main(int argc, char ** argv)
{
  if (argc < 2 || argc > 4)
  {
    std::cerr << "usage: moserhex_optimisers OUTPUT.md [FOLDER [K]]\n";
    return 2;
  }
  try
  {
    const std::string  folder = argc > 2 ? argv[2] : "";
    const std::size_t  atMost = argc > 3 ? std::stoul(argv[3]) : 3;
    std::ostringstream text;
    writePreamble(text);
    writeTables(text, collectCases(folder, atMost));
    writeTextFile(argv[1], text.str());
  }
  catch (const std::exception & error)
  {
    std::cerr << "moserhex_optimisers: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
