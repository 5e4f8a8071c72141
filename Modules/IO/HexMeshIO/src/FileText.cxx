#include "FileText.h"

#include <fstream>
#include <iterator>

namespace moserhex
{
namespace
{

bool
isSpace(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

} // namespace

FileText::FileText(const std::string & fileName, std::string remedy, char comment)
  : m_FileName(fileName), m_Remedy(std::move(remedy)), m_Comment(comment)
{
  std::ifstream file(fileName, std::ios::binary);
  m_Text.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  if (file.bad())
  {
    throw IOError(ErrorCode::InputOutput, fileName, "reading failed", "check the disk");
  }
}

std::string_view
FileText::nextWord()
{
  skipSpace();
  const std::size_t begin = m_Position;
  while (m_Position < m_Text.size() && !isSpace(m_Text[m_Position]))
  {
    ++m_Position;
  }
  return std::string_view(m_Text).substr(begin, m_Position - begin);
}

std::string_view
FileText::peekWord()
{
  const std::size_t      position = m_Position;
  const std::string_view word = nextWord();
  m_Position = position;
  return word;
}

std::string_view
FileText::nextLine()
{
  const std::size_t begin = m_Position;
  const std::size_t newLine = m_Text.find('\n', begin);
  const std::size_t end = newLine == std::string::npos ? m_Text.size() : newLine;
  m_Position = end == m_Text.size() ? end : end + 1;
  return std::string_view(m_Text).substr(begin, end - begin);
}

void
FileText::skipBehind(const std::string & mark)
{
  const std::size_t found = m_Text.find(mark, m_Position);
  if (found == std::string::npos)
  {
    refuse("the file ends before " + mark);
  }
  m_Position = found + mark.size();
}

void
FileText::requireRoom(std::size_t count, std::size_t bytesEach, const char * what) const
{
  if (count > remaining() / bytesEach)
  {
    refuse("the file promises " + std::to_string(count) + " " + what + " and is too short for them");
  }
}

void
FileText::refuse(const std::string & cause) const
{
  throw BadInput(ErrorCode::NotHexahedra, m_FileName, cause, m_Remedy);
}

void
FileText::skipSpace()
{
  while (m_Position < m_Text.size() &&
         (isSpace(m_Text[m_Position]) || (m_Comment != '\0' && m_Text[m_Position] == m_Comment)))
  {
    if (isSpace(m_Text[m_Position]))
    {
      ++m_Position;
    }
    else
    {
      (void)nextLine();
    }
  }
}

} // namespace moserhex
