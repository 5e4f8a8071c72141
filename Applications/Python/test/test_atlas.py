"""Statistics over shapes with known answers. Round-off: 1e-9; comparisons with numpy's own decomposition to 1e-8."""

import os
import signal
import threading
import time
import unittest

import numpy

import moserhex
from shapes import affine_of, ellipsoid, oblique_axes, to_other_space

RAS = to_other_space(affine_of(oblique_axes()))
LABELS = ellipsoid()


def expect(test, code, call, *arguments, **options):
    with test.assertRaises(moserhex.Error) as caught:
        call(*arguments, **options)
    test.assertEqual(caught.exception.code, code, str(caught.exception))


def turn(angle):
    c, s = numpy.cos(angle), numpy.sin(angle)
    return numpy.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


class Alignment(unittest.TestCase):
    def setUp(self):
        random = numpy.random.default_rng(3)
        self.shape = random.normal(size=(40, 3)) * [10.0, 7.0, 4.0]
        self.shapes = numpy.stack([self.shape @ turn(a).T + [5.0 * a, -a, 2.0] for a in (-0.3, -0.1, 0.1, 0.3)])

    def test_of_one_shape_in_four_places_is_exact(self):
        result = moserhex.procrustes(self.shapes)
        self.assertTrue(result.converged)
        self.assertLess(numpy.abs(result.aligned - result.mean).max(), 1e-9)
        self.assertLess(result.deviation, 1e-9)
        for shape, matrix, aligned in zip(self.shapes, result.matrices, result.aligned):
            self.assertLess(numpy.abs(shape @ matrix[:3, :3].T + matrix[:3, 3] - aligned).max(), 1e-12)

    def test_with_sizes_makes_them_equal(self):
        scaled = self.shapes * numpy.array([0.8, 1.0, 1.1, 1.3])[:, None, None]
        self.assertGreater(moserhex.procrustes(scaled).deviation, 1.0)
        result = moserhex.procrustes(scaled, align="similarity")
        self.assertLess(result.deviation, 1e-9)
        centred = scaled - scaled.mean(axis=1, keepdims=True)
        self.assertAlmostEqual(result.size, numpy.sqrt((centred**2).sum(axis=(1, 2))).mean(), 9)

    def test_of_none_is_the_plain_mean(self):
        result = moserhex.procrustes(self.shapes, align="none", threads=1)
        self.assertLess(numpy.abs(result.mean - self.shapes.mean(axis=0)).max(), 1e-12)
        self.assertTrue(numpy.array_equal(result.matrices, numpy.broadcast_to(numpy.eye(4), (4, 4, 4))))

    def test_refusals(self):
        expect(self, "E_DIMENSION", moserhex.procrustes, self.shape)
        expect(self, "E_DIMENSION", moserhex.procrustes, self.shapes[..., :2])
        expect(self, "E_DIMENSION", moserhex.procrustes, [])
        expect(self, "E_USAGE", moserhex.procrustes, self.shapes, align="affine")
        expect(self, "E_PRECONDITION", moserhex.procrustes, self.shapes, tolerance=-1.0)
        line = numpy.zeros((3, 5, 3))
        line[..., 0] = numpy.arange(5)
        expect(self, "E_PRECONDITION", moserhex.procrustes, line)


class Meshes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        wide = LABELS | numpy.roll(LABELS, 1, axis=0)
        long = LABELS | numpy.roll(LABELS, 1, axis=2)
        cls.meshes = [moserhex.mesh(labels, RAS, shells=3) for labels in (LABELS, wide, long)]

    def test_mean_is_exact_and_near_the_nodes_mean(self):
        mean = moserhex.mean_mesh(self.meshes)
        self.assertEqual((mean.nodes_per_side, mean.space, mean.warnings), (6, "RAS", []))
        self.assertLess(mean.quality()["volume_variance"], 1e-18)
        nodes = moserhex.procrustes(self.meshes).mean
        self.assertLess(numpy.sqrt(((mean.points - nodes) ** 2).sum(axis=1).mean()), 0.5)

    def test_of_two_spaces_are_taken_in_that_of_the_first(self):
        lps = moserhex.mesh(LABELS, to_other_space(RAS), space="LPS", shells=3)
        mixed = moserhex.procrustes([self.meshes[0], lps], align="none")
        self.assertLess(mixed.deviation, 1e-9)

    def test_of_other_nodes_are_refused(self):
        other = moserhex.mesh(LABELS, RAS, shells=4)
        expect(self, "E_PRECONDITION", moserhex.procrustes, [self.meshes[0], other])
        expect(self, "E_PRECONDITION", moserhex.mean_mesh, [self.meshes[0], other])

    def test_progress_that_returns_false_ends_the_mean(self):
        expect(self, "E_CANCELLED", moserhex.mean_mesh, self.meshes, progress=lambda _: False)


