#!/usr/bin/env python3
"""Puts the blocks of pages to the test, in a directory of their own.

    pages.py PROGRAM PAGE…

- "$ stickslip …" is run, and "$ script/trusted", and must print what is shown below it. "[…]" there stands for anything, on a line of its own
  for any lines. Files that are shown, by "$ cat FILE" or as TOML, are there for the commands that follow.
- Python is run where the module is to be found, after the page's commands: >>> by doctest, a script as it is unless
  what it imports is not installed.
- C++ and CMake stand in the examples, or in the sources of the paper, word for word.
- Commands without output, which may take long, are not run: program, scripts and options must exist.
"""

import ast
import doctest
import importlib.util
import os
import re
import shlex
import subprocess
import sys
import tempfile
import textwrap
from pathlib import Path

root = Path(__file__).resolve().parent.parent.parent


def blocks(page):
    """Kind and text of each block; "" where no kind is said, "indented" of those that are that."""
    fence = re.compile(r"^( *)```([^\n]*)\n(.*?)^\1```$", re.M | re.S)
    found = [(kind, textwrap.dedent(text)) for _, kind, text in fence.findall(page)]
    return found + [("indented", line) for line in re.findall(r"^    (.*)\n", fence.sub("", page), re.M)]


def shown_by(kind, block):
    """Pairs of a command and what is shown of its output."""
    if kind == "toml":
        yield "cat machine.toml", block
    for part in re.split(r"^\$ ", block, flags=re.M)[1:]:
        command, _, output = part.partition("\n")
        yield command, output


def agrees(shown, output):
    parts = [re.escape(part) for part in re.split(r"^\[…\]\n", shown, flags=re.M)]
    pattern = r"(?:.*\n)*?".join(part.replace(re.escape("[…]"), ".*?") for part in parts)
    return re.fullmatch(pattern, output) is not None


def said_otherwise(command, shown):
    """Runs it; what is to be complained of."""
    run = subprocess.run(command, shell=True, capture_output=True, text=True)
    output = run.stdout or run.stderr
    if run.returncode in (0, 1, 2, 64) and agrees(shown, output):
        return ""
    return f"$ {command}\nsays\n{output}\nand not\n{shown}"


def unknown(line):
    """What of a command is not there; without running it."""
    words = shlex.split(line, comments=True)
    if "stickslip" in words:
        words = words[words.index("stickslip"):]
        words = words[:words.index("&&")] if "&&" in words else words
        known = subprocess.run([*words[:2], "--help"], capture_output=True, text=True)
        options = [word.partition("=")[0] for word in words[2:] if word.startswith("--")]
        return ([] if known.returncode == 0 else words[:2]) + [
            option for option in options if not re.search(rf"{option}\b", known.stdout)]
    return [word for word in words[:1] if word.startswith("script/") and not (root / word).exists()]


def folded(text):
    """Without comments and white space."""
    return re.sub(r"\s+", "", re.sub(r"(^|\s)(//|#).*", "", text))


def stands_nowhere(kind, block):
    everything = [folded(source.read_text()) for pattern in (
        "examples/**/*.cpp", "examples/**/CMakeLists.txt", "proofs/pascal2012/**/*.cpp") for source in root.glob(pattern)]
    pieces = re.findall(r"find_package\([^)]*|stickslip::\w+", block) if kind == "cmake" else [block]
    return [piece for piece in pieces if not any(folded(piece) in text for text in everything)]


def fails(script):
    """Runs it, unless something that it imports is not installed."""
    nodes = [node for node in ast.walk(ast.parse(script)) if isinstance(node, ast.Import)]
    missing = [a.name for node in nodes for a in node.names if importlib.util.find_spec(a.name) is None]
    if missing:
        print(f"not run without {', '.join(missing)}:\n{script}")
        return ""
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    return run.stderr if run.returncode else ""


def main(program, *pages):
    os.environ["PATH"] = f"{Path(program).resolve().parent}:{os.environ['PATH']}"
    pages = [Path(page).resolve() for page in pages]
    complaints, count = [], 0

    def judge(page, complaint):
        nonlocal count
        count += 1
        if complaint:
            complaints.append(page)
            print(f"{page}: {complaint}")

    with tempfile.TemporaryDirectory() as place:
        os.chdir(place)
        for page in pages:
            every = blocks(page.read_text())
            for kind, block in every:
                for command, shown in shown_by(kind, block):
                    if command.startswith("cat "):
                        Path(command.split()[1]).write_text(shown)
                    elif command.startswith("stickslip "):
                        judge(page, said_otherwise(command, shown))
                    elif command == "script/trusted":
                        judge(page, said_otherwise(f"{root}/{command}", shown))
                if kind in ("sh", "indented") and re.match(r"(stickslip|script/|mpirun)", block):
                    for line in block.splitlines():
                        words = unknown(line)
                        judge(page, words and f"{line}\nthere is no {', '.join(words)}")
                if kind in ("cpp", "cmake"):
                    lost = stands_nowhere(kind, block)
                    judge(page, lost and "this stands in no source:\n" + "\n".join(lost))
            if importlib.util.find_spec("stickslip"):
                for block in (block for kind, block in every if kind == "python"):
                    judge(page, fails(block))
                if any(kind == "pycon" for kind, _ in every):
                    result = doctest.testfile(str(page), module_relative=False)
                    judge(page, result.failed and f"{result.failed} of {result.attempted} lines of Python say else")
    if count == 0:
        sys.exit("no block was found: this test looks at nothing")
    print(f"{count} blocks and commands, {len(complaints)} of which are not so")
    sys.exit(len(complaints) > 0)


main(*sys.argv[1:])
