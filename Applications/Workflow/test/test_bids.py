"""moserhex-bids on a dataset of four participants, one with two sessions, one with a labelmap that is cut off.

Environment: MOSERHEX_EXECUTABLE, MOSERHEX_BIDS.
"""
import csv
import gzip
import json
import os
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import make_cases

SIZE = 24


def nifti(voxels):
    header = struct.pack("<i36x8h14xhh34x", 348, 3, SIZE, SIZE, SIZE, 1, 1, 1, 1, 2, 8)
    header = header[:76] + struct.pack("<8ff2f", 1, 1.5, 1.5, 1.5, 1, 1, 1, 1, 352, 1, 0)
    header = header.ljust(254, b"\0") + struct.pack("<h", 1) + bytes(24)
    for axis in range(3):
        header += struct.pack("<4f", *(1.5 if column == axis else 0 for column in range(4)))
    return header.ljust(344, b"\0") + b"n+1\0" + bytes(4) + voxels


def write_labelmap(path, axes, cut=False):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    content = gzip.compress(nifti(make_cases.ellipsoid(SIZE, axes)))
    with open(path, "wb") as file:
        file.write(content[: len(content) // 2] if cut else content)


class Bids(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.bids = os.path.join(folder.name, "bids")
        self.output = os.path.join(folder.name, "meshes")
        write_labelmap(f"{self.bids}/sub-01/anat/sub-01_dseg.nii.gz", (8, 7, 9))
        write_labelmap(f"{self.bids}/sub-02/ses-a/anat/sub-02_ses-a_dseg.nii.gz", (8, 8, 9))
        write_labelmap(f"{self.bids}/sub-02/ses-b/anat/sub-02_ses-b_dseg.nii.gz", (9, 8, 9))
        write_labelmap(f"{self.bids}/sub-03/anat/sub-03_dseg.nii.gz", (8, 7, 8), cut=True)
        write_labelmap(f"{self.bids}/sub-04/anat/sub-04_desc-tumour_mask.nii.gz", (9, 9, 8))
        write_labelmap(f"{self.bids}/sub-04/anat/sub-04_T1w.nii.gz", (9, 9, 8))
        os.makedirs(f"{self.bids}/code")

    def start(self, *words):
        command = [sys.executable, os.environ["MOSERHEX_BIDS"], self.bids, self.output, *words]
        environment = dict(os.environ, MOSERHEX=os.environ.get("MOSERHEX", os.environ["MOSERHEX_EXECUTABLE"]))
        return subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def run_app(self, *words):
        process = self.start(*words)
        self.words, _ = process.communicate()
        return process.returncode

    def meshes(self):
        return sorted(
            os.path.relpath(os.path.join(place, name), self.output)
            for place, _, names in os.walk(self.output)
            for name in names
            if name.endswith(".vtu")
        )

    def test_participants_then_group(self):
        self.assertEqual(self.run_app("participant", "--shells", "3", "--n_cpus", "2"), 1, "one labelmap is cut off")
        self.assertEqual(
            self.meshes(),
            [
                "sub-01/anat/sub-01_dseg.vtu",
                "sub-02/ses-a/anat/sub-02_ses-a_dseg.vtu",
                "sub-02/ses-b/anat/sub-02_ses-b_dseg.vtu",
                "sub-04/anat/sub-04_desc-tumour_mask.vtu",
            ],
        )
        with open(f"{self.output}/dataset_description.json", encoding="utf-8") as file:
            description = json.load(file)
        self.assertEqual(description["DatasetType"], "derivative")
        self.assertEqual(description["GeneratedBy"][0]["Name"], "MoserHex")
        self.assertRegex(description["GeneratedBy"][0]["Version"], r"^\d+\.\d+\.\d+")

        self.assertEqual(self.run_app("group", "--shells", "3"), 1, self.words)
        with open(f"{self.output}/summary.csv", newline="", encoding="utf-8") as file:
            rows = {row["case"]: row for row in csv.DictReader(file)}
        self.assertEqual(len(rows), 5)
        self.assertEqual(rows["sub-03/anat/sub-03_dseg.vtu"]["status"], "failed")
        self.assertEqual(sum(row["status"] == "done" for row in rows.values()), 4)

    def test_chosen_participants_and_sessions(self):
        self.assertEqual(self.run_app("participant", "--participant_label", "02", "--session-label", "b", "--shells", "3"), 0, self.words)
        self.assertEqual(self.meshes(), ["sub-02/ses-b/anat/sub-02_ses-b_dseg.vtu"])
        self.assertEqual(self.run_app("participant", "--participant-label", "sub-01", "04", "--suffix", "mask", "--shells", "3"), 0)
        self.assertEqual(len(self.meshes()), 2, "sub-01 has no mask")

    def test_calls_for_different_participants_at_the_same_time(self):
        calls = [self.start("participant", "--participant-label", label, "--shells", "3") for label in ("01", "02", "04")]
        for call in calls:
            words, _ = call.communicate()
            self.assertEqual(call.returncode, 0, words)
        self.assertEqual(len(self.meshes()), 4)

    def test_options_of_batch(self):
        self.assertEqual(self.run_app("participant", "--participant-label", "01", "--", "--shells", "3", "--format", ".vtk"), 0, self.words)
        self.assertTrue(os.path.exists(f"{self.output}/sub-01/anat/sub-01_dseg.vtk"))

    def test_what_is_not_there_is_refused(self):
        for words in (["--participant-label", "77"], ["--suffix", "probseg"], ["--label", "1", "--all-labels"], ["--n-cpus", "0"]):
            self.assertEqual(self.run_app("participant", *words), 2, self.words)
        self.assertFalse(os.path.exists(self.output))

    def test_an_end_is_passed_on(self):
        """As `docker stop` asks for it: the batch ends, and so does the app, with the status of the signal."""
        waits = os.path.join(os.path.dirname(self.output), "waits.sh")
        with open(waits, "w", encoding="utf-8") as file:
            file.write('#!/bin/sh\n[ "$1" != --version ] || { echo moserhex 0.0.0; exit; }\necho started\nexec sleep 60\n')
        os.chmod(waits, 0o755)
        os.environ["MOSERHEX"] = waits
        self.addCleanup(os.environ.pop, "MOSERHEX")
        process = self.start("participant", "--participant-label", "01")
        self.assertEqual(process.stdout.readline(), "started\n")
        begin = time.monotonic()
        process.send_signal(signal.SIGTERM)
        process.communicate()
        self.assertEqual(process.returncode, 128 + signal.SIGTERM)
        self.assertLess(time.monotonic() - begin, 30)


if __name__ == "__main__":
    unittest.main()