class Model(unittest.TestCase):
    def setUp(self):
        random = numpy.random.default_rng(5)
        self.shapes = random.normal(size=(12, 30, 3)) * numpy.linspace(1.0, 3.0, 30)[:, None]

    def test_is_numpy_s_decomposition(self):
        model = moserhex.fit_shapes(self.shapes)
        rows = self.shapes.reshape(12, -1) - self.shapes.reshape(12, -1).mean(axis=0)
        _, singular, modes = numpy.linalg.svd(rows, full_matrices=False)
        self.assertEqual((model.modes.shape, model.scores.shape), ((11, 30, 3), (12, 11)))
        self.assertLess(numpy.abs(model.variances - singular[:11] ** 2 / 11).max(), 1e-8)
        self.assertAlmostEqual(model.total_variance, (rows**2).sum() / 11, 8)
        products = numpy.abs((model.modes.reshape(11, -1) * modes[:11]).sum(axis=1))
        self.assertLess(numpy.abs(products - 1.0).max(), 1e-8)

    def test_all_modes_give_the_subjects_back(self):
        model = moserhex.fit_shapes(self.shapes)
        for shape, scores in zip(self.shapes, model.scores):
            self.assertLess(numpy.abs(model.reconstruct(scores) - shape).max(), 1e-9)
            self.assertLess(numpy.abs(model.scores_of(shape) - scores).max(), 1e-9)

    def test_few_modes_are_kept(self):
        self.assertEqual(moserhex.fit_shapes(self.shapes, modes=2).modes.shape, (2, 30, 3))
        half = moserhex.fit_shapes(self.shapes, variance=0.5)
        self.assertGreaterEqual(half.variances.sum(), 0.5 * half.total_variance)
        self.assertLess(half.variances[:-1].sum(), 0.5 * half.total_variance)
        one = half.reconstruct([2.0])
        self.assertLess(numpy.abs(one - half.mean - 2.0 * half.modes[0]).max(), 1e-12)

    def test_refusals(self):
        model = moserhex.fit_shapes(self.shapes)
        expect(self, "E_PRECONDITION", moserhex.fit_shapes, self.shapes[:1])
        expect(self, "E_PRECONDITION", moserhex.fit_shapes, self.shapes, variance=1.5)
        expect(self, "E_USAGE", moserhex.fit_shapes, self.shapes, modes=0)
        expect(self, "E_PRECONDITION", model.reconstruct, numpy.zeros(12))
        expect(self, "E_PRECONDITION", model.scores_of, numpy.zeros((29, 3)))
        expect(self, "E_DIMENSION", model.scores_of, numpy.zeros((3, 30)))


