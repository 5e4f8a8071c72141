#include "SubjectFile.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace moserhex::app
{
namespace
{

[[noreturn]] void
throwFailed(const std::string & folder, const std::string & what)
{
  throw IOError(ErrorCode::InputOutput,
                folder,
                "cannot " + what + " the subjects' file (" + std::strerror(errno) + ")",
                "free some space or choose another folder");
}

off_t
placeOf(std::size_t subject, std::size_t column, std::size_t columns)
{
  return static_cast<off_t>((subject * columns + column) * sizeof(double));
}

} // namespace

SubjectFile::SubjectFile(const std::string & folder, std::size_t subjects, std::size_t columns)
  : m_Folder(folder), m_Subjects(subjects), m_Columns(columns)
{
  std::string name = folder + "/.moserhex-subjects-XXXXXX";
  m_File = ::mkstemp(name.data());
  if (m_File < 0 || ::unlink(name.c_str()) != 0)
  {
    throwFailed(folder, "make");
  }
}

SubjectFile::~SubjectFile()
{
  ::close(m_File);
}

void
SubjectFile::readAt(std::size_t subject, std::size_t firstColumn, std::size_t count, double * target) const
{
  char *      bytes = reinterpret_cast<char *>(target);
  std::size_t done = 0;
  while (done < count * sizeof(double))
  {
    const ssize_t read = ::pread(m_File,
                                 bytes + done,
                                 count * sizeof(double) - done,
                                 placeOf(subject, firstColumn, m_Columns) + static_cast<off_t>(done));
    if (read == 0 || (read < 0 && errno != EINTR))
    {
      throwFailed(m_Folder, "read");
    }
    done += read > 0 ? static_cast<std::size_t>(read) : 0;
  }
}

Eigen::MatrixXd
SubjectFile::read(std::size_t firstColumn, std::size_t count) const
{
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> slab(static_cast<Eigen::Index>(m_Subjects),
                                                                              static_cast<Eigen::Index>(count));
  for (std::size_t subject = 0; subject < m_Subjects; ++subject)
  {
    readAt(subject, firstColumn, count, slab.row(static_cast<Eigen::Index>(subject)).data());
  }
  return slab;
}

Eigen::VectorXd
SubjectFile::readSubject(std::size_t subject) const
{
  Eigen::VectorXd row(static_cast<Eigen::Index>(m_Columns));
  readAt(subject, 0, m_Columns, row.data());
  return row;
}

void
SubjectFile::writeSubject(std::size_t subject, const Eigen::VectorXd & row)
{
  const char * bytes = reinterpret_cast<const char *>(row.data());
  std::size_t  done = 0;
  while (done < m_Columns * sizeof(double))
  {
    const ssize_t written = ::pwrite(m_File,
                                     bytes + done,
                                     m_Columns * sizeof(double) - done,
                                     placeOf(subject, 0, m_Columns) + static_cast<off_t>(done));
    if (written < 0 && errno != EINTR)
    {
      throwFailed(m_Folder, "write");
    }
    done += written > 0 ? static_cast<std::size_t>(written) : 0;
  }
}

Eigen::MatrixXd
ChosenSubjects::read(std::size_t firstColumn, std::size_t count) const
{
  const Eigen::MatrixXd all = m_Table.read(firstColumn, count);
  Eigen::MatrixXd       rows(static_cast<Eigen::Index>(m_Chosen.size()), all.cols());
  for (std::size_t row = 0; row < m_Chosen.size(); ++row)
  {
    rows.row(static_cast<Eigen::Index>(row)) = all.row(static_cast<Eigen::Index>(m_Chosen[row]));
  }
  return rows;
}

} // namespace moserhex::app
