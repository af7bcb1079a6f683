#!/usr/bin/env bash
# What script/artifact makes leads from every statement, new theorem and claim of the audit to places and files that are
# there, and to a command that the program takes; what is missing is an error.
#
#   artifact.sh SOURCE STAGE OUT
set -euo pipefail
source=$1 stage=$2 out=$3
export PATH=$stage/bin:$PATH
rm -rf "$out"
"$source/script/artifact" --installed "$out" >/dev/null
(cd "$out" && sha256sum --quiet --check SHA256SUMS)
[[ $(find "$out" -type f | wc -l) == $(($(wc -l <"$out/SHA256SUMS") + 1)) ]] || { echo "a file has no sum"; exit 1; }
python3 - "$out" <<'EOF'
import csv, json, re, shlex, subprocess, sys
from pathlib import Path

import yaml

out = Path(sys.argv[1])
audit = json.loads((out / "audit/audit.json").read_text())
rows = list(csv.DictReader(open(out / "map.csv", newline="")))
claims = [claim["id"] for place in audit["places"] for claim in place["claims"]]
for kind, ids in (("statement", [one["id"] for one in audit["statements"]]),
                  ("theorem", [one["id"] for one in audit["results"]]), ("claim", claims)):
    assert ids and [row["id"] for row in rows if row["kind"] == kind] == ids, kind
pages = {page.name: page.read_text() for page in (out / "audit").glob("*.html")}
for row in rows:
    page, anchor = row["report"].removeprefix("audit/").split("#")
    assert f'id="{anchor}"' in pages[page], row
    assert row["certificates"] or row["reason"], f"{row['id']} has neither certificate nor reason"
    for file in row["certificates"].split():
        assert (out / file).is_file(), file
    assert row["command"] or not row["claims"], row
    if row["kind"] == "claim":
        # The certificate states a theorem of this claim.
        name = "claim_" + re.sub(r"\W", "_", row["id"]) + "_"
        text = "".join((out / file).read_text() for file in row["certificates"].split())
        assert not text or name in text, row["id"]
manifest = yaml.safe_load((out / "codecheck.yml").read_text())
assert manifest["version"].startswith("https://codecheck.org.uk/spec/config/")
assert manifest["paper"]["title"] and manifest["paper"]["authors"][0]["name"]
assert len(manifest["manifest"]) >= 5 and all((out / one["file"]).is_file() for one in manifest["manifest"])
# Every figure and table of the note is in the manifest, and made again by the script that is there.
again = out.parent / "artifact-again"
subprocess.run([sys.executable, out / "paper/make.py", "stickslip", again, "--audit", out / "audit", "--parts"], check=True)
parts = sorted(path.name for path in (again / "parts").iterdir())
assert {"motions.pdf", "loads.pdf", "digits.tex", "theorem-uniqueness.tex"} <= set(parts), parts
named = {one["file"] for one in manifest["manifest"]}
for part in parts:
    assert (out / "paper/parts" / part).read_bytes() == (again / "parts" / part).read_bytes(), part
    assert part in ("facts.tex", "setting.tex", "commands.csv") or f"paper/parts/{part}" in named, part
for row in [row for row in rows if row["kind"] == "theorem"] + rows[20:25]:
    run = subprocess.run(shlex.split(row["command"]), capture_output=True, text=True)
    assert run.returncode in (0, 1, 2) and run.stdout, (row["command"], run.stderr)
EOF
# Nothing is named that is not there.
rm "$out"/certificates/Claim_A5_energy.v
if python3 "$source/packaging/artifact.py" "$out" 2>"$out/said"; then
  echo "a certificate that is missing is no error"
  exit 1
fi
grep -q Claim_A5_energy.v "$out/said" || { cat "$out/said"; exit 1; }
