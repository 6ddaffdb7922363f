"""Drawings for make_own.py: numbers that are none, and files that are damaged, or written in a way of their own."""
from own_writer import Dxf


def no_number(line):
    return f"line {line} holds no number"


def no_numbers():
    d = Dxf()
    for n, word in enumerate(("nan", "-inf", "1e999", "seven", "0x10", "1.5.2", "--3", "12mm")):
        d.line_of(0, 0, word, 0, why=no_number(d.line + (12 if n else 18)))  # the section begins before the first
    d.add("CIRCLE", "10 0 20 0 40 NaN", no_number(d.line + 10))
    d.old_polyline(0, [(0, 0, 0), ("nan", 0, 0), (9, 9, 0)], no_number(d.line + 34))
    d.newer = True
    d.polyline(0, [(0, 0, 0), (9, "inf", 0)], no_number(d.line + 22))
    d.spline(8, 1, [0, 0, "nan", 1], [(0, 0), (9, 9)], why=no_number(d.line + 24))
    d.newer = False
    d.line_of("1,5", 0, "+3,5", 0)  # a comma is one of some countries
    d.line_of(0, 0, "1e-400", 1)  # too small to tell from 0
    d.hand("paths 2", "length 3  # 2 + 1", "box 0 0 3.5 1", "exact", "unit mm")
    return d


def no_length():
    d = Dxf("AC1015")
    nothing = "it has no length"
    d.line_of(5, 5, 5, 5, why=nothing)
    d.add("ELLIPSE", "10 0 20 0 30 0 11 0 21 0 31 0 40 0.5 41 0 42 1", "it has no size")
    d.add("ELLIPSE", "10 0 20 0 30 0 11 1 21 0 31 0 40 0 41 0 42 1", "it has no size")
    d.newer = False
    d.add("ARC", "10 0 20 0 40 0 50 0 51 90", "its radius is not above 0")
    d.old_polyline(0, [(1, 1, 0), (1, 1, 0.5), (1, 1, 0)], nothing)
    d.old_polyline(0, [], "it has no points")
    d.add("POINT", "10 5 20 5")
    d.hand("paths 1", "length 0  # the point", "box 5 5 5 5", "exact", "unit mm")
    return d


def huge():
    d = Dxf()
    d.line_of("1e9", "-1e9", "1000000003", "-999999996")
    d.add("ARC", "10 1e6 20 1e6 40 1e6 50 350 51 10")
    d.line_of("123456789.125", 0, "123456789.25", 0)
    return d


def beyond_numbers():
    d = Dxf()
    d.line_of("-1e308", 0, "1e308", 0, why="it is too large")
    d.add("CIRCLE", "10 1e308 20 0 40 1e308", "it is too large")
    d.line_of(0, 0, 1, 0)
    d.hand("paths 1", "length 1  # the line", "box 0 0 1 0", "exact", "unit mm")
    return d


def with_data_of_programs():
    """Extended data, reactors and handles hold codes and names that are no part of the drawing."""
    d = Dxf("AC1015")
    d.line_of(0, 0, 3, 4).tags("1001 ACAD 1000 LINE 1010 500 1020 500 1030 0 1040 7 1070 1")
    d.add("POINT", "5 2F 330 1F 102 {ACAD_REACTORS 330 1E 102 } 10 7 20 8 30 0")
    d.polyline(0, [(0, 0, 0), (6, 8, 0)])
    d.tags("1001 ACAD 1002 { 1010 nan 1020 500 1002 }")
    return d


def comments():
    d = Dxf()
    d.tag(999, "0").tag(999, "LINE")
    d.into("ENTITIES")
    d.tag(999, "before an entity")
    d.add("LINE", "10 0 20 0").tag(999, "within one").tags("11 3 21 4")
    d.tag(999, "  0").tag(999, "EOF")
    d.line_of(0, 0, 0, 2)
    return d


def ends_of_lines():
    """As DOS writes them."""
    d = Dxf()
    d.line_of(0, 0, 3, 4, layer="cut")
    d.add("CIRCLE", "10 9 20 9 40 1")
    d.finish()
    d.text = d.text.replace("\n", "\r\n")
    return d


def blanks():
    d = Dxf()
    d.line_of(0, 0, 3, 4, layer="cut")
    d.old_polyline(0, [(0, 0, 0.5), (5, 0, 0)])
    d.finish()
    d.text = "".join(f"\t {line.strip()} \t\n" for line in d.text.splitlines())
    d.hand("paths 2", "length 10.795595113  # 5; 4 atan 0.5 = 1.854590436 of radius 5 / (2 0.8) = 3.125",
           "box 0 -1.25 5 4  # 5 / 2 by 0.5 below", "exact", "unit mm")
    return d


def no_last_line_end():
    d = Dxf()
    d.line_of(0, 0, 3, 4)
    d.finish()
    d.text = d.text.rstrip("\n")
    return d


def byte_order_mark():
    d = Dxf()
    d.line_of(0, 0, 3, 4)
    d.finish()
    d.text = "\ufeff" + d.text
    d.hand("paths 1", "length 5  # 3 by 4", "box 0 0 3 4", "exact", "unit mm")
    return d


def long_line():
    d = Dxf()
    d.add("TEXT", f"10 0 20 0 40 1 1 {'x' * 3000}", "it is a text")
    d.line_of(0, 0, 3, 4)
    return d


def behind_the_end():
    d = Dxf()
    d.line_of(0, 0, 3, 4)
    d.finish()
    d.tags("0 LINE 8 0 10 0 20 0 11 500 21 500")
    return d


def nothing_drawn():
    d = Dxf()
    d.into("ENTITIES")
    return d


def only_entities():
    """No header, no tables: as small as a file can be."""
    d = Dxf(unit=None)
    d.add("LINE", "10 0 20 0 11 3 21 4")
    return d


def sound():
    d = Dxf()
    d.line_of(0, 0, 3, 4)
    d.line_of(3, 4, 9, 9)
    return d.finish().encode()


def cut_off():
    return sound()[:-70], "it does not end with EOF"


def cut_off_at_the_end():
    return sound()[:-8], "it does not end with EOF"


def empty():
    return b"", "is empty"


def binary():
    return b"AutoCAD Binary DXF\r\n\x1a\x00" + b"\x00SECTION\x00\x02ENTITIES\x00\x00ENDSEC\x00\x00EOF\x00", "is a binary DXF file"


def a_dwg():
    return b"AC1015\x00\x00\x00\x00\x00\x06\x01", "is a DWG file"


def a_picture():
    return b"\x89PNG\r\n\x1a\n\x01\x02\x03", "line 1: a group code was expected here"


def a_word():
    return sound().replace(b" 20\n", b"zwanzig\n", 1), "line 21: a group code was expected here"


def a_zero_byte():
    return sound().replace(b"LINE", b"LI\x00E", 1), "line 16: it contains a zero byte"


def too_many_parts():
    d = Dxf("AC1015")
    d.polyline(0, [(0, 0, 0), (1, 0, 0)], count=2000000000)
    return d.finish().encode(), "LWPOLYLINE declares more parts than it has"


BAD = {f.__name__: f for f in (
    no_numbers, no_length, huge, beyond_numbers, with_data_of_programs, comments, ends_of_lines, blanks, no_last_line_end,
    byte_order_mark, long_line, behind_the_end, nothing_drawn, only_entities, cut_off, cut_off_at_the_end, empty, binary, a_dwg,
    a_picture, a_word, a_zero_byte, too_many_parts)}
