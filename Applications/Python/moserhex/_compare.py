"""Two meshes of one organ: what has changed between them."""

from __future__ import annotations

import dataclasses

import numpy

from . import _moserhex
from ._mesh import Mesh


@dataclasses.dataclass(frozen=True)
class Comparison:
    """What lies between a baseline and a follow-up with the same lattice; cells in the order of `Mesh.cells`.

    alignment             4 x 4, the motion of the follow-up onto the baseline that was taken away
    displacement          (n^3, 3) aligned follow-up less baseline, at every node [mm]
    growth                g, volume of the aligned follow-up over that of the baseline [1]
    deformation_gradient  F, (cells, 3, 3), mean over the cell of dx/dX [1]
    volume_ratio          J, (cells,), volume after over before [1]
    volumetric            J / g - 1, (cells,) [1]; zero in meshes of equal cells
    strain                E, (cells, 3, 3), Green-Lagrange: (F~^T F~ - 1) / 2, F~ = F g^(-1/3), growth of the whole organ
                          removed [1]
    principal_strains     (cells, 3) eigenvalues of E, largest first [1]
    deviatoric_strain     (cells,) |E - tr(E)/3 1| [1]
    largest_stretch       (cells,) length after over before of the fibre that grew most, sqrt(1 + 2 E_1) [1]
    thickness_change      (n^3, 3) of the lattice lines along i, j, k through every node [mm]; NaN where a line lies in
                          the surface
    surface_nodes         (B,) numbers of the nodes on the surface
    normal_motion         (B,) displacement along the baseline's outward normal [mm]
    signed_distance       (B,) of the follow-up's node from the baseline's surface, outside > 0: read it for growth [mm]
    baseline_signed_distance  (B,) of the baseline's node from the follow-up's surface, inside > 0: read it for loss [mm]
    warnings              what makes the comparison doubtful, one line each

    Vectors and tensors are in the axes of the baseline's `space`.
    """

    alignment: numpy.ndarray
    displacement: numpy.ndarray
    growth: float
    deformation_gradient: numpy.ndarray
    volume_ratio: numpy.ndarray
    volumetric: numpy.ndarray
    strain: numpy.ndarray
    principal_strains: numpy.ndarray
    deviatoric_strain: numpy.ndarray
    largest_stretch: numpy.ndarray
    thickness_change: numpy.ndarray
    surface_nodes: numpy.ndarray
    normal_motion: numpy.ndarray
    signed_distance: numpy.ndarray
    baseline_signed_distance: numpy.ndarray
    warnings: tuple[str, ...]


def compare(baseline: Mesh, follow_up: Mesh, *, align: str = "rigid", threads: int = 0) -> Comparison:
    """Compare two meshes of as many nodes, as `moserhex compare` does; they may be in different spaces.

    align  what of the difference is taken away first: "rigid" (place and turn), "similarity" (and size), "none"

    Strains mean something where the same index is the same tissue: mesh the follow-up with `template=baseline`.

    What makes the answer doubtful is in its `warnings`: look at them. Padding is left out.

    Raises Error: E_PRECONDITION for other numbers of nodes or layers of padding, or a cell without positive volume;
    E_USAGE.
    """
    return Comparison(**_moserhex.compare(baseline._compiled, follow_up._compiled, align, threads))
