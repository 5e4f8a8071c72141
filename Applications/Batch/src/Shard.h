#pragma once

#include "CaseList.h"

#include <cstddef>
#include <string>
#include <vector>

namespace moserhex::app
{

/** A part of a list of cases, for one of several machines: every M-th, from the K-th. */
struct Shard
{
  std::size_t number{ 1 }; ///< K, from 1
  std::size_t count{ 1 };  ///< M

  [[nodiscard]] bool
  isAll() const
  {
    return count == 1;
  }

  /** "2-of-5", for names of files; empty for all. */
  [[nodiscard]] std::string
  name() const;

  void
  keepOwn(std::vector<BatchCase> & cases) const;
};

/** \param text  "K/M" with 1 <= K <= M, or empty: all. \throws UsageError */
[[nodiscard]] Shard
parseShard(const std::string & text);

} // namespace moserhex::app
