#!/usr/bin/env python3
"""Makes the note and the JOSS paper, and all that they show, of what the program says.

    make.py PROGRAM DIRECTORY [--audit REPORT] [--parts]

Of `stickslip audit --out` (or of the report that is named), `latex` and the commands below come the theorems with their
verdicts, the tables, the figures and every number of the texts: files in DIRECTORY/parts, whose commands.csv says which command
made which; the sources beside them. Then note.pdf by pdflatex and bibtex, paper.pdf by pandoc; with --parts neither. Fails
where the audit does not say what the texts say: a theorem with a claim that is not proved, a number in paper.md that is another
one. script/paper calls it.
"""

import argparse
import collections
import csv
import functools
import json
import math
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

# The same files from the same sources.
undated = {**os.environ, "SOURCE_DATE_EPOCH": "0", "FORCE_SOURCE_DATE": "1"}
here = Path(__file__).resolve().parent

# What a verdict is called under a theorem; nothing else may stand there.
verdicts = {"proved": "proved in the kernel", "refuted": "refuted in the kernel", "decided_in_balls": "decided in balls"}

moving_belt = "nonsticking --chi 0.3 --eta 4 --us 0.1 --ur 0.2 --V 0.1 --omega 0.6 --p 1"
resonance = "nonsticking --chi 3519/11800 --eta 13924/3519 --us 0.1 --ur 0.12 --V 0 --omega 7/20 --p 3"
# The machine of 37.least, over omega from beside the resonance 0.479 on.
load = {"chi": "0.64", "eta": "7.9", "us": "0.1", "ur": "0.15", "V": "0"}
loads_proved = ("0.492", "0.5", "0.51", "0.525", "0.545", "0.6", "0.64", "0.7")


def fail(words):
    sys.exit(f"paper: {words}")


class Program:
    """The program, and which of its commands made which file."""

    def __init__(self, path):
        self.path, self.made = path, []

    def __call__(self, arguments, of=None):
        run = subprocess.run([self.path, *shlex.split(arguments)], capture_output=True, text=True)
        # 1: something is refuted, 2: undecided, which the texts say where it matters.
        if run.returncode not in (0, 1, 2):
            fail(f"stickslip {arguments}: {run.stderr.strip()}")
        if of:
            self.made.append((of, f"stickslip {arguments}"))
        return run.stdout


class Audit:
    """A report: what `stickslip audit --out` made."""

    def __init__(self, directory):
        self.data = data = json.loads((directory / "audit.json").read_text())
        self.report = (directory / "audit.tex").read_text()
        self.claims = {claim["id"]: claim for place in data["places"] for claim in place["claims"]}
        self.results = {result["id"]: result for result in data["results"]}

    def verdict(self, id):
        """As a key of `verdicts`; anything else is not for a theorem."""
        claim = self.claims[id]
        if claim["status"] == "decided_in_balls":
            return "decided_in_balls"
        outcome = claim["outcome"]
        if not outcome["by_kernel"] or outcome["verdict"] not in verdicts:
            fail(f"a theorem needs {id}, which is {claim['status'].replace('_', ' ')}")
        return outcome["verdict"]

    def facts(self):
        """The numbers of both texts, by name."""
        claims = self.claims.values()
        theorems = [theorem for claim in claims for key in ("outcome", "corrected_outcome", "converse") if claim[key]
                    for theorem in claim[key]["theorems"]]
        facts = {"statements": len(self.data["statements"]), "claims": len(claims), "theorems": len(theorems),
                 "in-kernel": sum(claim["outcome"]["by_kernel"] for claim in claims),
                 "not-in-kernel": sum(not claim["outcome"]["by_kernel"] for claim in claims),
                 "in-balls": sum(claim["status"] == "decided_in_balls" for claim in claims),
                 "results": len(self.results), "new": sum(claim["origin"] == "new" for claim in claims)}
        for one in self.data["summary"]["statuses"]:
            facts[one["status"].replace("_", "-")] = one["count"]
        return facts

    def value(self, id, values, assumption=None):
        """The right side of a claim's printed formula, or of one of its assumptions, in double: to draw with, no proof."""
        text = self.claims[id]["printed"][0]["text"] if not assumption else next(
            one["text"] for one in self.claims[id]["assumptions"] if one["id"] == assumption)
        return evaluate(re.split(r" (?:=|>) ", text, maxsplit=1)[1], values)

    def machine(self, data):
        """The values of data and abbreviations, in double: omega_j, then what 6.d0 and 35.def define."""
        values = {name: evaluate(text, {}) for name, text in data.items()}
        trace, determinant = 1 + values["chi"] * values["eta"], values["chi"] * values["eta"] * (1 - values["chi"])
        for name, sign in (("omega1", -1), ("omega2", 1)):
            values[name] = math.sqrt(trace / 2 + sign * math.sqrt(trace * trace / 4 - determinant))
        for id in ("6.d0", "35.def"):
            for one in self.claims[id]["printed"]:
                name, text = one["text"].split(" = ")
                values[name] = evaluate(text, values)
        return values


