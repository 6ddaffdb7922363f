#!/usr/bin/env python3
"""Prints the ten slowest tests.   slowest.py FOLDER LOG...
FOLDER holds what the test binaries have written: gtest's JSON, one file for each process. Each LOG is ctest's output."""
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
    for log in sys.argv[2:]:
        for line in pathlib.Path(log).read_text(encoding="utf-8", errors="replace").splitlines():
            if (whole := WHOLE.match(line)) and not SHARD.search(whole[1]):
                seen.append((float(whole[2]), whole[1]))
    print("\nThe ten slowest:")
    for seconds, name in sorted(seen + list(of_binaries(sys.argv[1])), reverse=True)[:10]:
        print(f"{seconds:8.2f} s  {name}")


main()
