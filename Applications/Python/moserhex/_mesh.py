"""The functions and the class of the package: types, defaults and documentation around the compiled part."""

from __future__ import annotations

import functools
import json
import math
import os
import warnings
from typing import Any, Callable, Iterable, Optional, Tuple, Union

import numpy
import numpy.typing

from . import _moserhex

Array = numpy.typing.ArrayLike
Path = Union[str, "os.PathLike[str]"]


def mesh(
    labels: Array,
    affine: Array,
    *,
    label: Optional[int] = None,
    space: str = "RAS",
    shells: Optional[int] = None,
    padding: int = 0,
    stage: str = "exact",
    way: str = "fast",
    frame: str = "anatomical",
    shell_method: str = "auto",
    topology: str = "repair",
    max_repair: float = 5.0,
    density: Union[None, Array, Tuple[Array, Array]] = None,
    template: Optional[Mesh] = None,
    align: Union[str, Path] = "rigid",
    landmarks: Optional[Array] = None,
    template_landmarks: Optional[Array] = None,
    image: Union[None, Array, Tuple[Array, Array]] = None,
    template_image: Optional[Tuple[Array, Array]] = None,
    local_growth: bool = False,
    threads: int = 0,
    allow_partial: bool = False,
    progress: Optional[Callable[[float], Any]] = None,
) -> Mesh:
    """Mesh one label of a labelmap, or all its labels together: what the command `moserhex mesh` does.

    labels         array indexed [i, j, k] of integers, bools, or floats that are whole numbers; any strides and byte
                   order; copied once, never changed
    affine         4 x 4, from index to millimetres of `space`; its axes at right angles
    label          the label to mesh; None: the only one, or up to sixteen together
    space          of `affine` and of all coordinates of the mesh: "RAS" (nibabel) or "LPS" (ITK, SimpleITK, 3D Slicer)
    shells         N, from 2 to 64: (2N)^3 nodes, (2N-1)^3 cells; by default those of the template, else 10
    padding        layers of pillow cells around the lattice, for finite elements; the cube's functions of such a mesh
                   raise Error
    stage          last stage: "initial", "smoothed", "moser", "exact"
    way            of exact meshes: "fast" or "faithful"
    frame          "anatomical" or "ridge"
    shell_method   "auto", "chan-vese", "snapshots" or "eikonal"
    topology       "repair" labels that are not one solid without cavities and handles, or "reject" them
    max_repair     most that a repair may change, in per cent of the label's voxels
    density        positive image: cells get equal masses instead of equal volumes. An array on the voxels of `labels`, or
                   a pair (array, affine)
    template       a Mesh without padding that this one is tied to, node by node: a follow-up to its baseline, a subject
                   to an atlas; in any space; only with stage "exact", without padding, way and frame
    align          how the template is brought to the label first: "rigid" or "affine", by the surfaces; "none", where
                   both are of one scan; or a file with an ITK transform from the template to the label
    landmarks      (K, 3) places of this organ [mm], in `space`, and
    template_landmarks  (K, 3) the same ones on the template, in its space, to refine the tie by
    image          an image of this subject, to refine the tie by: an array on the voxels of `labels`, or a pair
                   (array, affine), and
    template_image a pair (array, affine in the template's space): an image of the same kind of the template's subject
    local_growth   every cell grows or shrinks as landmarks or images show, in place of all cells alike
    threads        0: all of the machine's; the result does not depend on it
    allow_partial  give out a mesh that is not exact, with a warning
    progress       called in this thread with the part done, in [0, 1]; what it raises ends the work, and so does returning
                   False (Error, E_CANCELLED)

    Other Python threads run meanwhile, and Ctrl-C ends the work. The same voxels and numbers of the affine give the same
    nodes, to the last bit, as the command.

    Raises Error; its `code` is one of Documentation/Errors.md.
    """
    density, density_affine = _with_affine(density, affine)
    image, image_affine = _with_affine(image, affine)
    if template_image is not None and not isinstance(template_image, tuple):
        raise TypeError("template_image: need a pair (array, affine)")
    template_image, template_affine = _with_affine(template_image, None)
    if template is not None and not isinstance(template, Mesh):
        raise TypeError(f"template: need a Mesh, not {type(template).__name__}")
    if shells is None:
        shells = 10 if template is None else template.nodes_per_side // 2
    return Mesh(
        _moserhex.mesh(
            labels,
            affine,
            label,
            space,
            shells,
            padding,
            stage,
            way,
            frame,
            shell_method,
            topology,
            max_repair,
            density,
            density_affine,
            None if template is None else template._compiled,
            os.fspath(align),
            landmarks,
            template_landmarks,
            image,
            image_affine,
            template_image,
            template_affine,
            local_growth,
            threads,
            allow_partial,
            progress,
        )
    )


