#!/usr/bin/env python3
"""Passes on what ctest prints, and tells the ten slowest tests at its end.   ctest ... | slowest.py FOLDER
FOLDER holds what the test binaries have written: gtest's JSON, one file for each process."""
import json
import pathlib
import re
import sys

WHOLE = re.compile(r"^\s*\d+/\d+ Test\s+#\d+: (\S+) \.*\s+Passed\s+([\d.]+) sec")
SHARD = re.compile(r"\.\d_of_\d$")


def of_binaries(folder):
    for file in pathlib.Path(folder).glob("*.json"):
        try:
            suites = json.loads(file.read_text(encoding="utf-8"))["testsuites"]
        except (OSError, ValueError, KeyError):
            continue
        for suite in suites:
            for test in suite["testsuite"]:
                yield float(test["time"].rstrip("s")), f"{suite['name']}.{test['name']}"


def main():
    seen = []
    for line in sys.stdin:
        if whole := WHOLE.match(line):
            if not SHARD.search(whole[1]):
                seen.append((float(whole[2]), whole[1]))
        print(line, end="", flush=True)
    print("\nThe ten slowest:")
    for seconds, name in sorted(seen + list(of_binaries(sys.argv[1])), reverse=True)[:10]:
        print(f"{seconds:8.2f} s  {name}")


main()
