// Exact. Read back by a few lines of NetCDF here, and by VTK's Exodus II reader in Python where it is installed.
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include "TestFolder.h"
#include "TestLattice.h"
#include "moserhex/Geometry/UnstructuredHexMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <vector>

using namespace moserhex;

namespace
{

/** Variables of a NetCDF classic file with 64-bit offsets and one record. */
class NetcdfVariables
{
public:
  explicit NetcdfVariables(std::string bytes) : m_Bytes(std::move(bytes))
  {
    EXPECT_EQ(m_Bytes.compare(0, 4, "CDF\x02"), 0);
    m_At = 4;
    EXPECT_EQ(take(4), 1U);
    std::vector<std::size_t> lengths;
    for (std::size_t count = beginList(); count > 0; --count)
    {
      (void)takeText();
      lengths.push_back(take(4));
    }
    skipAttributes();
    std::size_t expectedBegin = 0;
    for (std::size_t count = beginList(); count > 0; --count)
    {
      const std::string name = takeText();
      std::size_t       values = 1;
      for (std::size_t axes = take(4); axes > 0; --axes)
      {
        values *= std::max<std::size_t>(1, lengths.at(take(4)));
      }
      skipAttributes();
      const std::size_t type = take(4);
      const std::size_t size = take(4);
      const std::size_t begin = take(8);
      const std::size_t width = type == 6 ? 8 : type == 4 ? 4 : 1;
      EXPECT_EQ(size, (width * values + 3) / 4 * 4) << name;
      EXPECT_TRUE(expectedBegin == 0 || begin == expectedBegin) << name;
      EXPECT_LE(begin + size, m_Bytes.size()) << name;
      expectedBegin = begin + size;
      m_Variables[name] = { begin, values };
    }
    EXPECT_EQ(expectedBegin, m_Bytes.size());
  }

  [[nodiscard]] std::vector<int>
  integers(const std::string & name)
  {
    std::vector<int> values(variable(name).count);
    m_At = variable(name).begin;
    std::generate(values.begin(), values.end(), [this] { return static_cast<int>(take(4)); });
    return values;
  }

  [[nodiscard]] std::vector<double>
  doubles(const std::string & name)
  {
    std::vector<double> values(variable(name).count);
    m_At = variable(name).begin;
    std::generate(values.begin(), values.end(), [this] {
      const std::uint64_t bits = take(8);
      double              value = 0.0;
      std::memcpy(&value, &bits, sizeof(value));
      return value;
    });
    return values;
  }

  /** Names of 33 characters. */
  [[nodiscard]] std::vector<std::string>
  names(const std::string & name)
  {
    std::vector<std::string> texts;
    for (std::size_t at = 0; at < variable(name).count; at += 33)
    {
      texts.emplace_back(m_Bytes.c_str() + variable(name).begin + at);
    }
    return texts;
  }

private:
  struct Variable
  {
    std::size_t begin;
    std::size_t count;
  };

  [[nodiscard]] const Variable &
  variable(const std::string & name) const
  {
    return m_Variables.at(name);
  }

  std::uint64_t
  take(int width)
  {
    std::uint64_t value = 0;
    for (int i = 0; i < width; ++i)
    {
      value = 256 * value + static_cast<unsigned char>(m_Bytes.at(m_At++));
    }
    return value;
  }

  std::string
  takeText()
  {
    const std::size_t length = take(4);
    const std::string text = m_Bytes.substr(m_At, length);
    m_At += (length + 3) / 4 * 4;
    return text;
  }

  std::size_t
  beginList()
  {
    (void)take(4);
    return take(4);
  }

  void
  skipAttributes()
  {
    for (std::size_t count = beginList(); count > 0; --count)
    {
      (void)takeText();
      const std::size_t width = take(4) == 2 ? 1 : 4; // characters, or integers and single floats
      const std::size_t values = take(4);
      m_At += (width * values + 3) / 4 * 4;
    }
  }

  std::string                     m_Bytes;
  std::size_t                     m_At{ 0 };
  std::map<std::string, Variable> m_Variables;
};

NetcdfVariables
written(const HexMesh & mesh, const HexMeshFields & fields)
{
  const TestFolder folder;
  writeHexMesh(folder / "a.exo", mesh, fields);
  return NetcdfVariables(readBytes(folder / "a.exo"));
}

const std::vector<std::string> faceNames{ "FACE_I0", "FACE_I1", "FACE_J0", "FACE_J1", "FACE_K0", "FACE_K1" };

} // namespace

