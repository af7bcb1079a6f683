"""The manual: script/doc."""

import os
import re
import sys
from pathlib import Path

root = Path(__file__).resolve().parent.parent
sys.path.insert(0, os.environ["STICKSLIP_PYTHON"])

project = "stickslip"
author = "The stickslip developers"
release = re.search(r"^project\(stickslip VERSION ([\d.]+)", (root / "CMakeLists.txt").read_text(), re.M).group(1)
extensions = ["myst_parser", "breathe", "sphinx.ext.autodoc", "sphinx.ext.viewcode"]
# Links from a page to files of the repository that are no pages are for readers of the repository.
suppress_warnings = ["ref.myst"]
breathe_projects = {"stickslip": os.environ["STICKSLIP_DOXYGEN"]}
breathe_default_project = "stickslip"
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
html_theme = "classic"
html_show_sourcelink = False
html_show_copyright = False
