"""Meshes against the command's, to the last bit; files; threads; interruption."""

import concurrent.futures
import os
import signal
import threading
import unittest

import numpy

import moserhex
from shapes import FolderTest, affine_of, ellipsoid, oblique_axes, to_other_space, write_nrrd

LPS = affine_of(oblique_axes())
RAS = to_other_space(LPS)
LABELS = ellipsoid()


def small_mesh(**options):
    return moserhex.mesh(LABELS, RAS, shells=4, **options)


class MeshAgainstTheCommand(FolderTest):
    def setUp(self):
        super().setUp()
        write_nrrd(self.folder / "labels.nrrd", LABELS, LPS)

    def test_nodes_are_the_command_s_to_the_last_bit(self):
        self.command("mesh", "labels.nrrd", "mesh.vtu", "--quiet", "--shells", 4)
        written = moserhex.read(self.folder / "mesh.vtu", space="LPS").points
        self.assertTrue(numpy.array_equal(moserhex.mesh(LABELS, LPS, space="LPS", shells=4).points, written))
        self.assertTrue(numpy.array_equal(small_mesh().points, written * [-1.0, -1.0, 1.0]))

    def test_nodes_of_every_stage_and_way_are_the_command_s(self):
        for stage, way in (("initial", "fast"), ("smoothed", "fast"), ("moser", "fast"), ("exact", "faithful")):
            with self.subTest(stage=stage, way=way):
                options = ["--way", way] if stage == "exact" else []
                self.command("mesh", "labels.nrrd", "mesh.vtk", "--quiet", "--shells", 3, "--stage", stage, *options)
                mesh = moserhex.mesh(LABELS, LPS, space="LPS", shells=3, stage=stage, way=way)
                written = moserhex.read(self.folder / "mesh.vtk", space="LPS")
                self.assertTrue(numpy.array_equal(mesh.points, written.points))

    def test_files_have_the_command_s_bytes(self):
        mesh = small_mesh()
        for ending in ("vtu", "vtk", "msh", "inp", "mesh", "feb", "exo"):
            with self.subTest(ending=ending):
                self.command("mesh", "labels.nrrd", f"command.{ending}", "--quiet", "--shells", 4)
                mesh.write(self.folder / f"python.{ending}")
                ours = (self.folder / f"python.{ending}").read_bytes()
                self.assertEqual(ours, (self.folder / f"command.{ending}").read_bytes())

    def test_several_labels_are_meshed_together_and_written_with_their_labels(self):
        zones = LABELS.copy()
        zones[:, 14:, :] *= 3
        write_nrrd(self.folder / "zones.nrrd", zones, LPS)
        self.command("mesh", "zones.nrrd", "command.vtk", "--quiet", "--shells", 4)
        moserhex.mesh(zones, RAS, shells=4).write(self.folder / "python.vtk")
        self.assertEqual((self.folder / "python.vtk").read_bytes(), (self.folder / "command.vtk").read_bytes())

    def test_the_report_is_the_command_s_without_files(self):
        self.command("mesh", "labels.nrrd", "mesh.vtu", "--quiet", "--shells", 4, "--report", "report.json")
        theirs = self.json("report.json")
        ours = small_mesh().report
        for part, keys in (("input", ("file", "sha256")), ("mesh", ("file",))):
            for key in keys:
                del theirs[part][key]
        del theirs["peak_memory_mib"]  # Python's own is that of the whole program
        for report in (theirs, ours):
            del report["seconds"]
            for stage in report["stages"]:
                del stage["seconds"]
        self.assertEqual(ours, theirs)

    def test_quality_is_the_command_s(self):
        mesh = small_mesh()
        mesh.write(self.folder / "mesh.vtu")
        self.command("quality", "mesh.vtu", "--quiet", "--json", "quality.json")
        self.assertEqual(mesh.quality(), self.json("quality.json")["quality"])

    def test_a_density_gives_the_command_s_mesh(self):
        density = 1.0 + LABELS.astype(float) * numpy.linspace(0.0, 1.0, LABELS.shape[0])[:, None, None].round(2)
        density = (density * 100).astype(numpy.uint8)
        write_nrrd(self.folder / "density.nrrd", density, LPS)
        self.command("mesh", "labels.nrrd", "mesh.vtk", "--quiet", "--shells", 4, "--density", "density.nrrd")
        written = moserhex.read(self.folder / "mesh.vtk").points
        on_the_same_voxels = small_mesh(density=density)
        self.assertTrue(numpy.array_equal(on_the_same_voxels.points, written))
        self.assertTrue(numpy.array_equal(small_mesh(density=(density.astype(float), RAS)).points, written))
        self.assertNotIn("file", on_the_same_voxels.report["density"])
        self.assertGreater(on_the_same_voxels.report["density"]["mean"], 100.0)


