#!/usr/bin/env python3
"""The console's window under Xvfb, worked with a real mouse and keyboard. What it does is seen on the wire: a
silent second client of the emulator hears every reply of the controller."""
import ctypes
import functools
import json
import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest

PROGRAM = os.environ.get("HANDWHEEL", "build/handwheel")
WIDTH, HEIGHT = 1440, 900


class Wire:
    """Listens to what the controller says."""

    def __init__(self, port):
        self.text = ""
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=10)
        self.thread = threading.Thread(target=self._listen, daemon=True)
        self.thread.start()

    def _listen(self):
        self.socket.settimeout(None)
        while data := self.socket.recv(65536):
            self.text += data.decode("latin-1")

    def mark(self):
        return len(self.text)

    def positions(self, since=0):
        """Of motors 1 and 2 in turn, as the console asks for them."""
        return [int(p) for p in re.findall(r"([+-]\d{7})\r", self.text[since:])]

    def first_motor(self, since=0):
        """Motor 2 stays at zero in all of these tests. A stop may come between the two: they do not alternate for ever."""
        both = self.positions(since)
        return [second or first for first, second in zip(both, both[1:])]


class Window(unittest.TestCase):
    def set_the_display(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        home = pathlib.Path(self.folder.name)
        self.env = {**os.environ, "XDG_CONFIG_HOME": str(home / "config"), "XDG_STATE_HOME": str(home / "state"),
                    "LIBGL_ALWAYS_SOFTWARE": "1"}
        self.env.pop("WAYLAND_DISPLAY", None)
        self.start_display()
        self.wait_until(lambda: subprocess.run(["xdotool", "getdisplaygeometry"], env=self.env,
                                               capture_output=True).returncode == 0, "the display is there")
        self.start_desktop()

    def setUp(self):
        self.set_the_display()
        emulator = self.start([PROGRAM, "emulate", "vxm", "--tcp", "127.0.0.1:0"], stdout=subprocess.PIPE, text=True)
        self.port = int(emulator.stdout.readline().rsplit(":", 1)[1])
        self.address = f"vxm@tcp:127.0.0.1:{self.port}"
        subprocess.run([PROGRAM, "send", self.address, "setM1M4", "setM2M4"], check=True, timeout=60)
        self.places = self.layout(WIDTH, HEIGHT)
        self.console = self.start([PROGRAM, "open", self.way_to_emulator()], env=self.env, stderr=subprocess.PIPE, text=True)
        self.window = self.wait_for_window()
        self.wire = Wire(self.port)
        self.wait_until(lambda: len(self.wire.positions()) > 4, "the console polls")

    def start_display(self):
        """The server chooses a free number: several of these tests run side by side."""
        read, write = os.pipe()
        self.display = self.start(["Xvfb", "-displayfd", str(write), "-screen", "0", f"{WIDTH}x{HEIGHT}x24", "-nolisten", "tcp",
                                   "-noreset"], pass_fds=[write])
        os.close(write)
        with open(read) as told:
            self.env["DISPLAY"] = ":" + told.readline().strip()

    def start_desktop(self):
        """What else is on the display: nothing, for those that need no window manager."""

    def way_to_emulator(self):
        """The address that the console opens."""
        return self.address

    def start(self, command, **more):
        process = subprocess.Popen(command, **more)

        def end():
            process.send_signal(signal.SIGTERM)
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
            for pipe in (process.stdout, process.stderr):
                if pipe:
                    pipe.close()

        self.addCleanup(end)
        return process

    @staticmethod
    @functools.cache
    def layout(width, height, before=""):
        """Where things are in a window of this size: laid out once without one, after what `before` does. With a
        controller of its own, since two that poll on one wire would take each other's answers."""
        script = ("local c = assert(hw.open('vxm@emulator')) c:set('M1M', 4) c:set('M2M', 4)\n"
                  f"ui.window({width}, {height}) hw.sleep(8) {before} ui.frame(3)\n"
                  "for _, w in ipairs(ui.list()) do local r = w.rectangle\n"
                  "print(w.id .. '\\t' .. math.floor(r.x + r.width / 2) .. '\\t' .. math.floor(r.y + r.height / 2)) end")
        with tempfile.NamedTemporaryFile("w", suffix=".lua") as file:
            file.write(script)
            file.flush()
            listed = subprocess.run([PROGRAM, "run", "--gui", file.name], check=True, capture_output=True, text=True,
                                    timeout=120).stdout
        return {i: (int(x), int(y)) for i, x, y in (line.split("\t") for line in listed.splitlines())}

    def wait_until(self, condition, what, patience=30):
        end = time.monotonic() + patience
        while not condition():
            self.assertLess(time.monotonic(), end, f"{what}: not within {patience} s")
            time.sleep(0.05)

    def xdo(self, *command):
        return subprocess.run(["xdotool", *map(str, command)], env=self.env, check=True, capture_output=True,
                              text=True, timeout=30).stdout.strip()

    def wait_for_window(self):
        found = []

        def look():
            if self.console.poll() is not None:
                self.fail(f"the console has ended: {self.console.stderr.read()}")
            result = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "Handwheel"], env=self.env,
                                    capture_output=True, text=True)
            found[:] = result.stdout.split()
            return bool(found)

        self.wait_until(look, "the window opens", 60)
        self.xdo("windowmove", found[0], 0, 0)
        self.xdo("windowsize", found[0], WIDTH, HEIGHT)
        self.xdo("windowfocus", found[0])
        time.sleep(1)
        return found[0]

    def point(self, widget):
        self.assertIn(widget, self.places)
        self.xdo("mousemove", *self.places[widget])
        time.sleep(0.2)

    def at_rest(self):
        """The position at which motor 1 stays."""
        last = [None, time.monotonic()]

        def still():
            now = self.wire.first_motor()[-1]
            if now != last[0]:
                last[:] = [now, time.monotonic()]
            return time.monotonic() - last[1] > 1

        self.wait_until(still, "motor 1 comes to rest")
        return last[0]

    def until_done(self, act, done, what):
        """Acts until `done`. The console starts nothing on a frame that comes late, and on a busy machine some do: then
        the hand acts again."""
        for patience in (5, 10, 30):
            act()
            end = time.monotonic() + patience
            while time.monotonic() < end:
                if done():
                    return
                time.sleep(0.05)
        self.fail(f"{what}: not after three tries")

    def hold(self, widget, moved):
        """Presses until `moved`, with as many tries as `until_done`."""
        self.point(widget)
        for patience in (5, 10, 30):
            self.xdo("mousedown", 1)
            end = time.monotonic() + patience
            while time.monotonic() < end:
                if moved(self.wire.first_motor()[-1]):
                    return
                time.sleep(0.05)
            self.xdo("mouseup", 1)
            time.sleep(1)
        self.fail(f"{widget} moves nothing")

    def click(self, widget, button=1):
        self.point(widget)
        self.xdo("click", button)
        time.sleep(0.3)

    def type(self, text):
        self.xdo("type", "--delay", 40, text)

    def key(self, *keys):
        for key in keys:
            self.xdo("key", key)
            time.sleep(0.15)

    def drag(self, start, end, pace=0.03):
        self.xdo("mousemove", *start)
        self.xdo("mousedown", 1)
        for i in range(1, 9):
            self.xdo("mousemove", *(round(a + (b - a) * i / 8) for a, b in zip(start, end)))
            time.sleep(pace)
        self.xdo("mouseup", 1)
        time.sleep(0.3)

    def kept(self):
        """What the window has written about itself: sizes of its parts, theme."""
        file = pathlib.Path(self.env["XDG_STATE_HOME"]) / "handwheel" / "window.json"
        return json.loads(file.read_text()) if file.exists() else {}


