"""Reads what `moserhex` writes (.vtu meshes, .nrrd labelmaps) and takes meshes apart: numpy and VTK only.

A mesh is (nodes, shell, ratio): nodes n x n x n x 3 [mm, LPS] indexed [i, j, k]; shell and ratio per cell, [i, j, k].
"""

import gzip
from dataclasses import dataclass

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy


@dataclass
class Mesh:
    nodes: np.ndarray  # n x n x n x 3
    ratio: np.ndarray  # (n-1)^3, cell volume / mean
    grid: vtk.vtkUnstructuredGrid

    @property
    def n(self):
        return self.nodes.shape[0]

    @property
    def shells(self):
        return self.n // 2


@dataclass
class Labelmap:
    inside: np.ndarray  # bool, [i, j, k]
    origin: np.ndarray
    axes: np.ndarray  # columns: step of one voxel along i, j, k [mm, LPS]


def read_mesh(file_name):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(file_name))
    reader.Update()
    grid = reader.GetOutput()
    points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    n = round(len(points) ** (1 / 3))
    assert n**3 == len(points), f"{file_name}: {len(points)} nodes are no cube"
    nodes = points.reshape(n, n, n, 3).transpose(2, 1, 0, 3)
    ratio = vtk_to_numpy(grid.GetCellData().GetArray("VolumeRatio")).astype(float)
    return Mesh(nodes, ratio.reshape(n - 1, n - 1, n - 1).transpose(2, 1, 0), grid)


def read_nrrd(file_name, label=None):
    """Raw or gzip NRRD with a space, LPS or RAS; `label` None: everything above zero."""
    with open(file_name, "rb") as file:
        head, _, data = file.read().partition(b"\n\n")
    fields = {}
    for line in head.decode().splitlines():
        key, separator, value = line.partition(": ")
        if separator:
            fields[key.lower()] = value.strip()
    types = {"uchar": "u1", "unsigned char": "u1", "uint8": "u1", "short": "i2", "int16": "i2",
             "ushort": "u2", "unsigned short": "u2", "uint16": "u2", "uint8_t": "u1", "int": "i4"}
    if fields["encoding"] in ("gzip", "gz"):
        data = gzip.decompress(data)
    order = "<" if fields.get("endian", "little") == "little" else ">"
    sizes = [int(x) for x in fields["sizes"].split()]
    values = np.frombuffer(data, order + types[fields["type"]], count=int(np.prod(sizes))).reshape(sizes, order="F")
    vectors = [[float(x) for x in v.strip("()").split(",")] for v in fields["space directions"].split()]
    origin = np.array([float(x) for x in fields["space origin"].strip("()").split(",")])
    axes = np.array(vectors).T
    if fields["space"] in ("right-anterior-superior", "RAS"):
        flip = np.array([-1.0, -1.0, 1.0])
        origin, axes = origin * flip, axes * flip[:, None]
    return Labelmap(values > 0 if label is None else values == label, origin, axes)


def shell_of_node(n):
    """Shell number of every node, n x n x n."""
    index = np.abs(2 * np.arange(n) - (n - 1))
    return (1 + np.maximum(np.maximum(index[:, None, None], index[None, :, None]), index[None, None, :])) // 2


def cell_shells(n):
    """Shell number of every cell: that of its outermost node."""
    index = np.abs(np.arange(n - 1) - (n // 2 - 1))
    return 1 + np.maximum(np.maximum(index[:, None, None], index[None, :, None]), index[None, None, :])


def shell_quads(n, shell):
    """Node indices (i,j,k) of the quadrilaterals of a shell, outward: m x 4 x 3."""
    low, high = n // 2 - shell, n // 2 + shell - 1
    quads = []
    for axis in range(3):
        for level in (low, high):
            for b in range(low, high):
                for a in range(low, high):
                    corners = [(a, b), (a + 1, b), (a + 1, b + 1), (a, b + 1)]
                    if level == low:
                        corners.reverse()
                    quad = np.zeros((4, 3), int)
                    quad[:, axis] = level
                    quad[:, (axis + 1) % 3] = [c[0] for c in corners]
                    quad[:, (axis + 2) % 3] = [c[1] for c in corners]
                    quads.append(quad)
    return np.array(quads)


def at(values, index):
    """values[i, j, k] for an array of index triples."""
    return values[index[..., 0], index[..., 1], index[..., 2]]


def exposed_faces(n, kept):
    """Faces of kept cells that no kept cell shares, outward: (quads m x 4 x 3, cell of each m x 3)."""
    quads, cells = [], []
    padded = np.zeros((n + 1,) * 3, bool)
    padded[1:-1, 1:-1, 1:-1] = kept
    for axis in range(3):
        for side in (0, 1):
            step = np.zeros(3, int)
            step[axis] = 2 * side - 1
            neighbour = np.roll(padded, -step, (0, 1, 2))[1:-1, 1:-1, 1:-1]
            index = np.argwhere(kept & ~neighbour)
            corners = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])[:: 1 if side else -1]
            quad = np.repeat(index[:, None, :], 4, 1)
            quad[:, :, axis] += side
            quad[:, :, (axis + 1) % 3] += corners[:, 0]
            quad[:, :, (axis + 2) % 3] += corners[:, 1]
            quads.append(quad)
            cells.append(index)
    return np.concatenate(quads), np.concatenate(cells)


