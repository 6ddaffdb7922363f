#!/usr/bin/env python3
"""What ezdxf (Debian: python3-ezdxf) reads in drawing files: paths, their length and box, the unit, and what is in them
that lines and arcs do not show.   measure.py FOLDER writes FOLDER/expected.txt."""
import math
import sys
from pathlib import Path

import ezdxf
from ezdxf.math import Vec3

CHORD = 1e-6  # far below what the reader is asked for
DRAWN = {"LINE", "POINT", "ARC", "CIRCLE", "POLYLINE", "LWPOLYLINE", "ELLIPSE", "SPLINE", "INSERT"}
PARTS = {"VERTEX", "SEQEND", "BLOCK", "ENDBLK", "VIEWPORT"}
UNITS = dict(enumerate(
    "in ft mi mm cm m km uin mil yd angstrom nm um dm dam hm Gm au ly pc us-ft us-in us-yd us-mi".split(), 1))


def simple(entity, doc, insert_layer="0"):
    """The entity as lists of lines, arcs, circles, ellipses and splines, without what is hidden. What lies on 0 goes with
    its insert; an insert that is frozen is so with all that is in it."""
    kind = entity.dxftype()
    name = insert_layer if entity.dxf.layer == "0" else entity.dxf.layer
    layer = doc.layers.get(name) if name in doc.layers else None
    hidden = entity.dxf.get("invisible", 0) or (layer and (layer.is_frozen() or (layer.is_off() and kind != "INSERT")))
    if hidden or kind not in DRAWN:
        return
    if kind == "INSERT":
        for single in entity.multi_insert() if entity.mcount > 1 else [entity]:
            for part in single.virtual_entities():
                yield from simple(part, doc, name)
    elif kind in ("POLYLINE", "LWPOLYLINE"):
        yield list(entity.virtual_entities())
    else:
        yield [entity]


def arc_of(entity):
    """Centre, radius, begin and sweep in degrees, in the world."""
    centre = entity.ocs().to_wcs(entity.dxf.center)
    begin, end = (0, 360) if entity.dxftype() == "CIRCLE" else (entity.dxf.start_angle, entity.dxf.end_angle)
    sweep = (end - begin) % 360 or 360
    if entity.dxf.extrusion.z < 0:
        begin, sweep = 180 - begin, -sweep
    return centre, entity.dxf.radius, begin, sweep


def outline(entity):
    """Length, and points of its outline: the outermost among them."""
    kind = entity.dxftype()
    if kind == "POINT":
        return 0, [entity.dxf.location]
    if kind == "LINE":
        return entity.dxf.start.distance(entity.dxf.end), [entity.dxf.start, entity.dxf.end]
    if kind in ("ARC", "CIRCLE"):
        centre, radius, begin, sweep = arc_of(entity)
        low, high = sorted((begin, begin + sweep))
        angles = [low, high] + [a for a in range(-1440, 1441, 90) if low <= a <= high]
        return radius * math.radians(abs(sweep)), [centre + Vec3.from_deg_angle(a, radius) for a in angles]
    points = list(entity.flattening(CHORD))
    return sum(p.distance(q) for p, q in zip(points, points[1:])), points


# What ezdxf counts as well, but has no length: Inkscape closes its paths with single points.
WITHOUT_LENGTH = {"inkscape_r14.dxf": ["left out 14 LWPOLYLINE 1114: it has no length",
                                       "left out 30 LWPOLYLINE 1930: it has no length"]}


def left_out(path):
    """Number, kind and line of what is neither drawn nor a part of something: found in the text, without ezdxf."""
    found, number, section = list(WITHOUT_LENGTH.get(path.name, [])), 0, ""
    lines = path.read_text(errors="replace").splitlines()
    for at in range(0, len(lines) - 1, 2):
        code, value = lines[at].strip(), lines[at + 1].strip()
        if code == "2" and lines[at - 1].strip() == "SECTION":
            section = value
        elif code == "0" and value == "ENDSEC":
            section = ""
        elif code == "0" and section in ("BLOCKS", "ENTITIES"):
            number += 1
            if value not in DRAWN | PARTS:
                found.append(f"left out {number} {value} {at + 2}")
    return found


def read(path):
    """Lines of a table."""
    doc = ezdxf.readfile(path)
    paths, length, points, exact = 0, 0, [], True
    for entity in doc.modelspace():
        for parts in simple(entity, doc):
            outlines = [outline(part) for part in parts]
            own_length = sum(more for more, _ in outlines)
            paths += own_length > 0 or entity.dxftype() == "POINT"
            length += own_length
            for part, (_, its_points) in zip(parts, outlines):
                points += its_points
                exact = exact and part.dxftype() not in ("ELLIPSE", "SPLINE")
    table = [f"paths {paths}", f"length {length:.9f}"]
    if points:
        xs, ys = [p.x for p in points], [p.y for p in points]
        table.append(f"box {min(xs):.9f} {min(ys):.9f} {max(xs):.9f} {max(ys):.9f}")
    table.append("exact" if exact else "near")
    told = "$INSUNITS" in path.read_text(errors="replace")  # ezdxf adds one where there is none
    table.append(f"unit {UNITS.get(doc.header['$INSUNITS'], 'none') if told else 'none'}")
    return table


def block(name, table):
    return "\n  ".join([name] + table) + "\n"


HEAD = """# For each file what a reader has to find: paths, their length and box (left, bottom, right, top), within 1e-6
# (exact) or within the tolerance of chords (near); the unit; and what is left out: number, kind, line.
"""


def main():
    folder = Path(sys.argv[1])
    files = sorted(folder.glob("*.dxf"))
    (folder / "expected.txt").write_text(HEAD + "".join(block(f.name, read(f) + left_out(f)) for f in files))


if __name__ == "__main__":
    main()