class SharedWindow(Window):
    """One display, desktop and console for all cases of a class."""

    @classmethod
    def setUpClass(cls):
        cls.stage = cls("set_the_stage")
        cls.addClassCleanup(cls.stage.doCleanups)
        cls.stage.set_the_stage()

    def setUp(self):
        vars(self).update({k: v for k, v in vars(self.stage).items() if not k.startswith("_")})

    def set_the_stage(self):
        super().setUp()


class Hold(SharedWindow):
    def test_holding_a_jog_button_moves_until_it_is_let_go(self):
        begin = self.at_rest()
        self.hold("jog/1/+", lambda position: position > begin + 400)
        moving = self.wire.first_motor()[-1]
        self.xdo("mouseup", 1)
        stopped = self.at_rest()
        self.assertLess(stopped, moving + 6000)
        time.sleep(1)
        self.assertEqual(self.wire.first_motor()[-1], stopped, "stays")

    def grab_the_keyboard(self, keys_up, seconds=1.5):
        """As who switches windows or takes a screenshot does; meanwhile the keys go up, and nobody is told."""
        x = ctypes.CDLL("libX11.so.6")
        x.XOpenDisplay.restype = ctypes.c_void_p
        display = ctypes.c_void_p(x.XOpenDisplay(self.env["DISPLAY"].encode()))
        root = ctypes.c_ulong(x.XDefaultRootWindow(display))
        self.assertEqual(x.XGrabKeyboard(display, root, 0, 1, 1, 0), 0)
        x.XSync(display, 0)
        time.sleep(0.3)
        for key in keys_up:
            self.xdo("keyup", key)
        time.sleep(seconds)
        x.XUngrabKeyboard(display, 0)
        x.XCloseDisplay(display)

    def test_a_key_that_goes_up_unseen_is_let_go(self):
        begin = self.at_rest()
        self.xdo("keydown", "Right")
        self.wait_until(lambda: self.wire.first_motor()[-1] > begin + 400, "moves")
        self.grab_the_keyboard(["Right"])
        stopped = self.at_rest()
        time.sleep(1)
        self.assertEqual(self.wire.first_motor()[-1], stopped, "stays")
        self.xdo("keydown", "Right")
        self.wait_until(lambda: self.wire.first_motor()[-1] > stopped + 400, "the next press is one")
        self.xdo("keyup", "Right")
        self.at_rest()

    def test_a_modifier_that_goes_up_unseen_disables_nothing(self):
        begin = self.at_rest()
        self.xdo("keydown", "Alt_L")
        self.grab_the_keyboard(["Alt_L"])
        self.xdo("keydown", "Right")
        self.wait_until(lambda: self.wire.first_motor()[-1] > begin + 400, "moves")
        self.xdo("keyup", "Right")
        self.at_rest()

    def test_an_arrow_jogs_while_it_is_down(self):
        begin = self.at_rest()
        self.xdo("mousemove", WIDTH // 2, HEIGHT - 10)
        self.xdo("keydown", "Right")
        time.sleep(1.5)
        moving = self.wire.first_motor()[-1]
        self.assertGreater(moving, begin + 400)
        self.xdo("keyup", "Right")
        stopped = self.at_rest()
        time.sleep(1)
        self.assertEqual(self.wire.first_motor()[-1], stopped)


class Type(SharedWindow):
    def test_a_command_typed_into_the_terminal(self):
        self.at_rest()
        begin = self.wire.mark()
        self.point("terminal/command")
        self.xdo("click", 1)
        time.sleep(0.3)
        self.xdo("type", "--delay", 40, "getD1")
        self.xdo("key", "Return")
        self.wait_until(lambda: "12-29-04\r" in self.wire.text[begin:], "the answer to getD1")

    def test_copy_and_paste_in_the_terminal(self):
        self.at_rest()
        begin = self.wire.mark()
        self.click("terminal/command")
        self.type("getD1")
        self.key("ctrl+a", "ctrl+c", "Return")
        self.wait_until(lambda: "12-29-04\r" in self.wire.text[begin:], "the answer")
        begin = self.wire.mark()
        self.key("ctrl+v", "Return")
        self.wait_until(lambda: "12-29-04\r" in self.wire.text[begin:], "the answer to what was pasted")


class Escape(SharedWindow):
    def test_escape_stops_a_held_jog(self):
        begin = self.at_rest()
        self.hold("jog/1/+", lambda position: position > begin + 300)
        self.xdo("key", "Escape")
        stopped = self.at_rest()
        time.sleep(1)
        self.assertEqual(self.wire.first_motor()[-1], stopped, "stopped though the button is still down")
        self.xdo("mouseup", 1)
        time.sleep(0.7)
        self.assertEqual(self.wire.first_motor()[-1], stopped, "letting go starts nothing")

    def test_escape_stops_a_move_while_typing(self):
        self.at_rest()
        self.point("terminal/command")
        self.xdo("click", 1)
        self.xdo("type", "--delay", 40, "PM0,C,I1M40000,R")
        self.xdo("key", "Return")
        begin = self.wire.first_motor()[-1]
        self.wait_until(lambda: self.wire.first_motor()[-1] > begin + 1000, "moves")
        self.xdo("key", "Escape")
        stopped = self.at_rest()
        self.assertLess(stopped, begin + 20000, "stopped on the way")


class Crash(Window):
    def test_a_program_is_typed_run_and_comes_back_after_a_crash(self):
        begin = self.at_rest()
        self.click("program/text")
        self.type("I1M800")
        self.key("Return")
        self.type("P3,I1M-3009")
        self.key("BackSpace")
        self.key("ctrl+Return")
        self.wait_until(lambda: begin + 500 in self.wire.positions()[-8:], "the program has run: +800 -300")
        time.sleep(2)  # longer than the autosave waits
        self.console.send_signal(signal.SIGKILL)
        self.console.wait()
        kept = "".join(f.read_text(errors="replace") for f in pathlib.Path(self.env["XDG_STATE_HOME"]).rglob("*")
                       if f.is_file())
        self.assertIn("P3,I1M-300", kept, "what was typed is on the disk")

class Shape(SharedWindow):
    def test_splitters_theme_and_size_are_kept(self):
        # From where the splitter is now: a drag that came late may have taken it half the way.
        self.until_done(lambda: self.drag((self.kept().get("left", 304) - 2, 500), (362, 500)),
                        lambda: abs(self.kept().get("left", 0) - 364) < 3, "the left column is kept")
        self.xdo("mousemove", 362, 500)
        self.until_done(lambda: self.xdo("click", "--repeat", 2, "--delay", 80, 1),
                        lambda: self.kept().get("left") == 304, "a double click restores it")
        self.key("ctrl+equal")
        self.wait_until(lambda: abs(self.kept().get("size", 0) - 1.1) < 0.01, "110 %")
        self.key("ctrl+0")
        self.wait_until(lambda: self.kept().get("size") == 1, "100 %")
        x, y = self.layout(WIDTH, HEIGHT, "ui.click('menu')")["menu/theme"]
        self.until_done(lambda: (self.click("menu"), self.xdo("mousemove", x, y), time.sleep(0.2), self.xdo("click", 1)),
                        lambda: self.kept().get("dark") == 0, "light")

    def test_down_to_640_by_400_it_can_be_worked(self):
        begin = self.at_rest()
        self.xdo("windowsize", self.window, 640, 400)
        time.sleep(1)
        places = self.layout(640, 400)
        self.assertIn("tab/jog", places)
        self.places = places
        self.click("tab/jog")
        self.places = self.layout(640, 400, "ui.click('tab/jog')")
        self.hold("jog/1/+", lambda position: position > begin + 300)
        self.xdo("mouseup", 1)
        self.at_rest()
        x, y = self.places["stop_all"]
        self.assertTrue(640 - 160 <= x <= 640 and y < 56, "Stop stands in the corner")
        self.xdo("windowsize", self.window, WIDTH, HEIGHT)
        time.sleep(1)
        self.places = self.layout(WIDTH, HEIGHT)
        begin = self.at_rest()
        self.hold("jog/1/-", lambda position: position < begin - 300)
        self.xdo("mouseup", 1)
        self.at_rest()


class Close(Window):
    def stands(self):
        time.sleep(2.5)  # the ramp
        for _ in range(2):
            here = subprocess.run([PROGRAM, "send", self.address, "X"], check=True, capture_output=True, text=True,
                                  timeout=60).stdout.split()[0]
            time.sleep(0.5)
            there = subprocess.run([PROGRAM, "send", self.address, "X"], check=True, capture_output=True, text=True,
                                   timeout=60).stdout.split()[0]
        self.assertEqual(here, there)

    def test_closing_the_window_stops_a_held_jog(self):
        begin = self.at_rest()
        self.hold("jog/1/+", lambda position: position > begin + 300)
        self.console.send_signal(signal.SIGTERM)
        self.assertEqual(self.console.wait(30), 0)
        self.stands()

    def test_a_display_that_goes_away_stops_a_held_jog(self):
        begin = self.at_rest()
        self.hold("jog/1/+", lambda position: position > begin + 300)
        self.display.kill()
        self.assertEqual(self.console.wait(30), 1)
        self.assertIn("The display is gone.", self.console.stderr.read())
        self.stands()


if __name__ == "__main__":
    unittest.main(verbosity=2)
