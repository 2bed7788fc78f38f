# Manual of SUSPENSION: sphinx-build -W -b html doc/src OUTPUT-FOLDER

from pygments.lexers.special import TextLexer
from sphinx.highlighting import lexers

project = "SUSPENSION"
author = copyright = "the SUSPENSION authors"

extensions = ["sphinx.ext.extlinks", "sphinx.ext.mathjax"]

# Pages of LAMMPS' own manual, :lammps:`fix deform <fix_deform>`. Inside LAMMPS they become :doc:.
extlinks = {"lammps": ("https://docs.lammps.org/%s.html", "%s")}

lexers["LAMMPS"] = TextLexer()    # code-block:: LAMMPS, as in LAMMPS' manual
highlight_language = "none"

html_theme = "alabaster"
html_copy_source = False
