"""Drawings for make_own.py: every kind of curve."""
from own_writer import Dxf

SQUARE = [(0, 0, 0), (4, 0, 0), (4, 3, 0), (0, 3, 0)]
HILL = [(0, 0), (1, 3), (4, 4), (6, 0)]
CLAMPED = [0, 0, 0, 0, 1, 1, 1, 1]


def lines():
    d = Dxf()
    d.line_of(0, 0, 3, 4)
    d.line_of(-5, -1.25e1, -5, 20, layer="cut")
    d.add("LINE", "10 +1.5 20 .5 30 7 11 2.500 21 1E1 31 7")  # flat, but not at 0
    d.add("LINE", "11 9 21 9 10 8 20 8")  # the end first, no heights
    return d


def points():
    d = Dxf()
    for x, y in ((7, 8), (-1, 0), (0, 0)):
        d.add("POINT", f"10 {x} 20 {y} 30 0 39 2")
    return d


def arcs():
    d = Dxf()
    for n, (begin, end) in enumerate(((10, 200), (350, 10), (300, 20), (0, 360), (0, 180), (180, 0), (45, 45), (-90, 90), (270, 450), (90, 90.001))):
        d.add("ARC", f"10 {10 * n} 20 {-n} 30 0 40 {n + 0.5} 50 {begin} 51 {end}")
    return d


def arcs_new():
    d = Dxf("AC1015")
    d.add("ARC", "10 1 20 2 30 0 40 3 50 350 51 370")
    d.add("ARC", "10 1 20 2 30 0 40 3 50 100 51 10")
    return d


def arcs_below():
    d = Dxf("AC1015")
    for begin, end in ((10, 100), (350, 10), (0, 360)):
        d.add("ARC", f"10 5 20 1 30 0 210 0 220 0 230 -1 40 {begin / 100 + 1} 50 {begin} 51 {end}")
    d.newer = False
    d.add("CIRCLE", "10 3 20 9 30 0 40 2 210 0 220 0 230 -1")
    return d


def circles():
    d = Dxf()
    d.add("CIRCLE", "10 -1 20 -1 40 0.5")
    d.add("CIRCLE", "10 100 20 3 30 2 40 12.25 39 5")
    d.add("CIRCLE", "10 0 20 0 40 0", "its radius is not above 0")
    d.add("CIRCLE", "10 0 20 0 40 -3", "its radius is not above 0")
    d.hand("paths 2", "length 80.110612667  # 2 pi (0.5 + 12.25)", "box -1.5 -9.25 112.25 15.25  # centres and radii", "exact", "unit mm")
    return d


def old_polylines():
    d = Dxf()
    d.old_polyline(0, [(0, 0, 0), (1, 0, -1), (3, 0, 0), (3, 2, 0.2), (9, 9, 5)])  # the last bulge goes nowhere
    d.old_polyline(1, SQUARE)
    d.old_polyline(1, [(20, 0, 1), (26, 0, 1)])  # a circle
    d.old_polyline(1, [(30, 0, 0.3), (36, 0, -0.4), (33, 5, 0)], more="40 0.5 41 0.5 39 2")
    d.old_polyline(0, [(40, 0, 0.5), (41, 1, 0)], more="210 0 220 0 230 -1")
    d.old_polyline(2, [(50, 0, 0.25), (52, 2, 0.25), (54, 0, 0)])  # arcs through what was drawn
    return d


def polylines_in_space():
    d = Dxf()
    d.old_polyline(8, [(0, 0, 0, 5), (3, 4, 0, 5), (3, 9, 0, 5)], vertex_flags=32)
    d.old_polyline(9, [(x, y, 0, 1) for x, y, _ in SQUARE], vertex_flags=32)
    d.old_polyline(8, [(0, 0, 0, 0), (50, 50, 0, 1)], "it is not flat", vertex_flags=32)
    d.hand("paths 2", "length 24  # 5 + 5 and 2 (4 + 3)", "box 0 0 4 9", "exact", "unit mm")
    return d