class LabelFiles(FolderTest):
    def test_are_read_with_their_affine(self):
        write_nrrd(self.folder / "labels.nrrd", LABELS, LPS)
        for space, affine in (("LPS", LPS), ("RAS", RAS)):
            labels, read = moserhex.read_labels(self.folder / "labels.nrrd", space=space)
            self.assertTrue(numpy.array_equal(labels, LABELS))
            self.assertLess(numpy.abs(read - affine).max(), 1e-12)

    def test_a_threshold_makes_a_label(self):
        write_nrrd(self.folder / "probability.nrrd", LABELS * 200, LPS)
        labels, _ = moserhex.read_labels(self.folder / "probability.nrrd", threshold=100.0)
        self.assertTrue(numpy.array_equal(labels, LABELS))

    def test_what_is_doubtful_is_a_warning(self):
        skewed = LPS.copy()
        skewed[:3, 1] += 1e-4 * skewed[:3, 0]
        write_nrrd(self.folder / "labels.nrrd", LABELS, skewed)
        with self.assertWarnsRegex(UserWarning, "turned to right angles"):
            labels, affine = moserhex.read_labels(self.folder / "labels.nrrd")
        self.assertEqual(moserhex.mesh(labels, affine, shells=2, stage="initial").warnings, [])

    def test_the_command_s_sample_is_meshed(self):
        self.command("sample", ".", "--quiet")
        labels, affine = moserhex.read_labels(self.folder / "prostate.nrrd")
        mesh = moserhex.mesh(labels, affine)
        self.assertTrue(mesh.report["exact"]["reached"])
        self.assertEqual(mesh.quality()["certified"]["positive"], 6859)


class Meshes(FolderTest):
    def test_cells_are_right_handed_and_of_equal_volume(self):
        for space, affine in (("RAS", RAS), ("LPS", LPS)):
            mesh = moserhex.mesh(LABELS, affine, space=space, shells=4)
            corners = mesh.points[mesh.cells]
            a, b, c = (corners[:, n] - corners[:, 0] for n in (1, 3, 4))
            self.assertGreater(numpy.einsum("ij,ij->i", a, numpy.cross(b, c)).min(), 0.0)
            self.assertEqual(mesh.cells.shape, (343, 8))
            self.assertLess(mesh.quality()["volume_variance"], 1e-20)

    def test_nodes_lie_in_the_order_of_the_lattice(self):
        points = small_mesh(allow_partial=True).points.reshape(8, 8, 8, 3)  # [k, j, i]
        left = points[:, :, -1].mean(axis=(0, 1)) - points[:, :, 0].mean(axis=(0, 1))
        posterior = points[:, -1].mean(axis=(0, 1)) - points[:, 0].mean(axis=(0, 1))
        superior = points[-1].mean(axis=(0, 1)) - points[0].mean(axis=(0, 1))
        for direction, step in ((left, [-1, 0, 0]), (posterior, [0, -1, 0]), (superior, [0, 0, 1])):
            self.assertGreater(numpy.dot(direction, step), 0.9 * numpy.linalg.norm(direction))

    def test_what_was_written_is_read(self):
        mesh = small_mesh()
        for ending in ("vtu", "vtk", "msh", "mesh"):
            with self.subTest(ending=ending):
                path = self.folder / f"mesh.{ending}"
                mesh.write(path)
                read = moserhex.read(str(path))
                self.assertTrue(numpy.array_equal(read.points, mesh.points))
                self.assertTrue(numpy.array_equal(read.cells, mesh.cells))
                self.assertIsNone(read.report)
                self.assertEqual(read.nodes_per_side, 8)

    def test_a_file_is_read_without_a_child_process(self):
        small_mesh().write(self.folder / "mesh.vtu")
        self.assertEqual(moserhex.read(self.folder / "mesh.vtu", sandbox=False).nodes_per_side, 8)

    def test_a_mesh_that_is_not_exact_says_so(self):
        mesh = moserhex.mesh(LABELS, RAS, shells=3, stage="initial")
        self.assertNotIn("exact", mesh.report)
        self.assertEqual([stage["name"] for stage in mesh.report["stages"]][0], "conditioning")

    def test_a_repair_is_among_the_warnings(self):
        hollow = LABELS.copy()
        hollow[17, 14, 7] = 0
        mesh = moserhex.mesh(hollow, RAS, shells=4)
        self.assertTrue(any("cavit" in warning for warning in mesh.warnings), mesh.warnings)
        self.assertEqual(mesh.report["warnings"], mesh.warnings)

    def test_a_report_that_is_changed_stays_as_it_was_in_the_mesh(self):
        mesh = small_mesh()
        mesh.report["warnings"].append("mine")
        self.assertEqual(mesh.report["warnings"], [])

    def test_its_text_names_size_and_space(self):
        self.assertEqual(repr(small_mesh()), "<moserhex.Mesh of 8 x 8 x 8 nodes, RAS>")


