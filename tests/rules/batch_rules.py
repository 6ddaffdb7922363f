#!/usr/bin/env python3
"""Clean builds compile files of one library in batches (CMakeLists.txt, HW_BATCHES). There, what two files hide under
one name in the same namespace would meet: each such name may be used once in a library.
    batch_rules.py [HOUSE]"""
import collections
import json
import pathlib
import subprocess
import sys

HOUSE = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
# Folders whose files may share a batch, and what of them belongs to another library or is compiled by itself.
LIBRARIES = {
    "core": [], "transports": [], "gui": ["gui/app"], "gui/app": [], "panels": [],
    "tests/core": [], "tests/transports": [], "tests/contract": [], "tests/gui": [], "tests/panels": [],
}


def hidden(files):
    """(namespace, name, kind and signature, file) of all that is in an unnamed namespace."""
    command = ["ctags", "--output-format=json", "--fields=+nSk", "--kinds-C++=fvsgtec", "-f", "-", *map(str, files)]
    for line in subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines():
        tag = json.loads(line)
        space, anonymous, inner = tag.get("scope", "").partition("::__anon")
        if anonymous and "::" not in inner and tag.get("scopeKind") == "namespace":
            yield space, tag["name"], tag["kind"] + tag.get("signature", ""), tag["path"]


def clashes(folder, without):
    files = [f for f in sorted((HOUSE / folder).rglob("*.cpp"))
             if not any(f.is_relative_to(HOUSE / w) for w in without)]
    found = collections.defaultdict(dict)
    for space, name, what, path in hidden(files):
        found[space, name].setdefault(path, set()).add(what)
    for (space, name), places in sorted(found.items()):
        kinds = [what for each in places.values() for what in each]
        overloads = len(kinds) == len(set(kinds)) and all(k.startswith("function") for k in kinds)
        if len(places) > 1 and not overloads:
            yield f"{space}::{name} is hidden in {', '.join(sorted(places))}: give one another name, or share it."


found = [c for folder, without in LIBRARIES.items() for c in clashes(folder, without)]
print("\n".join(found) if found else "no hidden name is used twice")
sys.exit(bool(found))
