"""What the tests mesh, and how files and the command see it."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy

# Oblique, right-handed in LPS, voxels of 1.0 x 1.2 x 2.5 mm.
SPACING = numpy.array([1.0, 1.2, 2.5])
ORIGIN = numpy.array([-13.5, 41.25, 107.0])


def oblique_axes():
    a, b = 0.3, -0.2
    about_z = numpy.array([[numpy.cos(a), -numpy.sin(a), 0.0], [numpy.sin(a), numpy.cos(a), 0.0], [0.0, 0.0, 1.0]])
    about_x = numpy.array([[1.0, 0.0, 0.0], [0.0, numpy.cos(b), -numpy.sin(b)], [0.0, numpy.sin(b), numpy.cos(b)]])
    return about_z @ about_x


def affine_of(axes=None, spacing=SPACING, origin=ORIGIN):
    affine = numpy.eye(4)
    affine[:3, :3] = (numpy.eye(3) if axes is None else axes) * spacing
    affine[:3, 3] = origin
    return affine


def to_other_space(affine):
    """RAS from LPS, and back."""
    return numpy.diag([-1.0, -1.0, 1.0, 1.0]) @ affine


def ellipsoid(shape=(34, 28, 14), value=1):
    """A voxel of the ellipsoid is one whose centre lies in it; indexed [i, j, k]."""
    centre = (numpy.array(shape) - 1) / 2
    semi_axes = numpy.array([14.0, 13.0, 13.0])
    index = numpy.stack(numpy.meshgrid(*[numpy.arange(n) for n in shape], indexing="ij"), axis=-1)
    inside = (((index - centre) * SPACING / semi_axes) ** 2).sum(axis=-1) < 1.0
    return (inside * value).astype(numpy.uint8)


def write_nrrd(path, labels, affine_lps):
    """Raw NRRD of 8-bit labels."""
    directions = " ".join("(" + ",".join(repr(float(x)) for x in column) + ")" for column in affine_lps[:3, :3].T)
    origin = ",".join(repr(float(x)) for x in affine_lps[:3, 3])
    header = (
        "NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\n"
        f"sizes: {' '.join(str(n) for n in labels.shape)}\nspace directions: {directions}\n"
        f"kinds: domain domain domain\nencoding: raw\nspace origin: ({origin})\n\n"
    )
    pathlib.Path(path).write_bytes(header.encode() + labels.astype(numpy.uint8).tobytes(order="F"))


class FolderTest(unittest.TestCase):
    """A test with a folder of its own and the command."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def command(self, *arguments):
        """Runs `moserhex` with these arguments, in the folder."""
        run = subprocess.run(
            [os.environ["MOSERHEX_EXECUTABLE"], *map(str, arguments)], cwd=self.folder, capture_output=True, text=True
        )
        self.assertEqual(run.returncode, 0, run.stderr)

    def json(self, name):
        return json.loads((self.folder / name).read_text())