@functools.cache
def compiled(text):
    return compile(re.sub(r"\|([^|]*)\|", r"abs(\1)", text.replace("^", "**")), text, "eval")


names = {"__builtins__": {}, **{name: getattr(math, name) for name in ("pi", "sin", "cos", "tan", "sqrt")}, "abs": abs}


def evaluate(text, values):
    return eval(compiled(text), names, values)


# ------------------------------------------------------------------------------------------------------------- theorems

def block(text, environment):
    found = re.search(rf"\\begin{{{environment}}}(?:\[([^\n]*)\])?(?:\\label[^\n]*)?\n(.*?)\\end{{{environment}}}", text, re.S)
    if not found:
        fail(f"stickslip latex printed no {environment}")
    lines = [line for line in found[2].split("\n") if not line.startswith(r"\emergencystretch")]
    return found[1], lines


def set_verdicts(audit, ids):
    """Under a theorem: its claims, by verdict. Claims have the names that stickslip check takes."""
    ids = list(dict.fromkeys(ids))
    told = "; ".join(f"{words}: " + ", ".join(rf"\claim{{{id}}}" for id in ids if audit.verdict(id) == verdict)
                     for verdict, words in verdicts.items() if any(audit.verdict(id) == verdict for id in ids))
    return told[0].upper() + told[1:]


def setting_of(text):
    """The sentences before a theorem that say what it is about."""
    return re.split(r"(?<=\.) (?=[A-Z])", block(text, "theorem")[1][0])


def theorem(audit, id, text, common):
    """A result as the program sets it, without the sentences that the note says once for all its theorems."""
    title, lines = block(text, "theorem")
    own = [sentence for sentence in setting_of(text) if sentence not in common]
    statement, rest = " ".join([*own, lines[1]]), "\n".join(lines[2:])
    items = re.search(r"\\begin{itemize}.*\\end{itemize}\n?", rest, re.S)
    idea = "\n".join(block(text, "proof")[1]).strip()
    return "\n".join([rf"\begin{{theorem}}[{title}]\label{{thm:{id}}}", statement, items[0] if items else "",
                      r"\end{theorem}", rf"\begin{{idea}}{idea}\end{{idea}}",
                      rf"\verdicts{{{set_verdicts(audit, audit.results[id]['claims'])}}}", ""])


def small(formula):
    """For a line of text: brackets of one size, so that the line breaks within them."""
    for long, short in ((r"\left", ""), (r"\right", ""), (r"\quad", r"\;"), (r"\begin{pmatrix}", r"\bigl(\begin{smallmatrix}"),
                        (r"\end{pmatrix}", r"\end{smallmatrix}\bigr)")):
        formula = formula.replace(long, short)
    return formula


def inequality(audit, id):
    """The one formula of a claim, in a display of two lines."""
    left, right = audit.claims[id]["printed"][0]["latex"].split(r" \leq ")
    audit.verdict(id)
    return "\\begin{gather*}\n" + left + "\\\\\n{}\\leq " + right + "\n\\end{gather*}\n"


def proposition(program, audit, id):
    """A claim with all that it assumes, as the proof has it."""
    claim = audit.claims[id]
    words = re.search(r"\\paragraph{(.*) \([^()]*\)}\n", program(f"latex {id}", of=f"claim-{id}.tex"))[1]
    assumed = [one["latex"] for one in claim["assumptions"] + claim["outcome"]["hypotheses"]]
    concluded = [one["latex"] for one in claim["corrected"] or claim["printed"]]
    formulas = lambda latex: "; ".join(f"${small(one)}$" for one in latex)
    return "\n".join([rf"\begin{{proposition}}\label{{claim:{id}}}", f"{words}.", "",
                      rf"\assumed{{{formulas(assumed)}}}", rf"\concluded{{{formulas(concluded)}}}",
                      r"\end{proposition}", rf"\verdicts{{{set_verdicts(audit, [id])}}}", ""])


# --------------------------------------------------------------------------------------------------------------- tables

def rows(table):
    return "".join(" & ".join(row) + r" \\" + "\n" for row in table)


