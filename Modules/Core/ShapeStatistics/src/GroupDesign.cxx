#include "moserhex/ShapeStatistics/GroupDesign.h"

#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <numeric>
#include <string>

namespace moserhex
{

Eigen::MatrixXd
groupColumns(const std::vector<std::size_t> & groups, std::size_t k)
{
  const bool isInRange = std::all_of(groups.begin(), groups.end(), [k](std::size_t group) { return group < k; });
  if (k < 2 || !isInRange)
  {
    throw InvalidInput("groups: " + std::to_string(k) + " groups, need at least 2, and no subject of another");
  }
  Eigen::MatrixXd columns =
    Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(groups.size()), static_cast<Eigen::Index>(k) - 1);
  for (std::size_t subject = 0; subject < groups.size(); ++subject)
  {
    if (groups[subject] > 0)
    {
      columns(static_cast<Eigen::Index>(subject), static_cast<Eigen::Index>(groups[subject]) - 1) = 1.0;
    }
  }
  return columns;
}

std::vector<Eigen::MatrixXd>
groupDisplacements(const Eigen::MatrixXd & slopes, const std::vector<std::size_t> & sizes)
{
  const auto        others = static_cast<Eigen::Index>(sizes.size()) - 1;
  const std::size_t subjects = std::accumulate(sizes.begin(), sizes.end(), std::size_t{ 0 });
  if (others < 1 || slopes.rows() % others != 0 || subjects == 0)
  {
    throw InvalidInput("groups: " + std::to_string(slopes.rows()) + " slopes at a place for " +
                       std::to_string(sizes.size()) + " groups of " + std::to_string(subjects) + " subjects");
  }
  const Eigen::Index           q = slopes.rows() / others;
  std::vector<Eigen::MatrixXd> displacements{ Eigen::MatrixXd::Zero(q, slopes.cols()) };
  Eigen::MatrixXd              middle = displacements.front();
  for (Eigen::Index group = 0; group < others; ++group)
  {
    displacements.emplace_back(slopes.middleRows(q * group, q));
    const auto size = static_cast<double>(sizes[static_cast<std::size_t>(group) + 1]);
    middle += size / static_cast<double>(subjects) * displacements.back();
  }
  for (Eigen::MatrixXd & displacement : displacements)
  {
    displacement -= middle;
  }
  return displacements;
}

} // namespace moserhex
