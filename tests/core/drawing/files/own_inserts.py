"""Drawings for make_own.py: blocks, layers, units, and what cannot be drawn."""
from own_writer import Dxf

FLAT = "it does not lie in the plane of the drawing"
OTHER = "it is not drawn with lines and arcs"


def with_part():
    """A line, an arc and a circle; the base is not at 0."""
    d = Dxf()
    d.block("PART", "10 1 20 0 30 0")
    d.line_of(0, 0, 2, 0, inside=True)
    d.add("CIRCLE", "10 0 20 0 40 0.5", inside=True)
    d.add("ARC", "10 3 20 1 40 2 50 0 51 135", inside=True)
    d.end_block()
    return d


def insert(d, words, why="", block="PART", **more):
    d.add("INSERT", f"2 {block} {words}", why, **more)


def inserts():
    d = with_part()
    insert(d, "10 20 20 20 30 0")
    insert(d, "10 0 20 -20 30 0 41 2 42 2 43 2 50 30")
    insert(d, "10 50 20 5 30 0 50 -390")
    insert(d, "10 70 20 5 30 0 41 0.001 42 0.001")
    return d


def inserts_mirrored():
    d = with_part()
    insert(d, "10 0 20 0 30 0 41 -1 42 1 50 20")
    insert(d, "10 20 20 0 30 0 41 3 42 -3")
    insert(d, "10 40 20 0 30 0 41 -2 42 -2 50 100")
    return d


def inserts_stretched():
    d = with_part()
    insert(d, "10 20 20 20 30 0 41 2 42 0.5 50 30")
    insert(d, "10 40 20 20 30 0 41 -1 42 3")
    return d


def inserts_in_rows():
    d = with_part()
    insert(d, "10 0 20 0 30 0 70 3 71 2 44 5 45 7")
    insert(d, "10 40 20 0 30 0 50 45 70 2 71 3 44 4 45 3")
    insert(d, "10 80 20 0 30 0 41 -1 42 1 50 10 70 4 44 -6")
    return d


def inserts_below():
    d = with_part()
    insert(d, "10 20 20 20 30 0 50 30 210 0 220 0 230 -1")
    insert(d, "10 5 20 0 30 0 41 2 42 -2 70 2 44 9 210 0 220 0 230 -1")
    return d


def inserts_nested():
    d = with_part()
    d.block("MIDDLE", "10 0 20 2 30 0")
    insert(d, "10 4 20 4 30 0 50 -70 41 0.5 42 0.5", inside=True)
    d.line_of(0, 0, 1, 1, inside=True)
    d.end_block()
    d.block("OUTER")
    insert(d, "10 1 20 1 30 0 41 -2 42 2 70 2 44 11", block="MIDDLE", inside=True)
    d.end_block()
    insert(d, "10 50 20 5 30 0 50 15", block="OUTER")
    return d


def inserts_sheared():
    """Turned first, then stretched: no insert of its own could say that."""
    d = Dxf()
    d.block("BAR")
    d.line_of(0, 0, 1, 0, inside=True)
    d.add("CIRCLE", "10 0 20 0 40 1", inside=True)
    d.end_block()
    d.block("TURNED")
    insert(d, "10 0 20 0 30 0 50 45", block="BAR", inside=True)
    d.end_block()
    insert(d, "10 0 20 0 30 0 41 2 42 1", block="TURNED")
    d.hand("paths 2", "length 11.269587051  # sqrt(2 + 1/2), and an ellipse of 2 and 1: 9.688448221", "box -2 -1 2 1", "near", "unit mm")
    return d


def inserts_of_themselves():
    d = Dxf()
    d.block("A")
    d.line_of(0, 0, 1, 0, inside=True)
    insert(d, "10 1 20 0 30 0", block="B", inside=True)
    d.end_block()
    d.block("B")
    d.line_of(0, 1, 1, 1, inside=True)
    insert(d, "10 1 20 0 30 0", block="A", inside=True)
    d.end_block()
    d.block("SELF")
    insert(d, "10 1 20 0 30 0", block="SELF", inside=True)
    d.end_block()
    insert(d, "10 0 20 0 30 0", "block A contains itself", block="A")
    insert(d, "10 10 20 0 30 0", "block SELF contains itself", block="SELF")
    d.hand("paths 2", "length 2  # both lines once", "box 0 0 2 1", "exact", "unit mm")
    return d


