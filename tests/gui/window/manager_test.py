#!/usr/bin/env python3
"""The console's window under a window manager that takes keyboard and pointer away and gives them back: other
windows, minimised, another workspace, the manager's own menu, a locked screen. What the console sends is seen by a
tap on its wire."""
import contextlib
import pathlib
import socket
import subprocess
import sys
import threading
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from window_test import HEIGHT, WIDTH, SharedWindow  # noqa: E402

# No frames, so that the window stays where the stage has put it; two workspaces; the manager's menu by a key.
OPENBOX = """<?xml version="1.0"?>
<openbox_config xmlns="http://openbox.org/3.4/rc">
  <focus><focusNew>yes</focusNew><followMouse>no</followMouse></focus>
  <desktops><number>2</number><popupTime>0</popupTime></desktops>
  <keyboard>
    <keybind key="A-space"><action name="ShowMenu"><menu>client-menu</menu></action></keybind>
    <keybind key="A-Tab"><action name="NextWindow"/></keybind>
  </keyboard>
  <mouse>
    <context name="Client">
      <mousebind button="Left" action="Press"><action name="Focus"/><action name="Raise"/></mousebind>
    </context>
  </mouse>
  <applications><application class="*"><decor>no</decor></application></applications>
</openbox_config>
"""


class Tap:
    """A wire between console and emulator that writes down what the console sends."""

    def __init__(self, port):
        self.sent = b""
        self.port_behind = port
        self.server = socket.create_server(("127.0.0.1", 0))
        self.port = self.server.getsockname()[1]
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self):
        with contextlib.suppress(OSError):
            while True:
                console, _ = self.server.accept()
                emulator = socket.create_connection(("127.0.0.1", self.port_behind))
                threading.Thread(target=self._carry, args=(console, emulator, True), daemon=True).start()
                threading.Thread(target=self._carry, args=(emulator, console, False), daemon=True).start()

    def _carry(self, source, sink, note):
        with contextlib.suppress(OSError):
            while data := source.recv(65536):
                if note:
                    self.sent += data
                sink.sendall(data)
            sink.shutdown(socket.SHUT_WR)

    def close(self):
        self.server.close()

    def mark(self):
        return len(self.sent)


