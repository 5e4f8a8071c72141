"""Every refusal by its code, one line each."""

import math
import pickle
import unittest

import numpy

import moserhex
from shapes import FolderTest, affine_of, ellipsoid

LABELS = ellipsoid()
AFFINE = affine_of()


class Errors(FolderTest):
    def expect(self, code, call, *arguments, text="", **options):
        with self.assertRaises(moserhex.Error) as caught:
            call(*arguments, **options)
        message = str(caught.exception)
        self.assertEqual(caught.exception.code, code, message)
        self.assertIn(text, message)
        self.assertEqual(len(message.splitlines()), 1)
        self.assertNotIn("--", message)

    def refuse(self, code, labels=LABELS, affine=AFFINE, **options):
        self.expect(code, moserhex.mesh, labels, affine, **options)

    def test_geometry(self):
        sheared = AFFINE.copy()
        sheared[0, 1] += 0.3
        self.refuse("E_GEOMETRY", affine=sheared, text="labels: the image axes are not at right angles")
        singular = AFFINE.copy()
        singular[:3, 2] = singular[:3, 1]
        flat = AFFINE.copy()
        flat[:3, 2] = 0.0
        huge = AFFINE * 1e6
        huge[3, 3] = 1.0
        for affine in (singular, flat, huge, numpy.full((4, 4), math.nan), AFFINE + math.inf, AFFINE[:3], AFFINE.T):
            self.refuse("E_GEOMETRY", affine=affine)
        for affine in (None, "affine", [[1, 2], [3]], numpy.eye(3), numpy.eye(4)[None], 7):
            self.refuse("E_GEOMETRY", affine=affine, text="4 x 4")
        projective = AFFINE.copy()
        projective[3, 0] = 1e-3
        self.refuse("E_GEOMETRY", affine=projective, text="last row")

    def test_shapes(self):
        for labels in (LABELS[0], LABELS[None], numpy.uint8(1), []):
            self.refuse("E_DIMENSION", labels=labels)
        self.refuse("E_EMPTY", labels=numpy.zeros((4, 0, 4), "u1"))
        self.refuse("E_TOO_BIG", labels=numpy.broadcast_to(numpy.uint8(1), (2000, 2000, 2000)))

    def test_types(self):
        for labels in (LABELS.astype(complex), LABELS.astype(str), LABELS.astype(object), None, "labels", object()):
            self.refuse("E_PIXELTYPE", labels=labels)
        self.refuse("E_PIXELTYPE", labels=LABELS.astype(numpy.longdouble))

    def test_labels(self):
        for value in (-1.0, 0.5, math.nan, math.inf, 2.0**31):
            labels = LABELS.astype(float)
            labels[3, 4, 5] = value
            self.refuse("E_LABELS", labels=labels, text="labels: voxel (3, 4, 5) holds")
        self.refuse("E_LABELS", labels=-LABELS.astype("i2"))
        for label in (2, -1, 2**40):
            self.refuse("E_LABELS", label=label)
        self.refuse("E_EMPTY_LABEL", labels=0 * LABELS)
        many = LABELS.copy()
        many[0, 0, :13] = numpy.arange(2, 15)
        many[0, 1, :13] = numpy.arange(15, 28)
        self.refuse("E_LABELS", labels=many, text="choose one with label")

    def test_topology(self):
        two = numpy.concatenate([LABELS, LABELS], axis=0)
        self.refuse("E_TOPOLOGY", labels=two, max_repair=0.01, text="raise max_repair")
        self.refuse("E_TOPOLOGY", labels=two, topology="reject", text="topology='repair'")

    def test_thin(self):
        thin = numpy.zeros((5, 5, 5), "u1")
        thin[2, 2, 2] = 1
        self.refuse("E_THIN", labels=thin)

    def test_densities(self):
        density = LABELS.astype(float)
        density[17, 14, 7] = math.nan
        self.refuse("E_DENSITY", density=density)
        self.refuse("E_DENSITY", density=(density[:8], AFFINE), text="density")
        self.refuse("E_USAGE", density=density, stage="moser", text="density needs stage='exact'")

    def test_usage(self):
        for options in (
            {"space": "ras"},
            {"stage": "last"},
            {"way": "slow"},
            {"frame": "x"},
            {"align": "none"},
            {"topology": "ignore"},
            {"shell_method": "x"},
            {"shells": 1},
            {"shells": 65},
            {"max_repair": -1.0},
            {"max_repair": math.nan},
            {"threads": -1},
            {"threads": 5000},
            {"stage": "moser", "way": "faithful"},
        ):
            with self.subTest(options=options):
                self.refuse("E_USAGE", **options)

    def test_arguments_of_a_wrong_kind_are_type_errors(self):
        for options in ({"label": "one"}, {"shells": 3.5}, {"progress": 3}, {"unknown": 1}):
            with self.subTest(options=options):
                with self.assertRaises(TypeError):
                    moserhex.mesh(LABELS, AFFINE, **options)
        with self.assertRaises(TypeError):
            moserhex.mesh(LABELS, AFFINE, 1)

    def test_files(self):
        self.expect("E_NOINPUT", moserhex.read, self.folder / "none.vtu")
        (self.folder / "bad.vtk").write_text("not a mesh")
        self.expect("E_NOT_HEXAHEDRA", moserhex.read, self.folder / "bad.vtk")
        self.expect("E_USAGE", moserhex.read, self.folder / "none.vtu", space="x")
        mesh = moserhex.mesh(LABELS, AFFINE, shells=2, stage="initial")
        self.expect("E_USAGE", mesh.write, self.folder / "mesh.png")
        self.expect("E_CANTCREAT", mesh.write, self.folder / "none" / "mesh.vtu")
        with self.assertRaises(TypeError):
            mesh.write(7)

    def test_points_and_values(self):
        mesh = moserhex.mesh(LABELS, AFFINE, shells=2, stage="initial")
        for points in ([1.0, 2.0, 3.0], numpy.zeros((3, 2)), numpy.zeros((2, 2, 3))):
            self.expect("E_DIMENSION", mesh.cube_coordinates, points)
        self.expect("E_PIXELTYPE", mesh.cube_coordinates, [["a", "b", "c"]])
        self.expect("E_PRECONDITION", mesh.positions, [[0.5, 0.5, 1.5]])
        self.expect("E_DIMENSION", mesh.cell_means, LABELS[0], AFFINE)
        self.expect("E_GEOMETRY", mesh.cell_means, LABELS, AFFINE[:3])
        self.expect("E_PRECONDITION", mesh.cell_means, LABELS, AFFINE, order=1)
        self.expect("E_USAGE", mesh.node_samples, LABELS, AFFINE, interpolation="cubic")

    def test_an_error_is_a_runtime_error_and_can_be_sent_to_another_process(self):
        try:
            moserhex.mesh(LABELS, AFFINE, space="x")
        except RuntimeError as error:
            copy = pickle.loads(pickle.dumps(error))
            self.assertEqual((str(copy), copy.code), (str(error), "E_USAGE"))


if __name__ == "__main__":
    unittest.main()