def read(path: Path, *, space: str = "RAS", sandbox: bool = True) -> Mesh:
    """Read a lattice mesh that `Mesh.write` or the command wrote, or another tool's in the same order.

    Formats: .vtu, .vtk, .msh, .mesh, .inp, in LPS millimetres. `space` is that of the mesh's arrays. VTK's formats are
    read in a child process with limits of memory and time, unless `sandbox` is False: for programs whose other threads
    are busy, see Documentation/Python.md.

    Raises Error: E_NOINPUT, E_NOT_HEXAHEDRA and other faults of files.
    """
    return Mesh(_moserhex.read(os.fspath(path), space, sandbox))


def read_labels(
    path: Path,
    *,
    space: str = "RAS",
    threshold: Optional[float] = None,
    segment: Optional[str] = None,
    sandbox: bool = True,
) -> Tuple[numpy.ndarray, numpy.ndarray]:
    """Read a labelmap as the command does: (labels, affine), for `mesh(*read_labels(path))`.

    Formats: .nrrd, .nhdr, .seg.nrrd, .nii, .nii.gz, .mha, .mhd. The file is taken for hostile: a damaged one is refused.
    `threshold` makes a label of a probability map, `segment` names one of a .seg.nrrd. What is worth knowing of the file
    is a Python warning. `sandbox` as in `read`. The affine is computed of voxel sizes and axes: a mesh made with it equals
    the command's but for the effects of rounding, see Documentation/Python.md.

    Raises Error: E_NOINPUT, E_TRUNCATED, E_LABELS and other faults of files.
    """
    labels, affine, remarks = _moserhex.read_labels(os.fspath(path), space, threshold, segment, sandbox)
    for remark in remarks:
        warnings.warn(remark, stacklevel=2)
    return labels, affine


def agreement(
    labelmaps: Iterable[Tuple[Array, Array]],
    *,
    space: str = "RAS",
    disputed: float = 0.1,
    smoothing: float = 2.0,
) -> Tuple[numpy.ndarray, numpy.ndarray]:
    """The density of what several segmentations of one organ agree on, as (density, affine): for `mesh`.

    labelmaps   two or more pairs (labels, affine) in one space; every voxel that is not 0 is the organ
    space       of all affines: "RAS" or "LPS"
    disputed    density of voxels that only some hold, against 1
    smoothing   standard deviation of a Gaussian, within what at least one holds; 0: none [mm]

    Cells of equal mass under it hardly count what only one of them has, so that nodes stay where the organs are the same:

        agreed = moserhex.agreement([(first, affine), (second, affine)])
        baseline = moserhex.mesh(first, affine, density=agreed)
        follow_up = moserhex.mesh(second, affine, template=baseline, align="none", density=agreed)

    Raises Error: E_PRECONDITION for fewer than two, or none with a voxel in common; those of `mesh` for each array.
    """
    return _moserhex.agreement(list(labelmaps), space, disputed, smoothing)


