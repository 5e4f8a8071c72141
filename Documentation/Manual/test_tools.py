"""What the manual's own tools refuse: each test plants one fault."""
import json
import os
import stat
import subprocess
import sys
import tempfile
import unittest

FOLDER = os.path.dirname(os.path.abspath(__file__))
COMMANDS = [{"name": "mesh", "description": "d", "options": [
    {"names": ["--shells"], "place": "", "description": "How many [ten]", "values": "INT in [2 - 64]", "default": "",
     "required": False, "several": False, "excludes": []}]}]
PAGE = "<!DOCTYPE html><html lang='en'><head><title>t</title></head><body><p>--shells</p>{}</body></html>"


class Tools(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.root = self.temporary.name
        self.program = self.write("bin/moserhex", f"#!{sys.executable}\nprint('''{json.dumps(COMMANDS)}''')\n")
        os.chmod(self.program, os.stat(self.program).st_mode | stat.S_IXUSR)

    def write(self, name, text):
        path = os.path.join(self.root, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def run_tool(self, tool, *words):
        return subprocess.run([sys.executable, os.path.join(FOLDER, tool), *words], capture_output=True, text=True)

    def blocks(self, text):
        self.write("source/page.md", text)
        return self.run_tool("run_blocks.py", self.program, os.path.join(self.root, "source"), os.path.join(self.root, "work"), "page.md")

    def assemble(self, text, name="mesh"):
        for page in ("CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "Examples/README.md"):
            self.write("source/" + page, "# Title\n")
        self.write(f"source/Documentation/Commands/{name}.md", text)
        return self.run_tool("assemble.py", self.program, os.path.join(self.root, "source"), os.path.join(self.root, "out"))

    def check(self, body):
        self.write("site/Commands/mesh.html", PAGE.format(body))
        return self.run_tool("check_site.py", os.path.join(self.root, "site"), self.program)

    def test_blocks_run_in_order_in_one_folder(self):
        outcome = self.blocks("<!-- before: echo 1 > a -->\n```sh\ngrep 1 a\necho 2 > b\n```\n\n```sh\ngrep 2 b\n```\n")
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        self.assertIn("2 blocks: 2 run, 0 compared with built files, 0 not run", outcome.stdout)

    def test_block_that_fails_fails_the_page(self):
        self.assertIn("page.md:1: ended with 1", self.blocks("```sh\nfalse\necho fine\n```\n").stderr)
        self.assertIn("ended with", self.blocks("```sh\nfalse | cat\n```\n").stderr)
        self.assertIn("ended with", self.blocks("```sh\necho $NO_SUCH_VARIABLE\n```\n").stderr)

    def test_block_that_is_not_run_says_why(self):
        outcome = self.blocks("<!-- not run: needs a cluster -->\n```sh\nfalse\n```\n")
        self.assertEqual(outcome.returncode, 0)
        self.assertIn("needs a cluster", outcome.stdout)
        self.assertIn("1 blocks: 0 run, 0 compared with built files, 1 not run", outcome.stdout)
        self.assertIn("but why", self.blocks("<!-- not run: -->\n```sh\nfalse\n```\n").stderr)

    def test_commands_cannot_hide(self):
        self.assertIn("a block of language ''", self.blocks("```\nmoserhex x\n```\n").stderr)
        self.assertIn("indented command", self.blocks("Text\n\n    moserhex x\n").stderr)
        self.write("source/Documentation/Commands/forgotten.md", "```sh\ntrue\n```\n")
        self.write("source/Examples/README.md", "")
        outcome = self.run_tool("run_blocks.py", "--list", os.path.join(self.root, "source"), "page.md")
        self.assertIn("forgotten.md has blocks to run and is not in the list", outcome.stderr)

    def test_code_must_stand_in_a_file_that_is_built(self):
        self.write("source/a.cxx", "int a;\n  int b;\nint c;\n")
        self.assertEqual(self.blocks("<!-- part of: a.cxx -->\n```cpp\nint b;\nint c;\n```\n").returncode, 0)
        self.assertIn("not in a.cxx", self.blocks("<!-- part of: a.cxx -->\n```cpp\nint a;\nint c;\n```\n").stderr)
        self.assertIn("which file", self.blocks("```cpp\nint a;\n```\n").stderr)

    def test_page_of_a_command_gets_its_options(self):
        outcome = self.assemble("# mesh\n\n<!-- options -->\n")
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        with open(os.path.join(self.root, "out/Commands/mesh.md"), encoding="utf-8") as file:
            self.assertIn("| `--shells` | whole number from 2 to 64 | ten | How many |", file.read())

    def test_page_without_command_marker_or_target_is_refused(self):
        self.assertIn("needs the marker", self.assemble("# mesh\n").stderr)
        self.assertIn("which is not there", self.assemble("[x](../Nowhere.md) <!-- options -->").stderr)
        self.assemble("# mesh\n<!-- options -->\n")
        self.assertIn("has no command other", self.assemble("# other\n<!-- options -->\n", "other").stderr)

    def test_command_without_a_page_is_refused(self):
        self.write("source/Documentation/a.md", "# a\n")
        for page in ("CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "Examples/README.md"):
            self.write("source/" + page, "# Title\n")
        outcome = self.run_tool("assemble.py", self.program, os.path.join(self.root, "source"), os.path.join(self.root, "out"))
        self.assertIn("no page Documentation/Commands/NAME.md of mesh", outcome.stderr)

    def test_site_without_fault_passes(self):
        outcome = self.check("<p id='a'><a href='#a'>a</a> <a href='https://example.org'>elsewhere</a></p>")
        self.assertEqual(outcome.returncode, 0, outcome.stdout)

    def test_faults_of_a_site_are_named(self):
        for body, words in (("<script src='https://example.org/a.js'></script>", "loads https://example.org/a.js"),
                            ("<p><img src='//example.org/a.png' alt='a'></p>", "loads //example.org/a.png"),
                            ("<p><img src='a.png' alt='a'></p>", "a.png, which is not there"),
                            ("<p><a href='gone.html'>a</a></p>", "dead link gone.html"),
                            ("<p><a href='#gone'>a</a></p>", "#gone to a place that is not there"),
                            ("<p><div>a</p></div>", "Warning")):
            outcome = self.check(body)
            self.assertEqual(outcome.returncode, 1, body)
            self.assertIn(words, outcome.stdout)
        self.write("site/a.css", "@import url('https://example.org/a.css');")
        self.assertIn("a.css: loads https://example.org/a.css", self.check("").stdout)

    def test_option_that_is_missing_is_named(self):
        self.write("site/Commands/mesh.html", PAGE.replace("--shells", ""))
        self.assertIn("--shells is missing", self.run_tool("check_site.py", os.path.join(self.root, "site"), self.program).stdout)


if __name__ == "__main__":
    unittest.main()