TEST(ExodusWriter, NodesAndBlocksAreTheLatticeByShells)
{
  const HexMesh mesh = bentLattice(4);
  auto          file = written(mesh, {});
  const char *  axes[] = { "coordx", "coordy", "coordz" };
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto values = file.doubles(axes[axis]);
    ASSERT_EQ(values.size(), 64U);
    for (std::size_t node = 0; node < 64; ++node)
    {
      EXPECT_EQ(values[node], mesh.nodes[node][axis]);
    }
  }
  EXPECT_EQ(file.names("eb_names"), (std::vector<std::string>{ "SHELL_1", "SHELL_2" }));
  EXPECT_EQ(file.integers("eb_prop1"), (std::vector<int>{ 1, 2 }));
  EXPECT_EQ(file.integers("connect1"), (std::vector<int>{ 22, 23, 27, 26, 38, 39, 43, 42 }));
  auto numbers = file.integers("elem_num_map");
  EXPECT_EQ(numbers.at(0), 14);
  EXPECT_EQ(numbers.at(1), 1);
  const auto outer = file.integers("connect2");
  ASSERT_EQ(outer.size(), 26U * 8U);
  for (std::size_t cell = 0; cell < 26; ++cell)
  {
    const auto expected = mesh.cellNodes(static_cast<std::size_t>(numbers[cell + 1] - 1));
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      EXPECT_EQ(outer[8 * cell + corner], static_cast<int>(expected[corner] + 1));
    }
  }
  std::sort(numbers.begin(), numbers.end());
  for (int cell = 0; cell < 27; ++cell)
  {
    EXPECT_EQ(numbers[static_cast<std::size_t>(cell)], cell + 1);
  }
}

TEST(ExodusWriter, SetsOfFourNodesPerSideAreThoseByHand)
{
  auto file = written(bentLattice(4), {});
  EXPECT_EQ(file.names("ns_names"), faceNames);
  EXPECT_EQ(file.names("ss_names"), faceNames);
  EXPECT_EQ(file.integers("node_ns1"),
            (std::vector<int>{ 1, 5, 9, 13, 17, 21, 25, 29, 33, 37, 41, 45, 49, 53, 57, 61 }));
  EXPECT_EQ(file.integers("node_ns4"),
            (std::vector<int>{ 13, 14, 15, 16, 29, 30, 31, 32, 45, 46, 47, 48, 61, 62, 63, 64 }));
  // Cells 1 to 9 of the lattice; the file's first is cell 14.
  EXPECT_EQ(file.integers("elem_ss5"), (std::vector<int>{ 2, 3, 4, 5, 6, 7, 8, 9, 10 }));
  EXPECT_EQ(file.integers("side_ss5"), std::vector<int>(9, 5));
  EXPECT_EQ(file.integers("side_ss1"), std::vector<int>(9, 4));
}

TEST(ExodusWriter, FieldsAreThereBlockByBlock)
{
  const HexMesh mesh = bentLattice(4);
  const auto    fields = someFields(mesh);
  auto          file = written(mesh, fields);
  EXPECT_EQ(file.names("name_elem_var"),
            (std::vector<std::string>{ "Shell", "VolumeRatio", "ScaledJacobian", "Label" }));
  EXPECT_EQ(file.names("name_nod_var").size(), 6U);
  EXPECT_EQ(file.doubles("time_whole"), std::vector<double>{ 0.0 });
  EXPECT_EQ(file.doubles("vals_nod_var1").at(3), 3.0);
  EXPECT_EQ(file.doubles("vals_nod_var4").at(2), 2.0 / 3.0);
  EXPECT_EQ(file.doubles("vals_nod_var6").at(63), 1.0);
  EXPECT_EQ(file.doubles("vals_elem_var1eb1"), std::vector<double>{ 1.0 });
  EXPECT_EQ(file.doubles("vals_elem_var1eb2"), std::vector<double>(26, 2.0));
  EXPECT_EQ(file.doubles("vals_elem_var3eb1"), std::vector<double>{ fields.scaledJacobian[13] });
  EXPECT_EQ(file.doubles("vals_elem_var4eb2").at(25), fields.label[26]);
  EXPECT_EQ(written(mesh, {}).names("name_elem_var"), (std::vector<std::string>{ "Shell", "VolumeRatio" }));
}

