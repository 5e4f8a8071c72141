#include "HexCellCollector.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace moserhex
{
namespace
{

/** "12 x line, 24 x quadrilateral" */
std::string
listOf(const std::map<std::string, std::size_t> & counts)
{
  std::string list;
  for (const auto & [name, count] : counts)
  {
    list += (list.empty() ? "" : ", ") + std::to_string(count) + " x " + name;
  }
  return list;
}

bool
isConsecutive(const std::vector<HexCellCollector::NodeTag> & tags)
{
  return std::adjacent_find(tags.begin(), tags.end(), [](auto a, auto b) { return a + 1 != b; }) == tags.end();
}

} // namespace

HexCellCollector::HexCellCollector(std::string fileName) : m_FileName(std::move(fileName))
{}

void
HexCellCollector::addNode(NodeTag tag, const Vector3 & position)
{
  if (!(position.array().abs() <= 1e9).all())
  {
    refuse("node " + std::to_string(tag) + " is not finite or beyond 1e9 mm");
  }
  if (tag < 0 || tag == std::numeric_limits<NodeTag>::max())
  {
    refuse("a node has the number " + std::to_string(tag));
  }
  m_Tags.push_back(tag);
  m_Nodes.push_back(position);
}

void
HexCellCollector::addHexahedron(const std::array<NodeTag, 8> & tags)
{
  m_Cells.push_back(tags);
}

void
HexCellCollector::addOther(const std::string & name, int dimension, std::size_t count)
{
  if (count > 0)
  {
    (dimension < 3 ? m_Ignored : m_Refused)[name] += count;
  }
}

HexCellFile
HexCellCollector::finish()
{
  requireHexahedraOnly();
  numberNodes();
  HexCellFile file;
  file.mesh.nodes = std::move(m_Nodes);
  file.mesh.cells.reserve(m_Cells.size());
  for (std::size_t number = 0; number < m_Cells.size(); ++number)
  {
    std::array<std::size_t, 8> cell{};
    std::transform(m_Cells[number].begin(), m_Cells[number].end(), cell.begin(), [](NodeTag node) {
      return static_cast<std::size_t>(node);
    });
    auto sorted = cell;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    {
      refuse("hexahedron " + std::to_string(number + 1) + " of the file has one node twice");
    }
    file.mesh.cells.push_back(cell);
  }
  if (!m_Ignored.empty())
  {
    file.warnings.push_back("ignored: " + listOf(m_Ignored));
  }
  dropUnusedNodes(file);
  return file;
}

void
HexCellCollector::refuse(const std::string & cause) const
{
  throw BadInput(ErrorCode::NotHexahedra, m_FileName, cause, "export a mesh of 8-node hexahedra again");
}

void
HexCellCollector::requireHexahedraOnly() const
{
  if (!m_Refused.empty())
  {
    refuse("has cells other than 8-node hexahedra: " + listOf(m_Refused));
  }
  if (m_Cells.empty())
  {
    refuse("has no hexahedron" + (m_Ignored.empty() ? std::string() : ", only " + listOf(m_Ignored)));
  }
  if (m_Nodes.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
  {
    refuse("has " + std::to_string(m_Nodes.size()) + " nodes, more than 2^31 - 1");
  }
}

/** Replaces the tags in the cells by the numbers of the nodes. */
void
HexCellCollector::numberNodes()
{
  const NodeTag            count = static_cast<NodeTag>(m_Tags.size());
  const bool               consecutive = isConsecutive(m_Tags);
  std::vector<std::size_t> order(consecutive ? 0 : m_Tags.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) { return m_Tags[a] < m_Tags[b]; });
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    if (m_Tags[order[i - 1]] == m_Tags[order[i]])
    {
      refuse("node " + std::to_string(m_Tags[order[i]]) + " is given twice");
    }
  }
  const auto numberOf = [&](NodeTag tag) -> NodeTag {
    if (consecutive)
    {
      const bool known = count > 0 && tag >= m_Tags.front() && tag <= m_Tags.back();
      return known ? tag - m_Tags.front() : -1;
    }
    const auto found = std::lower_bound(
      order.begin(), order.end(), tag, [this](std::size_t node, NodeTag wanted) { return m_Tags[node] < wanted; });
    return found != order.end() && m_Tags[*found] == tag ? static_cast<NodeTag>(*found) : -1;
  };
  for (std::size_t cell = 0; cell < m_Cells.size(); ++cell)
  {
    for (NodeTag & tag : m_Cells[cell])
    {
      const NodeTag number = numberOf(tag);
      if (number < 0)
      {
        refuse("hexahedron " + std::to_string(cell + 1) + " of the file names node " + std::to_string(tag) +
               ", which is not there");
      }
      tag = number;
    }
  }
}

void
HexCellCollector::dropUnusedNodes(HexCellFile & file) const
{
  constexpr std::size_t    unused = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> newNumber(file.mesh.nodes.size(), unused);
  for (const auto & cell : file.mesh.cells)
  {
    for (const std::size_t node : cell)
    {
      newNumber[node] = 0;
    }
  }
  std::size_t kept = 0;
  for (std::size_t node = 0; node < newNumber.size(); ++node)
  {
    if (newNumber[node] != unused)
    {
      file.mesh.nodes[kept] = file.mesh.nodes[node];
      newNumber[node] = kept++;
    }
  }
  if (kept == newNumber.size())
  {
    return;
  }
  file.warnings.push_back("ignored: " + std::to_string(newNumber.size() - kept) + " nodes without a hexahedron");
  file.mesh.nodes.resize(kept);
  for (auto & cell : file.mesh.cells)
  {
    for (std::size_t & node : cell)
    {
      node = newNumber[node];
    }
  }
}

} // namespace moserhex
