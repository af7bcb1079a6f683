#!/usr/bin/env python3
"""Whether an audit has written its report whole, and has said so.

    written.py REPORT

REPORT is the directory; what was printed stands beside it in REPORT.json and REPORT.err, the exit code in REPORT.code.
"""

import json
import sys
from pathlib import Path

report = Path(sys.argv[1])


def beside(ending):
    return report.with_name(report.name + ending).read_text()


said, printed = beside(".err"), beside(".json")
assert int(beside(".code")) == (0 if json.loads(printed)["summary"]["decided"] else 2)
assert str(report) in said, said
assert (report / "audit.json").read_text() == printed
for page in ("index", "paper", "statements", "orbits"):
    assert (report / f"{page}.html").read_text().endswith("</html>\n"), page
assert (report / "audit.tex").read_text().endswith("\\end{document}\n")
assert (report / "audit.pdf").exists() == ("is not made" not in said), said
assert not list(report.glob("*.tmp"))