def table_of_verdicts(audit):
    counted = audit.data["summary"]["statuses"]
    return rows([(one["meaning"][0].upper() + one["meaning"][1:], str(one["count"])) for one in counted]
                ) + "\\midrule\n" + rows([("Statements", str(sum(one["count"] for one in counted)))])


def table_of_misprints(audit):
    table = []
    for claim in audit.claims.values():
        if claim["status"] == "misprint_corrected":
            audit.verdict(claim["id"])
            lines = lambda formulas: [f"${one['latex']}$" for one in formulas]
            heads = [(claim["remark"]["place"].split(",")[0], rf"\claim{{{claim['id']}}}"), ("", "")]
            for (place, name), what, formulas in zip(heads, ("printed", "read"), (claim["printed"], claim["corrected"])):
                table += [(place if not k else "", name if not k else "", what if not k else "", formula)
                          for k, formula in enumerate(lines(formulas))]
    return rows(table)


def table_of_digits(audit):
    table = []
    figures = {example["name"]: example["figure"] for example in audit.data["examples"]}
    for claim in audit.claims.values():
        if claim["status"] == "digits_off" and claim["origin"] == "paper" and claim["outcome"]["comparisons"]:
            audit.verdict(claim["id"])
            for one in claim["outcome"]["comparisons"]:
                if one["verdict"] == "refuted":
                    table.append((figures[claim["id"].split(".")[0]].replace(" ", "~"), f"${one['latex']}$",
                                  f"${one['printed']}$", f"${float(one['proved']['mid']):.8f}$"))
    half = (len(table) + 1) // 2
    return rows([(*table[k], *(table[half + k] if half + k < len(table) else [""] * 4)) for k in range(half)])


def table_of_refuted(audit, ids):
    """What the paper says and what is so, as the report sets it."""
    table = []
    for id in ids:
        audit.verdict(id)
        told = re.search(re.escape(rf"\statement{{\claimlink{{{id}}}}}") + r"[^\n]*\n\\field{The paper [^}]*} ([^\n]*)\n"
                         r"\\field{In fact:} ([^\n]*)\n", audit.report)
        if not told:
            fail(f"the report says nothing of {id}")
        table.append((rf"\claim{{{id}}}", told[1], re.sub(r"\\claimlink", r"\\claim", told[2])))
    return rows(table)


# -------------------------------------------------------------------------------------------------------------- figures

def gnuplot(file, script):
    if not shutil.which("gnuplot"):
        fail("gnuplot is missing; script/bootstrap installs it")
    # The text font has no Greek.
    script = re.sub("[α-ω]", r'{/\\"Latin Modern Math\\" \g<0>}', script)
    run = subprocess.run(["gnuplot"], input=script, env=undated, capture_output=True, text=True)
    if run.returncode:
        fail(f"gnuplot: {run.stderr.strip()}")
    # Cairo dates its files.
    file.write_bytes(re.sub(rb"(/CreationDate \(D:)\d{14}", rb"\g<1>19700101000000", file.read_bytes()))


style = """
set terminal pdfcairo size {width}cm,{height}cm font "Latin Modern Roman,9" linewidth 1
set output "{file}"
set border linewidth 0.5
set tics scale 0.5
set style line 1 linecolor rgb "#1f4e9c" linewidth 1.6
set style line 2 linecolor rgb "#c0392b" linewidth 1.6
set style line 3 linecolor rgb "#606060" linewidth 0.8 dashtype 3
set style line 4 linecolor rgb "#2e8b57" linewidth 1.4 dashtype 2
"""


def motion(program, figure, orbit, more=""):
    """Samples of one period as a block of gnuplot's, slip and overshoot apart."""
    text = program(f"simulate --orbit {orbit} {more}--periods 1 --every 0.05 --csv -", of=figure)
    samples = [" ".join([one["phase"], *(one[name] for name in ("x1", "x1'", "x2", "x2'"))])
               for one in csv.DictReader(text.splitlines())]
    # Each up to where the next begins; the last sample is the first of the next period.
    turn = next(k for k, sample in enumerate(samples) if sample.startswith("overshoot"))
    return "\n\n\n".join("\n".join(part) for part in (samples[:turn + 1], samples[turn:]))


