#pragma once

#include "ImageText.h"

namespace moserhex
{

/** The header of ImageText's voxels with an sform, in either byte order. */
class NiftiText
{
public:
  explicit NiftiText(bool swapped = false) : m_Swapped(swapped), m_Bytes(352, '\0')
  {
    set<std::int32_t>(0, 348);
    for (const std::int16_t n : { 3, 5, 4, 3, 1, 1, 1, 1 })
    {
      set<std::int16_t>(m_Next, n);
    }
    set<std::int16_t>(70, 2); // unsigned char
    set<std::int16_t>(72, 8);
    for (const float n : { 1.0F, 0.5F, 0.75F, 2.0F })
    {
      set<float>(76 + 4 * m_Axis++, n);
    }
    set<float>(108, 352.0F);
    set<float>(112, 1.0F);
    set<char>(123, 2);
    set<std::int16_t>(254, 1);
    for (const auto & [offset, n] : { std::pair(280, -0.5F),
                                      std::pair(292, -1.0F),
                                      std::pair(300, -0.75F),
                                      std::pair(308, -2.0F),
                                      std::pair(320, 2.0F),
                                      std::pair(324, 3.0F) })
    {
      set<float>(static_cast<std::size_t>(offset), n);
    }
    m_Bytes.replace(344, 4, std::string("n+1\0", 4));
  }

  template <typename T>
  NiftiText &
  set(std::size_t offset, T value)
  {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    if (m_Swapped)
    {
      std::reverse(bytes, bytes + sizeof bytes);
    }
    m_Bytes.replace(offset, sizeof bytes, bytes, sizeof bytes);
    m_Next = offset == m_Next ? m_Next + sizeof bytes : m_Next;
    return *this;
  }

  /** qform of half a turn about z: the same axes as the sform's. */
  NiftiText &
  setQform(float d, float x)
  {
    set<std::int16_t>(252, 1);
    set<float>(264, d);
    set<float>(268, x);
    set<float>(272, -2.0F);
    return set<float>(276, 3.0F);
  }

  NiftiText &
  setMagic(const std::string & magic)
  {
    m_Bytes.replace(344, 4, magic);
    return *this;
  }

  [[nodiscard]] std::string
  header() const
  {
    return m_Bytes;
  }

  [[nodiscard]] std::string
  file() const
  {
    return m_Bytes + ImageText::voxels();
  }

private:
  bool        m_Swapped;
  std::string m_Bytes;
  std::size_t m_Next{ 40 };
  std::size_t m_Axis{ 0 };
};

} // namespace moserhex
