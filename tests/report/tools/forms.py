#!/usr/bin/python3
"""Every form of every command with --json against its schema.

  forms.py PROGRAM SCHEMA-DIRECTORY [WORD]      WORD: only the forms whose command line has it

Of each form, that what it prints obeys the schema, and that it would not with a key left out or one too many.
Needs Debian's python3-jsonschema.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

from validate import faults, validators

# The machine of README.md, and one that is given by forces.
MACHINE = """m1 = 1
m2 = 0.8
k1 = 8
k2 = 9
normal_force = 10
friction_sliding = 0.15
friction_at_rest = 0.2
belt_velocity = 0.05
load_amplitude = 4
load_frequency = 0.5
"""
FORCES = re.sub("normal_force.*\n|friction_.*\n", "", MACHINE) + ("friction_force_sliding = 1.5\n"
                                                                 "friction_force_at_rest = 2\nload_phase = 0.1\n")

FORMS = {
    "audit": ["check 47.c", "check 44.H 20 --jobs 1", "prove H1^2(t)-I=H2(t)*H3(t)", "prove H1^2(t)+I=H2(t)*H3(t)"],
    "orbits": [
        "orbits symmetric --example S", "orbits overshooting --example O", "orbits nonsticking --example P",
        "orbits overshooting --example O --phi 0.3", "orbits nonsticking --example P --ur 0.3 --digits 40",
        "orbits nonsticking --example P --omega 0.6+-1e-6", "orbits symmetric --example S --omega 0.5+-0.3 --cells 50",
        "orbits nonsticking --params MACHINE", "orbits overshooting --params FORCES --jobs 1"
    ],
    "words": [
        "orbits OTS --example O", "orbits ST --example S", "orbits OSOTSOST --period 3 --example P",
        "orbits ST --example S --near 0.1,0.2,0,0 --phi 1", "orbits OS --params MACHINE"
    ],
    "pure": [
        "orbits S --example S", "orbits O --example S", "orbits T --example P", "orbits T --example S --p 9",
        "orbits S --params MACHINE"
    ],
    "branches": [
        "branch symmetric --example S --omega 0.586..0.588", "branch nonsticking --example P --omega 0.6..0.61 --at 0.6",
        "branch OTS --example O --ur 0.4375..0.4385 --at 0.438", "branch nonsticking --example P --p 0.9..1.1",
        "branch overshooting --example O --omega 0.9991..1.001",
        "branch overshooting --chi 0.3351 --eta 5.424 --us 0.3421 --V 0.184 --omega 1.037 --p 0.02293 --ur 0.614..0.618 --at 0.6165",
        "branch nonsticking --params MACHINE --along load_amplitude 4..4.1 --at 4", "branch OS --params MACHINE --along m1 1..1.01"
    ],
    "attractors": [
        "attractors --example O --starts 20", "attractors --example P --starts 20 --seed 3 --digits 30",
        "attractors --example P --starts 5 --most-periods 20", "attractors --example S --p 1e-3 --starts 5",
        "attractors --params MACHINE --starts 5",
        "attractors --chi 0.375 --eta 4/3 --us 0.1 --V 1 --omega 0.5 --p 1 --ur 0.2",
        "attractors --example P --along ur 0.25..0.3 --values 3 --starts 5",
        "attractors --example P --along us 0.1..2 --values 3 --starts 3",
        "attractors --params MACHINE --along omega 0.5..0.6 --values 2 --starts 3 --seed 2",
        "attractors --example P --plane x1,x2 --pixels 3",
        "attractors --example O --plane x2,x1' --pixels 3 --through 0.1,0,0,0 --most-periods 300",
        "attractors --params MACHINE --plane x1,x2' --pixels 2"
    ],
    "simulation": [
        "simulate --example O", "simulate --example O --perturb 0.01,0,0,0 --periods 3",
        "simulate --orbit nonsticking:1 --example P --periods 3 --csv SAMPLES",
        "simulate --example S --state 0,0,0,0 --every 0.1", "simulate --example P --state 9,9,9,9 --p 0",
        "simulate --params MACHINE --state 0,0,0,0", "simulate --params FORCES --orbit overshooting:1 --periods 2"
    ],
    "atlas": [
        "atlas symmetric --example S --omega 0.55..0.57 --p 0..0.1 --resolution 3 --out ATLAS",
        "atlas nonsticking --example P --omega 0.6..0.61 --resolution 2 --jobs 1 --out ATLAS1",
        "atlas overshooting --example O --phi 0 --omega 0.5..0.51 --p 0.05..0.051 --resolution 3 --out ATLAS2",
        "atlas symmetric --example S --omega 0.55..0.57 --resolution 6 --time-limit 0.001 --out ATLAS3",
        "atlas symmetric --example S --omega 0.55..0.57 --resolution 6 --resume --out ATLAS3",
        "atlas nonsticking --params RANGES --resolution 1 --out ATLAS4",
        "atlas nonsticking --params RANGES --along k1 1..1.1 --resolution 1 --out ATLAS5"
    ],
    "machine_attractors": [
        "attractors --params TABLES --starts 5", "attractors --params FREE --starts 5 --digits 30 --seed 2",
        "attractors --params DRILL --starts 3", "attractors --params SMOOTH --starts 3",
        "attractors --params TABLES --along belt.velocity -0.01..0.05 --values 3 --starts 3",
        "attractors --params FREE --along spring.1.k -1..1 --values 3 --starts 3",
        "attractors --params TABLES --plane x2,x1' --pixels 3", "attractors --params FREE --plane x1,x1' --pixels 3",
        "attractors --params FREE --plane x1,x1' --pixels 3 --window 0.1,0.1 --neighbourhood"
    ],
    "machine_words": [
        "orbits OTS --params TABLES", "orbits OTS --params TABLES --period 2 --digits 40",
        "orbits OSOT --params TABLES", "orbits OTS --params TABLES --near=-0.02,0.01,0.1,0.05", "orbits ST --params FREE",
        "orbits ST --params FREE --neighbourhood"
    ],
    "machine_steady": ["orbits S --params TABLES", "orbits S --params FREE", "orbits O --params DRILL"],
    "machine_branches": [
        "branch OTS --params TABLES --along load.1.frequency 3.58..3.6",
        "branch ST --params FREE --along belt.velocity 1.2..1.3 --at 1.25",
        "branch OSOT --params TABLES --along frequency 3.58..3.6"
    ],
    "machine_box": [
        "branch OTS --params TABLES --along belt.velocity 0.0495..0.0505 --along spring.1.c 0.59..0.61",
        "branch OTS --params TABLES --along friction.at_rest 13.19..13.51 --along spring.1.c 0.59..0.61 --parts 3",
        "branch OSOT --params TABLES --along belt.velocity 0.04..0.05 --along spring.1.c 0.59..0.61"
    ],
    "machine_steady_branch": [
        "branch S --params FREE --along spring.1.c 0..0.2", "branch S --params TABLES --along belt.velocity 0..1"
    ],
    "machine_simulation": [
        "simulate --params TABLES --state=0,0,0,0", "simulate --params TABLES --state=0,0,0,0 --phi 1 --time 2 --csv SAMPLES",
        "simulate --params FREE --state=0,0 --time 100"
    ],
    "machine_set": [
        "simulate --params TABLES --state=0,0,0,0 --set=1e-6,1e-6,0,1e-5 --time 0.05",
        "simulate --params FREE --state=0,0.1 --set=0.01,0.1 --time 1",
        "simulate --params MACHINE --units si --state=0,0,0,0 --set=1e-5,1e-5,0,1e-4 --time 1"
    ],
    "verification": ["atlas --verify ATLAS --sample 5", "atlas --verify ATLAS5 --sample 2"],
}

# Keys that are there only where they apply.
OPTIONAL = {
    "at", "energy", "periods", "steady_sliding", "forced", "machine", "proved", "proved_at", "pure_slip", "reason", "remarks", "room", "seen", "settles", "stability",
    "units"
}


def printed(program, words):
    run = subprocess.run([program, *words, "--json"], capture_output=True, text=True)
    if run.returncode not in (0, 1, 2):
        sys.exit(f"{' '.join(words)}: exit code {run.returncode}: {run.stderr}")
    return json.loads(run.stdout)


def spoiled(instance):
    yield "a surplus key", {**instance, "surplus": 0}
    for key in instance.keys() - OPTIONAL:
        yield f"{key} left out", {name: value for name, value in instance.items() if name != key}


def short(instance):
    """With a few members of each list: quick to look at."""
    if isinstance(instance, list):
        return [short(one) for one in instance[:4]]
    return {key: short(value) for key, value in instance.items()} if isinstance(instance, dict) else instance


def main():
    program, schemas = sys.argv[1], validators(sys.argv[2])
    only = sys.argv[3] if len(sys.argv) > 3 else ""
    if {f"{name}.schema.json" for name in FORMS} != set(schemas):
        sys.exit(f"the schemas are {', '.join(schemas)}")
    said = []
    with tempfile.TemporaryDirectory() as directory:
        places = {name: str(pathlib.Path(directory, name))
                  for name in ("MACHINE", "FORCES", "SAMPLES", "ATLAS", "ATLAS1", "ATLAS2", "ATLAS3", "ATLAS4", "ATLAS5",
                               "RANGES")}
        pathlib.Path(places["MACHINE"]).write_text(MACHINE)
        examples = pathlib.Path(__file__).resolve().parents[3] / "examples" / "machines"
        places |= {"TABLES": str(examples / "engineer.toml"), "FREE": str(examples / "stribeck.toml"),
                   "SMOOTH": str(examples / "smooth_stribeck.toml"),
                   "DRILL": str(examples / "drill_string.toml")}
        pathlib.Path(places["FORCES"]).write_text(FORCES)
        pathlib.Path(places["RANGES"]).write_text(MACHINE.replace("load_frequency = 0.5", 'load_frequency = "0.5+-0.001"'))
        for name, forms in FORMS.items():
            schema = schemas[f"{name}.schema.json"]
            for form in forms:
                words = [places.get(word, word) for word in form.split()]
                if only not in form or ("--verify" in words and not pathlib.Path(words[2]).exists()):
                    continue  # the latter: without HDF5
                instance = printed(program, words)
                said += [f"{form}: {fault}" for fault in faults(schema, instance)]
                few = short(instance)
                few = instance if faults(schema, few) else few
                said += [f"{form}: {what} is not seen" for what, bad in spoiled(few) if not faults(schema, bad)]
    sys.exit("\n".join(said) or 0)


if __name__ == "__main__":
    main()