def figure_of_motions(program, audit, parts):
    of = "motions.pdf"
    family, k = resonance.split(" ", 1)
    options = dict(re.findall(r"--(\w+) (\S+)", k))
    slope = audit.machine(options)["lambda1"]
    script = style.format(width=15.6, height=5.6, file=parts / of)
    script += f"$belt << E\n{motion(program, of, moving_belt.replace(' ', ':2 ', 1))}\nE\n"
    for name, epsilon in (("left", -0.05), ("middle", 0), ("right", 0.05)):
        more = f"--perturb={epsilon},{epsilon * slope!r},0,0 " if epsilon else ""
        script += f"${name} << E\n{motion(program, of, resonance.replace(' ', ':1 ', 1), more)}\nE\n"
    gnuplot(parts / of, script + """
set multiplot layout 1,2 margins 0.075,0.985,0.175,0.9 spacing 0.1
set xlabel "x_2" offset 0,0.5
set ylabel "x_2'" offset 1.5,0 norotate
set xrange [-4:4]; set yrange [-2.6:2.6]; set ytics 1
set key at graph 0.66,0.74 samplen 1.5 spacing 0.9
set title "a moving belt, V = 0.1" offset 0,-0.7
plot 0.1 with lines linestyle 3 title "V", $belt index 0 using 4:5 with lines linestyle 1 title "slip",\
     $belt index 1 using 4:5 with lines linestyle 2 title "overshoot"
set key at graph 0.66,0.62
set title "resonance, ω_1 = 2ω" offset 0,-0.7
set xlabel "x_1"; set ylabel "x_1'"
set xrange [-1.9:1.9]; set yrange [-0.8:0.8]; set ytics 0.4
plot $left using 2:3 with lines linestyle 1 title "ε = −1/20", $middle using 2:3 with lines linestyle 3 title "ε = 0",\
     $right using 2:3 with lines linestyle 2 title "ε = 1/20"
unset multiplot
""")


def least_loads(audit, omega):
    """In double: what (37), what (36), and what the motion within the slip asks for; the last by sampling."""
    values = audit.machine({**load, "omega": omega})
    slip = 0
    for k in range(1, 200):
        values["t"] = math.pi / values["omega"] * k / 200
        values["g"] = audit.value("37.slip", values, assumption="37.g")
        if values["g"] > 0:
            slip = max(slip, math.sqrt(audit.value("37.slip", values)) / math.sin(values["omega"] * values["t"]))
    return audit.value("37", values), math.sqrt(audit.value("37.sharp", values)), slip


def figure_of_loads(program, audit, parts):
    of = "loads.pdf"
    curves = "\n".join(" ".join(map(repr, (omega, *least_loads(audit, repr(omega)))))
                       for omega in (0.486 + 0.004 * k for k in range(60)))
    data = " ".join(f"--{name} {value}" for name, value in load.items())
    points = []
    for omega in loads_proved:
        near = max(least_loads(audit, omega)[1:])
        around = f"{0.97 * near:.3f}..{1.03 * near:.3f}"
        found = json.loads(program(f"branch nonsticking {data} --omega {omega} --p {around} --json", of=of))
        # No orbit is admissible up to `none`, one is from `one` on.
        none = max(float(part["to"]["mid"]) for part in found["counts"] if not part["admissible"])
        one = min(float(part["from"]["mid"]) for part in found["counts"] if part["admissible"])
        if not found["complete"] or not 0 <= one - none < 1e-3:
            fail(f"at omega = {omega} the branches do not prove one least load near {near}")
        points.append(f"{omega} {one}")
    points = "\n".join(points)
    script = style.format(width=10.5, height=5.8, file=parts / of)
    script += f"$curves << E\n{curves}\nE\n$proved << E\n{points}\nE\n"
    gnuplot(parts / of, script + """
set xlabel "ω" offset 0,0.5
set ylabel "p" norotate offset 1,0
set xrange [0.48:0.725]; set yrange [0:8]
set key top right samplen 2 spacing 0.95
plot $curves using 1:4 with lines linestyle 1 title "x_2' < 0 within the slip",\
     $curves using 1:3 with lines linestyle 2 title "(36), sharp", $curves using 1:2 with lines linestyle 4 title "(37)",\
     $proved with points pointtype 7 pointsize 0.45 linecolor rgb "black" title "least load, proved"
""")


# ---------------------------------------------------------------------------------------------------------------- texts

def check_numbers(text, facts):
    """Every number of paper.md that counts something names its fact, which it is: 180<!--statements-->."""
    body = re.split(r"^---$", text, maxsplit=2, flags=re.M)[2]
    for number, name in re.findall(r"([\d,]+)<!--([\w-]+)-->", body):
        if name not in facts or int(number.replace(",", "")) != facts[name]:
            fail(f"paper.md says {number} {name}; the audit says {facts.get(name, 'nothing of it')}")
    # Other numbers are of citations, commands and years.
    rest = re.sub(r"[\d,]+<!--[\w-]+-->|`[^`]*`|\[@[^\]]*\]|\b19\d\d\b", "", body)
    if (found := re.search(r".{0,30}\d.{0,30}", rest)) is not None:
        fail(f"paper.md has a number without its fact: {found[0]!r}")


