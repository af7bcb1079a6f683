#!/usr/bin/env bash
# Makes the note and the JOSS paper of an audit that is there, and looks at them as their readers do; then puts wrong audits and
# wrong texts to the script that makes them, which must refuse each.
#
#   note.sh PROGRAM SOURCE REPORT
set -euo pipefail
program=$1 source=$2 audit=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  echo "note: $*" >&2
  exit 1
}
make() { python3 "$source/paper/make.py" "$program" "$@"; }

make "$work/made" --audit "$audit"
for name in note paper; do
  log=$work/made/$name.log
  [[ -s $work/made/$name.pdf ]] || fail "there is no $name.pdf"
  ! grep -aE 'Overfull|undefined|multiply defined|Rerun to|Missing character' "$log" >&2 || fail "LaTeX has something to remark on $name"
done
pages=$(sed -nE 's/^Output written on note.pdf \(([0-9]+) pages?.*/\1/p' "$work/made/note.log")
((pages <= 8)) || fail "the note has $pages pages"
words=$(sed '1,/^bibliography:/d; s/<!--[^>]*-->//g' "$source/paper/paper.md" | wc -w)
((words >= 750 && words <= 1750)) || fail "the JOSS paper has $words words"
! grep -q "Warning" "$work/made/note.blg" || fail "BibTeX has something to remark"
# Two signs in a row are a sign that was not read.
! grep -E '[+-] [+-]' "$work"/made/parts/*.tex >&2 || fail "a formula has two signs in a row"

# Each theorem of the note is a result of the audit, whose claims stand below it with the verdicts that they have there.
python3 - "$work/made" "$audit/audit.json" <<'END'
import json, re, sys
from pathlib import Path

parts = Path(sys.argv[1]) / "parts"
audit = json.loads(Path(sys.argv[2]).read_text())
claims = {claim["id"]: claim for place in audit["places"] for claim in place["claims"]}
results = {result["id"]: result["claims"] for result in audit["results"]}
told = {"proved in the kernel": lambda one: one["outcome"]["by_kernel"] and one["outcome"]["verdict"] == "proved",
        "refuted in the kernel": lambda one: one["outcome"]["by_kernel"] and one["outcome"]["verdict"] == "refuted",
        "decided in balls": lambda one: one["status"] == "decided_in_balls"}
made = [*parts.glob("theorem-*.tex"), *parts.glob("claim-*.tex")]
assert len(made) > 10, made
for file in made:
    kind, id = file.stem.split("-", 1)
    text = file.read_text()
    below = [part.split(": ", 1) for part in re.search(r"\\verdicts{(.*)}\n", text)[1].split("; ")]
    names = [re.findall(r"\\claim{([^}]*)}", ids) for _, ids in below]
    assert sorted(sum(names, [])) == sorted(set(results[id] if kind == "theorem" else [id])), file
    for (words, _), ids in zip(below, names):
        assert all(told[words.lower()](claims[one]) for one in ids), (file, words)
for name in ("motions.pdf", "loads.pdf", "digits.tex", "misprints.tex", "refuted.tex", "verdicts.tex"):
    assert (parts / name).stat().st_size > 100, name
    assert f"\n{name},stickslip " in (parts / "commands.csv").read_text(), name
END

refused() {
  if make "$work/wrong" --parts "$@" 2>"$work/said"; then
    fail "it makes a note of what is wrong: $*"
  fi
}
changed() {
  mkdir -p "$work/audit"
  cp "$audit/audit.tex" "$work/audit"
  python3 - "$audit/audit.json" "$1" >"$work/audit/audit.json" <<'END'
import json, sys
audit = json.load(open(sys.argv[1]))
claims = {claim["id"]: claim for place in audit["places"] for claim in place["claims"]}
exec(sys.argv[2])
json.dump(audit, sys.stdout)
END
  refused --audit "$work/audit"
  grep -qF "$2" "$work/said" || fail "of a wrong audit it says $(<"$work/said")"
}
changed 'claims["A5.unique"]["outcome"]["verdict"] = "undecided"' 'a theorem needs A5.unique'
changed 'claims["37.sharp"]["outcome"]["verdict"] = "checked"' 'a theorem needs 37.sharp'
changed '[one.update(id="other") for one in audit["results"] if one["id"] == "symmetry"]' 'no result symmetry'
changed 'audit["statements"].pop()' 'paper.md says'
text() {
  rm -rf "$work/texts"
  cp -r "$source/paper" "$work/texts"
  sed -i "$2" "$work/texts/$1"
  ! cmp -s "$source/paper/$1" "$work/texts/$1" || fail "$2 changes nothing"
  refused --audit "$audit" --sources "$work/texts"
  grep -qF "$3" "$work/said" || fail "of a wrong text it says $(<"$work/said")"
}
text note.tex 's/^\\audited{symmetry}/\\begin{theorem}All is well.\\end{theorem}/' 'that the audit has not made'
text paper.md 's/refutes 6<!--refuted-->/refutes 7/' 'a number without its fact'
