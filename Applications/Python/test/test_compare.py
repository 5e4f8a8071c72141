"""Two meshes: templates, deformation of known size. Closed forms to 1e-9, comparisons of spaces to round-off."""

import unittest

import numpy

import moserhex
from shapes import FolderTest, affine_of, ellipsoid, oblique_axes, to_other_space, write_nrrd

LPS = affine_of(oblique_axes())
RAS = to_other_space(LPS)
LABELS = ellipsoid()
FLIP = numpy.diag([-1.0, -1.0, 1.0])


def moved(mesh, matrix, folder):
    """The same lattice under x -> matrix x, by a file."""
    mesh.write(folder / "before.vtk")
    text = (folder / "before.vtk").read_bytes()
    points = numpy.ascontiguousarray(mesh.points * [-1.0, -1.0, 1.0], ">f8").tobytes()
    at = text.index(points)
    changed = numpy.ascontiguousarray((mesh.points @ matrix.T) * [-1.0, -1.0, 1.0], ">f8").tobytes()
    (folder / "after.vtk").write_bytes(text[:at] + changed + text[at + len(points) :])
    return moserhex.read(folder / "after.vtk")


class Deformation(FolderTest):
    @classmethod
    def setUpClass(cls):
        cls.mesh = moserhex.mesh(LABELS, RAS, shells=3)

    def test_of_a_mesh_with_itself_is_none(self):
        comparison = moserhex.compare(self.mesh, self.mesh)
        self.assertEqual(comparison.displacement.shape, (216, 3))
        self.assertEqual(comparison.strain.shape, (125, 3, 3))
        self.assertLess(numpy.abs(comparison.displacement).max(), 1e-10)
        self.assertLess(numpy.abs(comparison.strain).max(), 1e-12)
        self.assertLess(numpy.abs(comparison.alignment - numpy.eye(4)).max(), 1e-10)

    def test_has_the_surface_and_what_makes_it_doubtful(self):
        shift = numpy.array([0.0, 0.0, 100.0])
        self.mesh.write(self.folder / "a.vtu")
        same = moserhex.compare(moserhex.read(self.folder / "a.vtu"), self.mesh, align="none")
        self.assertEqual(same.warnings, ())
        self.assertEqual(same.surface_nodes.shape, (152,))  # 6^3 less 4^3
        for values in (same.normal_motion, same.signed_distance, same.baseline_signed_distance):
            self.assertLess(numpy.abs(values).max(), 1e-9)
        self.assertEqual(same.thickness_change.shape, (216, 3))
        far = moserhex.mesh(LABELS, RAS + numpy.outer([*shift, 0.0], [0, 0, 0, 1]), shells=3)
        self.assertEqual(len(moserhex.compare(self.mesh, far).warnings), 0)
        warnings = moserhex.compare(self.mesh, far, align="none").warnings
        self.assertEqual(len(warnings), 1, warnings)
        self.assertIn("from the baseline's (median)", warnings[0])
        inexact = moserhex.mesh(LABELS, RAS, shells=3, stage="moser")
        self.assertIn("was not made exact", moserhex.compare(self.mesh, inexact).warnings[0])

    def test_that_is_affine_is_found_exactly(self):
        matrix = numpy.array([[1.2, 0.1, 0.0], [0.0, 0.9, -0.2], [0.05, 0.0, 1.1]])
        after = moved(self.mesh, matrix, self.folder)
        comparison = moserhex.compare(self.mesh, after, align="none")
        growth = numpy.linalg.det(matrix)
        unit = matrix / growth ** (1 / 3)
        strain = 0.5 * (unit.T @ unit - numpy.eye(3))
        self.assertAlmostEqual(comparison.growth, growth, 9)
        self.assertLess(numpy.abs(comparison.deformation_gradient - matrix).max(), 1e-9)
        self.assertLess(numpy.abs(comparison.volume_ratio - growth).max(), 1e-9)
        self.assertLess(numpy.abs(comparison.volumetric).max(), 1e-9)
        self.assertLess(numpy.abs(comparison.strain - strain).max(), 1e-9)
        principal = numpy.linalg.eigvalsh(strain)[::-1]
        self.assertLess(numpy.abs(comparison.principal_strains - principal).max(), 1e-9)
        self.assertLess(numpy.abs(comparison.largest_stretch - numpy.sqrt(1 + 2 * principal[0])).max(), 1e-9)
        deviatoric = numpy.linalg.norm(strain - numpy.trace(strain) / 3 * numpy.eye(3))
        self.assertLess(numpy.abs(comparison.deviatoric_strain - deviatoric).max(), 1e-9)
        self.assertLess(numpy.abs(comparison.displacement - (after.points - self.mesh.points)).max(), 1e-9)

    def test_that_is_a_motion_is_taken_away(self):
        angle = 0.3
        turn = numpy.array(
            [[numpy.cos(angle), -numpy.sin(angle), 0.0], [numpy.sin(angle), numpy.cos(angle), 0.0], [0.0, 0.0, 1.0]]
        )
        after = moved(self.mesh, 1.1 * turn, self.folder)
        comparison = moserhex.compare(self.mesh, after, align="similarity")
        self.assertLess(numpy.abs(comparison.displacement).max(), 1e-9)
        self.assertLess(numpy.abs(comparison.alignment[:3, :3] - turn.T / 1.1).max(), 1e-9)
        points = after.points @ comparison.alignment[:3, :3].T + comparison.alignment[:3, 3]
        self.assertLess(numpy.abs(points - self.mesh.points).max(), 1e-9)

    def test_is_the_same_tensor_in_the_other_space(self):
        other = moserhex.mesh(numpy.roll(LABELS, 1, axis=0) | LABELS, RAS, shells=3)
        self.mesh.write(self.folder / "a.vtk")
        other.write(self.folder / "b.vtk")
        in_ras = moserhex.compare(self.mesh, other)
        in_lps = moserhex.compare(moserhex.read(self.folder / "a.vtk", space="LPS"), other)
        self.assertLess(numpy.abs(in_ras.strain - FLIP @ in_lps.strain @ FLIP).max(), 1e-12)
        self.assertLess(numpy.abs(in_ras.displacement - in_lps.displacement @ FLIP).max(), 1e-12)
        self.assertGreater(numpy.abs(in_ras.strain).max(), 1e-3)

    def test_of_other_meshes_is_refused(self):
        for other in (moserhex.mesh(LABELS, RAS, shells=4), moserhex.mesh(LABELS, RAS, shells=3, padding=1)):
            with self.assertRaises(moserhex.Error) as caught:
                moserhex.compare(self.mesh, other)
            self.assertEqual(caught.exception.code, "E_PRECONDITION")
        with self.assertRaises(moserhex.Error) as caught:
            moserhex.compare(self.mesh, self.mesh, align="affine")
        self.assertEqual(caught.exception.code, "E_USAGE")


