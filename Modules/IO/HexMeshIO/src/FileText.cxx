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

FileText::FileText(const std::string & fileName, std::string remedy, char comment, ErrorCode code)
  : m_FileName(fileName), m_Remedy(std::move(remedy)), m_Comment(comment), m_Code(code)
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

bool
FileText::nextWords(std::vector<std::string_view> & words)
{
  words.clear();
  while (words.empty() && !atEnd())
  {
    std::string_view line = nextLine();
    if (m_Comment != '\0')
    {
      line = line.substr(0, line.find(m_Comment));
    }
    for (std::size_t begin = 0; begin < line.size();)
    {
      std::size_t end = begin;
      while (end < line.size() && !isSpace(line[end]))
      {
        ++end;
      }
      if (end > begin)
      {
        words.push_back(line.substr(begin, end - begin));
      }
      begin = end + 1;
    }
  }
  return !words.empty();
}

std::size_t
FileText::lineNumber() const
{
  const auto        here = m_Text.begin() + static_cast<std::ptrdiff_t>(m_Position);
  const std::size_t newLines = static_cast<std::size_t>(std::count(m_Text.begin(), here, '\n'));
  const bool        behindNewLine = m_Position > 0 && m_Text[m_Position - 1] == '\n';
  return newLines + (behindNewLine ? 0 : 1);
}

void
FileText::skipBytes(std::size_t count, const char * what)
{
  if (count > remaining())
  {
    refuseEnd(what);
  }
  m_Position += count;
}

void
FileText::skipBehind(const std::string & mark)
{
  const std::size_t found = m_Text.find(mark, m_Position);
  if (found == std::string::npos)
  {
    refuseEnd(mark.c_str());
  }
  m_Position = found + mark.size();
}

void
FileText::requireRoom(std::size_t count, std::size_t bytesEach, const char * what) const
{
  if (count > remaining() / bytesEach)
  {
    refuse(ErrorCode::Truncated,
           "the file promises " + std::to_string(count) + " " + what + " and is too short for them");
  }
}

void
FileText::refuse(const std::string & cause) const
{
  refuse(m_Code, cause);
}

void
FileText::refuse(ErrorCode code, const std::string & cause) const
{
  throw BadInput(code, m_FileName, cause, m_Remedy);
}

void
FileText::refuseWord(std::string_view word, const char * what) const
{
  refuse("'" + std::string(word.substr(0, 20)) + "' where " + what + " is expected");
}

void
FileText::refuseEnd(const char * what) const
{
  refuse(ErrorCode::Truncated, std::string("the file ends before ") + what);
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