TEST(ExodusWriter, VtkReadsItWhenItsPythonIsInstalled)
{
  if (std::system("/usr/bin/python3 -c 'import vtkmodules.vtkIOExodus' > /dev/null 2>&1") != 0)
  {
    GTEST_SKIP() << "no python3-vtk9 here";
  }
  const TestFolder folder;
  const HexMesh    mesh = bentLattice(6);
  writeHexMesh(folder / "a.exo", mesh, someFields(mesh));
  writeHexMesh(folder / "a.vtk", mesh, someFields(mesh));
  const char * const script =
    "import sys\n"
    "from vtkmodules.vtkIOExodus import vtkExodusIIReader as R\n"
    "from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader\n"
    "v = vtkUnstructuredGridReader(); v.SetFileName(sys.argv[1] + 'a.vtk'); v.ReadAllScalarsOn()\n"
    "v.ReadAllFieldsOn(); v.Update(); v = v.GetOutput()\n"
    "r = R(); r.SetFileName(sys.argv[1] + 'a.exo')\n"
    "r.UpdateInformation()\n"
    "for t in (R.ELEM_BLOCK, R.NODE_SET, R.SIDE_SET):\n"
    "    for i in range(r.GetNumberOfObjects(t)): r.SetObjectStatus(t, i, 1)\n"
    "for t in (R.NODAL, R.ELEM_BLOCK):\n"
    "    for i in range(r.GetNumberOfObjectArrays(t)):\n"
    "        r.SetObjectArrayStatus(t, r.GetObjectArrayName(t, i), 1)\n"
    "r.GenerateGlobalNodeIdArrayOn(); r.GenerateGlobalElementIdArrayOn(); r.Update()\n"
    "def grids(kind):\n"
    "    b = r.GetOutput().GetBlock(kind)\n"
    "    return [b.GetBlock(i) for i in range(b.GetNumberOfBlocks())]\n"
    "def key(p): return tuple(round(x, 3) for x in p) # VTK makes the points single\n"
    "cells = 0\n"
    "blocks = grids(0)\n"
    "assert len(blocks) == 3\n"
    "for s, g in enumerate(blocks):\n"
    "    assert r.GetObjectName(R.ELEM_BLOCK, s).startswith('SHELL_%d' % (s + 1))\n"
    "    node = g.GetPointData().GetArray('GlobalNodeId')\n"
    "    number = g.GetCellData().GetArray('GlobalElementId')\n"
    "    for c in range(g.GetNumberOfCells()):\n"
    "        w = int(number.GetTuple1(c)) - 1\n"
    "        a, b = g.GetCell(c).GetPointIds(), v.GetCell(w).GetPointIds()\n"
    "        for i in range(8):\n"
    "            assert int(node.GetTuple1(a.GetId(i))) - 1 == b.GetId(i)\n"
    "            assert key(g.GetPoint(a.GetId(i))) == key(v.GetPoint(b.GetId(i)))\n"
    "        for f in ('Shell', 'VolumeRatio', 'ScaledJacobian', 'Label'):\n"
    "            assert g.GetCellData().GetArray(f).GetTuple1(c) == v.GetCellData().GetArray(f).GetTuple1(w), f\n"
    "        cells += 1\n"
    "    names = [g.GetPointData().GetArrayName(i) for i in range(g.GetPointData().GetNumberOfArrays())]\n"
    "    for f in ('LatticeIndex', 'CubeCoordinate'):\n"
    "        x = [g.GetPointData().GetArray(n) for n in names if n.startswith(f)]\n"
    "        assert len(x) == 1 and x[0].GetNumberOfComponents() == 3, names\n"
    "        for p in range(g.GetNumberOfPoints()):\n"
    "            w = int(node.GetTuple1(p)) - 1\n"
    "            assert key(x[0].GetTuple3(p)) == key(v.GetPointData().GetArray(f).GetTuple3(w)), f\n"
    "assert cells == 125\n"
    "place = {key(v.GetPoint(i)): (i % 6, i // 6 % 6, i // 36) for i in range(216)}\n"
    "for kind, t, size in ((4, R.SIDE_SET, 25), (7, R.NODE_SET, 36)):\n"
    "    sets = grids(kind)\n"
    "    assert len(sets) == 6\n"
    "    for f, g in enumerate(sets):\n"
    "        assert r.GetObjectName(t, f).startswith('FACE_' + 'IJK'[f // 2] + '01'[f % 2])\n"
    "        assert g.GetNumberOfCells() == size\n"
    "        used = {key(g.GetPoint(g.GetCell(c).GetPointId(i))) for c in range(size)\n"
    "                for i in range(g.GetCell(c).GetNumberOfPoints())}\n"
    "        assert len(used) == 36 and all(place[p][f // 2] == (0, 5)[f % 2] for p in used)\n";
  writeBytes(folder / "check.py", script);
  const std::string command =
    "/usr/bin/python3 '" + folder / "check.py" + "' '" + folder / "" + "' > '" + folder / "log" + "' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << readBytes(folder / "log");
  EXPECT_EQ(readBytes(folder / "log"), "");
}