def inserts_of_nothing():
    d = with_part()
    d.block("EMPTY")
    d.end_block()
    d.block("HOLLOW")
    insert(d, "10 0 20 0 30 0", block="EMPTY", inside=True)
    d.end_block()
    insert(d, "10 0 20 0 30 0", "there is no block NOWHERE", block="NOWHERE")
    insert(d, "10 0 20 0 30 0 41 0 42 1", "its scale is 0")
    insert(d, "10 0 20 0 30 0 210 1 220 0 230 0", FLAT)
    insert(d, "10 0 20 0 30 0 70 30000 71 30000 44 1 45 1", block="EMPTY")
    insert(d, "10 0 20 0 30 0 70 30000 71 30000 44 1 45 1", block="HOLLOW")
    insert(d, "10 1 20 0 30 0", block="part")  # names are the same in small letters
    d.hand("paths 3", "length 9.853981634  # 2 + pi + 2 pi 3/4", "box -0.5 -0.5 5 3  # the circle, the arc's end and its top", "exact", "unit mm")
    return d


def layers():
    d = Dxf()
    d.layers(("0", 0, 7), ("cut", 0, 1), ("ice", 1, 7), ("dark", 0, -7), ("locked", 4, 3))
    d.block("B")
    d.line_of(0, 0, 0, 10, inside=True)
    d.line_of(1, 0, 1, 10, inside=True, layer="cut")
    d.end_block()
    for n, layer in enumerate(("cut", "ice", "dark", "locked", "not_in_the_table", "CUT", "Ice")):
        d.line_of(10 * n, 20, 10 * n + 5, 20, layer=layer)
    for n, layer in enumerate(("cut", "ice", "dark")):  # what is frozen hides all of its insert, what is off only its own
        insert(d, f"10 {10 * n} 20 0 30 0", block="B", layer=layer)
    d.add("LINE", "60 1 10 0 20 0 11 99 21 99", "it is hidden in the file", layer="cut")
    d.add("LINE", "60 0 10 0 20 40 11 9 21 40", layer="cut")
    return d


def layers_alone():
    d = Dxf()
    d.layers(("ice", 1, 7))
    d.line_of(0, 0, 5, 5, layer="ice")
    d.hand("paths 0", "length 0  # all is frozen", "exact", "unit mm")
    return d


def unit_inch():
    d = Dxf(unit="1")
    d.line_of(0, 0, 3, 4)
    return d


def unit_missing():
    d = Dxf(unit=None)
    d.line_of(0, 0, 3, 4)
    return d


def unit_odd():
    d = Dxf(unit="17")  # gigametres
    d.line_of(0, 0, 3, 4)
    return d


def texts():
    d = Dxf()
    d.block("SIGN")
    d.add("ATTDEF", "10 0 20 0 40 1 1 none 2 NAME 3 name 70 0", "it is a text", inside=True)
    d.line_of(0, 0, 1, 0, inside=True)
    d.end_block()
    insert(d, "10 5 20 5 30 0 66 1", block="SIGN")
    d.add("ATTRIB", "10 5 20 5 40 1 1 none 2 NAME 70 0", "it is a text")
    d.number += 1
    d.tags("0 SEQEND 8 0")
    d.add("TEXT", "10 0 20 0 40 1 1 margin", "it is a text")
    d.newer = True
    d.add("MTEXT", "10 0 20 0 30 0 40 1 1 margin", "it is a text")
    d.newer = False
    d.line_of(0, 0, 0, 2)
    return d


def filled():
    d = Dxf()
    area = "it is a filled area"
    d.add("SOLID", "10 0 20 0 11 9 21 0 12 0 22 9 13 9 23 9", area)
    d.add("TRACE", "10 0 20 0 11 9 21 0 12 0 22 9 13 9 23 9", area)
    d.add("HATCH", "10 0 20 0 30 0 2 SOLID 70 1 71 0 91 1 92 2 72 0 73 1 93 3 10 0 20 0 10 9 20 0 10 9 20 9 97 0 75 0 76 1 98 0", area)
    d.add("WIPEOUT", "10 0 20 0", OTHER)
    d.line_of(0, 0, 1, 0)
    d.hand("paths 1", "length 1  # the line", "box 0 0 1 0", "exact", "unit mm")
    return d


