#!/usr/bin/env python3
"""Each line of a checklist has exactly one block in the scripts that work the console, and the other way round."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
listed = re.findall(r"^- (\S+) ", (root / "tests/checklist/makers.md").read_text(), re.M)
blocks = []
for script in sorted((root / "tests/scripts/gui").glob("checklist_*.lua")):
    blocks += re.findall(r'^block\("([^"]+)"', script.read_text(), re.M)

wrong = [f"{name}: no block" for name in listed if name not in blocks]
wrong += [f"{name}: a block without a line in the list" for name in blocks if name not in listed]
wrong += [f"{name}: {blocks.count(name)} blocks" for name in set(blocks) if blocks.count(name) > 1]
print(f"{len(listed)} lines, {len(blocks)} blocks")
print("\n".join(wrong))
sys.exit(bool(wrong))
