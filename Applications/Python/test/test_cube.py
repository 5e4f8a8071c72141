"""Cube coordinates and back; images on the cells. Round-off: 1e-10; comparisons of spaces and threads: to the last bit."""

import math
import unittest

import numpy

import moserhex
from shapes import affine_of, ellipsoid, oblique_axes, to_other_space

LPS = affine_of(oblique_axes())
RAS = to_other_space(LPS)
LABELS = ellipsoid()


def volumes_and_centroids(mesh):
    """Of every cell, by 3 x 3 x 3 Gauss points: exact for a linear function times det J."""
    t = math.sqrt(0.6)
    points = [(0.5 - 0.5 * t, 5 / 18), (0.5, 8 / 18), (0.5 + 0.5 * t, 5 / 18)]
    x = mesh.points[mesh.cells]
    signs = numpy.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
    volumes = numpy.zeros(len(x))
    moments = numpy.zeros((len(x), 3))
    for u, wu in points:
        for v, wv in points:
            for w, ww in points:
                xi = numpy.array([u, v, w])
                factors = numpy.where(signs == 1, xi, 1 - xi)
                slopes = numpy.where(signs == 1, 1.0, -1.0)
                shape = factors.prod(axis=1)
                gradient = numpy.stack(
                    [slopes[:, a] * numpy.delete(factors, a, axis=1).prod(axis=1) for a in range(3)], axis=1
                )
                jacobian = numpy.linalg.det(numpy.einsum("cap,ag->cpg", x, gradient)) * wu * wv * ww
                volumes += jacobian
                moments += jacobian[:, None] * numpy.einsum("cap,a->cp", x, shape)
    return volumes, moments / volumes[:, None]


