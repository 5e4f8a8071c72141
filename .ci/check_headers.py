#!/usr/bin/env python3
"""Checks the syntax of all sources against the headers of another ITK and VTK, of which only the configuration is needed.

    .ci/check_headers.py ITK_BUILD VTK_BUILD [--jobs N] [--only REGEX] [-- CMAKE_OPTIONS]

ITK_BUILD and VTK_BUILD are folders in which CMake has configured and generated (not built) the two, with the modules of
CMake/MoserHexFindITK.cmake and CMake/MoserHexFindVTK.cmake; "none" takes the installed one. MoserHex is configured against
them in a temporary folder, and every source that includes ITK or VTK, itself or by a header of ours, is compiled with
-fsyntax-only and with the warnings of the presets as errors, deprecated functions among them. Templates are instantiated as
far as the sources do so. Nothing is linked or run. Exit status 0: nothing was found, and no header was left out.
"""
import argparse
import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
FOLDERS = ("Modules", "Applications", "Testing", "Examples")
# Sources of projects of their own are compiled with the options of this one.
ON_THEIR_OWN = tuple(os.path.join(ROOT, folder, "") for folder in ("Examples", os.path.join("Testing", "Consumer")))
LENDER = os.path.join(ROOT, "Applications", "MoserHex", "src", "MeshFile.cxx")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)
FOREIGN = re.compile(r"(itk[A-Z]|itksys|vtk)")


class Sources:
    """What includes what among our files. A header is known by its last name."""

    def __init__(self):
        self.includes = {}
        self.places = {}
        for folder in FOLDERS:
            for place, _, names in os.walk(os.path.join(ROOT, folder)):
                for name in names:
                    if name.endswith((".cxx", ".h", ".hxx")):
                        path = os.path.join(place, name)
                        with open(path, encoding="utf-8") as file:
                            self.includes[path] = INCLUDE.findall(file.read())
                        self.places.setdefault(name, []).append(path)

    def closure(self, path):
        """(the file and ours that it includes, whether ITK or VTK is among what they include)"""
        found, waiting, foreign = {path}, [path], False
        while waiting:
            for included in self.includes[waiting.pop()]:
                own = self.places.get(os.path.basename(included), [])
                foreign = foreign or (not own and FOREIGN.match(included) is not None)
                waiting += [header for header in own if header not in found]
                found.update(own)
        return found, foreign

    def that_need_itk_or_vtk(self):
        return {path for path in self.includes if self.closure(path)[1]}


def configure(folder, arguments):
    command = ["cmake", "-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
               "-DMoserHex_WARNINGS_AS_ERRORS=ON"]
    command += [f"-D{name}_DIR={os.path.abspath(place)}" for name, place in (("ITK", arguments.itk), ("VTK", arguments.vtk))
                if place != "none"]
    subprocess.run(command + arguments.cmake, check=True, stdout=subprocess.DEVNULL)
    with open(os.path.join(folder, "compile_commands.json"), encoding="utf-8") as file:
        return json.load(file)


def syntax_only(entry, path):
    """The words of a compiler's command for the source, without launcher and object."""
    words = shlex.split(entry["command"])
    if os.path.basename(words[0]) in ("ccache", "sccache"):
        words = words[1:]
    at = words.index("-o")
    words = words[:at] + words[at + 2:]
    at = words.index("-c")
    return words[:at] + words[at + 2:] + ["-fsyntax-only", path]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("itk", metavar="ITK_BUILD")
    parser.add_argument("vtk", metavar="VTK_BUILD")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--only", default="", metavar="REGEX", help="sources whose path matches")
    words = sys.argv[1:]
    end = words.index("--") if "--" in words else len(words)
    arguments = parser.parse_args(words[:end])
    arguments.cmake = words[end + 1:]
    sources = Sources()
    needed = sources.that_need_itk_or_vtk()
    with tempfile.TemporaryDirectory() as folder:
        entries = {os.path.abspath(entry["file"]): entry for entry in configure(folder, arguments)}
        for path in needed:
            if path.endswith(".cxx") and path.startswith(ON_THEIR_OWN):
                entries[path] = entries[LENDER]
        chosen = sorted(path for path in needed & set(entries) if re.search(arguments.only, path))

        def check(path):
            return path, subprocess.run(syntax_only(entries[path], path), cwd=entries[path]["directory"],
                                        capture_output=True, text=True)

        failed = 0
        seen = set()
        with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
            for path, outcome in pool.map(check, chosen):
                seen |= sources.closure(path)[0]
                failed += outcome.returncode != 0
                print(f"{'ok' if outcome.returncode == 0 else 'FAULT':6}{os.path.relpath(path, ROOT)}", flush=True)
                if outcome.returncode != 0:
                    print(outcome.stderr, flush=True)
    left_out = sorted(os.path.relpath(path, ROOT) for path in needed - seen)
    for path in left_out if not arguments.only else []:
        print(f"left out: {path}")
    print(f"{len(chosen)} sources and their {len(needed & seen) - len(chosen)} headers checked, {failed} with faults")
    return 1 if failed or not chosen or (left_out and not arguments.only) else 0


if __name__ == "__main__":
    sys.exit(main())