def polylines_of_programs():
    d = Dxf()
    d.old_polyline(16, [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], "it is a mesh", "71 2 72 2", 64)
    d.old_polyline(64, [(0, 0, 0), (1, 0, 0), (1, 1, 0)], "it is a mesh", "71 3 72 1", 192)
    d.old_polyline(4, [(0, 0, 0), (50, 0, 0)], "it is smoothed by a spline that only the program that made it knows", vertex_flags=8)
    d.line_of(0, 0, 1, 0)
    d.hand("paths 1", "length 1  # the line", "box 0 0 1 0", "exact", "unit mm")
    return d


def polylines():
    d = Dxf("AC1015")
    d.polyline(0, SQUARE)
    d.polyline(1, SQUARE, more="43 0.25")
    d.polyline(129, [(10, 0, 0.5), (13, 0, -0.3), (13, 3, 0)])
    d.polyline(0, [(20, 0, 0), (25, 0, 0), (25, 0, 0), (25, 5, 0)])  # the same point twice
    d.polyline(0, [(0, 10, 0.01), (30, 12, -3)], more="38 4 210 0 220 0 230 -1")
    return d


def bulges():
    d = Dxf("AC1015")
    for n, bulge in enumerate((1, -1, 0.4142135623730951, 1e-6, 5, -20)):
        d.polyline(0, [(10 * n, 0, bulge), (10 * n + 4, 3, 0)])
    d.polyline(1, [(0, 40, 1), (6, 40, 1)])
    d.polyline(1, [(20, 40, 0.2), (26, 40, 0.2), (23, 46, 0.2)])
    return d


def bulges_as_good_as_none():
    """Their centres are so far away that a double does not know them to a thousandth."""
    d = Dxf("AC1015")
    for n, bulge in enumerate((1e-12, -1e-9, 1e-7)):
        d.polyline(0, [(10 * n, 0, bulge), (10 * n + 4, 3, 0)])
    d.hand("paths 3", "length 15  # three times 3 by 4", "box 0 0 24 3", "exact", "unit mm")
    return d


def polylines_without_length():
    d = Dxf("AC1015")
    d.polyline(0, [(5, 5, 0)], "it has no length")
    d.polyline(1, [(5, 5, 1), (5, 5, 0)], "it has no length")
    d.polyline(0, [], "it has no points")
    d.polyline(0, SQUARE)
    d.hand("paths 1", "length 11  # 4 + 3 + 4", "box 0 0 4 3", "exact", "unit mm")
    return d


def polyline_count():
    d = Dxf("AC1015")
    for count in (2, 6):
        d.polyline(0, SQUARE, "its number of parts differs from the number it declares", count=count)
    d.polyline(0, SQUARE)
    d.hand("paths 1", "length 11  # 4 + 3 + 4", "box 0 0 4 3", "exact", "unit mm")
    return d


def ellipses():
    d = Dxf("AC1015")
    full = "41 0 42 6.283185307179586"
    d.add("ELLIPSE", f"10 2 20 2 30 0 11 4 21 1 31 0 40 0.4 {full}")
    d.add("ELLIPSE", f"10 -20 20 2 30 0 11 0 21 7 31 0 40 0.1 {full}")
    d.add("ELLIPSE", f"10 20 20 2 30 0 11 -3 21 0 31 0 40 1 {full}")  # a circle
    d.add("ELLIPSE", f"10 20 20 30 30 0 11 300 21 0 31 0 40 0.001 {full}")
    return d


def ellipse_parts():
    d = Dxf("AC1015")
    for n, (begin, end) in enumerate(((0.3, 5), (5, 1), (0, 3.141592653589793), (-1, 1), (1.5, 1.6), (3, 9.2))):
        d.add("ELLIPSE", f"10 {10 * n} 20 2 30 0 11 4 21 1 31 0 40 0.5 41 {begin} 42 {end}")
    return d


