#!/usr/bin/env python3
"""What a reviewer needs beside a report and its certificates, of their JSON: codecheck.yml, map.csv, README_ARTIFACT.md.

    artifact.py DIRECTORY      with audit/ of `stickslip audit --out`, certificates/ of `stickslip certify --out`, paper/ of
                               paper/make.py

Fails where a file or a place of a page that it would name is not there. script/artifact calls it.
"""

import csv
import json
import re
import sys
from pathlib import Path

root = Path(__file__).resolve().parent.parent
out = Path(sys.argv[1])
audit = json.loads((out / "audit/audit.json").read_text())
recorded = json.loads((out / "certificates/certificates.json").read_text())
if recorded["program"] != audit["program"]:
    sys.exit("artifact: the certificates are those of another version than the audit's")
certificates = {one["claim"]: one for one in recorded["claims"]}
reasons = {one["claim"]: one["reason"] for one in recorded["without"]}
claims = {claim["id"]: claim for place in audit["places"] for claim in place["claims"]}
anchors = {page.name: set(re.findall(r'\bid="([^"]*)"', page.read_text())) for page in (out / "audit").glob("*.html")}


def at(page, anchor):
    if anchor not in anchors[page]:
        sys.exit(f"artifact: audit/{page} has no place {anchor}")
    return f"audit/{page}#{anchor}"


def files_of(ids):
    """The certificates of these claims, each once."""
    files = list(dict.fromkeys(certificates[id]["file"] for id in ids if id in certificates))
    for file in files:
        if not (out / "certificates" / file).is_file():
            sys.exit(f"artifact: certificates/{file} is not there")
    return " ".join(f"certificates/{file}" for file in files)


def without(ids):
    return "; ".join(f"{id}: {reasons[id]}" for id in ids if id not in certificates)


def coq(ids):
    """What Coq said of them, as far as it was asked."""
    states = [claims[id]["certificate"]["state"] for id in ids]
    return ", ".join(f"{states.count(state)} {state}" for state in dict.fromkeys(states))


def explain(ids):
    return f"stickslip check {' '.join(ids)} --explain" if ids else ""


def rows():
    for one in audit["statements"]:
        ids = one["claims"] + one["or_read"]
        yield ("statement", one["id"], one["place"], "paper", one["words"], one["status"], " ".join(ids),
               at("paper.html", one["id"]), files_of(ids), coq(ids), "; ".join(filter(None, (one["missing"], without(ids)))),
               explain(ids))
    for one in audit["results"]:
        ids = one["claims"]
        yield ("theorem", one["id"], "", "new", one["theorem"], " ".join(dict.fromkeys(claims[id]["status"] for id in ids)),
               " ".join(ids), at("index.html", f"result-{one['id']}"), files_of(ids), coq(ids), without(ids), one["see"])
    for id, one in claims.items():
        yield ("claim", id, one["place"], one["origin"], one["words"], one["status"], " ".join(one["outcome"]["uses"]),
               at("statements.html", id), files_of([id]), coq([id]), without([id]), explain([id]))


names = ("kind", "id", "place", "origin", "words", "status", "claims", "report", "certificates", "coq", "reason", "command")
with open(out / "map.csv", "w", newline="") as file:
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(names)
    writer.writerows(rows())

# A text between quotes is the same in YAML as in JSON.
text = lambda words: json.dumps(words, ensure_ascii=False)
cited = (root / "CITATION.cff").read_text()
title = re.search(r'^title: "(.*)"$', cited, re.M).group(1)
authors = re.findall(r"^  - name: (.*)$", cited.split("authors:")[1].split("\nversion:")[0], re.M)
if not authors:
    sys.exit("artifact: CITATION.cff names no authors as `- name: …`")
