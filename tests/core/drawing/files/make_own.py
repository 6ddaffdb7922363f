#!/usr/bin/env python3
"""Makes the drawings of own/, one for each corner of the format, and their table: measured by ezdxf, or reasoned by hand
where ezdxf reads the file otherwise or not at all (the formula stands beside it).   make_own.py"""
from pathlib import Path

import measure
from own_bad import BAD
from own_curves import CURVES
from own_inserts import INSERTS

FOLDER = Path(__file__).parent / "own"


def main():
    FOLDER.mkdir(exist_ok=True)
    for old in FOLDER.iterdir():
        old.unlink()
    table = measure.HEAD + "# Only what is shown counts. A number with a formula beside it was reasoned by hand, all others are ezdxf's.\n"
    for name, make in sorted({**CURVES, **INSERTS, **BAD}.items()):
        path = FOLDER / f"{name}.dxf"
        made = make()
        if isinstance(made, tuple):  # bytes, and what is said of them
            path.write_bytes(made[0])
            table += measure.block(path.name, [f"refused: {made[1]}"])
            continue
        path.write_bytes(made.finish().encode())
        table += measure.block(path.name, (made.by_hand or measure.read(path)) + made.left_out)
    (FOLDER / "expected.txt").write_text(table)


main()
