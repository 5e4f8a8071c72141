"""Structured hexahedral meshes of equal-volume cells from labelmaps.

    import nibabel, numpy, moserhex

    image = nibabel.load("prostate.nii.gz")
    mesh = moserhex.mesh(numpy.asanyarray(image.dataobj), image.affine)
    mesh.write("prostate.vtu")

Every mesh is a one-to-one image of the unit cube: `Mesh.cube_coordinates` tells where in the cube a point is,
`Mesh.positions` goes back, `Mesh.cell_means` takes an image onto the cells and `Mesh.grid_samples` from the cube to
voxels. `compare` says what has changed between two meshes; `procrustes`, `mean_mesh`, `fit_shapes` and
`permutation_test` are statistics over many. What the library refuses is an `Error`, whose `code` is listed in
Documentation/Errors.md.
"""

from ._atlas import (
    PermutationTest,
    Procrustes,
    ShapeModel,
    fit_shapes,
    group_columns,
    mean_mesh,
    permutation_test,
    procrustes,
)
from ._compare import Comparison, compare
from ._mesh import Mesh, agreement, mesh, read, read_labels
from ._moserhex import Error, __version__

__all__ = [
    "Comparison",
    "Error",
    "Mesh",
    "PermutationTest",
    "Procrustes",
    "ShapeModel",
    "agreement",
    "compare",
    "fit_shapes",
    "group_columns",
    "mean_mesh",
    "mesh",
    "permutation_test",
    "procrustes",
    "read",
    "read_labels",
    "__version__",
]
