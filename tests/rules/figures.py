#!/usr/bin/env python3
"""What the house measures: lines, functions, its largest classes, and includes against its arrows.
    figures.py [HOUSE]
Functions and classes are those that universal-ctags finds. A function is as long as its lines from name to last brace.
Its figures are read beside those of the last release (assets/manual/figures.md); no budget hangs on them."""
import collections
import json
import pathlib
import subprocess
import sys

HOUSE = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
ROOMS = ("core", "transports", "gui", "panels")


def sources(room):
    return [f for f in sorted((HOUSE / room).rglob("*")) if f.suffix in (".h", ".cpp")]


def tags(files):
    """Functions with a body, members, prototypes in classes, classes and structures."""
    command = ["ctags", "--output-format=json", "--fields=+neSK", "--kinds-C++=fmpcs", "-L", "-", "-f", "-"]
    listed = subprocess.run(command, input="\n".join(map(str, files)), capture_output=True, text=True, check=True).stdout
    return [json.loads(line) for line in listed.splitlines()]


def percentile(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))] if ordered else 0


def readable(tag):
    """Without the names that ctags gives to what has none; one that has none itself is known by its place."""
    parts = [p for p in full_name(tag).split("::") if not p.startswith("__anon")]
    place = f" ({pathlib.Path(tag['path']).relative_to(HOUSE)}:{tag['line']})"
    return "::".join(parts) + (place if tag["name"].startswith("__anon") else "")


def lengths(found):
    """(lines, name, file) of each function."""
    return [(t["end"] - t["line"] + 1, readable(t), t["path"])
            for t in found if t["kind"] == "function" and "end" in t]


def full_name(tag):
    return (tag["scope"] + "::" if "scope" in tag else "") + tag["name"]


def classes(found):
    """Name -> (members, functions): what stands between the braces of the class."""
    bodies = {(full_name(t), t["path"]): t for t in found if t["kind"] in ("class", "struct") and "end" in t}
    parts = collections.defaultdict(lambda: [0, 0])
    for t in found:
        body = bodies.get((t.get("scope"), t["path"]))
        if not body or not body["line"] <= t["line"] <= body["end"]:
            continue
        if t["kind"] in ("member", "function", "prototype"):
            parts[readable(body)][t["kind"] != "member"] += 1
    return parts


def print_lines():
    print(f"{'':12} {'files':>6} {'lines':>8} {'longest file':>13}")
    for room in (*ROOMS, "tests"):
        counts = [len(f.read_text(encoding="utf-8", errors="replace").splitlines()) for f in sources(room)]
        print(f"{room:12} {len(counts):6} {sum(counts):8} {max(counts, default=0):13}")


def print_functions(found):
    by_room = collections.defaultdict(list)
    for lines, name, path in lengths(found):
        by_room[pathlib.Path(path).relative_to(HOUSE).parts[0]].append((lines, name, path))
    print(f"\n{'functions':12} {'number':>6} {'p50':>4} {'p90':>4} {'max':>4}  the longest")
    for room in ROOMS:
        all_lengths = [lines for lines, _, _ in by_room[room]]
        longest = max(by_room[room], default=(0, "", ""))
        print(f"{room:12} {len(all_lengths):6} {percentile(all_lengths, 0.5):4} {percentile(all_lengths, 0.9):4} "
              f"{longest[0]:4}  {longest[1]}")


def print_classes(found):
    print(f"\n{'the ten largest classes':44} {'members':>8} {'functions':>10}")
    for name, (members, functions) in sorted(classes(found).items(), key=lambda c: -sum(c[1]))[:10]:
        print(f"{name:44} {members:8} {functions:10}")
    print(f"\n{'the ten with most members':44} {'members':>8} {'functions':>10}")
    for name, (members, functions) in sorted(classes(found).items(), key=lambda c: -c[1][0])[:10]:
        print(f"{name:44} {members:8} {functions:10}")


def print_includes():
    rules = pathlib.Path(__file__).with_name("include_rules.py")
    told = subprocess.run([sys.executable, rules, HOUSE], capture_output=True, text=True, check=False)
    against = told.stdout.splitlines() if told.returncode else []
    print(f"\nincludes against the arrows: {len(against)}")
    print("\n".join(against), end="\n" * bool(against))


def main():
    print_lines()
    found = tags([f for room in ROOMS for f in sources(room)])
    print_functions(found)
    print_classes(found)
    print_includes()


main()
