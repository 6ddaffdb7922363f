#!/usr/bin/env python3
"""What becomes of what moves when the window is closed by its manager, or ended by a signal."""
import ctypes
import json
import pathlib
import signal
import subprocess
import time
import unittest

from window_test import PROGRAM, Window


class ClientMessage(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("window", ctypes.c_ulong), ("message_type", ctypes.c_ulong),
                ("format", ctypes.c_int), ("data", ctypes.c_long * 5), ("room", ctypes.c_long * 24)]


CLIENT_MESSAGE = 33


class Closing(Window):
    def ask_to_close(self):
        """As the button of a window manager's frame and Alt+F4 do."""
        x = ctypes.CDLL("libX11.so.6")
        x.XOpenDisplay.restype = ctypes.c_void_p
        x.XInternAtom.restype = ctypes.c_ulong
        display = ctypes.c_void_p(x.XOpenDisplay(self.env["DISPLAY"].encode()))
        window = ctypes.c_ulong(int(self.window))
        event = ClientMessage(type=CLIENT_MESSAGE, window=int(self.window), format=32,
                              message_type=x.XInternAtom(display, b"WM_PROTOCOLS", 0))
        event.data[0] = x.XInternAtom(display, b"WM_DELETE_WINDOW", 0)
        x.XSendEvent(display, window, 0, ctypes.c_long(0), ctypes.byref(event))
        x.XSync(display, 0)
        x.XCloseDisplay(display)
        time.sleep(0.7)

    def run_a_program(self):
        self.click("terminal/command")
        self.type("PM0,C,S1M2000,I1M90000,R")
        self.key("Return")
        self.wait_until(lambda: self.wire.first_motor()[-1] > 500, "motor 1 moves")

    def where(self):
        told = subprocess.run([PROGRAM, "send", self.address, "X"], check=True, capture_output=True, text=True, timeout=60)
        return int(told.stdout.split()[0])

    def assert_stands(self):
        here = self.where()
        time.sleep(0.3)
        self.assertEqual(here, self.where())
        self.assertLess(here, 90000)

    def assert_moves_on(self):
        self.assertIsNone(self.console.poll(), "the window stays")
        here = self.wire.first_motor()[-1]
        self.wait_until(lambda: self.wire.first_motor()[-1] > here + 200, "it moves on")

    def last_end(self):
        return pathlib.Path(self.env["XDG_STATE_HOME"]) / "handwheel" / "last-end.json"

    def test_the_first_request_asks_and_the_second_stops_and_closes(self):
        self.run_a_program()
        self.ask_to_close()
        self.assert_moves_on()
        self.key("Return")  # stays
        self.assert_moves_on()
        self.ask_to_close()
        self.assert_moves_on()
        self.ask_to_close()
        self.assertEqual(self.console.wait(15), 0)
        time.sleep(1.5)  # the ramp
        self.assert_stands()

    def test_a_session_that_ends_stops_what_it_began_and_the_next_tells(self):
        self.run_a_program()
        self.console.send_signal(signal.SIGTERM)
        self.assertEqual(self.console.wait(15), 0)
        self.assert_stands()
        end = json.loads(self.last_end().read_text())["ends"][0]
        self.assertEqual(end["how"], "SIGTERM")
        self.assertEqual(end["controllers"], [{"name": "VXM", "what": "Program 0 was running", "fate": 0}])
        self.start([PROGRAM], env=self.env, stderr=subprocess.DEVNULL)
        self.wait_until(lambda: not self.last_end().exists(), "the next start reads it")

    def test_what_somebody_else_began_goes_on(self):
        self.wire.socket.sendall(b"PM0,C,S1M2000,I1M90000,R")
        self.wait_until(lambda: self.wire.first_motor()[-1] > 500, "motor 1 moves")
        self.console.send_signal(signal.SIGTERM)
        self.assertEqual(self.console.wait(15), 0)
        here = self.where()
        time.sleep(0.3)
        self.assertGreater(self.where(), here)
        self.assertEqual(json.loads(self.last_end().read_text())["ends"][0]["controllers"][0]["fate"], 3)


if __name__ == "__main__":
    unittest.main(verbosity=2)
