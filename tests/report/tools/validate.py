#!/usr/bin/python3
"""Validates JSON against its published schema.

  validate.py SCHEMA-DIRECTORY SCHEMA FILE...

Needs Debian's python3-jsonschema.
"""
import json
import pathlib
import sys

import jsonschema


def validators(directory):
    """Of each schema in the directory, by the name of its file."""
    schemas = {path.name: json.loads(path.read_text()) for path in sorted(pathlib.Path(directory).glob("*.schema.json"))}
    made = {}
    for name, schema in schemas.items():
        jsonschema.Draft202012Validator.check_schema(schema)
        if not schema["$id"].startswith("https://") or not schema["$id"].endswith("/" + name):
            sys.exit(f"{name}: the $id '{schema['$id']}' is no absolute name of it")
        made[name] = jsonschema.Draft202012Validator(schema)
    return made


def faults(validator, instance):
    return [f"{error.json_path}: {error.message[:300]}" for error in validator.iter_errors(instance)]


def main():
    validator = validators(sys.argv[1])[sys.argv[2]]
    said = [f"{name}: {fault}" for name in sys.argv[3:]
            for fault in faults(validator, json.loads(pathlib.Path(name).read_text()))]
    sys.exit("\n".join(said) or 0)


if __name__ == "__main__":
    main()
