#pragma once

#include "moserhex/ShapeStatistics/SubjectTable.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** The subjects' coordinates in a file without a name that goes with the object: any number of them in no memory. */
class SubjectFile : public SubjectTable
{
public:
  /** \param folder  on whose disk it lies \throws IOError */
  SubjectFile(const std::string & folder, std::size_t subjects, std::size_t columns);
  ~SubjectFile() override;

  [[nodiscard]] std::size_t
  subjects() const override
  {
    return m_Subjects;
  }

  [[nodiscard]] std::size_t
  columns() const override
  {
    return m_Columns;
  }

  /** \throws IOError */
  [[nodiscard]] Eigen::MatrixXd
  read(std::size_t firstColumn, std::size_t count) const override;

  /** \throws IOError */
  [[nodiscard]] Eigen::VectorXd
  readSubject(std::size_t subject) const;

  /** Rows may be written in any order, by several threads. \throws IOError  disk full, and others */
  void
  writeSubject(std::size_t subject, const Eigen::VectorXd & row);

private:
  void
  readAt(std::size_t subject, std::size_t firstColumn, std::size_t count, double * target) const;

  std::string m_Folder;
  std::size_t m_Subjects;
  std::size_t m_Columns;
  int         m_File{ -1 };
};

/** Some of the subjects of a table. Keeps a reference: the table must outlive the object. */
class ChosenSubjects : public SubjectTable
{
public:
  ChosenSubjects(const SubjectTable & table, std::vector<std::size_t> chosen)
    : m_Table(table), m_Chosen(std::move(chosen))
  {}

  [[nodiscard]] std::size_t
  subjects() const override
  {
    return m_Chosen.size();
  }

  [[nodiscard]] std::size_t
  columns() const override
  {
    return m_Table.columns();
  }

  [[nodiscard]] Eigen::MatrixXd
  read(std::size_t firstColumn, std::size_t count) const override;

private:
  const SubjectTable &     m_Table;
  std::vector<std::size_t> m_Chosen;
};

} // namespace moserhex::app
