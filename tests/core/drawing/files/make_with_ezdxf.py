#!/usr/bin/env python3
"""Makes the drawings of ezdxf/ with ezdxf (Debian: python3-ezdxf). By hand; what it makes is committed. What ezdxf reads
in them: measure.py ezdxf.   make_with_ezdxf.py [FOLDER]"""
import sys
from pathlib import Path

import ezdxf

FOLDER = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent / "ezdxf"
VERSIONS = ["R12", "R2000", "R2007", "R2018"]


def lines_and_arcs(msp, block):
    msp.add_line((0, 0), (10, 5), dxfattribs={"layer": "cut"})
    msp.add_point((7, 7))
    msp.add_circle((3, 3), 2)
    msp.add_arc((1, 1), 4, 10, 200)
    msp.add_arc((1, 1), 3, 300, 20)
    msp.add_polyline2d([(0, 0, 0.2), (5, 1, 0), (6, 4, -1), (9, 9, 0)], format="xyb")
    msp.add_polyline2d([(20, 0, 0.2), (25, 1, 1.5), (26, 4, 0)], format="xyb").close()


def seen_from_below(msp, block):
    below = {"extrusion": (0, 0, -1)}
    msp.add_arc((5, 1), 4, 10, 100, dxfattribs=below)
    msp.add_circle((3, 3), 2, dxfattribs=below)
    msp.add_polyline2d([(0, 0, 0.2), (5, 1, 0), (6, 4, 0)], format="xyb", dxfattribs=below)


def blocks(msp, block):
    msp.add_blockref("PART", (20, 20), dxfattribs={"xscale": 2, "yscale": 2, "rotation": 30})
    msp.add_blockref("PART", (0, -20), dxfattribs={"xscale": -3, "yscale": 3, "rotation": 100})
    msp.add_blockref("OUTER", (50, 5), dxfattribs={"rotation": 15})
    msp.add_blockref("PART", (-30, 0), dxfattribs={
        "rotation": 45, "column_count": 3, "row_count": 2, "column_spacing": 4, "row_spacing": 3})


def stretched(msp, block):
    msp.add_blockref("PART", (20, 20), dxfattribs={"xscale": 2, "yscale": 0.5, "rotation": 30})


def light_polylines(msp, block):
    msp.add_lwpolyline([(0, 0, 0.5), (3, 0, -0.3), (3, 3, 0)], format="xyb", close=True)
    msp.add_lwpolyline([(10, 0, 1), (14, 0, 1)], format="xyb", close=True)  # a circle
    msp.add_lwpolyline([(0, 10, 0.01), (30, 12, -3)], format="xyb", dxfattribs={"extrusion": (0, 0, -1)})


def ellipses(msp, block):
    msp.add_ellipse((2, 2), (4, 1), 0.4, 0.3, 5)
    msp.add_ellipse((-20, 2), (0, 7), 0.1)
    msp.add_ellipse((20, 2), (4, 1), 0.7, 5, 1)
    msp.add_ellipse((9, 30), (4, 1), 0.4, 0.3, 2, dxfattribs={"extrusion": (0, 0, -1)})


def splines(msp, block):
    msp.add_open_spline([(0, 0), (1, 3), (4, 4), (6, 0), (9, 1)], degree=3)
    msp.add_open_spline([(0, 20), (1, 23), (4, 24), (6, 20), (9, 21), (12, 30)], degree=2)
    msp.add_rational_spline([(20, 0), (21, 3), (24, 4), (26, 0)], [1, 2, 0.5, 1], degree=3)
    spline = msp.add_spline()
    spline.set_closed([(40, 0, 0), (41, 3, 0), (44, 4, 0), (46, 0, 0)], degree=3)
    spline = msp.add_spline()
    spline.set_closed_rational([(60, 0, 0), (61, 3, 0), (64, 4, 0), (66, 0, 0)], [1, 3, 1, 0.5], degree=3)


NEWER = {light_polylines, ellipses, splines}


def fill_blocks(doc):
    part = doc.blocks.new("PART", base_point=(1, 0))
    part.add_line((0, 0), (2, 0))
    part.add_circle((0, 0), 0.5)
    part.add_arc((3, 1), 2, 0, 135)
    outer = doc.blocks.new("OUTER", base_point=(0, 2))
    outer.add_blockref("PART", (4, 4), dxfattribs={"rotation": -70})
    outer.add_line((0, 0), (1, 1))


def main():
    FOLDER.mkdir(exist_ok=True)
    for make in (lines_and_arcs, seen_from_below, blocks, stretched, light_polylines, ellipses, splines):
        for version in VERSIONS:
            if version == "R12" and make in NEWER:
                continue
            doc = ezdxf.new(version)
            doc.layers.new("cut")
            fill_blocks(doc)
            make(doc.modelspace(), doc.blocks)
            doc.saveas(FOLDER / f"{make.__name__}_{version.lower()}.dxf")


main()