class Test(unittest.TestCase):
    def setUp(self):
        random = numpy.random.default_rng(7)
        self.groups = numpy.array([0] * 6 + [1] * 6)
        self.values = random.normal(size=(12, 50))
        self.values[6:, 10] += 6.0

    def test_finds_the_place_that_differs(self):
        test = moserhex.permutation_test(self.values, self.groups)
        self.assertEqual((test.permutations, test.is_exact, test.degrees_of_freedom), (924, True, 10))
        self.assertAlmostEqual(test.smallest_possible_p, 2 / 924)  # the groups that change places
        self.assertEqual(test.nuisance_left_out, [])
        self.assertLess(test.p_family_wise[10], 0.01)
        self.assertAlmostEqual(test.p[10], 2 / 924, 12)  # the groups as they are, and with their names changed
        self.assertAlmostEqual(test.q_false_discovery[10], 50 * 2 / 924, 12)
        self.assertGreater(numpy.delete(test.p_family_wise, 10).min(), 0.05)
        difference = self.values[6:].mean(axis=0) - self.values[:6].mean(axis=0)
        self.assertLess(numpy.abs(test.slope[:, 0] - difference).max(), 1e-9)
        pooled = numpy.sqrt((self.values[:6].var(axis=0, ddof=1) + self.values[6:].var(axis=0, ddof=1)) / 2)
        self.assertLess(numpy.abs(test.statistic - (difference / pooled) ** 2 * 3).max(), 1e-6)
        self.assertLess(numpy.abs(test.standardised_difference - difference / pooled).max(), 1e-6)

    def test_of_vectors_and_a_covariate(self):
        values = numpy.stack([self.values] * 3, axis=-1) + numpy.random.default_rng(1).normal(size=(12, 50, 3))
        age = numpy.linspace(50.0, 70.0, 12)
        test = moserhex.permutation_test(values, age, nuisance=self.groups[:, None], permutations=200, seed=4)
        self.assertEqual(test.slope.shape, (50, 3))
        self.assertIsNone(test.standardised_difference)
        self.assertEqual(test.permutations, 201)  # the subjects' own order, too
        again = moserhex.permutation_test(
            values, age, nuisance=self.groups[:, None], permutations=200, seed=4, threads=1
        )
        self.assertTrue(numpy.array_equal(test.p, again.p))

    def test_missing_groups_are_refused(self):
        for missing in (None, float("nan"), "", "NA", "n/a"):
            groups = ["a", "b", missing, "a"] if isinstance(missing, str) else [0, 1, missing, 0]
            with self.subTest(missing), self.assertRaises(moserhex.Error) as caught:
                moserhex.group_columns(groups)
            self.assertEqual(caught.exception.code, "E_PRECONDITION")
            self.assertIn("subject 2", str(caught.exception))

    def test_three_groups_are_tested_together(self):
        groups = [0, 1, 2] * 4
        columns = moserhex.group_columns(groups)
        self.assertTrue(numpy.array_equal(columns, [[g == 1, g == 2] for g in groups]))
        test = moserhex.permutation_test(self.values, columns, permutations=100)
        means = numpy.stack([self.values[g::3].mean(axis=0) for g in range(3)])
        self.assertEqual(test.slope.shape, (50, 2, 1))
        self.assertLess(numpy.abs(test.slope[:, :, 0] - (means[1:] - means[0]).T).max(), 1e-9)
        between = (4 * (means - self.values.mean(axis=0)) ** 2).sum(axis=0)
        total = ((self.values - self.values.mean(axis=0)) ** 2).sum(axis=0)
        self.assertLess(numpy.abs(test.pillai_trace - between / total).max(), 1e-9)
        self.assertIsNone(test.standardised_difference)
        words = moserhex.group_columns(["c", "a", "b"])
        self.assertTrue(numpy.array_equal(words, [[0, 1], [0, 0], [1, 0]]))
        expect(self, "E_PRECONDITION", moserhex.group_columns, [0, 0])
        expect(self, "E_DIMENSION", moserhex.group_columns, [[0, 1]])

    def test_refusals(self):
        expect(self, "E_PRECONDITION", moserhex.permutation_test, self.values, self.groups[:5])
        expect(self, "E_PRECONDITION", moserhex.permutation_test, self.values, numpy.zeros(12))
        expect(self, "E_USAGE", moserhex.permutation_test, self.values, self.groups, permutations=0)
        expect(self, "E_DIMENSION", moserhex.permutation_test, self.values[0], self.groups)
        expect(self, "E_DIMENSION", moserhex.permutation_test, self.values, 3)

    def test_ctrl_c_ends_a_long_one(self):
        values = numpy.random.default_rng(2).normal(size=(40, 60000))
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        begin = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            moserhex.permutation_test(values, numpy.arange(40) % 2, permutations=20000, threads=1)
        timer.join()
        self.assertLess(time.monotonic() - begin, 60.0)


if __name__ == "__main__":
    unittest.main()
