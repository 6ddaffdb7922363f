#!/usr/bin/env python3
"""Clean builds compile files of one library in batches (CMakeLists.txt, HW_BATCHES). There, what two files hide under
one name in the same namespace would meet: each such name may be used once in a library, and not as the name of a type,
function or constant in a header beside it.
    batch_rules.py [HOUSE]"""
import collections
import json
import pathlib
import subprocess
import sys

HOUSE = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
# Folders whose files may share a batch, and what of them belongs to another library or is compiled by itself.
LIBRARIES = {
    "core": [], "transports": [], "gui": ["gui/app", "gui/model"], "gui/app": [], "gui/model": [], "panels": [],
    "tests/core": [], "tests/transports": [], "tests/contract": [], "tests/gui": ["tests/gui/model"], "tests/gui/model": [], "tests/panels": [], "tests/simulation": [],
}


def tags(files, kinds):
    command = ["ctags", "--output-format=json", "--fields=+nSk", "--fields-C++=+{template}", f"--kinds-C++={kinds}", "-f", "-", *map(str, files)]
    lines = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
    return [json.loads(line) for line in lines]


def declared_in(headers):
    """(namespace, name) -> header. What is hidden keeps a function of its name from being found, or makes it ambiguous."""
    return {(t.get("scope", ""), t["name"]): t["path"] for t in tags(headers, "sgtcpfv") if t.get("scopeKind") == "namespace"}


def hidden(files):
    """(namespace, name, kind and signature, file) of all that is static or in an unnamed namespace."""
    for tag in tags(files, "fvsgtec"):
        space, anonymous, inner = tag.get("scope", "").partition("::__anon")
        static = not anonymous and tag["pattern"].startswith("/^static ")
        if (anonymous or static) and "::" not in inner and tag.get("scopeKind") == "namespace":
            template = " template" if "template" in tag else ""
            yield space, tag["name"], tag["kind"] + template + tag.get("signature", ""), tag["path"]


def clashes(folder, without):
    files = [f for f in sorted((HOUSE / folder).rglob("*.cpp"))
             if not any(f.is_relative_to(HOUSE / w) for w in without)]
    found = collections.defaultdict(dict)
    for space, name, what, path in hidden(files):
        found[space, name].setdefault(path, set()).add(what)
    headers = declared_in(sorted((HOUSE / folder).rglob("*.h")))
    for (space, name), places in sorted(found.items()):
        if (space, name) in headers:
            yield f"{space}::{name} is hidden in {', '.join(sorted(places))} and declared in {headers[space, name]}."
        kinds = [what for each in places.values() for what in each]
        # One with a default argument may be meant by the same call as another without.
        overloads = len(kinds) == len(set(kinds)) and all(k.startswith("function(") and "=" not in k for k in kinds)
        if len(places) > 1 and not overloads:
            yield f"{space}::{name} is hidden in {', '.join(sorted(places))}: give one another name, or share it."


found = [c for folder, without in LIBRARIES.items() for c in clashes(folder, without)]
print("\n".join(found) if found else "no hidden name is used twice")
sys.exit(bool(found))