def in_space():
    d = Dxf()
    d.add("LINE", "10 0 20 0 30 0 11 9 21 9 31 5", "it is not flat")
    d.add("CIRCLE", "10 0 20 0 30 0 40 3 210 0.6 220 0 230 0.8", FLAT)
    d.add("ARC", "10 0 20 0 30 0 40 3 50 0 51 90 210 0 220 1 230 0", FLAT)
    d.add("3DFACE", "10 0 20 0 11 9 21 0 12 9 22 9 13 0 23 9", "it is not flat")
    for kind in ("3DSOLID", "REGION", "BODY", "MESH", "SURFACE"):
        d.add(kind, "70 1", OTHER)
    d.newer = True
    d.add("ELLIPSE", "10 0 20 0 30 0 11 4 21 1 31 2 40 0.4 41 0 42 1", "it is not flat")
    d.add("ELLIPSE", "10 0 20 0 30 0 11 4 21 0 31 0 210 0 220 1 230 0 40 0.4 41 0 42 1", FLAT)
    d.add("SPLINE", "70 0 71 1 72 4 73 2 74 0 40 0 40 0 40 1 40 1 10 0 20 0 30 0 10 9 20 9 30 1", "it is not flat")
    d.newer = False
    d.line_of(0, 0, 1, 0)
    d.hand("paths 1", "length 1  # the line", "box 0 0 1 0", "exact", "unit mm")
    return d


def dimensions():
    d = Dxf()
    d.block("*D1")
    d.line_of(0, -4, 40, -4, inside=True)
    d.end_block()
    d.add("DIMENSION", "2 *D1 10 40 20 -4 11 20 21 -4 70 0 13 0 23 0 14 40 24 0", "it belongs to a dimension")
    d.add("LEADER", "71 1 72 0 73 3 76 2 10 0 20 0 30 0 10 9 20 9 30 0", "it belongs to a dimension")
    d.add("TOLERANCE", "3 STANDARD 10 0 20 0 1 text", OTHER)
    d.line_of(0, 0, 40, 0)
    d.hand("paths 1", "length 40  # the line", "box 0 0 40 0", "exact", "unit mm")
    return d


def passed_over():
    d = Dxf()
    d.line_of(0, 0, 1, 0)
    d.add("XLINE", "10 0 20 0 11 1 21 1", "it has no end")
    d.add("RAY", "10 0 20 0 11 1 21 1", "it has no end")
    d.add("MLINE", "2 STANDARD 10 0 20 0", OTHER)
    d.add("SHAPE", "10 0 20 0 40 1 2 BOLT", OTHER)
    d.add("IMAGE", "10 0 20 0 30 0 11 1 21 0 31 0 12 0 22 1 32 0 13 10 23 10 340 5", "it is a picture")
    d.line_of(1, 0, 1, 1)
    d.add("OLE2FRAME", "10 0 20 0", OTHER)
    d.add("ACAD_PROXY_ENTITY", "90 498", OTHER)
    d.add("HELIX", "10 0 20 0", OTHER)
    d.add("NOBODY_KNOWS_IT", "10 0 20 0 11 9 21 9", OTHER)
    d.add("VIEWPORT", "10 0 20 0 40 9 41 9 68 1 69 1")  # a window onto the drawing: nothing of it
    d.line_of(1, 1, 0, 1)
    d.hand("paths 3", "length 3  # the lines", "box 0 0 1 1", "exact", "unit mm")
    return d


def on_the_sheet():
    d = with_part()
    sheet = "it is in paper space, not in model space"
    d.line_of(0, 0, 5, 0)
    d.add("LINE", "67 1 10 0 20 0 11 297 21 210", sheet)
    insert(d, "67 1 10 0 20 0 30 0 41 50 42 50", sheet)
    d.old_polyline(1, [(0, 0, 0), (297, 0, 0), (297, 210, 0)], sheet, more="67 1")
    d.add("LINE", "67 0 10 0 20 0 11 0 21 5")
    return d


INSERTS = {f.__name__: f for f in (
    inserts, inserts_mirrored, inserts_stretched, inserts_in_rows, inserts_below, inserts_nested, inserts_sheared, inserts_of_themselves,
    inserts_of_nothing, layers, layers_alone, unit_inch, unit_missing, unit_odd, texts, filled, in_space, dimensions, passed_over,
    on_the_sheet)}
