"""Images to the cube and back. Positions to 1e-9 mm, integrals to 1e-6, round-off to 1e-10."""

import math
import unittest

import numpy

import moserhex
from shapes import affine_of, ellipsoid, oblique_axes, to_other_space

LPS = affine_of(oblique_axes())
RAS = to_other_space(LPS)
LABELS = ellipsoid()
VOXEL = abs(numpy.linalg.det(RAS[:3, :3]))
FLIP = numpy.array([-1.0, -1.0, 1.0])


def places(affine, shape=LABELS.shape):
    """Where the voxels are, [i, j, k, axis]."""
    index = numpy.stack(numpy.meshgrid(*[numpy.arange(n) for n in shape], indexing="ij"), axis=-1)
    return index @ affine[:3, :3].T + affine[:3, 3]


class TransferTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.mesh = moserhex.mesh(LABELS, RAS, shells=4)
        larger = ellipsoid() | numpy.roll(ellipsoid(), 1, axis=0)
        cls.other = moserhex.mesh(larger, RAS, shells=5)


class Positions(TransferTest):
    def test_come_back_to_a_millionth_of_a_micrometre(self):
        cube = numpy.random.default_rng(2).random((3000, 3))
        positions = self.mesh.positions(cube)
        again = self.mesh.positions(self.mesh.cube_coordinates(positions))
        self.assertLess(numpy.abs(again - positions).max(), 1e-9)


class Images(TransferTest):
    def test_of_several_components_are_each_of_them(self):
        values = numpy.stack([places(RAS)[..., 0], LABELS * 3.0], axis=-1)
        means = self.mesh.cell_means(values, RAS)
        samples = self.mesh.node_samples(values, RAS)
        self.assertEqual((means.shape, samples.shape), ((7, 7, 7, 2), (8, 8, 8, 2)))
        for component in range(2):
            alone = self.mesh.cell_means(numpy.asfortranarray(values[..., component]), RAS)
            self.assertTrue(numpy.array_equal(means[..., component], alone))
            alone = self.mesh.node_samples(values[..., component].copy(), RAS)
            self.assertTrue(numpy.array_equal(samples[..., component], alone))

    def test_volumes_of_any_boxes_add_up_to_the_mesh_s(self):
        cells = self.mesh.cell_volumes()
        self.assertEqual(cells.shape, (7, 7, 7))
        self.assertLess(numpy.ptp(cells), 1e-8 * cells.mean())
        for boxes in (1, 5, 20):
            volumes = self.mesh.cell_volumes(boxes=boxes)
            self.assertEqual(volumes.shape, (boxes,) * 3)
            self.assertAlmostEqual(volumes.sum() / cells.sum(), 1.0, 12)
        self.assertAlmostEqual(cells.sum() / self.mesh.quality()["volume_mm3"], 1.0, 12)

    def test_means_over_boxes_have_the_integral_of_the_cells(self):
        values = numpy.sin(0.2 * places(RAS)).sum(axis=-1) + 5.0
        integral = (self.mesh.cell_means(values, RAS, order=24) * self.mesh.cell_volumes()).sum()
        boxes = (self.mesh.cell_means(values, RAS, boxes=12, order=24) * self.mesh.cell_volumes(boxes=12)).sum()
        self.assertLess(abs(boxes / integral - 1.0), 1e-6)

    def test_a_place_comes_back_to_its_voxel(self):
        samples = self.mesh.node_samples(places(RAS), RAS)
        back = self.mesh.grid_samples(samples, RAS, LABELS.shape, sampling="nodes")
        inside = ~numpy.isnan(back).any(axis=-1)
        self.assertTrue((inside == ~numpy.isnan(self.mesh.cube_coordinates(places(RAS).reshape(-1, 3))).any(axis=1).reshape(LABELS.shape)).all())
        self.assertLess(numpy.abs(back - places(RAS))[inside].max(), 1e-9)

    def test_values_go_to_another_subject_s_voxels(self):
        constant = numpy.full(LABELS.shape, 7.5)
        means = self.mesh.cell_means(constant, RAS)
        there = self.other.grid_samples(means, RAS, LABELS.shape, background=-1.0)
        self.assertEqual(set(numpy.unique(there.round(12))), {-1.0, 7.5})

    def test_nearest_keeps_labels(self):
        cube = numpy.zeros((4, 4, 4))
        cube[2:] = 3.0
        labels = self.mesh.grid_samples(cube, RAS, LABELS.shape, interpolation="nearest", background=0.0)
        self.assertEqual(set(numpy.unique(labels)), {0.0, 3.0})

    def test_masses_stay_to_the_last_digits(self):
        density = numpy.exp(0.05 * places(RAS)[..., 1])
        masses = self.mesh.cell_means(density, RAS, order=8) * self.mesh.cell_volumes()
        for mesh in (self.mesh, self.other):
            spread, outside = mesh.grid_masses(masses, RAS, LABELS.shape)
            self.assertEqual(outside.shape, (1,))
            self.assertLess(abs((spread.sum() * VOXEL + outside.sum()) / masses.sum() - 1.0), 1e-12)
        again = self.mesh.cell_means(self.mesh.grid_masses(masses, RAS, LABELS.shape)[0], RAS)
        self.assertEqual(again.shape, masses.shape)

    def test_masses_beyond_the_voxels_are_told(self):
        spread, outside = self.mesh.grid_masses(numpy.ones((7, 7, 7, 2)), RAS, (17, 28, 14))
        self.assertEqual((spread.shape, outside.shape), ((17, 28, 14, 2), (2,)))
        self.assertGreater(outside[0], 100.0)
        self.assertLess(abs(spread[..., 1].sum() * VOXEL + outside[1] - 343.0), 1e-9)