paper, program = audit["paper"], audit["program"]
of_paper = f"{paper['author']}, {paper['title']}, {paper['journal']}" if paper["author"] else paper["title"]
manifest = [("audit/audit.json", f"every statement of {of_paper}: verdict, hypotheses, theorems"),
            ("audit/index.html", "the same as pages; audit.tex and, where LaTeX was, audit.pdf for print"),
            ("map.csv", "each statement, each new theorem, each claim: place in the report, certificate, command"),
            ("certificates/Statements.v", "what the certificates for Coq state, to be read"),
            ("certificates/certificates.json", "which file certifies which claim, and what has none, and why")]
manifest += [(f"audit/{page.name}", "the orbits at the data of " + example["figure"]) for example in audit["examples"]
             for page in [out / f"audit/figure-{example['name']}.svg"] if page.exists()]
# The note's figures and tables: what paper/make.py made them with stands in a table beside them.
made = {}
for row in csv.DictReader(open(out / "paper/parts/commands.csv", newline="")):
    made.setdefault(row["made"], []).append(row["command"])
manifest += [(f"paper/parts/{part}", f"of the note, made by paper/make.py of {'; '.join(commands)}")
             for part, commands in made.items()]
manifest += [(f"paper/{name}.pdf", words) for name, words in (("note", "the note on the results"), ("paper", "the JOSS paper"))
             if (out / f"paper/{name}.pdf").exists()]
for file, _ in manifest:
    if not (out / file).is_file():
        sys.exit(f"artifact: {file} is not there")
lines = [f"# Made by script/artifact with {program['name']} {program['version']}. Placeholders, for the authors: paper's authors",
         "# and reference, repository; for the codechecker: codechecker, check_time, summary, report.",
         "---", "version: https://codecheck.org.uk/spec/config/1.0/", "paper:", f"  title: {text(title)}", "  authors:",
         *(f"    - name: {text(name)}" for name in authors), '  reference: "PLACEHOLDER"', "manifest:"]
for file, comment in manifest:
    lines += [f"  - file: {text(file)}", f"    comment: {text(comment)}"]
lines += ['repository: "PLACEHOLDER"', "codechecker:", '  - name: "PLACEHOLDER"', 'check_time: "PLACEHOLDER"',
          'summary: "PLACEHOLDER"', 'report: "PLACEHOLDER"', ""]
(out / "codecheck.yml").write_text("\n".join(lines))

counts = ", ".join(f"{one['count']} {one['status'].replace('_', ' ')}" for one in audit["summary"]["statuses"])
libraries = ", ".join(f"{one['name']} {one['version']}" for one in audit["libraries"])
(out / "README_ARTIFACT.md").write_text(f"""# What {program['name']} {program['version']} found, and how to have it again

Examined: {of_paper}. {len(audit['statements'])} statements: {counts}. {len(claims)} claims, {len(certificates)} of them with a
certificate for Coq, {len(reasons)} without, each for the reason in `map.csv`; {len(audit['results'])} results that are not the paper's.
Made with {libraries}.

- `audit/index.html`: the report; `audit/audit.json`: the same for programs.
- `map.csv`: of each statement, each new theorem and each claim the place in the report, the certificate and the command that
  shows it again.
- `certificates/`: all theorems for the proof assistant Coq; begin with `Statements.v`.
- `paper/`: the note on the results and the JOSS paper; `python3 paper/make.py stickslip again` makes every theorem, figure and
  table of the note again, and with LaTeX and pandoc both PDFs; `paper/parts/commands.csv` says by which command.
- `codecheck.yml`: the manifest, for CODECHECK. What it calls PLACEHOLDER is not known to the program.
- `SHA256SUMS`: `sha256sum --check SHA256SUMS` says whether all files are as they were made.

Again, in a minute: `stickslip audit --compare audit/audit.json` audits everything anew and says what is not the same. One line of
`map.csv`: its command. The certificates, without trust in this program: `make -k -j -C certificates`, then
`stickslip certify --record certificates`; some ten minutes on two cores, with Coq, Coquelicot and Interval.
""")
