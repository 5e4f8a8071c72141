"""Every block of Python in Documentation/Python.md runs, one after the other, beside the command's sample."""

import contextlib
import io
import os
import pathlib
import re
import unittest

import numpy

from shapes import FolderTest, affine_of, ellipsoid, oblique_axes, to_other_space

PAGE = pathlib.Path(__file__).parents[3] / "Documentation" / "Python.md"


def blocks():
    """Line and text of each."""
    text = PAGE.read_text()
    for match in re.finditer(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
        yield text[: match.start()].count("\n") + 2, match.group(1)


def write_nifti(path):
    """What the first example reads. False without nibabel."""
    try:
        import nibabel
    except ImportError:
        return False
    nibabel.save(nibabel.Nifti1Image(ellipsoid(), to_other_space(affine_of(oblique_axes()))), path)
    return True


class Documentation(FolderTest):
    def test_blocks_run(self):
        self.command("sample", "data", "--quiet")
        has_nibabel = write_nifti(self.folder / "prostate.nii.gz")
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        names = {"numpy": numpy}
        run = 0
        for line, block in blocks():
            if "nibabel" in block and not has_nibabel:
                print(f"{PAGE.name}:{line}: left out, there is no nibabel")
                continue
            with self.subTest(line=line), contextlib.redirect_stdout(io.StringIO()):
                exec(compile("\n" * (line - 1) + block, str(PAGE), "exec"), names)
                run += 1
        self.assertGreaterEqual(run, 5)

    def test_every_block_is_fenced(self):
        outside = re.sub(r"^```python\n.*?^```$", "", PAGE.read_text(), flags=re.MULTILINE | re.DOTALL)
        self.assertNotRegex(outside, r"(?m)^ {4}(import|from|try|mesh =)\b")


if __name__ == "__main__":
    unittest.main()