def triangulated_shell(mesh, shell):
    """A shell as (vertices, triangles), outward; every quadrilateral is cut along its shorter diagonal."""
    quads = shell_quads(mesh.n, shell)
    number = np.ravel_multi_index(tuple(quads.reshape(-1, 3).T), (mesh.n,) * 3)
    used, local = np.unique(number, return_inverse=True)
    vertices = mesh.nodes.reshape(-1, 3)[used]
    q = local.reshape(-1, 4)
    d02 = np.linalg.norm(vertices[q[:, 0]] - vertices[q[:, 2]], axis=1)
    d13 = np.linalg.norm(vertices[q[:, 1]] - vertices[q[:, 3]], axis=1)
    first = np.where((d02 <= d13)[:, None], q[:, [0, 1, 2]], q[:, [0, 1, 3]])
    second = np.where((d02 <= d13)[:, None], q[:, [0, 2, 3]], q[:, [1, 2, 3]])
    return vertices, np.concatenate([first, second])


def cut_cells(mesh, origin, normal):
    """Polygons in which a plane cuts the cells, and the cell (i,j,k) of each."""
    numbered = vtk.vtkUnstructuredGrid()
    numbered.ShallowCopy(mesh.grid)
    number = vtk.vtkIdTypeArray()
    number.SetName("Cell")
    number.SetNumberOfTuples(mesh.grid.GetNumberOfCells())
    for cell in range(mesh.grid.GetNumberOfCells()):
        number.SetValue(cell, cell)
    numbered.GetCellData().AddArray(number)
    plane = vtk.vtkPlane()
    plane.SetOrigin(*origin)
    plane.SetNormal(*normal)
    cutter = vtk.vtkCutter()
    cutter.SetInputData(numbered)
    cutter.SetCutFunction(plane)
    cutter.GenerateTrianglesOff()
    cutter.Update()
    cut = cutter.GetOutput()
    points = vtk_to_numpy(cut.GetPoints().GetData()).astype(float)
    cells = vtk_to_numpy(cut.GetCellData().GetArray("Cell"))
    polygons = [points[vtk_ids(cut.GetCell(c))] for c in range(cut.GetNumberOfCells())]
    index = np.array(np.unravel_index(cells, (mesh.n - 1,) * 3, order="F")).T
    return polygons, index


def vtk_ids(cell):
    return [cell.GetPointId(p) for p in range(cell.GetNumberOfPoints())]


def cut_surface(vertices, triangles, origin, normal):
    """Segments in which a plane cuts a triangle surface: m x 2 x 3."""
    side = (vertices - origin) @ normal
    segments = []
    for t in triangles:
        ends = []
        for a, b in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0])):
            if (side[a] < 0) != (side[b] < 0):
                weight = side[a] / (side[a] - side[b])
                ends.append((1 - weight) * vertices[a] + weight * vertices[b])
        if len(ends) == 2:
            segments.append(ends)
    return np.array(segments).reshape(-1, 2, 3)


def scaled_jacobians(mesh):
    """By vtkMeshQuality: VTK's own implementation of Verdict, [i, j, k]."""
    quality = vtk.vtkMeshQuality()
    quality.SetInputData(mesh.grid)
    quality.SetHexQualityMeasureToScaledJacobian()
    quality.Update()
    values = vtk_to_numpy(quality.GetOutput().GetCellData().GetArray("Quality")).astype(float)
    return values.reshape((mesh.n - 1,) * 3).transpose(2, 1, 0)
