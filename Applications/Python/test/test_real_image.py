"""A tie refined by a magnetic resonance image of a head: Debian's mricron-data, which is not part of this project."""

import pathlib
import unittest

import numpy

import moserhex

IMAGE = pathlib.Path("/usr/share/mricron/templates/ch2.nii.gz")
CENTRE = numpy.array([0.0, -18.0, 8.0])  # of an ellipsoid in the middle of the brain, RAS mm
SEMI_AXES = numpy.array([30.0, 36.0, 26.0])


def turned(points, angle, axis):
    """Turns shells of the ellipsoid about an axis, by less towards the surface, which stays: keeps all volumes."""
    unit = (points - CENTRE) / SEMI_AXES
    angles = angle * numpy.clip(1.0 - (unit**2).sum(axis=-1), 0.0, None) ** 2
    i, j = (axis + 1) % 3, (axis + 2) % 3
    result = unit.copy()
    result[..., i] = numpy.cos(angles) * unit[..., i] - numpy.sin(angles) * unit[..., j]
    result[..., j] = numpy.sin(angles) * unit[..., i] + numpy.cos(angles) * unit[..., j]
    return result * SEMI_AXES + CENTRE


def deformed(points):
    return turned(turned(points, 0.4, 2), 0.28, 0)


def before_deformation(points):
    return turned(turned(points, -0.28, 0), -0.4, 2)


def interpolated(image, index):
    """Trilinear; the border's value beyond it."""
    low = numpy.clip(numpy.floor(index).astype(int), 0, numpy.array(image.shape) - 2)
    part = numpy.clip(index - low, 0.0, 1.0)
    result = numpy.zeros(index.shape[:-1])
    for corner in numpy.ndindex(2, 2, 2):
        weights = numpy.where(corner, part, 1.0 - part).prod(axis=-1)
        result += weights * image[tuple(numpy.moveaxis(low + corner, -1, 0))]
    return result


@unittest.skipUnless(IMAGE.exists(), f"{IMAGE} is missing: it is of the Debian package mricron-data")
class RealImage(unittest.TestCase):
    def test_draws_the_nodes_to_the_same_tissue(self):
        image, affine = moserhex.read_labels(IMAGE)
        image = image.astype(float)
        voxels = numpy.stack(numpy.meshgrid(*[numpy.arange(n) for n in image.shape], indexing="ij"), axis=-1)
        points = voxels @ affine[:3, :3].T + affine[:3, 3]
        organ = (((points - CENTRE) / SEMI_AXES) ** 2).sum(axis=-1) < 1.0
        source = before_deformation(points) - affine[:3, 3]
        later = 1.3 * interpolated(image, source @ numpy.linalg.inv(affine[:3, :3]).T) + 20.0  # of another gain
        later += numpy.random.default_rng(1).normal(0.0, 0.1 * image[organ].std(), image.shape)

        baseline = moserhex.mesh(organ, affine, shells=8)
        truth = deformed(baseline.points)
        inner = (((baseline.points - CENTRE) / SEMI_AXES) ** 2).sum(axis=1) < 0.8

        def error(mesh):
            return numpy.median(numpy.linalg.norm(mesh.points - truth, axis=1)[inner])

        tied = moserhex.mesh(organ, affine, template=baseline, align="none")
        refined = moserhex.mesh(
            organ, affine, template=baseline, align="none", image=later, template_image=(image, affine)
        )
        print(f"median error of inner nodes: {error(tied):.2f} mm tied, {error(refined):.2f} mm refined by the image")
        self.assertTrue(refined.report["exact"]["reached"])
        self.assertGreater(error(tied), 1.5)  # the shape alone says nothing of what moves inside
        self.assertLess(error(refined), 0.5 * error(tied))


if __name__ == "__main__":
    unittest.main()