class Threads(unittest.TestCase):
    def test_the_mesh_is_the_same_for_any_number_of_threads(self):
        one = small_mesh(threads=1)
        self.assertTrue(numpy.array_equal(one.points, small_mesh(threads=3).points))

    def test_two_python_threads_mesh_at_the_same_time(self):
        expected = small_mesh().points
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            for mesh in pool.map(lambda threads: small_mesh(threads=threads), (1, 2, 3, 1)):
                self.assertTrue(numpy.array_equal(mesh.points, expected))

    def test_other_threads_run_meanwhile(self):
        counted = []
        done = threading.Event()

        def count():
            while not done.wait(0.001):
                counted.append(None)

        counter = threading.Thread(target=count)
        counter.start()
        before = len(counted)
        small_mesh()
        after = len(counted)
        done.set()
        counter.join()
        self.assertGreater(after, before)


class Interruption(unittest.TestCase):
    def test_progress_goes_from_0_to_1(self):
        seen = []
        moserhex.mesh(LABELS, RAS, shells=12, progress=seen.append)
        self.assertTrue(all(0.0 <= fraction <= 1.0 for fraction in seen))
        self.assertEqual(seen[-1], 1.0)

    def test_what_progress_raises_ends_the_work(self):
        class Enough(Exception):
            pass

        def refuse(_):
            raise Enough("no more")

        with self.assertRaisesRegex(Enough, "no more"):
            moserhex.mesh(LABELS, RAS, shells=20, progress=refuse)

    def test_progress_that_returns_false_ends_the_work(self):
        with self.assertRaises(moserhex.Error) as caught:
            moserhex.mesh(LABELS, RAS, shells=20, progress=lambda _: False)
        self.assertEqual(caught.exception.code, "E_CANCELLED")

    def test_ctrl_c_ends_the_work(self):
        timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            moserhex.mesh(LABELS, RAS, shells=40)
        timer.join()

    def test_the_next_mesh_after_an_interrupted_one_is_as_ever(self):
        expected = small_mesh().points
        with self.assertRaises(moserhex.Error):
            moserhex.mesh(LABELS, RAS, shells=20, progress=lambda _: False)
        self.assertTrue(numpy.array_equal(small_mesh().points, expected))


class Agreement(FolderTest):
    def test_density_is_the_command_s_and_makes_a_mesh(self):
        other = LABELS.copy()
        other[..., : LABELS.shape[2] // 3] = 0
        write_nrrd(self.folder / "a.nrrd", LABELS, LPS)
        write_nrrd(self.folder / "b.nrrd", other, LPS)
        self.command("agreement", "a.nrrd", "b.nrrd", "--output", "agreed.nrrd", "--quiet")
        self.command("mesh", "a.nrrd", "command.vtu", "--density", "agreed.nrrd", "--quiet", "--shells", 3)
        agreed = moserhex.agreement([(LABELS, LPS), (other, LPS)], space="LPS")
        self.assertAlmostEqual(agreed[0].max(), 1.0)
        self.assertLess(agreed[0].min(), 0.2)
        mesh = moserhex.mesh(LABELS, LPS, space="LPS", shells=3, density=agreed)
        written = moserhex.read(self.folder / "command.vtu", space="LPS")
        self.assertLess(numpy.abs(mesh.points - written.points).max(), 0.01)  # rounding of the affine, amplified

    def test_one_alone_is_refused(self):
        with self.assertRaisesRegex(moserhex.Error, "at least two labels"):
            moserhex.agreement([(LABELS, RAS)])


if __name__ == "__main__":
    unittest.main()
