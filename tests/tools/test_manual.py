"""The manual as HTML: it builds without warnings, its links lead somewhere, and it needs no network."""
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

ROOT = Path(__file__).resolve().parents[2]
SOURCES = ROOT / "doc" / "src"
SKIPPED = 77


class Page(HTMLParser):
    """What a page refers to, and the places that others can refer to."""

    def __init__(self, text):
        super().__init__()
        self.links, self.loads, self.anchors = [], [], set()
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        if "id" in attrs:
            self.anchors.add(attrs["id"])
        if tag == "a" and "href" in attrs:
            self.links.append(attrs["href"])
        elif tag == "link" and attrs.get("rel") != "canonical":
            self.loads.append(attrs["href"])
        elif "src" in attrs:
            self.loads.append(attrs["src"])


class Manual(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()    # pylint: disable=consider-using-with
        cls.addClassCleanup(cls.scratch.cleanup)
        cls.folder = Path(cls.scratch.name) / "manual"
        cls.built = subprocess.run([ROOT / "tools" / "manual.sh", cls.folder], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   text=True, check=False)
        cls.pages = {path: Page(path.read_text(encoding="utf-8")) for path in cls.folder.glob("*.html")}

    def test_builds_without_warnings(self):
        self.assertEqual(self.built.returncode, 0, self.built.stdout)
        names = {path.stem for path in SOURCES.glob("*.rst")}
        self.assertEqual(names - {path.stem for path in self.pages}, set())

    def test_links_lead_somewhere(self):
        self.assertGreater(sum(len(page.links) for page in self.pages.values()), 500)
        for path, page in self.pages.items():
            for link in page.links + page.loads:
                parts = urlsplit(link)
                if parts.scheme:
                    continue
                target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
                self.assertTrue(target.is_file(), f"{path.name}: {link}")
                if parts.fragment and target in self.pages:
                    self.assertIn(unquote(parts.fragment), self.pages[target].anchors, f"{path.name}: {link}")

    def test_needs_no_network(self):
        for path, page in self.pages.items():
            for load in page.loads:
                self.assertEqual(urlsplit(load).scheme + urlsplit(load).netloc, "", f"{path.name} loads {load}")
            self.assertNotRegex(path.read_text(encoding="utf-8"), r"cdn\.|cdnjs", path.name)
        for path in (self.folder / "_static").glob("*.css"):
            for url in re.findall(r"(?:@import\s+|url\()[\"']?([^\"')]+)", path.read_text(encoding="utf-8")):
                self.assertFalse(url.startswith(("http", "//")), f"{path.name} loads {url}")

    def test_formulas_are_drawn_from_here(self):
        static = self.folder / "_static" / "mathjax"
        for name in ("MathJax.js", "config/TeX-AMS_SVG.js", "jax/output/SVG/jax.js", "jax/output/SVG/fonts/TeX/fontdata.js"):
            self.assertTrue((static / name).is_file(), name)
        self.assertIn("_static/mathjax/MathJax.js", self.pages[self.folder / "lubcontact_model.html"].loads)

    def test_tables_are_in_blocks_that_scroll(self):
        for path in self.pages:
            text = path.read_text(encoding="utf-8")
            self.assertEqual(text.count('<div class="table-scroll"><table'), text.count('<table class="docutils'), path.name)


class Sources(unittest.TestCase):
    def test_every_page_is_in_the_index(self):
        index = (SOURCES / "index.rst").read_text(encoding="ascii")
        for path in SOURCES.glob("*.rst"):
            if path.stem != "index":
                self.assertIn(f"\n   {path.stem}\n", index)


if __name__ == "__main__":
    if not (shutil.which("sphinx-build") or Path("/usr/bin/sphinx-build").exists()):
        print("no sphinx-build: tools/setup.sh --tests installs it")
        sys.exit(SKIPPED)
    unittest.main()