class Managed(SharedWindow):
    def set_the_stage(self):
        super().set_the_stage()
        self.other = self.start(["xmessage", "-geometry", "+40+700", "another window"], env=self.env)
        self.other_window = self.xdo("search", "--sync", "--onlyvisible", "--name", "xmessage").split()[0]
        self.xdo("windowactivate", "--sync", self.window)
        self.at_rest()

    def start_desktop(self):
        rules = pathlib.Path(self.folder.name) / "openbox.xml"
        rules.write_text(OPENBOX)
        self.start(["openbox", "--sm-disable", "--config-file", str(rules)], env=self.env, stderr=subprocess.DEVNULL)
        self.wait_until(lambda: "window id" in self.ask("xprop", "-root", "_NET_SUPPORTING_WM_CHECK"),
                        "the window manager is there")

    def way_to_emulator(self):
        self.tap = Tap(self.port)
        self.addCleanup(self.tap.close)
        return f"vxm@tcp:127.0.0.1:{self.tap.port}"

    def ask(self, *command):
        return subprocess.run(command, env=self.env, capture_output=True, text=True, timeout=30).stdout

    def active(self):
        return self.ask("xdotool", "getactivewindow").strip()

    def back(self):
        self.wait_until(lambda: self.active() == self.window, "the console is in front again", 5)

    # ---- what takes the window away; each gives it back at the end of its block

    @contextlib.contextmanager
    def another_window(self):
        self.xdo("windowactivate", "--sync", self.other_window)
        yield
        self.xdo("windowactivate", "--sync", self.window)

    @contextlib.contextmanager
    def another_window_by_keys(self):
        self.key("alt+Tab")
        yield
        self.key("alt+Tab")
        self.back()

    @contextlib.contextmanager
    def minimised(self):
        self.xdo("windowminimize", "--sync", self.window)
        yield
        self.xdo("windowactivate", "--sync", self.window)

    @contextlib.contextmanager
    def another_workspace(self):
        self.xdo("set_desktop", 1)
        yield
        self.xdo("set_desktop", 0)
        self.back()

    @contextlib.contextmanager
    def managers_menu(self):
        self.xdo("key", "--clearmodifiers", "alt+space")
        yield
        self.xdo("key", "Escape")

    @contextlib.contextmanager
    def locked(self):
        locker = self.start(["i3lock", "--nofork"], env=self.env)
        self.wait_until(lambda: "i3lock" in self.ask("xwininfo", "-root", "-tree"), "the screen is locked", 5)
        yield
        locker.kill()  # as one that has heard the password
        locker.wait()

    WAYS = [another_window, another_window_by_keys, minimised, another_workspace, managers_menu, locked]

    @contextlib.contextmanager
    def away(self, way):
        with way(self):
            time.sleep(0.2)
            yield
        time.sleep(0.25)

    def sent_after(self, mark, text, what):
        self.wait_until(lambda: text in self.tap.sent[mark:], what, 3)

    def test_a_press_acts_where_the_pointer_rests(self):
        for way in self.WAYS:
            for widget, wire in (("stop_all", b"D"), ("io/out/1", b"U")):
                with self.subTest(way=way.__name__, widget=widget):
                    self.xdo("mousemove", *self.places[widget])
                    with self.away(way):
                        pass
                    mark = self.tap.mark()
                    self.xdo("click", 1)
                    self.sent_after(mark, wire, f"{widget} clicked once")

    def test_a_press_acts_where_the_window_has_gone(self):
        self.xdo("mousemove", *self.places["stop_all"])
        x, y = (there - here for there, here in zip(self.places["stop_all"], self.places["io/out/1"]))
        self.xdo("windowmove", "--sync", self.window, x, y)
        self.addCleanup(self.xdo, "windowmove", "--sync", self.window, 0, 0)
        time.sleep(0.3)
        mark = self.tap.mark()
        self.xdo("click", 1)
        self.sent_after(mark, b"U", "the output that lies under the pointer now")

    def test_a_key_held_over_does_not_jog_again(self):
        self.xdo("mousemove", WIDTH // 2, HEIGHT - 10)
        for way in self.WAYS:
            with self.subTest(way=way.__name__):
                begin = self.wire.first_motor()[-1]
                self.xdo("keydown", "Right")
                self.wait_until(lambda: self.wire.first_motor()[-1] > begin + 400, "jogs", 5)
                with self.away(way):
                    stopped = self.at_rest()
                time.sleep(0.7)  # more than the delay of auto-repeat
                here = self.wire.first_motor()[-1]
                self.xdo("keyup", "Right")
                self.assertEqual(here, stopped, "does not jog again")
                time.sleep(0.15)
                self.xdo("keydown", "Right")
                self.wait_until(lambda: self.wire.first_motor()[-1] > stopped + 400, "a new press does", 5)
                self.xdo("keyup", "Right")

    def leave_the_field(self):
        """The keys jog again."""
        self.xdo("mousemove", WIDTH // 2, 25, "click", 1)
        time.sleep(0.3)

    def go_to(self, place):
        self.click("goto/1")
        self.xdo("key", "ctrl+a")
        self.type(place)
        self.key("Return")

    def test_escape_in_an_open_list_closes_it_and_stops(self):
        begin = self.at_rest()
        self.go_to(str(begin + 20000))
        self.wait_until(lambda: self.wire.first_motor()[-1] > begin + 200, "motor 1 moves", 10)
        self.click("dro/unit")
        mark = self.tap.mark()
        self.key("Escape")
        self.sent_after(mark, b"D", "the stop")
        self.assertLess(self.at_rest(), begin + 20000)
        mark = self.tap.mark()
        self.click("io/out/1")  # which an open list would have kept for itself
        self.sent_after(mark, b"U", "the output")
        self.leave_the_field()

    def test_a_double_click_selects_the_number(self):
        begin = self.at_rest()
        self.click("goto/1")
        self.xdo("key", "ctrl+a")
        self.xdo("type", "--delay", 40, "--", "-1234,5")
        self.xdo("click", "--repeat", 2, "--delay", 60, 1)
        time.sleep(0.3)
        mark = self.tap.mark()
        self.type(str(begin + 200))
        self.key("Return")
        self.sent_after(mark, f"IA1M{begin + 200}\r".encode(), "the second number alone")
        self.at_rest()
        self.leave_the_field()

    def test_a_press_on_what_has_only_just_come_moves_nothing(self):
        begin = self.at_rest()
        self.click("program/text")
        self.type("I1M400")
        run = ("mousemove", *self.places["program/run"], "click", 1)
        self.click("tab/setup")
        mark = self.tap.mark()
        self.xdo("mousemove", *self.places["tab/program"], "click", 1, *run)
        time.sleep(1)
        self.assertNotIn(b"I1M400", self.tap.sent[mark:])
        self.assertEqual(self.wire.first_motor()[-1], begin)
        self.until_done(lambda: self.xdo(*run), lambda: b"I1M400" in self.tap.sent[mark:], "the next press runs it")
        self.assertEqual(self.at_rest(), begin + 400)
        self.leave_the_field()


if __name__ == "__main__":
    unittest.main(verbosity=2)
