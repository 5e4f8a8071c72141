#include "moserhex/Numerics/CubeTransform.h"

#include "FieldLines.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Common/Types.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace moserhex
{
namespace
{
/** Lines transformed together. */
constexpr Eigen::Index panelLanes = 64;

/** What a thread works with: its own engine and its own panel. */
struct Worker
{
  std::unique_ptr<LineTransform> lines;
  LinePanel                      panel;
};

/** Workers not in use. As many are made as threads ever work at the same time. */
class WorkerPool
{
public:
  explicit WorkerPool(std::unique_ptr<LineTransform> original) : m_Original(std::move(original))
  {}

  std::unique_ptr<Worker>
  take() const
  {
    {
      const std::lock_guard<std::mutex> lock(m_Mutex);
      if (!m_Idle.empty())
      {
        std::unique_ptr<Worker> worker = std::move(m_Idle.back());
        m_Idle.pop_back();
        return worker;
      }
    }
    auto worker = std::make_unique<Worker>();
    worker->lines = m_Original->clone();
    return worker;
  }

  void
  putBack(std::unique_ptr<Worker> worker) const
  {
    const std::lock_guard<std::mutex> lock(m_Mutex);
    m_Idle.push_back(std::move(worker));
  }

private:
  std::unique_ptr<const LineTransform>         m_Original;
  mutable std::mutex                           m_Mutex;
  mutable std::vector<std::unique_ptr<Worker>> m_Idle;
};
} // namespace

struct CubeTransform::Plan
{
  Plan(int size, Basis basis, Engine engineInUse)
    : n(size)
    , engine(engineInUse)
    , workers(engineInUse == Engine::Fast ? makeFastLineTransform(size, basis) : makeDenseLineTransform(size, basis))
  {}

  Eigen::Index n;
  Engine       engine;
  WorkerPool   workers;
};

namespace
{
void
requireSize(int n)
{
  if (n < 1)
  {
    throw InvalidInput("size of the transform " + std::to_string(n) + ", must be at least 1");
  }
}

void
requireSymbol(const Eigen::VectorXd & symbol, Eigen::Index n)
{
  if (symbol.size() != n * n * n)
  {
    throw InvalidInput("symbol of " + std::to_string(symbol.size()) + " values, must be " + std::to_string(n) +
                       "^3 = " + std::to_string(n * n * n));
  }
}

/** Fields in memory: stacks of n^3 points with `interleaved` values each. */
struct Memory
{
  double *     values;
  Eigen::Index n;
  Eigen::Index stacks;
  Eigen::Index stackStride; // from the first value of a stack to that of the next
  Eigen::Index interleaved;
};

Memory
memoryOf(Eigen::Ref<Eigen::VectorXd> & fields, Eigen::Index n, ComponentOrder order)
{
  const Eigen::Index points = n * n * n;
  if (fields.size() == 0 || fields.size() % points != 0)
  {
    throw InvalidInput("fields of " + std::to_string(fields.size()) + " values, must be a multiple of " +
                       std::to_string(n) + "^3 = " + std::to_string(points));
  }
  const Eigen::Index components = fields.size() / points;
  if (order == ComponentOrder::Stacked)
  {
    return { fields.data(), n, components, points, 1 };
  }
  return { fields.data(), n, 1, fields.size(), components };
}

Memory
memoryOfColumns(Eigen::Ref<Eigen::MatrixXd> & fields, Eigen::Index n)
{
  if (fields.rows() != n * n * n)
  {
    throw InvalidInput("fields of " + std::to_string(fields.rows()) + " values, must have " + std::to_string(n) +
                       "^3 = " + std::to_string(n * n * n));
  }
  return { fields.data(), n, fields.cols(), fields.outerStride(), 1 };
}

enum class Direction
{
  Forward,
  Inverse
};

void
transformPanel(Worker & worker, Direction direction)
{
  if (direction == Direction::Forward)
  {
    worker.lines->forward(worker.panel);
  }
  else
  {
    worker.lines->inverse(worker.panel);
  }
}

/** Loads up to panelLanes lines from line `first` on, does body() with the worker's panel, and stores them. */
template <class Body>
void
withPanel(Worker &        worker,
          double *        values,
          const LineSet & lines,
          Eigen::Index    first,
          Eigen::Index    n,
          const Body &    body)
{
  const Eigen::Index count = std::min(panelLanes, lines.count - first);
  const Eigen::Index rows = (count + linesTogether - 1) / linesTogether * linesTogether;
  worker.panel.resize(rows, n);
  loadLines(worker.panel, values, lines, first, count);
  body();
  storeLines(worker.panel, values, lines, first, count);
}

/** Threads that are worth their start. */
unsigned int
usefulThreads(const Memory & memory, unsigned int threads)
{
  constexpr Eigen::Index fewValues = 16384; // about 0.2 ms of work
  return memory.stacks * memory.interleaved * memory.n * memory.n * memory.n < fewValues ? 1 : threads;
}

/** Along i and j, one plane of constant k after the other. */
void
transformPlanes(const WorkerPool & workers, const Memory & memory, Direction direction, unsigned int threads)
{
  const Eigen::Index n = memory.n;
  const Eigen::Index width = memory.interleaved * n;
  const LineSet      alongI{ width, memory.interleaved, memory.interleaved, width };
  const LineSet      alongJ{ width, width, width, 0 };
  parallelFor(static_cast<std::size_t>(memory.stacks * n), usefulThreads(memory, threads), [&](std::size_t index) {
    std::unique_ptr<Worker> worker = workers.take();
    const Eigen::Index      stack = static_cast<Eigen::Index>(index) / n;
    const Eigen::Index      k = static_cast<Eigen::Index>(index) % n;
    double * const          plane = memory.values + stack * memory.stackStride + k * width * n;
    for (const LineSet & lines : { alongI, alongJ })
    {
      for (Eigen::Index first = 0; first < lines.count; first += panelLanes)
      {
        withPanel(*worker, plane, lines, first, n, [&] { transformPanel(*worker, direction); });
      }
    }
    workers.putBack(std::move(worker));
  });
}

/** Along k: body(worker, first) does what is to be done with the panel of lines that begins with line `first`. */
template <class Body>
void
transformColumns(const WorkerPool & workers, const Memory & memory, unsigned int threads, const Body & body)
{
  const Eigen::Index n = memory.n;
  const Eigen::Index count = memory.interleaved * n * n;
  const LineSet      alongK{ count, count, count, 0 };
  const Eigen::Index panels = (count + panelLanes - 1) / panelLanes;
  parallelFor(static_cast<std::size_t>(memory.stacks * panels), usefulThreads(memory, threads), [&](std::size_t index) {
    std::unique_ptr<Worker> worker = workers.take();
    double * const          stack = memory.values + static_cast<Eigen::Index>(index) / panels * memory.stackStride;
    const Eigen::Index      first = static_cast<Eigen::Index>(index) % panels * panelLanes;
    withPanel(*worker, stack, alongK, first, n, [&] { body(*worker, first); });
    workers.putBack(std::move(worker));
  });
}

/** There, times symbol, and back; the spectrum along k never leaves the panel. */
void
multiplySpectra(const WorkerPool & workers, const Memory & memory, const Eigen::VectorXd & symbol, unsigned int threads)
{
  const Eigen::Index n = memory.n;
  requireSymbol(symbol, n);
  transformPlanes(workers, memory, Direction::Forward, threads);
  transformColumns(workers, memory, threads, [&](Worker & worker, Eigen::Index first) {
    transformPanel(worker, Direction::Forward);
    const Eigen::Index count = std::min(panelLanes, memory.interleaved * n * n - first);
    for (Eigen::Index lane = 0; lane < count; ++lane)
    {
      const double * const factors = symbol.data() + (first + lane) / memory.interleaved;
      for (Eigen::Index c = 0; c < n; ++c)
      {
        worker.panel(lane, c) *= factors[n * n * c];
      }
    }
    transformPanel(worker, Direction::Inverse);
  });
  transformPlanes(workers, memory, Direction::Inverse, threads);
}
} // namespace

CubeTransform::CubeTransform(int n, Basis basis, Engine engine)
{
  requireSize(n);
  if (engine == Engine::Automatic)
  {
    engine = fastLineTransformPays(n, basis) ? Engine::Fast : Engine::Dense;
  }
  m_Plan = std::make_shared<const Plan>(n, basis, engine);
}

int
CubeTransform::size() const
{
  return static_cast<int>(m_Plan->n);
}

CubeTransform::Engine
CubeTransform::engine() const
{
  return m_Plan->engine;
}

void
CubeTransform::forwardInPlace(Eigen::Ref<Eigen::VectorXd> fields, ComponentOrder order, unsigned int threads) const
{
  const Memory memory = memoryOf(fields, m_Plan->n, order);
  transformPlanes(m_Plan->workers, memory, Direction::Forward, threads);
  transformColumns(m_Plan->workers, memory, threads, [](Worker & worker, Eigen::Index) {
    transformPanel(worker, Direction::Forward);
  });
}

void
CubeTransform::inverseInPlace(Eigen::Ref<Eigen::VectorXd> spectra, ComponentOrder order, unsigned int threads) const
{
  const Memory memory = memoryOf(spectra, m_Plan->n, order);
  transformColumns(m_Plan->workers, memory, threads, [](Worker & worker, Eigen::Index) {
    transformPanel(worker, Direction::Inverse);
  });
  transformPlanes(m_Plan->workers, memory, Direction::Inverse, threads);
}

void
CubeTransform::multiplySpectrumInPlace(Eigen::Ref<Eigen::VectorXd> fields,
                                       const Eigen::VectorXd &     symbol,
                                       ComponentOrder              order,
                                       unsigned int                threads) const
{
  multiplySpectra(m_Plan->workers, memoryOf(fields, m_Plan->n, order), symbol, threads);
}

void
CubeTransform::multiplySpectraOfColumnsInPlace(Eigen::Ref<Eigen::MatrixXd> fields,
                                               const Eigen::VectorXd &     symbol,
                                               unsigned int                threads) const
{
  multiplySpectra(m_Plan->workers, memoryOfColumns(fields, m_Plan->n), symbol, threads);
}

Eigen::VectorXd
laplacianEigenvalues(int n, CubeTransform::Basis basis)
{
  requireSize(n);
  Eigen::VectorXd eigenvalues(n);
  for (int a = 0; a < n; ++a)
  {
    const double angle = basis == CubeTransform::Basis::Cosine ? pi * a / n : pi * (a + 1) / (n + 1);
    eigenvalues[a] = 2.0 - 2.0 * std::cos(angle);
  }
  return eigenvalues;
}

SpectralOperator::SpectralOperator(CubeTransform transform, Eigen::VectorXd symbol)
  : m_Transform(std::move(transform)), m_Symbol(std::move(symbol))
{
  requireSymbol(m_Symbol, m_Transform.size());
}

SpectralOperator::SpectralOperator(CubeTransform transform, const std::function<double(int a, int b, int c)> & symbol)
  : m_Transform(std::move(transform))
{
  const int    n = m_Transform.size();
  Eigen::Index entry = 0;
  m_Symbol.resize(static_cast<Eigen::Index>(n) * n * n);
  for (int c = 0; c < n; ++c)
  {
    for (int b = 0; b < n; ++b)
    {
      for (int a = 0; a < n; ++a)
      {
        m_Symbol[entry++] = symbol(a, b, c);
      }
    }
  }
}

void
SpectralOperator::applyInPlace(Eigen::Ref<Eigen::VectorXd> fields, ComponentOrder order, unsigned int threads) const
{
  m_Transform.multiplySpectrumInPlace(fields, m_Symbol, order, threads);
}

void
SpectralOperator::applyToColumnsInPlace(Eigen::Ref<Eigen::MatrixXd> fields, unsigned int threads) const
{
  m_Transform.multiplySpectraOfColumnsInPlace(fields, m_Symbol, threads);
}

SpectralOperator
functionOfLaplacian(int n, CubeTransform::Basis basis, const std::function<double(double lambda)> & g)
{
  const Eigen::VectorXd lambda = laplacianEigenvalues(n, basis);
  return { CubeTransform(n, basis), [&](int a, int b, int c) { return g(lambda[a] + (lambda[b] + lambda[c])); } };
}

} // namespace moserhex