def ellipses_below():
    d = Dxf("AC1015")
    for n, (begin, end) in enumerate(((0, 6.283185307179586), (0.3, 2), (5, 1))):
        d.add("ELLIPSE", f"10 {10 * n} 20 2 30 0 11 4 21 1 31 0 210 0 220 0 230 -1 40 0.4 41 {begin} 42 {end}")
    return d


def splines():
    d = Dxf("AC1015")
    d.spline(8, 3, CLAMPED, HILL)
    d.spline(8, 2, [0, 0, 0, 1, 2, 3, 3, 3], [(0, 20), (1, 23), (4, 24), (6, 20), (9, 21)])
    d.spline(8, 5, [0] * 6 + [1] * 6, [(20, 0), (21, 5), (23, -5), (25, 5), (27, -5), (29, 0)])
    d.spline(8, 1, [0, 0, 1, 2, 2], [(30, 0), (35, 5), (40, 0)])  # lines
    d.spline(8, 3, [0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2], [(0, 40), (2, 44), (4, 44), (6, 40), (8, 36), (8, 44), (12, 40)])  # a corner
    d.spline(8, 3, CLAMPED, [(20, 40), (20, 40), (26, 46), (26, 46)])
    return d


def splines_closed():
    d = Dxf("AC1015")
    ring = [(0, 0), (4, 0), (4, 4), (0, 4)]
    d.spline(11, 3, list(range(11)), ring + ring[:3])
    d.spline(11, 2, list(range(9)), [(x + 10, y) for x, y in ring + ring[:2]])
    d.spline(9, 3, [0, 0, 0, 0, 1, 2, 2, 2, 2], [(20, 0), (24, 0), (24, 4), (20, 4), (20, 0)])
    return d


def splines_weighted():
    d = Dxf("AC1015")
    half = 0.7071067811865476
    d.spline(12, 2, [0, 0, 0, 1, 1, 1], [(2, 0), (2, 2), (0, 2)], [1, half, 1])  # a quarter of a circle
    d.spline(13, 2, [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4],
             [(12, 0), (12, 2), (10, 2), (8, 2), (8, 0), (8, -2), (10, -2), (12, -2), (12, 0)], [1, half] * 4 + [1])  # all of it
    d.spline(12, 3, CLAMPED, [(x + 20, y) for x, y in HILL], [1, 20, 0.05, 1])
    return d


def splines_through_points():
    d = Dxf("AC1015")
    d.spline(8, 3, [], [], fit=HILL)
    d.spline(8, 3, CLAMPED, HILL, fit=[(0, 0), (6, 0)])
    return d


def splines_wrong():
    d = Dxf("AC1015")
    d.spline(8, 3, [0, 0, 0, 0, 1, 1, 0.5, 1], HILL, why="its knots are not in order")
    d.spline(8, 3, CLAMPED[1:], HILL, why="it has the wrong number of knots")
    d.spline(8, 3, CLAMPED + [2], HILL, why="it has the wrong number of knots")
    d.spline(8, 3, [], HILL, why="it has the wrong number of knots")
    d.spline(8, 3, [1] * 8, HILL, why="its knots span no range")
    d.spline(8, 3, CLAMPED, HILL[:3], why="it has too few control points")
    d.spline(8, 0, CLAMPED, HILL, why="its degree is out of range")
    d.spline(12, 3, CLAMPED, HILL, [1, 1, -1, 1], why="a weight is not above 0")
    d.spline(12, 3, CLAMPED, HILL, [1, 0, 1, 1], why="a weight is not above 0")
    d.spline(8, 3, CLAMPED, [(5, 5)] * 4, why="it has no length")
    d.line_of(0, 0, 1, 0)
    d.hand("paths 1", "length 1  # the line", "box 0 0 1 0", "exact", "unit mm")
    return d


CURVES = {f.__name__: f for f in (
    lines, points, arcs, arcs_new, arcs_below, circles, old_polylines, polylines_in_space, polylines_of_programs, polylines, bulges, bulges_as_good_as_none,
    polylines_without_length, polyline_count, ellipses, ellipse_parts, ellipses_below, splines, splines_closed, splines_weighted,
    splines_through_points, splines_wrong)}
