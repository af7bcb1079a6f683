#!/usr/bin/python3
"""Validates the JSON of a report against its published schema.

  validate.py SCHEMA-DIRECTORY SCHEMA FILE...

Needs Debian's python3-jsonschema.
"""
import json
import pathlib
import sys

import jsonschema


def main():
    directory = pathlib.Path(sys.argv[1])
    schemas = {path.name: json.loads(path.read_text()) for path in sorted(directory.glob("*.schema.json"))}
    for schema in schemas.values():
        jsonschema.Draft202012Validator.check_schema(schema)
    resolver = jsonschema.RefResolver("", {}, store=schemas)
    validator = jsonschema.Draft202012Validator(schemas[sys.argv[2]], resolver=resolver)
    faults = 0
    for name in sys.argv[3:]:
        for error in validator.iter_errors(json.loads(pathlib.Path(name).read_text())):
            faults += 1
            print(f"{name}: {error.json_path}: {error.message[:300]}", file=sys.stderr)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
