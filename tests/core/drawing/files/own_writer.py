"""A writer of drawing files for make_own.py that knows where each entity comes to stand, and adds no more than it is
told: what other software would never write is what a reader has to survive."""

MARKERS = {"LINE": ["AcDbLine"], "POINT": ["AcDbPoint"], "CIRCLE": ["AcDbCircle"], "ARC": ["AcDbCircle"],
           "LWPOLYLINE": ["AcDbPolyline"], "ELLIPSE": ["AcDbEllipse"], "SPLINE": ["AcDbSpline"], "MTEXT": ["AcDbMText"]}


class Dxf:
    """`version` none: neither that nor the marks of subclasses, as R12 has them."""

    def __init__(self, version=None, unit="4"):
        self.text, self.line, self.number, self.section = "", 0, 0, ""
        self.left_out, self.by_hand, self.ended, self.newer = [], None, False, bool(version)
        if version or unit:
            self.into("HEADER")
            if version:
                self.tag(9, "$ACADVER").tag(1, version)
            if unit:
                self.tag(9, "$INSUNITS").tag(70, unit)

    def tag(self, code, value):
        self.text += f"{code:>3}\n{value}\n"
        self.line += 2
        return self

    def tags(self, words):
        """ "10 1.5 20 3": codes and values, none of which has a blank in it."""
        words = words.split()
        for code, value in zip(words[::2], words[1::2]):
            self.tag(int(code), value)
        return self

    def into(self, section):
        if self.section == section:
            return
        if self.section:
            self.tag(0, "ENDSEC")
        self.section = section
        if section:
            self.tag(0, "SECTION").tag(2, section)

    def layers(self, *rows):
        """(name, flags, colour)"""
        self.into("TABLES")
        self.tag(0, "TABLE").tag(2, "LAYER").tag(70, len(rows))
        for name, flags, colour in rows:
            self.tags(f"0 LAYER 2 {name} 70 {flags} 62 {colour} 6 CONTINUOUS")
        self.tag(0, "ENDTAB")

    def block(self, name, base="10 0 20 0 30 0"):
        self.into("BLOCKS")
        self.number += 1
        self.tags(f"0 BLOCK 8 0 2 {name} 70 0 {base} 3 {name}")

    def end_block(self):
        self.number += 1
        self.tags("0 ENDBLK 8 0")

    def add(self, kind, words, why="", layer="0", inside=False):
        """An entity; `why`: it is left out. `inside`: of the block that was begun."""
        if not inside:
            self.into("ENTITIES")
        self.tag(0, kind)
        self.number += 1
        if why:
            self.left_out.append(f"left out {self.number} {kind} {self.line}: {why}")
        if self.newer:
            self.tag(100, "AcDbEntity")
        self.tag(8, layer)
        if self.newer:
            for marker in MARKERS.get(kind, []):
                self.tag(100, marker)
        if kind == "ARC" and self.newer:
            at = words.index("50 ")
            self.tags(words[:at]).tag(100, "AcDbArc")
            words = words[at:]
        return self.tags(words)

    def line_of(self, x1, y1, x2, y2, **more):
        return self.add("LINE", f"10 {x1} 20 {y1} 30 0 11 {x2} 21 {y2} 31 0", **more)

    def old_polyline(self, flags, vertices, why="", more="", vertex_flags=0):
        """(x, y, bulge), or (x, y, bulge, z)"""
        self.add("POLYLINE", f"66 1 10 0 20 0 30 0 70 {flags} {more}", why)
        for x, y, bulge, *z in vertices:
            self.number += 1
            self.tags(f"0 VERTEX 8 0 10 {x} 20 {y} 30 {z[0] if z else 0} 42 {bulge} 70 {vertex_flags}")
        self.number += 1
        self.tags("0 SEQEND 8 0")

    def polyline(self, flags, vertices, why="", more="", count=None):
        points = " ".join(f"10 {x} 20 {y} 42 {bulge}" for x, y, bulge in vertices)
        self.add("LWPOLYLINE", f"90 {len(vertices) if count is None else count} 70 {flags} {more} {points}", why)

    def spline(self, flags, degree, knots, points, weights=(), fit=(), why=""):
        words = f"70 {flags} 71 {degree} 72 {len(knots)} 73 {len(points)} 74 {len(fit)} "
        words += " ".join(f"40 {k}" for k in knots)
        words += "".join(f" 41 {w}" for w in weights)
        words += "".join(f" 10 {x} 20 {y} 30 0" for x, y in points)
        words += "".join(f" 11 {x} 21 {y} 31 0" for x, y in fit)
        self.add("SPLINE", words, why)

    def hand(self, *rows):
        """What ezdxf reads otherwise, or not at all."""
        self.by_hand = list(rows)

    def finish(self):
        if not self.ended:
            self.into("")
            self.tag(0, "EOF")
            self.ended = True
        return self.text
