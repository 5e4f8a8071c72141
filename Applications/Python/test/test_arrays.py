"""Arrays in, of every kind, and arrays out, whose memory is their own."""

import gc
import unittest

import numpy

import moserhex
from shapes import affine_of, ellipsoid, oblique_axes, to_other_space

RAS = to_other_space(affine_of(oblique_axes()))
LABELS = ellipsoid()


def points_of(labels, affine=RAS, **options):
    return moserhex.mesh(labels, affine, shells=3, **options).points


class LabelArrays(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.expected = points_of(LABELS)

    def expect_same(self, labels, affine=RAS, **options):
        self.assertTrue(numpy.array_equal(points_of(labels, affine, **options), self.expected))

    def test_every_type_of_number(self):
        for name in ("bool", "i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f2", "f4", "f8"):
            with self.subTest(type=name):
                self.expect_same(LABELS.astype(name))

    def test_both_byte_orders(self):
        for name in (">i2", "<i2", ">u4", ">f8", "<f4"):
            with self.subTest(type=name):
                self.expect_same(LABELS.astype(name))

    def test_every_order_in_memory(self):
        self.expect_same(numpy.ascontiguousarray(LABELS))
        self.expect_same(numpy.asfortranarray(LABELS))
        for axes in ((0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)):
            with self.subTest(axes=axes):
                copy = numpy.ascontiguousarray(LABELS.transpose(axes))
                self.expect_same(copy.transpose(numpy.argsort(axes)))

    def test_strides_that_are_negative_zero_or_large(self):
        self.expect_same(LABELS[::-1, ::-1, ::-1].copy()[::-1, ::-1, ::-1])
        spread = numpy.zeros([2 * n + 1 for n in LABELS.shape], "i4")
        spread[1::2, 1::2, 1::2] = LABELS
        self.expect_same(spread[1::2, 1::2, 1::2])
        fields = numpy.zeros(LABELS.shape, [("odd", "u1"), ("label", "i4")])
        fields["label"] = LABELS
        self.expect_same(fields["label"])
        box = numpy.zeros((1, 1, LABELS.shape[2]), "u1")
        box[:, :, 4:10] = 1
        repeated = numpy.broadcast_to(box, (20, 20, LABELS.shape[2]))
        self.assertTrue(numpy.array_equal(points_of(repeated), points_of(repeated.copy())))

    def test_read_only_arrays_lists_and_memory_of_others(self):
        frozen = LABELS.copy()
        frozen.flags.writeable = False
        self.expect_same(frozen)
        self.expect_same(LABELS.tolist())
        self.expect_same(memoryview(LABELS))

    def test_labels_are_not_changed(self):
        labels = LABELS.copy()
        points_of(labels)
        self.assertTrue(numpy.array_equal(labels, LABELS))

    def test_one_label_of_several(self):
        several = LABELS.astype("i2") * 7
        several[0, 0, 0] = 3
        self.expect_same(several, label=7)
        self.expect_same(several, label=numpy.int64(7))

    def test_affines_of_other_types(self):
        self.expect_same(LABELS, RAS.tolist())
        self.expect_same(LABELS, numpy.asfortranarray(RAS))
        self.expect_same(LABELS, RAS.astype(object))

    def test_left_handed_voxels_are_the_same_solid_in_the_same_place(self):
        flipped = RAS.copy()
        flipped[:3, 3] += RAS[:3, 0] * (LABELS.shape[0] - 1)
        flipped[:3, 0] *= -1
        points = points_of(LABELS[::-1], flipped)
        self.assertLess(numpy.abs(points.mean(axis=0) - self.expected.mean(axis=0)).max(), 0.1)
        self.assertLess(numpy.abs(numpy.ptp(points, axis=0) - numpy.ptp(self.expected, axis=0)).max(), 1.0)


class ArraysOut(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.mesh = moserhex.mesh(LABELS, RAS, shells=3)

    def test_types_and_shapes(self):
        mesh = self.mesh
        self.assertEqual((mesh.points.shape, mesh.points.dtype), ((216, 3), numpy.float64))
        self.assertEqual((mesh.cells.shape, mesh.cells.dtype), ((125, 8), numpy.int64))
        self.assertEqual(mesh.nodes_per_side, 6)
        self.assertTrue(mesh.points.flags.c_contiguous and mesh.cells.flags.c_contiguous)

    def test_the_first_cell_in_vtk_s_order(self):
        self.assertEqual(self.mesh.cells[0].tolist(), [0, 1, 7, 6, 36, 37, 43, 42])

    def test_arrays_outlive_the_mesh(self):
        mesh = moserhex.mesh(LABELS, RAS, shells=3)
        values = numpy.ones((3, 3, 3))
        arrays = [
            mesh.points,
            mesh.cells,
            mesh.points[::2, 1],
            mesh.cell_means(values, affine_of(), outside=2.0),
            mesh.node_samples(values, affine_of(), outside=2.0),
            mesh.cube_coordinates(mesh.points),
        ]
        copies = [array.copy() for array in arrays]
        del mesh
        gc.collect()
        others = [numpy.full(100000, 7.0) for _ in range(20)]  # takes memory that was given back
        for array, copy in zip(arrays, copies):
            self.assertTrue(numpy.array_equal(array, copy))
        del others

    def test_points_and_cells_are_read_only_and_always_the_same(self):
        for array in (self.mesh.points, self.mesh.cells):
            with self.assertRaises(ValueError):
                array[0, 0] = 1
        self.assertIs(self.mesh.points, self.mesh.points)
        self.assertIs(self.mesh.cells, self.mesh.cells)

    def test_meshes_leave_no_memory_behind(self):
        import resource

        self.mesh.cube_coordinates(self.mesh.points)
        points = numpy.zeros((200000, 3))
        before = None
        for turn in range(40):
            self.mesh.cube_coordinates(points)
            self.mesh.cell_means(numpy.ones((60, 60, 60)), numpy.eye(4))
            if turn == 10:
                before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        self.assertLess(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before, 20000)  # kB


if __name__ == "__main__":
    unittest.main()
