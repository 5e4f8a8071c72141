#pragma once

#include "TestFolder.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace moserhex
{

/** Header lines of a small labelmap, to be changed line by line, and its 60 voxels. */
class ImageText
{
public:
  /** NRRD, 5 x 4 x 3 voxels of 0.5 x 0.75 x 2 mm. */
  static ImageText
  nrrd()
  {
    ImageText text;
    text.m_Separator = ": ";
    text.m_Begin = "NRRD0004\n";
    text.m_End = "\n";
    text.m_Lines = { { "type", "uint8" },
                     { "dimension", "3" },
                     { "space", "left-posterior-superior" },
                     { "sizes", "5 4 3" },
                     { "space directions", "(0.5,0,0) (0,0.75,0) (0,0,2)" },
                     { "kinds", "domain domain domain" },
                     { "encoding", "raw" },
                     { "space origin", "(1,2,3)" } };
    return text;
  }

  /** The same as MetaImage. */
  static ImageText
  meta()
  {
    ImageText text;
    text.m_Separator = " = ";
    text.m_Lines = { { "ObjectType", "Image" },     { "NDims", "3" },
                     { "BinaryData", "True" },      { "BinaryDataByteOrderMSB", "False" },
                     { "CompressedData", "False" }, { "TransformMatrix", "1 0 0 0 1 0 0 0 1" },
                     { "Offset", "1 2 3" },         { "ElementSpacing", "0.5 0.75 2" },
                     { "DimSize", "5 4 3" },        { "ElementType", "MET_UCHAR" },
                     { "ElementDataFile", "LOCAL" } };
    return text;
  }

  /** Changes a line; a new one goes before the last; an empty value takes it away. */
  ImageText
  with(const std::string & key, const std::string & value) const
  {
    ImageText  text = *this;
    const auto line =
      std::find_if(text.m_Lines.begin(), text.m_Lines.end(), [&key](const auto & one) { return one.first == key; });
    if (line == text.m_Lines.end())
    {
      text.m_Lines.insert(text.m_Lines.end() - 1, { key, value });
    }
    else if (value.empty())
    {
      text.m_Lines.erase(line);
    }
    else
    {
      line->second = value;
    }
    return text;
  }

  /** Puts a whole line before the last one. */
  ImageText
  withLine(const std::string & line) const
  {
    ImageText text = *this;
    text.m_Extra += line + '\n';
    return text;
  }

  [[nodiscard]] std::string
  header() const
  {
    std::string text = m_Begin;
    for (std::size_t n = 0; n < m_Lines.size(); ++n)
    {
      text += n + 1 == m_Lines.size() ? m_Extra : "";
      text += m_Lines[n].first + m_Separator + m_Lines[n].second + '\n';
    }
    return text + m_End;
  }

  [[nodiscard]] std::string
  file() const
  {
    return header() + voxels();
  }

  /** 60 bytes: 1 and 2 in the middle. */
  static std::string
  voxels()
  {
    std::string bytes(60, '\0');
    bytes[26] = 1;
    bytes[27] = 2;
    bytes[32] = 1;
    return bytes;
  }

private:
  std::string                                      m_Separator;
  std::string                                      m_Begin;
  std::string                                      m_End;
  std::string                                      m_Extra;
  std::vector<std::pair<std::string, std::string>> m_Lines;
};

/** Voxels of another type, in this machine's byte order or the other one. */
template <typename TVoxel>
std::string
voxelsAs(bool swapped = false, double factor = 1.0)
{
  std::string bytes;
  for (const char voxel : ImageText::voxels())
  {
    const auto value = static_cast<TVoxel>(factor * voxel);
    char       own[sizeof value];
    std::memcpy(own, &value, sizeof value);
    if (swapped)
    {
      std::reverse(own, own + sizeof own);
    }
    bytes.append(own, sizeof own);
  }
  return bytes;
}

} // namespace moserhex
