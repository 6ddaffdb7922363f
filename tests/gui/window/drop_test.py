#!/usr/bin/env python3
"""A drawing is dragged from another program's window onto the console's, with a real mouse, and cut from there."""
import pathlib
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from manager_test import OPENBOX, Tap  # noqa: E402
from window_test import HEIGHT, PROGRAM, WIDTH, Window  # noqa: E402

HERE = pathlib.Path(__file__).parent
# Debian's own: GTK's bindings are there for no other.
DRAG_SOURCE = ["/usr/bin/python3", str(HERE / "drag_source.py")]
SQUARE = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + "".join(
    f"0\nLINE\n8\n0\n10\n{a}\n20\n{b}\n11\n{c}\n21\n{d}\n"
    for a, b, c, d in ((0, 0, 9, 0), (9, 0, 9, 9), (9, 9, 0, 9), (0, 9, 0, 0))) + "0\nENDSEC\n0\nEOF\n"


class Drop(Window):
    def setUp(self):
        self.set_the_display()
        self.drawing = pathlib.Path(self.folder.name) / "ein Plättchen, 9 x 9.dxf"
        self.drawing.write_text(SQUARE)
        emulator = self.start([PROGRAM, "emulate", "pmx-4ex-sa", "--tcp", "127.0.0.1:0"], stdout=subprocess.PIPE, text=True)
        port = int(emulator.stdout.readline().rsplit(":", 1)[1])
        subprocess.run([PROGRAM, "send", f"pmx-4ex-sa@tcp:127.0.0.1:{port}", "EO=15"], check=True, timeout=60,
                       stdout=subprocess.DEVNULL)
        self.tap = Tap(port)
        self.addCleanup(self.tap.close)
        self.places = self.places_of_a_cut()
        self.console = self.start([PROGRAM, "open", f"pmx-4ex-sa@tcp:127.0.0.1:{self.tap.port}"], env=self.env,
                                  stderr=subprocess.PIPE, text=True)
        self.window = self.wait_for_window()
        self.wait_until(lambda: self.tap.sent.count(b"PP") > 4, "the console polls")

    def start_desktop(self):
        rules = pathlib.Path(self.folder.name) / "openbox.xml"
        rules.write_text(OPENBOX)
        self.start(["openbox", "--sm-disable", "--config-file", str(rules)], env=self.env, stderr=subprocess.DEVNULL)
        self.wait_until(lambda: "window id" in subprocess.run(["xprop", "-root", "_NET_SUPPORTING_WM_CHECK"], env=self.env,
                                                              capture_output=True, text=True).stdout, "the window manager is there")

    def places_of_a_cut(self):
        """Where the buttons are, in the same states without a window."""
        script = pathlib.Path(self.folder.name) / "places.lua"
        script.write_text(f"""
local function tell(id)
  local r
  for _, w in ipairs(ui.list()) do if w.id == id then r = w.rectangle end end
  print(id .. '\\t' .. math.floor(r.x + r.width / 2) .. '\\t' .. math.floor(r.y + r.height / 2))
end
local c = assert(hw.open('pmx-4ex-sa@emulator')) c:send('EO=15')
ui.window({WIDTH}, {HEIGHT}) hw.sleep(8)
ui.click('tab/drawing') ui.click('drawing/open') ui.type('file/path', '{self.drawing}\\n') hw.sleep(2)
tell('drawing/view') tell('drawing/cut')
ui.click('drawing/cut') hw.sleep(1)
tell('drawing/ask_cut/yes')
""")
        told = subprocess.run([PROGRAM, "run", "--gui", str(script)], check=True, capture_output=True, text=True, timeout=120)
        return {i: (int(x), int(y)) for i, x, y in (line.split("\t") for line in told.stdout.splitlines())}

    def drag_to(self, place, *files):
        source = self.start([*DRAG_SOURCE, *map(str, files)], env={**self.env, "NO_AT_BRIDGE": "1"})
        window = self.xdo("search", "--sync", "--onlyvisible", "--name", "some files").split()[0]
        self.xdo("windowmove", "--sync", window, 10, HEIGHT - 160)
        self.xdo("windowactivate", "--sync", window)
        time.sleep(0.5)
        self.drag((50, HEIGHT - 130), place, pace=0.06)
        source.terminate()

    def test_a_drawing_dropped_on_the_window_is_cut(self):
        self.assertNotIn(b"SR0=1", self.tap.sent)
        self.drag_to(self.places["drawing/view"], self.drawing)
        time.sleep(2)  # the drawing is read and rehearsed
        self.click("drawing/cut")
        time.sleep(1)
        self.click("drawing/ask_cut/yes")
        self.wait_until(lambda: b"SR0=1" in self.tap.sent, "the program of the drawing runs")
        self.assertTrue(b"=MOVE,X,900" in self.tap.sent, "it goes to a corner, 9 mm of 100 pulses from the first")


if __name__ == "__main__":
    unittest.main(verbosity=2)