class CubeCoordinates(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.mesh = moserhex.mesh(LABELS, RAS, shells=5)
        cls.cube = numpy.random.default_rng(1).random((2000, 3))

    def test_there_and_back(self):
        positions = self.mesh.positions(self.cube)
        self.assertLess(numpy.abs(self.mesh.cube_coordinates(positions) - self.cube).max(), 1e-10)

    def test_nodes_are_at_the_lattice_s_places(self):
        n = self.mesh.nodes_per_side
        numbers = numpy.arange(n**3)
        index = numpy.stack([numbers % n, numbers // n % n, numbers // n**2], axis=1)
        self.assertLess(numpy.abs(self.mesh.cube_coordinates(self.mesh.points) - index / (n - 1)).max(), 1e-10)
        self.assertLess(numpy.abs(self.mesh.positions(index / (n - 1)) - self.mesh.points).max(), 1e-10)

    def test_points_outside_are_nan(self):
        points = numpy.array([[0.0, 0.0, 0.0], [math.nan, 1.0, 2.0], [math.inf, 0.0, 0.0], self.mesh.points[555]])
        found = self.mesh.cube_coordinates(points)
        self.assertTrue(numpy.isnan(found[:3]).all())
        self.assertFalse(numpy.isnan(found[3]).any())
        self.assertTrue(numpy.isnan(self.mesh.positions(found[:3])).all())

    def test_the_voxels_inside_have_the_mesh_s_volume(self):
        index = numpy.stack(numpy.meshgrid(*[numpy.arange(n) for n in LABELS.shape], indexing="ij"), -1).reshape(-1, 3)
        centres = index @ RAS[:3, :3].T + RAS[:3, 3]
        inside = ~numpy.isnan(self.mesh.cube_coordinates(centres)).any(axis=1)
        agreement = (inside == LABELS.reshape(-1).astype(bool)).mean()
        self.assertGreater(agreement, 0.97)

    def test_spaces_agree(self):
        other = moserhex.mesh(LABELS, LPS, space="LPS", shells=5)
        flip = numpy.array([-1.0, -1.0, 1.0])
        positions = self.mesh.positions(self.cube)
        self.assertTrue(numpy.array_equal(other.positions(self.cube), positions * flip))
        found = self.mesh.cube_coordinates(positions)
        self.assertTrue(numpy.array_equal(other.cube_coordinates(positions * flip), found))

    def test_any_number_of_threads(self):
        points = self.mesh.positions(self.cube)
        one = self.mesh.cube_coordinates(points, threads=1)
        self.assertTrue(numpy.array_equal(one, self.mesh.cube_coordinates(points, threads=3)))

    def test_types_strides_and_no_points(self):
        points = self.mesh.positions(self.cube)
        expected = self.mesh.cube_coordinates(points)
        self.assertTrue(numpy.array_equal(self.mesh.cube_coordinates(numpy.asfortranarray(points)), expected))
        self.assertTrue(numpy.array_equal(self.mesh.cube_coordinates(points[::-1])[::-1], expected))
        self.assertEqual(self.mesh.cube_coordinates(numpy.zeros((0, 3))).shape, (0, 3))
        self.assertEqual(self.mesh.cube_coordinates([[0, 0, 0]]).shape, (1, 3))


class CellMeans(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.mesh = moserhex.mesh(LABELS, RAS, shells=5)
        index = numpy.stack(numpy.meshgrid(*[numpy.arange(n) for n in LABELS.shape], indexing="ij"), axis=-1)
        cls.slope = numpy.array([0.3, -1.5, 0.8])
        cls.ramp = (index @ RAS[:3, :3].T + RAS[:3, 3]) @ cls.slope + 4.0

    def test_of_a_ramp_are_its_values_at_the_centroids(self):
        _, centroids = volumes_and_centroids(self.mesh)
        means = self.mesh.cell_means(self.ramp, RAS)
        self.assertEqual(means.shape, (9, 9, 9))
        expected = (centroids @ self.slope + 4.0).reshape(9, 9, 9).transpose(2, 1, 0)
        self.assertLess(numpy.abs(means - expected).max(), 1e-10)

    def test_of_equal_cells_average_to_the_mean_over_the_mesh(self):
        volumes, centroids = volumes_and_centroids(self.mesh)
        mean = (volumes * (centroids @ self.slope + 4.0)).sum() / volumes.sum()
        self.assertAlmostEqual(self.mesh.cell_means(self.ramp, RAS, order=2).mean(), mean, 9)

    def test_samples_at_nodes_are_the_ramp_there(self):
        samples = self.mesh.node_samples(self.ramp, RAS)
        expected = (self.mesh.points @ self.slope + 4.0).reshape(10, 10, 10).transpose(2, 1, 0)
        self.assertLess(numpy.abs(samples - expected).max(), 1e-10)

    def test_spaces_and_threads_agree(self):
        other = moserhex.mesh(LABELS, LPS, space="LPS", shells=5)
        means = self.mesh.cell_means(self.ramp, RAS, threads=1)
        self.assertTrue(numpy.array_equal(means, other.cell_means(self.ramp, LPS, threads=3)))

    def test_of_labels_are_shares(self):
        shares = self.mesh.cell_means(LABELS, RAS, interpolation="nearest")
        self.assertTrue(((0.0 <= shares) & (shares <= 1.0)).all())
        self.assertTrue((shares[3:6, 3:6, 3:6] == 1.0).all())

    def test_beyond_the_image_there_is_nothing_or_what_was_said(self):
        half = self.ramp[:17]
        means = self.mesh.cell_means(half, RAS)
        self.assertTrue(numpy.isnan(means).any())
        self.assertFalse(numpy.isnan(means).all())
        self.assertFalse(numpy.isnan(self.mesh.cell_means(half, RAS, outside=0.0)).any())

    def test_values_of_any_type(self):
        whole = self.ramp.round()
        expected = self.mesh.cell_means(whole, RAS)
        for name in ("f4", "i2", ">i4"):
            self.assertTrue(numpy.array_equal(self.mesh.cell_means(whole.astype(name), RAS), expected))


class Padding(unittest.TestCase):
    def test_layers_surround_the_lattice_and_the_cube_s_functions_refuse_them(self):
        mesh = moserhex.mesh(LABELS, RAS, shells=3, padding=1)
        self.assertEqual((mesh.nodes_per_side, mesh.padding_layers), (6, 1))
        self.assertEqual(len(mesh.points), 6**3 + 6**3 - 4**3)
        self.assertEqual(len(mesh.cells), 5**3 + 6 * 5**2)
        self.assertGreater(mesh.quality()["scaled_jacobian"]["min"], 0.3)
        volumes, _ = volumes_and_centroids(mesh)
        self.assertLess(numpy.ptp(volumes), 1e-9 * volumes.mean())
        with self.assertRaises(moserhex.Error):
            mesh.cube_coordinates(mesh.points[:1])
        with self.assertRaises(moserhex.Error):
            moserhex.mesh(LABELS, RAS, padding=9)



if __name__ == "__main__":
    unittest.main()
