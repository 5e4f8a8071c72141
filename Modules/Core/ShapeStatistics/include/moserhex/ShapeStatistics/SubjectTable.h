#pragma once

#include <Eigen/Core>

#include <cstddef>

namespace moserhex
{

/** Numbers of many subjects, a row a subject, that are read a slab of columns at a time: all subjects at some places.
 * Of shapes, columns 3 a, 3 a + 1, 3 a + 2 are the coordinates of aligned point a [mm].
 *
 * Statistics over subjects need all subjects at one place, not all places of one subject, so a file with the subjects
 * one after the other serves any number of them in a fixed amount of memory, read once for each pass. */
class SubjectTable
{
public:
  SubjectTable() = default;
  virtual ~SubjectTable() = default;
  SubjectTable(const SubjectTable &) = delete;
  SubjectTable &
  operator=(const SubjectTable &) = delete;

  /** N, the number of rows. */
  [[nodiscard]] virtual std::size_t
  subjects() const = 0;

  /** Numbers of a subject: of shapes, 3 for each point. */
  [[nodiscard]] virtual std::size_t
  columns() const = 0;

  /** subjects() x count. Called by several threads at once. */
  [[nodiscard]] virtual Eigen::MatrixXd
  read(std::size_t firstColumn, std::size_t count) const = 0;
};

/** A table in memory. */
class MatrixTable : public SubjectTable
{
public:
  /** \param values  a row for each subject */
  explicit MatrixTable(Eigen::MatrixXd values) : m_Values(std::move(values))
  {}

  /** Rows of the matrix. */
  [[nodiscard]] std::size_t
  subjects() const override
  {
    return static_cast<std::size_t>(m_Values.rows());
  }

  /** Columns of the matrix. */
  [[nodiscard]] std::size_t
  columns() const override
  {
    return static_cast<std::size_t>(m_Values.cols());
  }

  [[nodiscard]] Eigen::MatrixXd
  read(std::size_t firstColumn, std::size_t count) const override
  {
    return m_Values.middleCols(static_cast<Eigen::Index>(firstColumn), static_cast<Eigen::Index>(count));
  }

private:
  Eigen::MatrixXd m_Values;
};

} // namespace moserhex
