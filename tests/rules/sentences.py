#!/usr/bin/env python3
"""Prints every sentence that a user can read, with its place, so that they can be read in one go.

    tests/rules/sentences.py [ROOT] [FOLDER...]

A sentence is a string literal of at least three words; literals that follow each other are one.
"""
import pathlib
import re
import sys

TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\((.*?)\)\1"|"((?:[^"\\\n]|\\.)*)"|\'(?:[^\'\\]|\\.)*\'|\d[\w\']*|\s+|.', re.S)
FOLDERS = ("core", "transports", "gui", "panels")


def literals(text):
    """(line, literal) of each run of adjacent string literals."""
    begun, parts, line = 0, [], 1
    for token in TOKEN.finditer(text):
        whole = token.group(0)
        if token.group(3) is not None or token.group(2) is not None:
            if not parts:
                begun = line
            parts.append(token.group(3) if token.group(3) is not None else token.group(2))
        elif not whole.isspace() and not whole.startswith(("//", "/*")) and parts:
            yield begun, "".join(parts)
            parts = []
        line += whole.count("\n")


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    for folder in sys.argv[2:] or FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            for line, literal in literals(path.read_text(encoding="utf-8")):
                if len(re.findall(r"[A-Za-z']{2,}", literal)) >= 3 and " " in literal:
                    print(f"{path.relative_to(root)}:{line}: {literal}")


if __name__ == "__main__":
    main()
