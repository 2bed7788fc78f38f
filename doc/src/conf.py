# Manual of SUSPENSION as HTML: tools/manual.sh [FOLDER]

import os
import re
import shutil
from pathlib import Path

from pygments.lexers.special import TextLexer
from sphinx.highlighting import lexers
from sphinx.util import logging

project = "SUSPENSION"
author = copyright = "the SUSPENSION authors"

extensions = ["sphinx.ext.extlinks", "sphinx.ext.mathjax"]

# Pages of LAMMPS' own manual, :lammps:`fix deform <fix_deform>`. Inside LAMMPS they become :doc:.
extlinks = {"lammps": ("https://docs.lammps.org/%s.html", "%s")}

lexers["LAMMPS"] = TextLexer()    # code-block:: LAMMPS, as in LAMMPS' manual
highlight_language = "none"

html_theme = "alabaster"
html_theme_options = {"page_width": "min(1200px, 96vw)", "body_max_width": "none", "sidebar_width": "230px",
                      "show_powered_by": False}
html_static_path = ["_static"]
html_css_files = ["suspension.css"]
html_copy_source = False

# Formulas without a network: MathJax 2 of the Debian package libjs-mathjax is copied beside the pages. It draws in SVG,
# whose fonts are scripts, so that browsers take them from a folder, too. MATHJAX: another place of MathJax 2.
MATHJAX = Path(os.environ.get("MATHJAX", "/usr/share/javascript/mathjax"))
MATHJAX_PARTS = ["MathJax.js", "config/TeX-AMS_SVG.js", "extensions", "jax/element", "jax/input/TeX", "jax/output/SVG"]
if (MATHJAX / "MathJax.js").is_file():
    mathjax_path = "mathjax/MathJax.js"
    mathjax2_config = {"config": ["TeX-AMS_SVG.js"], "showMathMenu": False, "messageStyle": "none",
                       "menuSettings": {"assistiveMML": False}}
else:
    logging.getLogger(__name__).info(f"no MathJax in {MATHJAX}: the formulas of these pages need a network")


def copy_mathjax(app, exception):
    """Only the parts that draw formulas, 2 of 54 MB."""
    if exception is None and app.builder.format == "html" and (MATHJAX / "MathJax.js").is_file():
        for part in MATHJAX_PARTS:
            source, target = MATHJAX / part, Path(app.outdir) / "_static" / "mathjax" / part
            target.parent.mkdir(parents=True, exist_ok=True)
            if source.is_dir():
                other_fonts = shutil.ignore_patterns("STIX-Web", "Asana-Math", "Gyre-*", "Latin-Modern", "Neo-Euler")
                shutil.copytree(source, target, dirs_exist_ok=True, ignore=other_fonts)
            else:
                shutil.copy(source, target)


def let_tables_scroll(app, pagename, templatename, context, doctree):
    """A table in a block of its own, which scrolls where it is wider than the page."""
    if "body" in context:
        context["body"] = re.sub(r'<table class="docutils.*?</table>', r'<div class="table-scroll">\g<0></div>', context["body"], flags=re.DOTALL)


def setup(app):
    app.connect("build-finished", copy_mathjax)
    app.connect("html-page-context", let_tables_scroll)
