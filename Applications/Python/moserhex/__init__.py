"""Structured hexahedral meshes of equal-volume cells from labelmaps.

    import nibabel, numpy, moserhex

    image = nibabel.load("prostate.nii.gz")
    mesh = moserhex.mesh(numpy.asanyarray(image.dataobj), image.affine)
    mesh.write("prostate.vtu")

Every mesh is a one-to-one image of the unit cube: `Mesh.cube_coordinates` tells where in the cube a point is,
`Mesh.positions` goes back, `Mesh.cell_means` takes an image onto the cells. What the library refuses is an `Error`, whose
`code` is listed in Documentation/Errors.md.
"""

from ._mesh import Mesh, mesh, read, read_labels
from ._moserhex import Error, __version__

__all__ = ["Error", "Mesh", "mesh", "read", "read_labels", "__version__"]