class Template(FolderTest):
    FOLLOW_UP = numpy.roll(LABELS, 1, axis=0) | LABELS

    def test_gives_the_command_s_mesh(self):
        write_nrrd(self.folder / "a.nrrd", LABELS, LPS)
        write_nrrd(self.folder / "b.nrrd", self.FOLLOW_UP, LPS)
        self.command("mesh", "a.nrrd", "a.vtk", "--quiet", "--shells", 4)
        baseline = moserhex.mesh(LABELS, RAS, shells=4)
        for align in ("rigid", "none"):
            self.command(
                "mesh", "b.nrrd", "b.vtk", "--quiet", "--shells", 4, "--template", "a.vtk", "--align", align,
                "--report", "b.json",
            )
            tied = moserhex.mesh(self.FOLLOW_UP, RAS, template=baseline, align=align)
            self.assertEqual(tied.nodes_per_side, 8)
            written = moserhex.read(self.folder / "b.vtk")
            self.assertTrue(numpy.array_equal(tied.points, written.points))
            report = self.json("b.json")["template"]
            del report["file"], report["sha256"]
            self.assertEqual(tied.report["template"], report)

    def test_hands_its_record_on(self):
        turned = moserhex.mesh(LABELS, RAS, shells=3, frame="ridge")
        turned.write(self.folder / "t.vtu")
        tied = moserhex.mesh(self.FOLLOW_UP, RAS, template=moserhex.read(self.folder / "t.vtu"))
        self.assertEqual(
            tied.report.get("lattice_turn_degrees"), turned.report.get("lattice_turn_degrees"), tied.report["warnings"]
        )
        self.assertEqual(moserhex.compare(turned, tied).warnings, ())
        for warning in tied.warnings:
            self.assertNotIn("--", warning)
        tied.write(self.folder / "t.msh")  # a format without arrays of the mesh

    def test_in_the_other_space_is_the_same_template(self):
        ras = moserhex.mesh(LABELS, RAS, shells=3)
        lps = moserhex.mesh(LABELS, LPS, shells=3, space="LPS")
        one = moserhex.mesh(self.FOLLOW_UP, RAS, template=ras)
        self.assertTrue(numpy.array_equal(one.points, moserhex.mesh(self.FOLLOW_UP, RAS, template=lps).points))

    def test_is_refined_as_by_the_command(self):
        write_nrrd(self.folder / "a.nrrd", LABELS, LPS)
        write_nrrd(self.folder / "b.nrrd", self.FOLLOW_UP, LPS)
        pattern = numpy.random.default_rng(3).integers(0, 255, LABELS.shape)
        later = numpy.roll(pattern, 1, axis=0)
        write_nrrd(self.folder / "ai.nrrd", pattern, LPS)
        write_nrrd(self.folder / "bi.nrrd", later, LPS)
        self.command("mesh", "a.nrrd", "a.vtk", "--quiet", "--shells", 3)
        baseline = moserhex.mesh(LABELS, RAS, shells=3)
        places = baseline.points[[86, 100, 130]]
        moved = places + [[1.0, 0.0, 0.0], [0.5, 0.5, 0.0], [0.0, 0.0, 1.0]]
        for name, points in (("t.csv", places), ("s.csv", moved)):
            rows = ["x,y,z"] + [",".join(repr(float(x)) for x in point) for point in points @ FLIP]
            (self.folder / name).write_text("\n".join(rows) + "\n")
        for arguments, options in (
            (
                ("--landmarks", "s.csv", "--template-landmarks", "t.csv"),
                {"landmarks": moved, "template_landmarks": places},
            ),
            (
                ("--image", "bi.nrrd", "--template-image", "ai.nrrd"),
                {"image": later, "template_image": (pattern, RAS)},
            ),
            (
                ("--image", "bi.nrrd", "--template-image", "ai.nrrd", "--local-growth"),
                {"image": later, "template_image": (pattern, RAS), "local_growth": True},
            ),
        ):
            with self.subTest(arguments):
                self.command(
                    "mesh", "b.nrrd", "b.vtk", "--quiet", "--template", "a.vtk", "--shells", 3, "--align", "none",
                    "--report", "b.json", *arguments,
                )
                tied = moserhex.mesh(self.FOLLOW_UP, RAS, template=baseline, align="none", **options)
                self.assertTrue(numpy.array_equal(tied.points, moserhex.read(self.folder / "b.vtk").points))
                said, command_s = tied.report["template"], self.json("b.json")["template"]
                residuals = sorted(key for key in said if key.endswith(("_before", "_after")))
                self.assertEqual(len(residuals), 2, said)
                self.assertEqual([said[key] for key in residuals], [command_s[key] for key in residuals])
                self.assertEqual(said.get("local_growth"), command_s.get("local_growth"))
                self.assertEqual("local_growth" in said, "local_growth" in options)
                self.assertLess(said[residuals[0]], said[residuals[1]])  # after, before

    def test_refinement_that_cannot_be_is_refused(self):
        template = moserhex.mesh(LABELS, RAS, shells=3)
        three = numpy.zeros((3, 3))
        holed = numpy.full(LABELS.shape, numpy.nan)
        for code, options in (
            ("E_USAGE", {"landmarks": three}),
            ("E_USAGE", {"image": LABELS}),
            ("E_USAGE", {"local_growth": True}),
            ("E_USAGE", {"template": None, "landmarks": three, "template_landmarks": three}),
            ("E_DIMENSION", {"landmarks": three, "template_landmarks": three[:2]}),
            ("E_DIMENSION", {"landmarks": three[:0], "template_landmarks": three[:0]}),
            ("E_DIMENSION", {"landmarks": three[:, :2], "template_landmarks": three}),
            ("E_PIXELTYPE", {"landmarks": three * numpy.nan, "template_landmarks": three}),
            ("E_PIXELTYPE", {"image": holed, "template_image": (LABELS, RAS)}),
        ):
            with self.subTest(**options), self.assertRaises(moserhex.Error) as caught:
                moserhex.mesh(LABELS, RAS, **{"template": template, **options})
            self.assertEqual(caught.exception.code, code, str(caught.exception))
            self.assertNotIn("--", str(caught.exception))
        with self.assertRaises(TypeError):
            moserhex.mesh(LABELS, RAS, template=template, image=LABELS, template_image=LABELS)

    def test_that_does_not_fit_is_refused(self):
        template = moserhex.mesh(LABELS, RAS, shells=3)
        for code, options in (
            ("E_NOT_HEXAHEDRA", {"shells": 4}),
            ("E_USAGE", {"align": "similarity"}),
            ("E_USAGE", {"padding": 1}),
            ("E_USAGE", {"frame": "ridge"}),
            ("E_USAGE", {"way": "faithful"}),
            ("E_USAGE", {"stage": "moser"}),
        ):
            with self.subTest(**options), self.assertRaises(moserhex.Error) as caught:
                moserhex.mesh(LABELS, RAS, template=template, **options)
            self.assertEqual(caught.exception.code, code, str(caught.exception))
            self.assertNotIn("--", str(caught.exception))
        with self.assertRaises(TypeError):
            moserhex.mesh(LABELS, RAS, template="baseline.vtu")


if __name__ == "__main__":
    unittest.main()
