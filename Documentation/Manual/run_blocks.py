#!/usr/bin/env python3
"""Runs what a page of the manual shows, as its reader would.

    run_blocks.py MOSERHEX SOURCE WORK PAGE [--python PYTHON --python-path FOLDER]
    run_blocks.py --list SOURCE PAGE...

The blocks of a page run one after the other in a new folder below WORK, with MOSERHEX in the PATH; the first that fails ends the
test. What a block is for is said by its language and by a comment in the lines above it:

    sh, python          run. All Python blocks of a page are one program, run where the first stands
    cpp, cmake          must stand, line for line, in a file that other tests build: <!-- part of: FILE -->
    text, json, ...     data or output
    <!-- before: COMMANDS -->   run first, by sh: what a reader has and the test does not. $SAMPLE is a folder with the sample's
                                labelmaps, their meshes of 5 shells (prostate.vtu, prostate_followup.vtu) and reports
    <!-- not run: REASON -->    the block below is shown only; all of these are counted and listed

A block without a language, an indented command and a not-run block without a reason are faults. --list prints how many blocks
are run, compared and not run, with the reasons.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
import textwrap

RUN = ("sh", "python")
COMPARED = ("cpp", "cmake")
SHOWN = ("text", "json", "xml", "yaml", "{toctree}")
COMMANDS = r"moserhex|moserhex-\w+|cmake|docker|pip|apt|import moserhex|MoserHex\w+ --"


class Block:
    def __init__(self, page, line, language, text, comments):
        self.where = f"{page}:{line}"
        self.language = language
        self.text = textwrap.dedent(text)
        self.before = [words for kind, words in comments if kind == "before"]
        self.reasons = [words for kind, words in comments if kind == "not run"]
        self.part_of = [words for kind, words in comments if kind == "part of"]


def fail(message):
    sys.exit(f"run_blocks.py: {message}")


def blocks_of(page, text):
    """The blocks of a page in its order."""
    blocks, comments = [], []
    lines = text.split("\n")
    number = 0
    while number < len(lines):
        line = lines[number]
        comment = re.fullmatch(r"\s*<!-- (before|not run|part of): *(.*)", line)
        fence = re.fullmatch(r"( *)```(\S*)", line)
        if comment:
            words = [comment.group(2)]
            while not words[-1].rstrip().endswith("-->"):
                number += 1
                words.append(lines[number])
            comments.append((comment.group(1), "\n".join(words).rstrip()[:-len("-->")].strip()))
        elif fence:
            first = number + 1
            number += 1
            while lines[number].strip() != "```":
                number += 1
            block = Block(page, first, fence.group(2), "\n".join(lines[first:number]), comments)
            if block.language not in RUN + COMPARED + SHOWN:
                fail(f"{block.where}: a block of language '{block.language}'; say sh, python, cpp, cmake or text")
            if block.language in RUN + COMPARED and "" in block.reasons:
                fail(f"{block.where}: not run, but why?")
            blocks.append(block)
            comments = []
        elif re.match(rf"    ({COMMANDS})\b", line) and (number == 0 or not lines[number - 1].strip()):
            fail(f"{page}:{number + 1}: an indented command; put it into a block ```sh")
        elif line.strip():
            if comments:
                fail(f"{page}:{number + 1}: a comment for a block with no block below it")
        number += 1
    return blocks


def with_own_lines(text):
    return [line.strip() for line in text.split("\n") if line.strip()]


def require_part(block, source):
    """The lines of the block stand in the file that it names, in this order and together."""
    if len(block.part_of) != 1:
        fail(f"{block.where}: which file is it part of?")
    with open(os.path.join(source, block.part_of[0]), encoding="utf-8") as file:
        lines = with_own_lines(file.read())
    wanted = with_own_lines(block.text)
    if not any(lines[at:at + len(wanted)] == wanted for at in range(len(lines))):
        fail(f"{block.where}: not in {block.part_of[0]} like this")


class Runner:
    def __init__(self, arguments):
        self.arguments = arguments
        name = re.sub(r"\W+", "-", os.path.splitext(arguments.page)[0])
        self.folder = os.path.join(os.path.abspath(arguments.work), name)
        shutil.rmtree(self.folder, ignore_errors=True)
        os.makedirs(self.folder)
        self.environment = dict(os.environ, PATH=os.path.dirname(os.path.abspath(arguments.moserhex)) + os.pathsep + os.environ["PATH"],
                                SAMPLE=os.path.abspath(arguments.sample or ""), MOSERHEX_SOURCE=os.path.abspath(arguments.source))
        self.environment.pop("DISPLAY", None)
        if arguments.python_path:
            self.environment["PYTHONPATH"] = arguments.python_path

    def call(self, block, words, text):
        print(f"== {block.where}\n{text.rstrip()}", flush=True)
        outcome = subprocess.run(words, input=text, text=True, cwd=self.folder, env=self.environment)
        if outcome.returncode != 0:
            fail(f"{block.where}: ended with {outcome.returncode}")

    def run(self, blocks):
        """Returns whether something was left out."""
        python = [block for block in blocks if block.language == "python" and not block.reasons]
        left_out = False
        for block in blocks:
            for commands in block.before:
                self.call(block, ["bash", "-eu"], commands)
            if block.reasons:
                print(f"== {block.where} is not run: {'; '.join(block.reasons)}")
            elif block.language == "sh":
                self.call(block, ["bash", "-eu", "-o", "pipefail"], block.text)
            elif block.language in COMPARED:
                require_part(block, self.arguments.source)
            elif python and block is python[0]:
                if self.arguments.python_path:
                    self.call(block, [self.arguments.python, "-"], "\n\n".join(one.text for one in python))
                else:
                    print(f"== {block.where} is not run: the Python module is not built")
                    left_out = True
        return left_out


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    if "--list" in sys.argv:
        parser.add_argument("--list", action="store_true")
        parser.add_argument("source")
        parser.add_argument("pages", nargs="+")
        return show_list(parser.parse_args())
    for name in ("moserhex", "source", "work", "page"):
        parser.add_argument(name)
    for name in ("--sample", "--python", "--python-path"):
        parser.add_argument(name)
    arguments = parser.parse_args()
    with open(os.path.join(arguments.source, arguments.page), encoding="utf-8") as file:
        blocks = blocks_of(arguments.page, file.read())
    left_out = Runner(arguments).run(blocks)
    print(summary_of(blocks))
    return 77 if left_out else 0


def summary_of(blocks):
    shown = [block for block in blocks if block.language in RUN + COMPARED]
    not_run = [block for block in shown if block.reasons]
    compared = [block for block in shown if block.language in COMPARED and not block.reasons]
    return (f"{len(shown)} blocks: {len(shown) - len(not_run) - len(compared)} run, {len(compared)} compared with built files, "
            f"{len(not_run)} not run")


def pages_of(source):
    """All pages that may have blocks."""
    folders = ("", "Documentation", "Documentation/Commands", "Examples")
    return {os.path.join(folder, name) for folder in folders for name in os.listdir(os.path.join(source, folder))
            if name.endswith(".md")}


def show_list(arguments):
    for page in sorted(pages_of(arguments.source) - set(arguments.pages)):
        with open(os.path.join(arguments.source, page), encoding="utf-8") as file:
            if any(block.language in RUN + COMPARED for block in blocks_of(page, file.read())):
                fail(f"{page} has blocks to run and is not in the list")
    blocks = []
    for page in arguments.pages:
        with open(os.path.join(arguments.source, page), encoding="utf-8") as file:
            blocks += blocks_of(page, file.read())
    for block in blocks:
        if block.reasons:
            print(f"not run: {block.where}: {'; '.join(block.reasons)}")
    print(summary_of(blocks))
    return 0


if __name__ == "__main__":
    sys.exit(main())