class Rotation(TransferTest):
    VECTOR = numpy.array([1.0, 2.0, -2.0])
    TENSOR = numpy.array([3.0, 0.5, 0.1, 2.0, -0.25, 1.0])

    def test_keeps_lengths_and_comes_back(self):
        vectors = numpy.broadcast_to(self.VECTOR, LABELS.shape + (3,))
        cube = self.mesh.node_samples(vectors, RAS, rotate=True)
        self.assertLess(numpy.abs(numpy.linalg.norm(cube, axis=-1) - 3.0).max(), 1e-12)
        self.assertGreater(numpy.abs(cube - self.VECTOR).max(), 0.5)

    def test_of_the_middle_of_an_ellipsoid_is_that_of_the_lattice(self):
        # There i grows to the patient's left, -x in RAS, as the cube's first axis does.
        vectors = numpy.broadcast_to([-1.0, 0.0, 0.0], LABELS.shape + (3,))
        middle = self.mesh.cell_means(vectors, RAS, rotate=True)[3, 3, 3]
        self.assertGreater(middle[0], 0.9)

    def test_does_not_depend_on_the_space(self):
        in_lps = moserhex.mesh(LABELS, LPS, space="LPS", shells=4)
        for one, other in (
            (self.VECTOR, self.VECTOR * FLIP),
            (self.TENSOR, self.TENSOR * [1.0, 1.0, -1.0, 1.0, -1.0, 1.0]),
        ):
            ras = self.mesh.cell_means(numpy.broadcast_to(one, LABELS.shape + one.shape), RAS, rotate=True)
            lps = in_lps.cell_means(numpy.broadcast_to(other, LABELS.shape + one.shape), LPS, rotate=True)
            self.assertLess(numpy.abs(ras - lps).max(), 1e-12)
            back_ras = self.mesh.grid_samples(ras, RAS, LABELS.shape, rotate=True, background=0.0)
            back_lps = in_lps.grid_samples(lps, LPS, LABELS.shape, rotate=True, background=0.0)
            signs = numpy.where(one != other, -1.0, 1.0)
            self.assertLess(numpy.abs(back_ras - back_lps * signs).max(), 1e-12)
            self.assertLess(numpy.abs(back_ras[17, 14, 7] - one).max(), 0.1 * numpy.abs(one).max())


class Refusals(TransferTest):
    def expect(self, code, call, *arguments, **options):
        with self.assertRaises(moserhex.Error) as caught:
            call(*arguments, **options)
        self.assertEqual(caught.exception.code, code, str(caught.exception))
        self.assertEqual(len(str(caught.exception).splitlines()), 1)

    def test_shapes_and_kinds_of_arrays(self):
        image = LABELS.astype(float)
        self.expect("E_DIMENSION", self.mesh.cell_means, image[0], RAS)
        self.expect("E_DIMENSION", self.mesh.cell_means, image[None, None], RAS)
        self.expect("E_PIXELTYPE", self.mesh.cell_means, numpy.zeros((2, 2, 2, 4097)), RAS)
        self.expect("E_PIXELTYPE", self.mesh.cell_means, image[..., None][..., [0, 0]], RAS, rotate=True)
        self.expect("E_DIMENSION", self.mesh.grid_samples, numpy.zeros((3, 3, 4)), RAS, (5, 5, 5))
        self.expect("E_DIMENSION", self.mesh.grid_masses, numpy.zeros((3, 3)), RAS, (5, 5, 5))
        self.expect("E_DIMENSION", self.mesh.grid_samples, numpy.zeros((3, 3, 3)), RAS, (5, 5))
        self.expect("E_DIMENSION", self.mesh.grid_samples, numpy.zeros((3, 3, 3)), RAS, (5, -5, 5))
        self.expect("E_EMPTY", self.mesh.grid_samples, numpy.zeros((3, 3, 3)), RAS, (5, 0, 5))
        self.expect("E_GEOMETRY", self.mesh.grid_samples, numpy.zeros((3, 3, 3)), numpy.zeros((4, 4)), (5, 5, 5))

    def test_words_and_numbers(self):
        cube = numpy.zeros((3, 3, 3))
        self.expect("E_USAGE", self.mesh.grid_samples, cube, RAS, (5, 5, 5), sampling="cell")
        self.expect("E_USAGE", self.mesh.grid_samples, cube, RAS, (5, 5, 5), interpolation="cubic")
        self.expect("E_USAGE", self.mesh.cell_volumes, threads=-1)
        for boxes in (-1, 1001):
            self.expect("E_PRECONDITION", self.mesh.cell_volumes, boxes=boxes)

    def test_padding(self):
        padded = moserhex.mesh(LABELS, RAS, shells=3, padding=1)
        self.expect("E_PRECONDITION", padded.cell_volumes)
        self.expect("E_PRECONDITION", padded.grid_samples, numpy.zeros((3, 3, 3)), RAS, (5, 5, 5))
        self.assertTrue(math.isfinite(padded.quality()["volume_variance"]))


if __name__ == "__main__":
    unittest.main()