class Mesh:
    """A structured hexahedral mesh, n x n x n nodes; made by `mesh` and `read`, never changed.

    Node (i, j, k) has the number i + n (j + n k), cell (i, j, k) likewise with n - 1. i grows towards the patient's left,
    j towards the back, k upwards, whatever the space of the coordinates. Safe to use from several threads.
    """

    def __init__(self, compiled: _moserhex.Mesh) -> None:
        self._compiled = compiled

    def __repr__(self) -> str:
        n = self.nodes_per_side
        return f"<moserhex.Mesh of {n} x {n} x {n} nodes, {self.space}>"

    @property
    def nodes_per_side(self) -> int:
        """n; twice the number of shells."""
        return self._compiled.nodes_per_side

    @property
    def padding_layers(self) -> int:
        """Layers of pillow cells around the lattice."""
        return self._compiled.padding_layers

    @property
    def space(self) -> str:
        """ "RAS" or "LPS": of all coordinates and affines."""
        return self._compiled.space

    @functools.cached_property
    def points(self) -> numpy.ndarray:
        """Nodes, (n^3, 3) float64 [mm], read-only."""
        return _read_only(self._compiled.points())

    @functools.cached_property
    def cells(self) -> numpy.ndarray:
        """Node numbers of the cells, ((n-1)^3, 8) int64, in the order of VTK_HEXAHEDRON, read-only.

        Seen in LPS coordinates the cells are right-handed; in RAS coordinates, too, as two axes change their sign.
        """
        return _read_only(self._compiled.cells())

    @property
    def report(self) -> Optional[dict]:
        """What the command's JSON report says, without names and checksums of files; None for a mesh from a file.

        Places in it are LPS millimetres.
        """
        if not self._compiled.report:
            return None
        report = json.loads(self._compiled.report)
        for part in ("input", "density", "template", "mesh"):
            for key in ("file", "sha256"):
                report.get(part, {}).pop(key, None)
        return report

    @property
    def warnings(self) -> list[str]:
        """What to know about the mesh or its input, one line each."""
        return self._compiled.warnings

    def quality(self, *, threads: int = 0) -> dict:
        """Numbers of `moserhex quality`: volume, variance, certificate, distributions of Verdict's metrics."""
        return json.loads(self._compiled.quality(threads))["quality"]

    def cube_coordinates(self, points: Array, *, threads: int = 0) -> numpy.ndarray:
        """Where points lie in the cube: (K, 3) in [0, 1]; rows of NaN for points outside the mesh.

        ((i, j, k) + (u, v, w)) / (n - 1) for a point of cell (i, j, k) at (u, v, w) in its unit cube. The inverse of
        `positions`, to 1e-12 of a cell's diagonal, where cells are certified (`quality()["certified"]`).
        """
        return self._compiled.cube_coordinates(points, threads)

    def positions(self, cube_coordinates: Array) -> numpy.ndarray:
        """Positions of cube coordinates, (K, 3) [mm]; rows of NaN stay NaN.

        Raises Error, E_PRECONDITION, for coordinates outside [0, 1].
        """
        return self._compiled.positions(cube_coordinates)

    def cell_means(
        self,
        values: Array,
        affine: Array,
        *,
        boxes: Optional[int] = None,
        order: int = 4,
        interpolation: str = "linear",
        outside: float = math.nan,
        rotate: bool = False,
        threads: int = 0,
    ) -> numpy.ndarray:
        """Mean of an image over every cell: (n-1, n-1, n-1), or of C components (n-1, n-1, n-1, C), indexed [i, j, k].

        values         array indexed [i, j, k], or [i, j, k, component]
        affine         4 x 4, from index to millimetres of the mesh's `space`
        boxes          N, 1 to 1000: means over N^3 equal boxes of the cube, (N, N, N); by default over the mesh's cells
        order          Gauss points along each axis of a cell, 2 to 48: as many as there are voxels along a cell, for the
                       kinks and steps between voxels
        interpolation  "linear" or "nearest"
        outside        value beyond half a voxel from the outermost voxel centres; by default cells that reach there are NaN
        rotate         vectors (C = 3) and symmetric tensors (C = 6: xx, xy, xz, yy, yz, zz), in the mesh's `space`, are
                       turned into the cube's own axes at each place

        Means times `cell_volumes` are integrals over the cells.

        Raises Error: E_GEOMETRY, E_DIMENSION, E_PIXELTYPE, E_USAGE, E_PRECONDITION.
        """
        return _moserhex.cell_means(
            self._compiled, values, affine, boxes or 0, order, interpolation, outside, rotate, threads
        )

    def node_samples(
        self,
        values: Array,
        affine: Array,
        *,
        interpolation: str = "linear",
        outside: float = math.nan,
        rotate: bool = False,
        threads: int = 0,
    ) -> numpy.ndarray:
        """An image at every node: (n, n, n) or (n, n, n, C), indexed [i, j, k]. Arguments as in `cell_means`."""
        return _moserhex.node_samples(self._compiled, values, affine, interpolation, outside, rotate, threads)

    def cell_volumes(self, *, boxes: Optional[int] = None, threads: int = 0) -> numpy.ndarray:
        """Volumes [mm^3] of the cells, (n-1, n-1, n-1), or of the images of N^3 boxes of the cube, indexed [i, j, k]."""
        return _moserhex.cell_volumes(self._compiled, boxes or 0, threads)

    def grid_samples(
        self,
        values: Array,
        affine: Array,
        shape: Tuple[int, int, int],
        *,
        sampling: str = "cells",
        interpolation: str = "linear",
        background: float = math.nan,
        rotate: bool = False,
        threads: int = 0,
    ) -> numpy.ndarray:
        """An image of the cube on a subject's voxels: what `cell_means` or `node_samples` of any mesh gave, back.

        values         (N, N, N), or (N, N, N, C), indexed [i, j, k]
        affine, shape  of the image to make: 4 x 4, from index to millimetres of the mesh's `space`; three sizes
        sampling       "cells": of N^3 boxes; "nodes": at N^3 points from face to face
        interpolation  "linear" or "nearest", between the cube's values
        background     of voxels whose centre is not in the mesh
        rotate         vectors and symmetric tensors in the cube's own axes are turned into the mesh's `space`

        Returns an array of that shape, with a fourth axis where there are components.
        """
        return _moserhex.grid_samples(
            self._compiled, values, affine, shape, sampling, interpolation, background, rotate, threads
        )

    def grid_masses(
        self,
        masses: Array,
        affine: Array,
        shape: Tuple[int, int, int],
        *,
        background: float = 0.0,
        threads: int = 0,
    ) -> Tuple[numpy.ndarray, numpy.ndarray]:
        """Masses of boxes of the cube on a subject's voxels, none lost: (densities, outside).

        masses         (N, N, N), or (N, N, N, C): `cell_means(...) * cell_volumes(...)` of a density, of any mesh
        affine, shape  as in `grid_samples`

        `densities`, mass per mm^3 of voxel, has that shape; times the voxel's volume and summed it is the sum of the
        masses less `outside`, (C,), what lies beyond the voxels. Voxels at the surface hold the mass of their part inside.
        """
        return _moserhex.grid_masses(self._compiled, masses, affine, shape, background, threads)

    def write(self, path: Path) -> None:
        """Write the mesh in the format of the name's ending, in LPS millimetres, completely or not at all.

        .vtu, .vtk, .msh, .inp, .mesh, .feb or .exo: Documentation/Formats.md. The same bytes as the command's.

        Raises Error: E_USAGE, E_CANTCREAT, E_IO.
        """
        self._compiled.write(os.fspath(path))


def _with_affine(image: Any, affine: Optional[Array]) -> Tuple[Any, Optional[Array]]:
    """An image and its affine, which is `affine` unless the image is a pair."""
    return image if isinstance(image, tuple) else (image, affine)


def _read_only(array: numpy.ndarray) -> numpy.ndarray:
    array.flags.writeable = False
    return array
