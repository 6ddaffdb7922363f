#!/usr/bin/env python3
"""Each decision that the code cites has an entry in the DECISIONS.md of its family, and each entry says all it has to."""
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
# How an id of the family looks, and where a comment with that form can mean nothing else.
FAMILIES = {
    "arcus": (re.compile(r"\bAMB-(\d{3})\b"), ("core", "transports", "panels", "gui", "tests")),
    "vxm": (re.compile(r"\bV(\d{2,3})\b"), ("core/devices/vxm", "tests/core/devices/vxm")),
    "vme58": (re.compile(r"\bM(\d{2,3})\b"), ("core/devices/vme58", "tests/core/devices/vme58")),
}
COMMENT = re.compile(r"//(.*)")
TABLES = re.compile(r"[^\t]*$")  # of a command table: its last column, where a row cites any
RANGE = re.compile(r"\b(AMB-|V|M)(\d{2,3}) to \1(\d{2,3})\b")
ENTRY = re.compile(r"^### (AMB-\d{3}|[VM]\d{2,3})\b.*\n((?:(?!^#).*\n)*)", re.MULTILINE)
PARTS = ("**Open:**", "**We do:**", "**Why:**", "**How sure:**")
HOW_SURE = re.compile(r"\*\*How sure:\*\* `?(printed|other software does so|guess)`?")
problems = []


def cited(pattern, folders):
    ids = {}
    for folder in folders:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix not in (".h", ".cpp", ".tsv"):
                continue
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                comment = (TABLES if path.suffix == ".tsv" else COMMENT).search(line)
                if not comment:
                    continue
                where = f"{path.relative_to(ROOT).as_posix()}:{number}"
                for found in pattern.finditer(comment[comment.re.groups]):
                    ids.setdefault(found[0], where)
                for prefix, first, last in RANGE.findall(comment[comment.re.groups]):
                    if pattern.fullmatch(prefix + first):
                        for n in range(int(first), int(last) + 1):
                            ids.setdefault(f"{prefix}{n:0{len(first)}}", where)
    return ids


for family, (pattern, folders) in FAMILIES.items():
    book = ROOT / "core" / "devices" / family / "DECISIONS.md"
    name = book.relative_to(ROOT).as_posix()
    entries = dict(ENTRY.findall(book.read_text(encoding="utf-8") + "\n"))
    for decision, where in sorted(cited(pattern, folders).items()):
        if decision not in entries:
            problems.append(f"{where}: {decision} has no entry in {name}")
    for decision, text in entries.items():
        missing = [part for part in PARTS if part not in text]
        if missing:
            problems.append(f"{name}: {decision} does not say {', '.join(missing)}")
        elif not HOW_SURE.search(text):
            problems.append(f"{name}: {decision}: how sure is printed, other software does so, or guess")

for problem in problems:
    print(problem)
sys.exit(bool(problems))
