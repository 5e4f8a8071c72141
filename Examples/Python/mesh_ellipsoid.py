#!/usr/bin/env python3
"""Mesh an ellipsoid, look at it from within, take an image onto its cells, write it.

Usage: mesh_ellipsoid.py [OUTPUT.vtu]. Needs numpy and the installed package moserhex.
"""

import sys

import numpy

import moserhex

# A labelmap as nibabel gives one: an array [i, j, k] and the affine from index to RAS millimetres.
affine = numpy.diag([-1.0, -1.0, 2.0, 1.0])
affine[:3, 3] = [30.0, 24.0, -22.0]
i, j, k = numpy.meshgrid(range(60), range(48), range(24), indexing="ij")
x, y, z = numpy.moveaxis(numpy.stack([i, j, k], axis=-1) @ affine[:3, :3].T + affine[:3, 3], -1, 0)
labels = (x / 25) ** 2 + (y / 20) ** 2 + (z / 18) ** 2 < 1

mesh = moserhex.mesh(labels, affine, shells=6, progress=lambda done: print(f"\r{done:4.0%}", end=""))
exact = mesh.report["exact"]
print(f"\n{mesh}: variance of the volumes {exact['variance']:.1e}, certified: {exact['certified']}")
for warning in mesh.warnings:
    print("warning:", warning)

# Where in the cube are the centre and a point near the surface? The same cube coordinates in another mesh are the same place.
cube = mesh.cube_coordinates([[0.0, 0.0, 0.0], [24.0, 0.0, 0.0], [40.0, 0.0, 0.0]])
print("cube coordinates of the centre, of a point 1 mm below the surface, and of one outside:")
print(cube.round(3))
print("and back:")
print(mesh.positions(cube).round(3))

# An image on the cells, [i, j, k]: here its value is the distance from the centre in mm.
means = mesh.cell_means(numpy.sqrt(x**2 + y**2 + z**2), affine)
print(f"mean distance from the centre {means.mean():.3f} mm; of the innermost cell {means[5, 5, 5]:.3f} mm")

if len(sys.argv) > 1:
    mesh.write(sys.argv[1])
    print("written:", sys.argv[1])
