#!/usr/bin/python3
"""Checks that what the theory pages name exists: tests (`Suite.Name`), keys of references.bib, figures, pages, options
of make_figures.py. Prints what is missing; exit code 1 when anything is.

    /usr/bin/python3 Documentation/Theory/check_pages.py
"""

import re
import sys
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
SOURCE = FOLDER.parent.parent


def known_tests():
    pattern = re.compile(r"^TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\s*\)", re.MULTILINE)
    names = set()
    for root in ("Modules", "Testing", "Applications"):
        for file in (SOURCE / root).rglob("*GTest.cxx"):
            names.update(f"{suite}.{name}" for suite, name in pattern.findall(file.read_text()))
    return names


def main():
    tests = known_tests()
    keys = set(re.findall(r"^@\w+\{(\w+),", (FOLDER.parent / "references.bib").read_text(), re.MULTILINE))
    cited, missing = set(), []
    for page in sorted(FOLDER.glob("*.md")):
        text = page.read_text()
        for name in re.findall(r"`([A-Z]\w+\.[A-Z]\w+)`", text):
            if name not in tests:
                missing.append(f"{page.name}: test {name}")
        for group in re.findall(r"\[([a-z]+\d{4}(?:, [a-z]+\d{4})*)[^\]]*\]", text):
            cited.update(group.split(", "))
            missing += [f"{page.name}: key {key}" for key in group.split(", ") if key not in keys]
        for target in re.findall(r"\]\(([^)#]+)\)", text):
            if not target.startswith("http") and not (FOLDER / target).exists():
                missing.append(f"{page.name}: file {target}")
    print("\n".join(missing) if missing else f"all found; not cited: {', '.join(sorted(keys - cited)) or 'none'}")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
