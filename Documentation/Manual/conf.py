"""How Sphinx makes the manual: Markdown by MyST, the theme Furo; nothing is loaded from elsewhere."""
import pathlib
import re

project = "MoserHex"
author = "the MoserHex authors"
copyright = "the MoserHex authors, Apache-2.0"  # noqa: A001, a name that Sphinx wants
extensions = ["myst_parser"]
html_theme = "furo"
html_title = "MoserHex"
html_show_sphinx = False
html_copy_source = False
html_show_sourcelink = False
myst_heading_anchors = 4
highlight_language = "none"
exclude_patterns = []
html_theme_options = {"light_css_variables": {"font-stack": "sans-serif"}, "dark_css_variables": {"font-stack": "sans-serif"}}


def mend_controls(app, exception):
    """Furo puts div into labels and buttons, where HTML allows span only."""
    for path in pathlib.Path(app.outdir).rglob("*.html") if exception is None else ():
        text = path.read_text(encoding="utf-8")
        mended = re.sub(r"<(label|button)\b.*?</\1>", lambda control: re.sub(r"(</?)div\b", r"\1span", control[0]), text, flags=re.S)
        path.write_text(mended, encoding="utf-8")


def setup(app):
    app.connect("build-finished", mend_controls)
