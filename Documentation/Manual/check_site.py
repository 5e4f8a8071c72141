#!/usr/bin/env python3
"""Checks the built manual: valid HTML, nothing loaded from elsewhere, no dead link within the site, every command and option there.

    check_site.py HTML MOSERHEX

HTML is the folder of the site, MOSERHEX the program. Needs HTML Tidy (Debian: tidy). Ends with 1 and says what is wrong.
"""
import html.parser
import json
import os
import re
import subprocess
import sys
import urllib.parse

# What makes a browser load something, in contrast to a link that a reader follows.
LOADS = {("script", "src"), ("img", "src"), ("source", "src"), ("iframe", "src"), ("embed", "src"), ("object", "data"),
         ("audio", "src"), ("video", "src"), ("input", "src"), ("link", "href"), ("image", "href"), ("use", "href")}


class Page(html.parser.HTMLParser):
    """The identifiers of a page, its links, and what it loads."""

    def __init__(self, path):
        super().__init__(convert_charrefs=True)
        self.identifiers = set()
        self.links = []
        self.loads = []
        self.words = []
        with open(path, encoding="utf-8") as file:
            self.feed(file.read())

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        for name in ("id", "name"):
            if given.get(name):
                self.identifiers.add(given[name])
        for name, value in attributes:
            if (tag, name) in LOADS and value:
                self.loads.append(value)
            elif name == "srcset" and value:
                self.loads += [part.split()[0] for part in value.split(",")]
            elif (tag, name) == ("a", "href") and value:
                self.links.append(value)

    def handle_data(self, data):
        self.words.append(data)


def is_elsewhere(address):
    return re.match(r"([a-z][a-z0-9+.-]*:)?//", address, re.I) is not None


class Site:
    def __init__(self, folder):
        self.folder = os.path.realpath(folder)
        self.faults = []
        self.pages = {}
        self.styles = []
        for parent, _, files in os.walk(self.folder):
            for name in files:
                path = os.path.join(parent, name)
                if name.endswith(".html"):
                    self.pages[path] = Page(path)
                elif name.endswith(".css"):
                    self.styles.append(path)

    def fault(self, path, what):
        self.faults.append(f"{os.path.relpath(path, self.folder)}: {what}")

    def check_html(self):
        paths = sorted(self.pages)
        for begin in range(0, len(paths), 100):  # Tidy names no file, so one of a faulty hundred at a time
            some = paths[begin:begin + 100]
            if subprocess.run(["tidy", "-e", "-q", *some], capture_output=True).returncode >= 1:
                for path in some:
                    told = subprocess.run(["tidy", "-e", "-q", path], capture_output=True, text=True)
                    lines = [line for line in told.stderr.splitlines() if not is_tolerated(line)]
                    if lines:
                        self.fault(path, "; ".join(lines[:3]))

    def check_loads(self):
        for path, page in sorted(self.pages.items()):
            for address in page.loads:
                if is_elsewhere(address):
                    self.fault(path, f"loads {address}")
                elif not address.startswith("data:") and not os.path.exists(self.file_of(path, address)):
                    self.fault(path, f"loads {address}, which is not there")
        for path in sorted(self.styles):
            with open(path, encoding="utf-8") as file:
                for address in re.findall(r"(?:url\(|@import\s+(?!url))\s*[\"']?([^\"')\s;]+)", file.read()):
                    if is_elsewhere(address):
                        self.fault(path, f"loads {address}")

    def file_of(self, path, address):
        name = urllib.parse.unquote(re.split(r"[?#]", address)[0])
        return os.path.normpath(os.path.join(os.path.dirname(path), name)) if name else path

    def check_links(self):
        for path, page in sorted(self.pages.items()):
            for address in page.links:
                if re.match(r"[a-z][a-z0-9+.-]*:", address, re.I):
                    continue
                aim = self.file_of(path, address)
                anchor = urllib.parse.unquote(address.partition("#")[2])
                if not os.path.exists(aim):
                    self.fault(path, f"dead link {address}")
                elif anchor == "nested-classes" and "/api/" in path:
                    continue  # Doxygen links to a list that it leaves out when all of it is private
                elif anchor and aim in self.pages and anchor not in self.pages[aim].identifiers:
                    self.fault(path, f"link {address} to a place that is not there")

    def check_commands(self, program):
        described = subprocess.run([program, "--describe-commands"], check=True, capture_output=True, text=True).stdout
        options = 0
        for command in json.loads(described):
            path = os.path.join(self.folder, "Commands", command["name"] + ".html")
            if path not in self.pages:
                self.fault(path, "no page of this command")
                continue
            words = set(" ".join(self.pages[path].words).replace(",", " ").split())
            for option in command["options"]:
                for name in option["names"] or [option["place"]]:
                    options += 1
                    if name not in words:
                        self.fault(path, f"{name} is missing")
        return options


def is_tolerated(line):
    """Notices of Tidy that are no faults of HTML 5: elements without content, which a style sheet fills; the summary of a
    table, which HTML 5 has given up; attributes of SVG, which Tidy does not know."""
    return any(words in line for words in ("trimming empty", 'lacks "summary" attribute', "<svg> proprietary attribute"))


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    site = Site(sys.argv[1])
    if not site.pages:
        sys.exit(f"no page in {sys.argv[1]}")
    site.check_html()
    site.check_loads()
    site.check_links()
    options = site.check_commands(sys.argv[2])
    for fault in site.faults:
        print(fault)
    print(f"{len(site.pages)} pages, {len(site.styles)} style sheets, {options} names of options: {len(site.faults)} faults")
    return 1 if site.faults else 0


if __name__ == "__main__":
    sys.exit(main())
