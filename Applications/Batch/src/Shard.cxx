#include "Shard.h"

#include "CommandErrors.h"

#include <utility>

namespace moserhex::app
{
namespace
{

constexpr std::size_t mostShards = 100'000;

/** 0 for what is no number of shards. */
std::size_t
numberOf(const std::string & text)
{
  const bool isNumber = !text.empty() && text.size() <= 6 && text.find_first_not_of("0123456789") == std::string::npos;
  return isNumber ? std::stoul(text) : 0;
}

} // namespace

std::string
Shard::name() const
{
  return isAll() ? "" : std::to_string(number) + "-of-" + std::to_string(count);
}

void
Shard::keepOwn(std::vector<BatchCase> & cases) const
{
  std::vector<BatchCase> own;
  for (std::size_t c = number - 1; c < cases.size(); c += count)
  {
    own.push_back(std::move(cases[c]));
  }
  cases = std::move(own);
}

Shard
parseShard(const std::string & text)
{
  if (text.empty())
  {
    return {};
  }
  const std::size_t slash = text.find('/');
  Shard             shard;
  shard.number = numberOf(text.substr(0, slash));
  shard.count = slash == std::string::npos ? 0 : numberOf(text.substr(slash + 1));
  if (shard.number < 1 || shard.number > shard.count || shard.count > mostShards)
  {
    throw UsageError("--shard: " + oneLine(text, 40) + ", need K/M with 1 <= K <= M, for example 3/16");
  }
  return shard;
}

} // namespace moserhex::app
