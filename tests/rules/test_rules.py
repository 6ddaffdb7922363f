#!/usr/bin/env python3
"""A test over parameters says why it leaves one of them out: by GTEST_SKIP and its words, not by a bare return.
test_rules.py [ROOT]"""
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
BODY = re.compile(r"^TEST_P\((.*?)\) \{\n(.*?)^\}", re.MULTILINE | re.DOTALL)
LEAVES = re.compile(r"^ *if \((.*)\) return;", re.MULTILINE)


def main():
    seen, problems = 0, []
    for file in sorted((ROOT / "tests").rglob("*.cpp")):
        for name, body in BODY.findall(file.read_text(encoding="utf-8")):
            seen += 1
            problems += [f"{file.relative_to(ROOT)}: {name}: if ({why}) return" for why in LEAVES.findall(body)
                         if why != "HasFatalFailure()"]  # which has said why
    print("\n".join(problems or [f"{seen} tests over parameters"]))
    return 1 if problems or not seen else 0


sys.exit(main())