def run(command, directory, words):
    done = subprocess.run(command, cwd=directory, env=undated, capture_output=True, text=True, errors="replace")
    if done.returncode:
        fail(f"{words}: {(done.stdout + done.stderr)[-2000:]}")


def main():
    options = argparse.ArgumentParser(usage="make.py PROGRAM DIRECTORY [--audit REPORT] [--parts]")
    options.add_argument("program")
    options.add_argument("directory", type=Path)
    options.add_argument("--audit", type=Path)
    options.add_argument("--parts", action="store_true")
    options.add_argument("--sources", type=Path, default=here, help=argparse.SUPPRESS)
    asked = options.parse_args()
    program = Program(shutil.which(asked.program) or asked.program)
    out = asked.directory.resolve()
    out.mkdir(parents=True, exist_ok=True)
    if not asked.audit:
        program(f"audit --out {shlex.quote(str(out / 'audit'))}")
    audit = Audit(asked.audit or out / "audit")
    note = re.sub(r"^%.*\n", "", (asked.sources / "note.tex").read_text(), flags=re.M)
    paper = (asked.sources / "paper.md").read_text()

    facts = audit.facts()
    check_numbers(paper, facts)
    if found := re.search(r"\\begin{(theorem|proposition|lemma|corollary)}", note):
        fail(f"note.tex has a {found[1]} that the audit has not made")

    parts = out / "parts"
    shutil.rmtree(parts, ignore_errors=True)
    parts.mkdir(parents=True)
    write = lambda name, text: (parts / name).write_text(text)
    ids = re.findall(r"\\audited{([\w-]+)}", note)
    for id in ids:
        if id not in audit.results:
            fail(f"the audit has no result {id}")
        set_verdicts(audit, audit.results[id]["claims"])
    theorems = {id: program(f"latex --theorem {id}", of=f"theorem-{id}.tex") for id in ids}
    said = collections.Counter(sentence for text in theorems.values() for sentence in setting_of(text))
    common = [sentence for sentence, times in said.items() if times > 1]
    for id, text in theorems.items():
        write(f"theorem-{id}.tex", theorem(audit, id, text, common))
    for id in re.findall(r"\\auditedclaim{([\w.]+)}", note):
        write(f"claim-{id}.tex", proposition(program, audit, id))
    for id in re.findall(r"\\auditedformula{([\w.]+)}", note):
        write(f"formula-{id}.tex", inequality(audit, id))
        program.made.append((f"formula-{id}.tex", "stickslip audit --out audit"))
    write("setting.tex", "\n".join(common) + "\n")
    write("facts.tex", "".join(rf"\expandafter\def\csname fact {name}\endcsname{{{value}}}" + "\n"
                               for name, value in facts.items()))
    refuted = re.search(r"\\refuted{([^}]*)}", note)[1].split(",")
    for name, table in (("verdicts", table_of_verdicts(audit)), ("misprints", table_of_misprints(audit)),
                        ("digits", table_of_digits(audit)), ("refuted", table_of_refuted(audit, refuted))):
        write(f"{name}.tex", table)
        program.made.append((f"{name}.tex", "stickslip audit --out audit"))
    figure_of_motions(program, audit, parts)
    figure_of_loads(program, audit, parts)
    with open(parts / "commands.csv", "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(("made", "command"))
        table.writerows(program.made)
    for name in ("note.tex", "paper.md", "paper.bib", "make.py"):
        shutil.copy(asked.sources / name, out)
    if asked.parts:
        return
    latex = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "note"]
    run(latex, out, "pdflatex")
    run(["bibtex", "note"], out, "bibtex")
    run(latex, out, "pdflatex")
    run(latex, out, "pdflatex")
    # JOSS's own head names them `authors`; pandoc's document `author`.
    authors = [name.strip("'") for name in re.findall(r"^  - name: (.*)$", paper.split("\naffiliations:")[0], re.M)]
    run(["pandoc", "paper.md", "--citeproc", "--standalone", "--output=paper.tex",
         *(f"--metadata=author:{name}" for name in authors), "--variable=geometry:a4paper,margin=2.6cm",
         "--variable=colorlinks"], out, "pandoc")
    run([*latex[:-1], "paper"], out, "pdflatex")
    run([*latex[:-1], "paper"], out, "pdflatex")


main()
