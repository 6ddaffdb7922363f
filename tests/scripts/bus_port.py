#!/usr/bin/env python3
"""Speaks to `handwheel emulate vme58 --bus` from a process of its own, with bus cycles as the contract prints them:
the transcripts of tests/talk/vme58, and the probe with which a control system looks for a board.

Usage: bus_port.py HANDWHEEL TALK_FOLDER"""
import pathlib
import re
import socket
import struct
import subprocess
import sys
import time

INPUT_PUT, OUTPUT_GET, INPUT_BUFFER = 0x000, 0x002, 0x004
OUTPUT_PUT, INPUT_GET, OUTPUT_BUFFER = 0x800, 0x802, 0x804
CONTROL, STATUS = 0xFE1, 0xFE3
CELLS = 256
SPEED = 20  # of the emulator: transcripts take their time
PATIENCE = 20
EXACT = {"three_axes.talk"}  # asks where axes are at an exact moment: that is for virtual time


class Bus:
    """Bus cycles over TCP."""

    FORMAT = {1: ">B", 2: ">H", 4: ">I"}

    def __init__(self, place):
        host, port = place.rsplit(":", 1)
        self.socket = socket.create_connection((host, int(port)), timeout=PATIENCE)

    def read(self, width, offset):
        self.socket.sendall(struct.pack(">BH", width, offset))
        answer = b""
        while len(answer) < width:
            more = self.socket.recv(width - len(answer))
            if not more:
                raise ConnectionError("the bus port closed")
            answer += more
        return struct.unpack(self.FORMAT[width], answer)[0]

    def write(self, width, offset, value):
        self.socket.sendall(struct.pack(">BH", 0x80 | width, offset) + struct.pack(self.FORMAT[width], value))


class Host:
    """A host's side of the rings."""

    def __init__(self, bus):
        self.bus = bus
        self.put = bus.read(2, OUTPUT_PUT)
        self.get = bus.read(2, INPUT_PUT)
        bus.write(2, INPUT_GET, self.get)
        self.came = ""

    def say(self, text):
        for c in text:
            self.bus.write(2, OUTPUT_BUFFER + 2 * self.put, ord(c))
            self.put = (self.put + 1) % CELLS
        self.bus.write(2, OUTPUT_PUT, self.put)

    def fetch(self):
        end = self.bus.read(2, INPUT_PUT)
        while self.get != end:
            self.came += chr(self.bus.read(2, INPUT_BUFFER + 2 * self.get) & 0xFF)
            self.get = (self.get + 1) % CELLS
        self.bus.write(2, INPUT_GET, self.get)

    def hear(self, count):
        end = time.monotonic() + PATIENCE
        self.fetch()
        while len(self.came) < count and time.monotonic() < end:
            time.sleep(0.002)
            self.fetch()
        heard, self.came = self.came[:count], self.came[count:]
        return heard


def unescape(text):
    def one(match):
        code = match.group(1)
        return {"r": "\r", "n": "\n", "0": "\0", "\\": "\\"}.get(code) or chr(int(code[1:], 16))

    return re.sub(r"\\(r|n|0|\\|x[0-9A-Fa-f]{2})", one, text)


class Emulator:
    def __init__(self, handwheel, options):
        command = [handwheel, "emulate", "vme58", "--bus", "127.0.0.1:0", "--speed", str(SPEED)]
        for option in options:
            key, value = option.split("=")
            command += ["--" + key, value]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        line = self.process.stdout.readline()
        match = re.fullmatch(r"ready vme58 bus (\S+)\n", line)
        assert match, f"no ready line: {line!r}"
        self.place = match.group(1)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        assert self.process.wait(10) == 0, "the emulator did not end well"


def play(handwheel, path):
    lines = path.read_text().splitlines()
    options = [word for line in lines if line.startswith("@") for word in line[1:].split()]
    if path.name in EXACT or any(line.startswith("!") for line in lines):
        return False  # hands on the bench do not pass a bus
    with Emulator(handwheel, options) as emulator:
        host = Host(Bus(emulator.place))
        for number, line in enumerate(lines, 1):
            kind, rest = line[:1], line[2:]
            if kind == ">":
                host.say(unescape(rest))
            elif kind == "<" and rest:
                expected = unescape(rest)
                heard = host.hear(len(expected))
                assert heard == expected, f"{path.name}:{number}: expected {expected!r}, heard {heard!r}"
            elif kind == "<":
                host.fetch()
                assert host.came == "", f"{path.name}:{number}: heard {host.came!r}"
            elif kind == "~":
                value, unit = re.fullmatch(r"([0-9.]+)(us|ms|s)", rest.strip()).groups()
                time.sleep(float(value) * {"us": 1e-6, "ms": 1e-3, "s": 1}[unit] / SPEED + 0.01)
    return True


def probe(handwheel):
    """Words at each 0x100, the registers byte by byte, 32 bits as two halves; a mark that a reset clears."""
    with Emulator(handwheel, []) as emulator:
        bus = Bus(emulator.place)
        for offset in range(0, 0x1000, 0x100):
            bus.read(2, offset)
        assert bus.read(1, STATUS) & 0x02, "not initialized"
        bus.write(2, 0xA04, 0x1234)
        assert bus.read(2, 0xA04) == 0x1234
        assert bus.read(1, 0xA05) == 0x34, "big-endian"
        host = Host(bus)
        host.say("AX LP-2\n")
        bus.write(1, CONTROL, 0x01)
        end = time.monotonic() + PATIENCE
        while bus.read(1, CONTROL) & 0x01 and time.monotonic() < end:
            time.sleep(0.001)
        assert bus.read(4, 0x404) == 0xFFFFFFFE, "32 bits"
        assert bus.read(2, 0x404) == 0xFFFF and bus.read(2, 0x406) == 0xFFFE, "high half first"
        host.say("XQ\n")
        time.sleep(0.01)
        assert bus.read(1, STATUS) & 0x01 and not bus.read(1, STATUS) & 0x01, "reading clears a command error"
        other = Bus(emulator.place)
        assert other.read(2, 0xA04) == 0x1234, "two clients, one board"


def main():
    handwheel, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    probe(handwheel)
    played = [path.name for path in sorted(folder.glob("*.talk")) if play(handwheel, path)]
    assert played, "no transcript could be played"
    print("played over the bus port:", ", ".join(played))


if __name__ == "__main__":
    main()
