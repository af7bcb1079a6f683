#!/usr/bin/env python3
"""Runs every command that a page shows with its output, "$ stickslip …", and compares.

    commands.py PROGRAM PAGE…

"[…]" in what is shown stands for anything, on a line of its own for any lines. Files that are shown, by "$ cat FILE" or
as TOML, are there for the commands that follow.
"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path


def shown_by(page):
    """Pairs of a command and what is shown of its output."""
    for kind, block in re.findall(r"^```(\w*)\n(.*?)^```$", page, re.M | re.S):
        if kind == "toml":
            yield "cat machine.toml", block
        for part in re.split(r"^\$ ", block, flags=re.M)[1:]:
            command, _, output = part.partition("\n")
            yield command, output


def agrees(shown, output):
    parts = [re.escape(part) for part in re.split(r"^\[…\]\n", shown, flags=re.M)]
    pattern = r"(?:.*\n)*?".join(part.replace(re.escape("[…]"), ".*?") for part in parts)
    return re.fullmatch(pattern, output) is not None


def main(program, *pages):
    os.environ["PATH"] = f"{Path(program).resolve().parent}:{os.environ['PATH']}"
    pages = [Path(page).resolve() for page in pages]
    failed, count = 0, 0
    with tempfile.TemporaryDirectory() as place:
        os.chdir(place)
        for page in pages:
            for command, shown in shown_by(page.read_text()):
                if command.startswith("cat "):
                    Path(command.split()[1]).write_text(shown)
                    continue
                if not command.startswith("stickslip "):
                    continue
                run = subprocess.run(command, shell=True, capture_output=True, text=True)
                output = run.stdout or run.stderr
                count += 1
                if run.returncode not in (0, 1, 2) or not agrees(shown, output):
                    failed += 1
                    print(f"{page}: $ {command}\nsays\n{output}\nand not\n{shown}")
    if count == 0:
        sys.exit("no command was found: this test looks at nothing")
    print(f"{count} commands, {failed} of which say something else")
    sys.exit(failed > 0)


main(*sys.argv[1:])
