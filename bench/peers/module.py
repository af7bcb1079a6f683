"""Complete lists through the Python module: seconds of processor time for each, and those of the import.

    module.py DIRECTORY      where the module is
"""
import json
import statistics
import sys
import time

sys.path.insert(0, sys.argv[1])
begin = time.process_time()
import stickslip

imported = time.process_time() - begin


def seconds(family, example):
    def once():
        start = time.process_time()
        stickslip.orbits(family, example=example)
        return time.process_time() - start

    once()
    return statistics.median(once() for _ in range(31))


print(json.dumps({"import": imported, "S": seconds("symmetric", "S"), "P": seconds("nonsticking", "P")}))
