#!/usr/bin/env python3
"""Speaks to `handwheel emulate vme58 --bus` from a process of its own, with bus cycles as the contract prints them:
the transcripts of tests/talk/vme58, and the probe with which a control system looks for a board.

Usage: bus_port.py HANDWHEEL TALK_FOLDER"""
import concurrent.futures
import pathlib
import re
import socket
import struct
import subprocess
import sys
import tempfile
import time

INPUT_PUT, OUTPUT_GET, INPUT_BUFFER = 0x000, 0x002, 0x004
OUTPUT_PUT, INPUT_GET, OUTPUT_BUFFER = 0x800, 0x802, 0x804
CONTROL, STATUS = 0xFE1, 0xFE3
CELLS = 256
SPEED = 20  # of the emulator: transcripts take their time
SLOWLY = {"three_axes.talk": 0.25}  # asks where axes are on their way, which takes an exact moment
ON_THE_WAY = 0.05  # how far off the moment may be, as a share of the way
PATIENCE = 20
HAND_EVERY_S = 1.5  # hands come by a bench file, so late that what stands before them has certainly been done
AXES = "XYZTUVRS"


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

    def hear_reply(self):
        """One whole reply, however long its numbers are."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            self.fetch()
            match = re.match(r"\n\r\r?[^\n\r]+\n\r\r?", self.came)
            if match:
                self.came = self.came[match.end():]
                return match.group(0)
            time.sleep(0.002)
        return self.came


def unescape(text):
    def one(match):
        code = match.group(1)
        return {"r": "\r", "n": "\n", "0": "\0", "\\": "\\"}.get(code) or chr(int(code[1:], 16))

    return re.sub(r"\\(r|n|0|\\|x[0-9A-Fa-f]{2})", one, text)


class Emulator:
    def __init__(self, handwheel, options, speed=SPEED, bench=None):
        command = [handwheel, "emulate", "vme58", "--bus", "127.0.0.1:0", "--speed", str(speed)]
        for option in options:
            key, value = option.split("=")
            command += ["--" + key, value]
        if bench:
            command += ["--bench", bench]
        self.begun = time.monotonic()  # at the latest: its clock starts behind this moment, ...
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        line = self.process.stdout.readline()
        match = re.fullmatch(r"ready vme58 bus (\S+)\n", line)
        assert match, f"no ready line: {line!r}"
        self.ready = time.monotonic()  # ... and before this one
        self.place = match.group(1)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        assert self.process.wait(10) == 0, "the emulator did not end well"


class Hands:
    """The `!` lines of a transcript as a bench file: those at its head are there from the start, each other one comes
    at a time of its own."""

    def __init__(self, lines, speed):
        self.speed, self.times, self.text, later = speed, [], [], []
        waited, said = 0.0, False
        for line in lines:
            if line.startswith("~"):
                waited += seconds(line[1:])
            elif line.startswith(">"):
                said = True
            elif line.startswith("!"):
                words = line[1:].split()
                if words[0] == "place":
                    assert not said, "a load is placed before anything is said"
                    self.text += [f"[axis.{AXES[int(words[1]) - 1]}]"] + [self.placed(w) for w in words[2:]]
                    continue
                at = (len(self.times) + 1) * HAND_EVERY_S * speed + waited
                self.times.append(at)
                later += ["[[at]]", f"t = {at}", self.hand(words)]
        self.text += later

    @staticmethod
    def placed(word):
        key, value = word.split("=")
        zone = re.fullmatch(r"(-?\d+)\.\.(-?\d+)", value)
        return f"{key} = [{zone.group(1)}, {zone.group(2)}]" if zone else f"{key} = {value}"

    @staticmethod
    def hand(words):
        what, number, state = words
        assert what == "input", f"no bench file is written for {what} yet"
        return f"input = [{int(number) - 1}, {'true' if state == 'low' else 'false'}]"  # the maker counts from 0

    def wait_for_next(self, emulator):
        at = self.times.pop(0) / self.speed
        assert time.monotonic() < emulator.begun + at, "this machine is too slow for the transcript"
        time.sleep(max(0, emulator.ready + at - time.monotonic()) + 0.02)


def seconds(text):
    value, unit = re.fullmatch(r"([0-9.]+)(us|ms|s)", text.strip()).groups()
    return float(value) * {"us": 1e-6, "ms": 1e-3, "s": 1}[unit]


def near(heard, expected):
    """Both are lists of numbers, and one is the other a moment earlier or later."""
    pattern = r"\n\r-?\d+(,-?\d+)*\n\r"
    if not re.fullmatch(pattern, heard) or not re.fullmatch(pattern, expected):
        return False
    got, wanted = ([int(n) for n in text.strip().split(",")] for text in (heard, expected))
    longest = max(wanted, key=abs)
    if len(got) != len(wanted) or longest == 0:
        return False
    share = got[wanted.index(longest)] / longest
    return abs(share - 1) <= ON_THE_WAY and all(abs(g - share * w) <= 1 for g, w in zip(got, wanted))


def play(handwheel, path, folder):
    lines = path.read_text().splitlines()
    options = [word for line in lines if line.startswith("@") for word in line[1:].split()]
    slow = path.name in SLOWLY
    speed = SLOWLY.get(path.name, SPEED)
    hands = Hands(lines, speed)
    bench = folder / (path.stem + ".toml")
    bench.write_text("\n".join(hands.text) + "\n")
    with Emulator(handwheel, options, speed, str(bench)) as emulator:
        host = Host(Bus(emulator.place))
        last_wait = max((n for n, line in enumerate(lines, 1) if line.startswith("~")), default=0)
        for number, line in enumerate(lines, 1):
            kind, rest = line[:1], line[2:]
            if kind == ">":
                host.say(unescape(rest))
            elif kind == "<" and rest:
                expected = unescape(rest)
                on_the_way = slow and number < last_wait
                heard = host.hear_reply() if on_the_way else host.hear(len(expected))
                fits = near(heard, expected) if on_the_way else heard == expected
                assert fits, f"{path.name}:{number}: expected {expected!r}, heard {heard!r}"
            elif kind == "<":
                host.fetch()
                assert host.came == "", f"{path.name}:{number}: heard {host.came!r}"
            elif kind == "~":
                late = 0 if slow and number < last_wait else 0.1 if slow else 0.01
                time.sleep(seconds(rest) / speed + late)
            elif kind == "!" and rest.split()[0] != "place":
                hands.wait_for_next(emulator)


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
    transcripts = sorted(folder.glob("*.talk"))
    assert transcripts, "there are no transcripts"
    with tempfile.TemporaryDirectory() as bench_folder, concurrent.futures.ThreadPoolExecutor(4) as pool:
        for _ in pool.map(lambda path: play(handwheel, path, pathlib.Path(bench_folder)), transcripts):
            pass  # what it raised is raised here
    print("played over the bus port:", ", ".join(path.name for path in transcripts))


if __name__ == "__main__":
    main()
