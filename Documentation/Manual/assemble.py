#!/usr/bin/env python3
"""Puts the sources of the manual together, for Sphinx.

    assemble.py MOSERHEX SOURCE OUTPUT

MOSERHEX is the program, SOURCE the repository, OUTPUT a folder that is made anew. The pages of Documentation go to OUTPUT; the
marker <!-- options --> of a page Commands/NAME.md becomes the table of all arguments and options that the program
itself names for the command NAME. A command without a page, or a page without its command or marker, is an error. Links to
files that are not part of the manual become their names.
"""
import json
import os
import re
import shutil
import subprocess
import sys

MARKER = "<!-- options -->"
# Pages from elsewhere in the repository, and where they are in the manual.
FROM_ELSEWHERE = {"CHANGELOG.md": "Project/Changelog.md", "CONTRIBUTING.md": "Project/Contributing.md",
                  "SECURITY.md": "Project/Security.md", "Examples/README.md": "Examples.md"}
LEFT_OUT = ("Manual",)
LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)")


def fail(message):
    sys.exit(f"assemble.py: {message}")


def cell(text):
    """Text of the program in a cell of a Markdown table."""
    text = re.sub(r"([|\\`*_<>\[\]])", r"\\\1", text)
    return text.replace("--", "\\-\\-")  # no dash instead of two hyphens


def values_of(option):
    """What may be given: words, a range, or the kind of thing."""
    names = {"INT": "whole number", "UINT": "whole number", "FLOAT": "number", "TEXT": "text"}
    words = re.search(r"\{([^}]*)\}", option["values"])
    if words:
        return ", ".join(f"`{word}`" for word in words.group(1).split(","))
    span = re.search(r"\[(\S+) - (\S+)\]", option["values"])
    kind = names.get(re.split(r"[: ]", option["values"])[0], "")
    if span:
        low, high = (f"{float(number):g}" if float(number) < 1e6 else str(int(float(number))) for number in span.groups())
        kind += f" from {low} to {high}"
    return kind + (", one or several" if option["several"] and kind else "")


def table_of(command):
    """All arguments and options of a command."""
    rows = ["| argument or option | values | default | |", "| --- | --- | --- | --- |"]
    for option in sorted(command["options"], key=lambda option: not option["place"]):
        name = option["place"] or ", ".join(option["names"])
        words = re.fullmatch(r"(.*?)(?: \[([^\]]+)\])?", option["description"])  # a default in words is in brackets at the end
        notes = [cell(words.group(1))]
        if option["excludes"]:
            notes.append("not with " + ", ".join(f"`{other}`" for other in option["excludes"]))
        default = f"`{option['default']}`" if option["default"] else cell(words.group(2) or "")
        default = "needed" if option["required"] else default
        rows.append(f"| `{name}` | {values_of(option)} | {default} | {'; '.join(notes)} |")
    return "\n".join(rows)


def usage_of(command):
    """The command in one line."""
    words = ["moserhex", command["name"]]
    for option in command["options"]:
        if option["place"]:
            words.append(option["place"] + (" ..." if option["several"] else ""))
    words += [f"{option['names'][0]} ..." for option in command["options"] if option["required"] and not option["place"]]
    return " ".join(words + ["[options]"])


class Manual:
    def __init__(self, program, source, output):
        self.source = source
        self.output = output
        described = subprocess.run([program, "--describe-commands"], check=True, capture_output=True, text=True).stdout
        self.commands = {command["name"]: command for command in json.loads(described)}
        self.places = {}  # of the repository's files in the manual
        for folder, folders, files in os.walk(os.path.join(source, "Documentation")):
            folders[:] = sorted(name for name in folders if name not in LEFT_OUT)
            for name in files:
                path = os.path.relpath(os.path.join(folder, name), source)
                if name.endswith((".md", ".png", ".svg")):
                    self.places[path] = os.path.relpath(path, "Documentation")
        self.places.update(FROM_ELSEWHERE)

    def link(self, path, match):
        """A link of the page `path`, to where the same file is in the manual."""
        picture, text, target = match.groups()
        file_name, mark, anchor = target.partition("#")
        if re.match(r"[a-z]+:", target) or not file_name:
            return match.group(0)
        aim = os.path.normpath(os.path.join(os.path.dirname(path), file_name))
        if not os.path.exists(os.path.join(self.source, aim)):
            fail(f"{path}: link to {target}, which is not there")
        if os.path.isdir(os.path.join(self.source, aim)):
            aim = os.path.join(aim, "README.md")
        if aim in self.places:
            here = os.path.dirname(self.places[path])
            return f"{picture}[{text}]({os.path.relpath(self.places[aim], here or '.')}{mark}{anchor})"
        return f"{text} (`{os.path.normpath(os.path.join(os.path.dirname(path), file_name))}` of the source)"

    def page(self, path):
        with open(os.path.join(self.source, path), encoding="utf-8") as file:
            text = file.read()
        if os.path.dirname(path) == "Documentation/Commands":
            name = os.path.splitext(os.path.basename(path))[0]
            if name not in self.commands:
                fail(f"{path}: the program has no command {name}")
            if text.count(MARKER) != 1:
                fail(f"{path}: needs the marker {MARKER} once")
            command = self.commands.pop(name)
            text = text.replace(MARKER, f"```\n{usage_of(command)}\n```\n\n{table_of(command)}")
        parts = re.split(r"(^```.*?^```$)", text, flags=re.S | re.M)  # code stays as it is
        return "".join(part if index % 2 else LINK.sub(lambda match: self.link(path, match), part)
                       for index, part in enumerate(parts))

    def write(self):
        shutil.rmtree(self.output, ignore_errors=True)
        for path, place in sorted(self.places.items()):
            target = os.path.join(self.output, place)
            os.makedirs(os.path.dirname(target), exist_ok=True)
            if path.endswith(".md"):
                with open(target, "w", encoding="utf-8") as file:
                    file.write(self.page(path))
            else:
                shutil.copyfile(os.path.join(self.source, path), target)
        if self.commands:
            fail(f"no page Documentation/Commands/NAME.md of {', '.join(self.commands)}")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        fail("usage: assemble.py MOSERHEX SOURCE OUTPUT")
    Manual(*sys.argv[1:]).write()
