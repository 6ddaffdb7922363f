#!/usr/bin/env python3
"""The program as a shell sees it: arguments, exit statuses, sentences, endpoints.   command_line.py [CLASS...]"""
import concurrent.futures
import contextlib
import hashlib
import json
import os
import pathlib
import re
import select
import signal
import socket
import subprocess
import sys
import tempfile
import termios
import threading
import time
import unittest

PROGRAM = os.environ.get("HANDWHEEL", "build/handwheel")
HERE = pathlib.Path(__file__).resolve().parent


def run(*arguments, timeout=60, settings=None, **more):
    """`settings`: variables of the environment."""
    env = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")} | (settings or {})
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=timeout,
                          env=env, **more)


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def profile(self, key, axis):
        """What the console keeps of the first axis of a controller, if XDG_CONFIG_HOME is this folder."""
        total = 2166136261
        for byte in key.encode():
            total = (total ^ byte) * 16777619 & 0xFFFFFFFF
        name = f"handwheel/profiles/{key.replace('@', '-')}-{total:08x}.json"
        return self.file(name, json.dumps({"controller": key, "axes": [axis]}))

    def interrupt(self, said, *arguments, when=None):
        """Lets the program work until it prints `when`, or for a while, and presses Ctrl-C."""
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True)
        if when:
            self.assertEqual(process.stdout.readline(), when)
            time.sleep(0.3)  # it has moved
        else:
            time.sleep(1.5)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=30)
        self.assertEqual(process.returncode, 1, (out, err))
        self.assertIn(said, err)

    def stands(self, address, question="X"):
        """Waits until two readings agree, which they never do of an axis that was not stopped; where it is."""
        places = [None]
        for _ in range(20):
            places.append(run("send", address, question).stdout)
            if places[-1] == places[-2] != "":
                return places[-1].strip()
        self.fail(f"it moves on: {places}")

    def expect(self, result, status, *parts):
        self.assertEqual(result.returncode, status, result)
        for part in parts:
            self.assertIn(part, result.stderr if status else result.stdout)


@contextlib.contextmanager
def emulator(*arguments):
    """Serves an emulator; gives the lines that it printed when ready."""
    process = subprocess.Popen([PROGRAM, "emulate", *map(str, arguments)], stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
    endpoints = sum(1 for a in arguments if str(a) in ("--tcp", "--pty"))
    try:
        yield [process.stdout.readline().strip() for _ in range(endpoints)], process
    finally:
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=30)


def port_of(line):
    return line.rsplit(" ", 1)[1]


class Log(Case):
    REFUSED = 'local c = hw.check(hw.open("vxm@emulator"))\nprint(c:move_to{[1] = 99999999})\n'

    def test_says_why_of_the_subject_that_is_asked_for(self):
        script = self.file("refused.lua", self.REFUSED)
        told = run("run", script, "--log", "pump=debug").stderr
        self.assertRegex(told, r"debug pump: vxm: command \d+ not done: Position 99999999 of motor 1 lies outside")
        self.assertNotIn(" driver", told)
        self.assertIn("debug driver.vxm: ", run("--log", "link=debug,driver.vxm=debug", "run", script).stderr)

    def test_says_what_a_script_was_refused(self):
        told = run("run", self.file("refused.lua", self.REFUSED), "--log", "script=debug").stderr
        self.assertRegex(told, r"debug script: .*refused.lua:2: refused \(refused\): Position 99999999 of motor 1")

    def test_says_nothing_unless_it_is_asked_for(self):
        self.assertNotIn("debug", run("run", self.file("refused.lua", self.REFUSED)).stderr)

    def test_tells_what_there_is(self):
        self.expect(run("send", "vxm@emulator", "V", "--log", "lnik=debug"), 2, '"lnik=debug"', "SUBJECT=LEVEL")
        self.expect(run("send", "vxm@emulator", "V", "--log", "link=loud"), 2, '"link=loud"')
        self.expect(run("send", "vxm@emulator", "V", "--log", "pump=debug,driver.vmx=debug"), 2,
                    'no controller model "vmx"', 'Did you mean "vxm"?')


class Demo(Case):
    def test_without_a_display_it_works_and_leaves_pictures(self):
        pictures = self.folder / "pictures"
        result = run("demo", "--headless", "--pictures", pictures, timeout=170)
        self.expect(result, 0, "let go: stopped at")
        names = {p.name for p in pictures.glob("*.png")}
        self.assertLessEqual({"connect.png", "program.png", "jog.png", "pmx-draws.png", "dmx-bus.png", "vme58-hole.png"}, names)


class Usage(Case):
    def test_version_and_help(self):
        self.expect(run("--version"), 0, "handwheel ")
        result = run("--help")
        self.expect(result, 0)
        for name in "open demo run emulate send check simulate convert scan backup restore params".split():
            self.assertIn(name, result.stdout)
            self.expect(run(name, "--help"), 0, "handwheel " + name)

    def test_the_version_names_the_commit(self):
        self.assertRegex(run("--version").stdout, r"^handwheel \d+\.\d+\.\d+( \(\w+(, changed)?\))?\n$")

    def test_manual_page_and_completion_know_every_command_and_option(self):
        for form in ("man", "bash", "zsh", "fish"):
            text = run("reference", form).stdout.replace("\\-", "-")
            for name in "open demo run emulate send check simulate convert scan backup restore params reference".split():
                self.assertIn(name, text, form)
                for option in re.findall(r"--([a-z-]+)", run(name, "--help").stdout.split("Options:")[-1]):
                    self.assertRegex(text, rf"(--|-l ){option}\b", form)
        self.expect(run("reference", "csh"), 2, "Choose man, bash, zsh or fish")

    def test_wrong_usage_is_2(self):
        self.expect(run("nonsense"), 2, "nonsense")
        self.expect(run("run"), 2, "SCRIPT.lua")
        self.expect(run("run", "--nonsense", "x.lua"), 2, "--nonsense")
        self.expect(run("emulate", "vxm"), 2, "--tcp")
        for where in ("127.0.0.1", "127.0.0.1:", "127.0.0.1:lots", "127.0.0.1:70000", ""):
            self.expect(run("emulate", "dmx-k-sa", "--tcp", where), 2, "--tcp", "Give a port too")
        self.expect(run("emulate", "pxm", "--tcp", "127.0.0.1:0"), 2, 'no controller model "pxm"')
        self.expect(run("send", "vxm@nowhere", "V"), 2, '"nowhere" is not a transport')
        self.expect(run("send", "vxm@emulator"), 2, "TEXT")
        self.expect(run("simulate", "x.vxm"), 2, "--for")
        self.expect(run("simulate", "x.vxm", "--for", "vxm", "--for-seconds", "soon"), 2, "--for-seconds soon")
        self.expect(run("backup", "vxm@emulator"), 2, "-o FILE.toml")
        self.expect(run("convert", "a.dxf", "--for", "vxm"), 2, "-o OUT")
        self.expect(run("convert", "a.dxf", "-o", "a.vxm"), 2, "--for")
        self.expect(run("convert", "a.dxf", "--for", "vxm", "-o", "a.vxm", "--origin", "there"), 2, "--origin there")
        self.expect(run("convert", "a.dxf", "--for", "vxm", "-o", "a.vxm", "--per-unit", "0"), 2, "more than 0")

    def test_a_failed_job_is_1(self):
        self.expect(run("run", self.folder / "none.lua"), 1, "There is no file", "none.lua")
        self.expect(run("check", self.folder / "none.vxm", "--for", "vxm"), 1, "none.vxm")
        self.expect(run("send", "vxm@serial:/dev/none", "V"), 1, "/dev/none")
        self.expect(run("send", "vxm@tcp:127.0.0.1:1", "V"), 1, "127.0.0.1:1")


class Scripts(Case):
    def script(self, text, *arguments):
        return run("run", self.file("s.lua", text), *arguments)

    def test_arguments(self):
        text = "print(#hw.args, hw.args[1], hw.args[2], hw.args[3])"
        self.expect(self.script(text), 0, "0\tnil")
        self.expect(self.script(text, "a", "b"), 0, "2\ta\tb")
        self.expect(self.script(text, "--traffic", self.folder / "t", "a", "--", "--gui", "-x"), 0, "3\ta\t--gui\t-x")
        path = self.file("s.lua", text)
        self.expect(run("run", "--traffic", self.folder / "t", path, "a"), 0, "1\ta")

    def test_declared_arguments(self):
        declared = """local a = hw.arguments{about = "Scans a plate.",
            {name = "table", help = "where the result goes"},
            {name = "count", kind = "whole", default = 10, help = "how many rows"},
            {name = "way", default = "plus", choices = {"plus", "minus"}},
            {name = "dry", kind = "flag", help = "moves nothing"}}
          print(a.table, a.count, a.way, a.dry)"""
        for words, shown in ((["a.csv"], "a.csv\t10\tplus\tfalse"),
                             (["count=3", "a.csv"], "a.csv\t3\tplus\tfalse"),
                             (["--", "--dry", "--count", "-4", "--way=minus", "a.csv"], "a.csv\t-4\tminus\ttrue")):
            result = self.script(declared, *words)
            self.assertEqual((result.returncode, result.stdout), (0, shown + "\n"), result)
        for words, why in (([], '"table" is missing.'), (["a", "b"], '"b" is one word too many.'),
                           (["a", "--", "--cuont", "3"], 'There is no "--cuont". Did you mean "count"?'),
                           (["a", "count=x"], '"count" must be a whole number, not "x".'),
                           (["a", "way=pluss"], '"way" must be one of plus, minus, not "pluss". Did you mean "plus"?'),
                           (["a", "count=1", "count=2"], '"count" is given twice.'),
                           (["a", "--", "--count"], 'A value is missing after "--count".')):
            self.expect(self.script(declared, *words), 2, why, "--help lists the options.")
        told = self.script(declared, "--", "--help")
        self.assertEqual(told.returncode, 0, told)
        for part in ("TABLE [-- OPTIONS]", "Scans a plate.", "--count N", "how many rows (default 10)", "--way plus|minus"):
            self.assertIn(part, told.stdout)
        self.expect(self.script("hw.arguments{{name = 'a', sort = 1}}", "--", "--help"), 1, 'an argument has no "sort"')

    def test_what_was_written_is_told_at_the_end(self):
        traffic = os.path.join(self.folder, "wire.txt")
        result = self.script("hw.write_csv('t.csv', {{1}, {2}}) hw.write_csv('t.csv', {{3}}) error('x')", "--traffic", traffic)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr.count("t.csv (1 row)"), 1, result.stderr)
        self.assertIn("wire.txt (traffic).", result.stderr)

    def test_results_and_logs_go_different_ways(self):
        result = self.script('print("result") hw.log("log line")')
        self.assertEqual(result.stdout, "result\n")
        self.assertIn("log line", result.stderr)

    def test_an_error_names_its_line(self):
        self.expect(self.script("\n\nerror('boom')"), 1, "s.lua:3: boom")
        self.expect(self.script("\nlocal x = = 3"), 1, "s.lua:2: ")
        self.expect(self.script("local c\nc:wait()"), 1, "s.lua:2: ")
        self.expect(self.script("local function f()\nerror('deep')\nend\nf()"), 1, "s.lua:2: deep",
                    "called from s.lua:4")
        self.expect(self.script("error({})"), 1, "an error that is a table")

    def test_a_failed_check_ends_the_run(self):
        self.expect(self.script("hw.check(1 == 1)\nhw.check(false, 'not so')\nprint('never')"), 1,
                    "s.lua:2: hw.check failed: not so")
        result = self.script("pcall(function()\nhw.check(false, 'inside')\nend)\nprint('never')")
        self.expect(result, 1, "s.lua:2: hw.check failed: inside")
        self.assertNotIn("never", result.stdout)

    def test_an_error_in_a_timed_function(self):
        self.expect(self.script("local c = hw.open('vxm@emulator')\nc.bench:at(1, function()\nerror('late')\nend)\n"
                                "hw.sleep(5)\nprint('never')"), 1, "s.lua:3: late")

    def test_virtual_time_is_fast(self):
        began = time.monotonic()
        self.expect(self.script("hw.sleep(3600) print(hw.now())"), 0, "3600")
        self.assertLess(time.monotonic() - began, 20)

    def test_real_time_is_not(self):
        began = time.monotonic()
        self.expect(self.script("hw.sleep(0.5)", "--realtime"), 0)
        self.assertGreater(time.monotonic() - began, 0.45)

    def test_a_real_port_makes_time_real(self):
        with emulator("vxm", "--tcp", "127.0.0.1:0") as (ready, _):
            began = time.monotonic()
            self.expect(self.script("local c = assert(hw.open('vxm@tcp:' .. hw.args[1]))\nhw.sleep(0.5)\n"
                                    "hw.check(c:query('V') == 'R') hw.check(not pcall(c.bench.jam, c.bench, 1))",
                                    port_of(ready[0])), 0)
            self.assertGreater(time.monotonic() - began, 0.45)

    def test_an_interrupted_script_stops_the_motors(self):
        with emulator("vxm", "--tcp", "127.0.0.1:0") as (ready, _):
            script = self.file("jog.lua", "local c = assert(hw.open('vxm@tcp:' .. hw.args[1]))\n"
                                          "c:jog(1, '+') print('jogs') hw.sleep(1000)")
            self.interrupt("told to stop", "run", script, port_of(ready[0]), when="jogs\n")
            self.assertNotEqual(self.stands("vxm@tcp:" + port_of(ready[0])), "+0000000")

    def test_a_stop_that_is_not_answered_keeps_nothing_back(self):
        with emulator("vxm", "--tcp", "127.0.0.1:0") as (ready, _):
            address = "vxm@tcp:" + port_of(ready[0])
            self.expect(run("send", address, "D", "V"), 0, "R")
            self.expect(run("send", address, "res", "V"), 0, "R")

    def test_an_interrupted_send_stops_the_motors(self):
        with emulator("vxm", "--tcp", "127.0.0.1:0") as (ready, _):
            address = "vxm@tcp:" + port_of(ready[0])
            self.interrupt("Interrupted. The controller was told to stop.", "send", address, "PM-0,S1M1000,I1M60000,R",
                           "PM-1,S1M1000,I1M-60000,R")
            self.assertNotEqual(self.stands(address), "+0000000")

    def test_an_interrupted_send_stops_what_has_just_begun(self):
        with emulator("dmx-k-sa", "--tcp", "127.0.0.1:0", "--wire", "real") as (ready, _):
            address = "dmx-k-sa@tcp:" + port_of(ready[0])
            self.expect(run("send", address, "EO=1"), 0)
            process = subprocess.Popen([PROGRAM, "send", address, "X1000000"] + ["ID"] * 100, text=True,
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.assertEqual(process.stdout.read(3), "OK\n")
            process.send_signal(signal.SIGINT)
            _, err = process.communicate(timeout=15)
            self.assertEqual(process.returncode, 1, err)
            self.assertIn("Interrupted. The controller was told to stop.", err)
            self.stands(address, "PX")


class Ends(Case):
    """What a script leaves behind when it fails, in virtual time."""
    def traffic_after(self, status, text, *parts):
        """Runs it; what went to the controllers: (time, wire, text)."""
        path = self.folder / "traffic"
        self.expect(run("run", self.file("s.lua", text), "--traffic", path), status, *parts)
        lines = re.findall(r"(?m)^ *([\d.]+) (\d+) > (.*)$", path.read_text())
        return [(float(t), int(wire), what) for t, wire, what in lines]

    def test_a_program_in_its_pause_is_stopped(self):
        said = self.traffic_after(1, "local c = hw.open('vxm@emulator')\n"
                                     "c:load('S1M2000,I1M400,P20,I1M-400,P20,L0') assert(c:run()) hw.sleep(1.3)\n"
                                     "hw.check(not c:status().moving, 'it pauses') hw.check(false)\n", "s.lua:3: ")
        self.assertIn("K", [what for _, _, what in said])

    def test_what_began_after_the_last_look_is_stopped(self):
        said = self.traffic_after(1, "local c = hw.open('pmx-4ex-sa@emulator,wire=real')\n"
                                     "c:query('EO=15') c:query('INC') hw.sleep(1)\n"
                                     "hw.check(c:query('X1000000') == '1')\n", "s.lua:3: ")
        self.assertIn("@00STOP\\r", [what for _, _, what in said])

    def test_what_was_sent_last_does_not_follow_the_stop(self):
        said = self.traffic_after(1, "local c = hw.open('pmx-4ex-sa@emulator,wire=real')\n"
                                     "c:query('EO=15') hw.sleep(1) c:send('X1000000') hw.check(false)\n")
        words = [what for _, _, what in said]
        self.assertIn("@00STOP\\r", words)
        self.assertNotIn("@00X1000000\\r", words[words.index("@00STOP\\r"):])

    # Ramps that are longer than the end of a script waits.
    SLOW = ("local a, b = hw.open('pmx-4ex-sa@emulator'), hw.open('pmx-4ex-sa@emulator')\n"
            "for _, c in ipairs {a, b} do for _, t in ipairs {'EO=15', 'INC', 'HS=20000', 'ACC=20000'} do\n"
            "assert(c:query(t) == 'OK') end end\n")

    def first_stops(self, said):
        return {wire: t for t, wire, what in reversed(said) if what.startswith("@00STOP")}

    def test_all_controllers_are_told_before_the_first_is_waited_for(self):
        said = self.traffic_after(1, self.SLOW + "a:query('X1000000') b:query('X1000000') hw.sleep(25) hw.check(false)",
                                  "pmx-4ex-sa@emulator: Watch the controller: stop was sent, and it has not come to rest yet.")
        stops = self.first_stops(said)
        self.assertEqual(sorted(stops), [1, 2])
        self.assertAlmostEqual(stops[1], stops[2], delta=0.01)

    def test_jogs_are_let_go_together(self):
        said = self.traffic_after(0, self.SLOW + "a:jog('X', '+') b:jog('X', '+') hw.sleep(25)")
        stops = self.first_stops(said)
        self.assertEqual(sorted(stops), [1, 2])
        self.assertAlmostEqual(stops[1], stops[2], delta=0.01)

    def test_a_stop_that_reaches_nobody_is_said(self):
        self.traffic_after(1, "local a, b = hw.open('vxm@emulator'), hw.open('pmx-4ex-sa@emulator')\n"
                              "a.bench:unplug(true) hw.sleep(5) hw.check(false)\n",
                           "These controllers may not have stopped:\nvxm@emulator: Use the controller's power switch")


class Interrupted(Case):
    """Ctrl-C and its kin while a script does what it likes."""
    JOG = "local c = assert(hw.open('vxm@tcp:' .. hw.args[1])) assert(c:jog(1, '+')) hw.sleep(0.3) print('now') "
    TOLD = "Interrupted. The controllers were told to stop."

    @contextlib.contextmanager
    def script(self, text, model="vxm"):
        """Runs it, until it prints a line, with an emulator."""
        with emulator(model, "--tcp", "127.0.0.1:0") as (ready, _):
            self.address = f"{model}@tcp:" + port_of(ready[0])
            process = subprocess.Popen([PROGRAM, "run", self.file("s.lua", text), port_of(ready[0])], text=True,
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            try:
                self.assertEqual(process.stdout.read(3), "now")
                time.sleep(0.3)
                yield process
            finally:
                process.kill()
                process.communicate()

    def assert_stands(self):
        self.assertNotEqual(self.stands(self.address), "+0000000")

    def ends_by(self, text, number):
        with self.script(self.JOG + text) as process:
            process.send_signal(number)
            _, err = process.communicate(timeout=15)
            self.assertEqual(process.returncode, 1, err)
            self.assertIn(self.TOLD, err)
            self.assert_stands()

    def test_a_script_that_computes(self):
        self.ends_by("local t = {} for i = 1, 1000 do t[i] = i end\n"
                     "while true do pcall(function() while true do table.concat(t, ',') end end) end", signal.SIGINT)

    def test_a_call_that_does_not_come_back(self):
        self.ends_by("pcall(string.find, ('a'):rep(60), ('a-'):rep(30) .. 'b') hw.sleep(100)", signal.SIGTERM)

    # A ramp of many seconds, which the end of the script waits for.
    SLOW = ("local c = assert(hw.open('pmx-4ex-sa@tcp:' .. hw.args[1]))\n"
            "for _, t in ipairs {'EO=15', 'HS=20000', 'ACC=20000'} do assert(c:query(t) == 'OK') end\n"
            "assert(c:jog('X', '+')) hw.sleep(4) print('now') ")

    def test_the_regular_end(self):
        with self.script(self.SLOW, "pmx-4ex-sa") as process:
            process.send_signal(signal.SIGINT)
            _, err = process.communicate(timeout=5)
            self.assertEqual(process.returncode, 1, err)
            self.assertIn(self.TOLD, err)

    def test_the_second_signal(self):
        with self.script(self.SLOW + "hw.sleep(100)", "pmx-4ex-sa") as process:
            process.send_signal(signal.SIGINT)
            time.sleep(0.5)
            self.assertIsNone(process.poll(), "it waits for the ramp")
            process.send_signal(signal.SIGINT)
            _, err = process.communicate(timeout=5)
            self.assertEqual(process.returncode, -signal.SIGINT, err)
            self.assertNotIn("told to stop", err)


class Output(Case):
    """What becomes of a command whose results nobody gets: a closed pipe, a full disk."""
    JOG = "local c = assert(hw.open(hw.args[1])) assert(c:jog(1, '+'))\n"
    UNREAD = "The output cannot be written: nobody reads the other end of the pipe. The controllers were told to stop."

    def into_a_pipe_that_closes(self, *arguments, lines=1):
        """Reads some lines of its output, as `head -1` does; its status and what it says aside."""
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True)
        for _ in range(lines):
            self.assertTrue(process.stdout.readline())
        process.stdout.close()
        said = process.stderr.read()
        process.stderr.close()
        return process.wait(timeout=30), said

    def onto_a_full_disk(self, *arguments):
        with open("/dev/full", "w") as full:
            return subprocess.run([PROGRAM, *map(str, arguments)], stdout=full, stderr=subprocess.PIPE, text=True,
                                  timeout=60)

    def assert_stands(self, address, question="X"):
        self.assertNotIn(self.stands(address, question), ("", "0", "+0000000"))

    def ends_unread(self, text):
        with emulator("vxm", "--tcp", "127.0.0.1:0") as (ready, _):
            address = "vxm@tcp:" + port_of(ready[0])
            status, said = self.into_a_pipe_that_closes("run", self.file("s.lua", self.JOG + text), address)
            self.assertEqual((status, said.splitlines()[-1]), (1, f"handwheel: s.lua:2: {self.UNREAD}"))
            self.assert_stands(address)

    def test_a_script_stops_what_it_began(self):
        self.ends_unread("for i = 1, 100 do print(c:position(1)) hw.sleep(0.1) end")

    def test_no_pcall_survives_it(self):
        self.ends_unread("for i = 1, 100 do pcall(print, c:position(1)) hw.sleep(0.1) end")

    def test_send_stops_what_it_began(self):
        with emulator("dmx-k-sa", "--tcp", "127.0.0.1:0") as (ready, _):
            address = "dmx-k-sa@tcp:" + port_of(ready[0])
            status, said = self.into_a_pipe_that_closes("send", address, "J+", *["ID"] * 1000,
                                                        lines=200)
            self.assertEqual((status, said), (1, "handwheel: The output cannot be written: nobody reads the other "
                                                 "end of the pipe. The controller was told to stop.\n"))
            self.assert_stands(address, "PX")

    def test_send_sends_nothing_more(self):
        with emulator("vxm", "--tcp", "127.0.0.1:0") as (ready, _):
            address = "vxm@tcp:" + port_of(ready[0])
            self.assertEqual(self.onto_a_full_disk("send", address, "X", "C,I1M4000,R").returncode, 1)
            self.assertEqual(run("send", address, "X").stdout, "+0000000\n")

    def test_a_full_disk_fails_the_job(self):
        program = self.file("a.vxm", "I1M400\n")
        arcus = self.file("a.prg", "PRG 0\nX100\nEND\n")
        said = "The output cannot be written: the disk is full."
        for arguments in (("run", self.file("s.lua", "print('a')")), ("send", "vxm@emulator", "X"),
                          ("check", program, "--for", "vxm"), ("simulate", program, "--for", "vxm"),
                          ("simulate", program, "--for", "vxm", "--json"),
                          ("compile", arcus, "--for", "pmx-4ex-sa", "--listing"),
                          ("compile", arcus, "--for", "pmx-4ex-sa", "-o", self.folder / "a.lst"),
                          ("backup", "vxm@emulator", "-o", self.folder / "a.toml"),
                          ("emulate", "vxm", "--tcp", "127.0.0.1:0"), ("scan", "--help"), ("--version",)):
            result = self.onto_a_full_disk(*arguments)
            self.assertEqual(result.returncode, 1, (arguments, result))
            self.assertEqual(result.stderr.count(said), 1, (arguments, result))

    def test_traffic_that_cannot_be_written(self):
        script = self.file("s.lua", "local c = hw.open('vxm@emulator') for i = 1, 1000 do c:query('X') end print('end')")
        result = run("run", script, "--traffic", "/dev/full")
        self.assertEqual((result.returncode, result.stdout), (1, ""), result)
        self.assertIn("/dev/full cannot be written: the disk is full. The controllers were told to stop.", result.stderr)
        short = self.file("short.lua", "print(hw.open('vxm@emulator'):query('X'))")
        self.expect(run("run", short, "--traffic", "/dev/full"), 1, "/dev/full cannot be written: the disk is full.")

    def test_files_that_may_not_grow(self):
        """Screenshots, tables, backups and traffic: a sentence, and nothing half written."""
        def small(*arguments):
            return subprocess.run(["prlimit", "--fsize=4096", PROGRAM, *map(str, arguments)], capture_output=True, text=True,
                                  timeout=60)
        why = "the file would be larger than is allowed there."
        said = "was not written: " + why
        shot = self.folder / "a.png"
        result = small("run", "--gui", self.file("shot.lua", f"ui.screenshot('{shot}')"))
        self.expect(result, 1, "a.png " + said)
        result = small("run", self.file("a.lua", """
          local rows = {}
          for i = 1, 20000 do rows[i] = {i, i * 2} end
          local c = assert(hw.open("vme58@emulator"))
          for file, write in pairs{["a.csv"] = function() return hw.write_csv("a.csv", rows) end,
                                   ["b.toml"] = function() return c:backup("b.toml") end} do
            local done, why, more = write()
            hw.check(done == nil and more.kind == "port" and why:find(file, 1, true), why)
            print(why)
          end"""))
        self.expect(result, 0)
        self.assertEqual(result.stdout.count(said), 2, result)
        result = small("run", self.file("t.lua", "local c = assert(hw.open('vxm@emulator')) assert(c:jog(1, '+')) "
                                                 "for i = 1, 3000 do c:query('X') end print('end')"),
                       "--traffic", self.folder / "t.txt")
        self.expect(result, 1, "t.txt cannot be written: " + why, "The controllers were told to stop.")
        left = {path.name for path in self.folder.iterdir()}
        self.assertEqual(left, {"shot.lua", "a.lua", "t.lua", "t.txt"}, "what was begun is taken away")

    def test_what_the_window_saves_on_a_full_disk(self):
        for ending in ("log", "toml", "moves", "prg", "svg", "png"):
            (self.folder / f"full.{ending}").symlink_to("/dev/full")
        self.expect(run("run", "--gui", HERE / "gui/full_disk.lua", self.folder), 0)
        self.assertTrue(all(path.is_symlink() for path in self.folder.iterdir()), "nothing else is left there")

    def test_everything_that_writes_a_file_says_that_the_disk_is_full(self):
        for ending in ("lst", "toml", "prg", "png", "txt"):
            (self.folder / f"full.{ending}").symlink_to("/dev/full")
        full = lambda ending: self.folder / f"full.{ending}"
        drawing = ("convert", HERE / "../../assets/examples/plate.dxf", "--for", "pmx-4ex-sa", "--per-unit", "100", "-o")
        for arguments, what in (
                (("backup", "vxm@emulator", "-o", full("toml")), "full.toml"),
                (("compile", self.file("a.prg", "PRG 0\nX100\nEND\n"), "--for", "pmx-4ex-sa", "-o", full("lst")), "full.lst"),
                ((*drawing, full("prg")), "full.prg"), ((*drawing, full("toml")), "full.toml"),
                (("run", "--traffic", full("txt"), self.file("s.lua", "hw.open('vxm@emulator')")), "full.txt"),
                (("run", "--gui", self.file("g.lua", f"ui.screenshot('{full('png')}')")), "full.png")):
            self.expect(run(*arguments), 1, what, "the disk is full.")

    def test_nobody_reads_the_complaints_either(self):
        script = self.file("s.lua", "for i = 1, 100 do hw.log('a') print('b') end error('c')")
        process = subprocess.Popen([PROGRAM, "run", script], stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        process.stdout.close()
        self.assertEqual(process.wait(timeout=30), 1)

    def test_a_closed_output_is_no_port(self):
        with emulator("vxm", "--tcp", "127.0.0.1:0") as (ready, _):
            address = "vxm@tcp:" + port_of(ready[0])
            script = self.file("s.lua", "local c = assert(hw.open(hw.args[1])) print('C,I1M4000,R') hw.sleep(0.2)")
            closed = subprocess.run(["sh", "-c", 'exec "$0" run "$1" "$2" >&-', PROGRAM, script, address], text=True,
                                    stderr=subprocess.PIPE, timeout=30)
            self.assertEqual(closed.returncode, 1)
            self.assertIn("The output cannot be written: it is closed.", closed.stderr)
            self.assertEqual(run("send", address, "X").stdout, "+0000000\n")

    def test_each_line_comes_at_once(self):
        process = subprocess.Popen([PROGRAM, "run", "--realtime", self.file("s.lua", "print('a') hw.sleep(30)")],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        began = time.monotonic()
        self.assertEqual(process.stdout.readline(), "a\n")
        self.assertLess(time.monotonic() - began, 15)
        process.terminate()
        process.communicate(timeout=30)


class Sandbox(Case):
    def script(self, text):
        return run("run", self.file("s.lua", text), timeout=300)

    def test_a_loop_without_end_is_ended(self):
        self.expect(self.script("while true do end"), 1, "s.lua:1: ", "without letting time pass")
        self.expect(self.script("while true do pcall(function() while true do end end) end"), 1, "without letting")
        self.expect(self.script("while true do hw.sleep(0) end"), 1, "without letting")
        self.expect(self.script("while true do coroutine.wrap(function() while true do end end)() end"), 1,
                    "without letting")

    def test_memory_is_limited(self):
        self.expect(self.script("local t = {} for i = 1, 1e9 do t[i] = ('x'):rep(100000) .. i end"), 1,
                    "s.lua:1: ", "MB of memory")
        self.expect(self.script("local s = ('x'):rep(1e10)"), 1, "s.lua:1: ")

    def test_a_module_outside_of_the_folder(self):
        self.file("outside.lua", "return 1")
        inside = self.file("inside/s.lua", "require('link')")
        (self.folder / "inside/link.lua").symlink_to(self.folder / "outside.lua")
        self.expect(run("run", inside), 1, "s.lua:1: ", "outside of the script's folder")

    def test_no_text(self):
        self.expect(self.script(b"\x1bLua\x54\x00"), 1, "s.lua")
        self.expect(run("run", self.folder), 1)

    def test_yield_to_nowhere(self):
        self.expect(self.script("coroutine.yield()"), 1, "outside of a coroutine")


class Replay(Case):
    def traffic(self, name):
        path = self.folder / name
        self.expect(run("run", HERE / "replay.lua", "--traffic", path), 0)
        return path.read_bytes()

    def test_a_minute_replays_byte_for_byte(self):
        first, second = self.traffic("one"), self.traffic("two")
        self.assertEqual(first, second)
        self.assertGreater(len(first), 10000)
        lines = re.findall(r"(?m)^ *([\d.]+) (\d+) (.) (.*)$", first.decode())
        self.assertTrue(any(way == "#" and "pulled" in what for _, _, way, what in lines), "the cable was pulled")
        heard = "".join(what for _, wire, way, what in lines if wire != "1" and way == "<")
        self.assertIn("+0000800", heard, "the move after it")
        # The same in every build. When a change of what goes over the wire is meant, the sum that is shown here goes
        # into the file.
        wanted = (HERE / "replay.sha256").read_text().split()[0]
        self.assertEqual(hashlib.sha256(first).hexdigest(), wanted, "tests/scripts/replay.sha256")


class Emulate(Case):
    def test_tcp(self):
        with emulator("vxm", "--tcp", "127.0.0.1:0") as (ready, _):
            self.assertRegex(ready[0], r"^ready vxm tcp 127\.0\.0\.1:\d+$")
            host, port = port_of(ready[0]).split(":")
            with socket.create_connection((host, int(port)), timeout=10) as wire:
                wire.sendall(b"FV")
                self.assertEqual(wire.recv(1), b"R")
                wire.sendall(b"X")
                got = b""
                while len(got) < 9:
                    got += wire.recv(9)
                self.assertEqual(got, b"+0000000\r")

    def test_all_endpoints_are_one_wire(self):
        with emulator("vxm", "--tcp", "127.0.0.1:0", "--tcp", "127.0.0.1:0") as (ready, _):
            wires = [socket.create_connection(("127.0.0.1", int(line.rsplit(":")[-1])), timeout=10) for line in ready]
            for wire in wires:
                wire.settimeout(10)
            wires[1].sendall(b"FV")  # answered: the emulator has taken the connection
            self.assertEqual(wires[1].recv(1), b"R")
            wires[0].sendall(b"V")
            self.assertEqual(wires[0].recv(1), b"R")
            self.assertEqual(wires[1].recv(1), b"R")
            for wire in wires:
                wire.close()

    def test_pty(self):
        link = self.folder / "port"
        with emulator("vxm", "--pty", link, "--wire", "off") as (ready, _):
            self.assertEqual(ready[0], f"ready vxm pty {link}")
            for _ in range(2):  # clients come and go
                port = os.open(link, os.O_RDWR | os.O_NOCTTY)
                self.assertEqual(termios.tcgetattr(port)[3] & (termios.ICANON | termios.ECHO), 0, "raw")
                os.write(port, b"FV")
                self.assertTrue(select.select([port], [], [], 10)[0])
                self.assertEqual(os.read(port, 10), b"R")
                os.close(port)
        self.assertFalse(link.exists() or link.is_symlink(), "the symlink goes with the emulator")

    def test_ready_lines_come_in_the_order_of_the_endpoints(self):
        link = self.folder / "port"
        with emulator("vxm", "--pty", link, "--tcp", "127.0.0.1:0", "--wire", "off") as (ready, _):
            self.assertEqual([line.split()[2] for line in ready], ["pty", "tcp"])

    def test_byte_times(self):
        link = self.folder / "port"
        with emulator("vxm", "--pty", link):
            port = os.open(link, os.O_RDWR | os.O_NOCTTY)
            os.write(port, b"F")
            time.sleep(0.1)
            began = time.monotonic()
            for question, length in ((b"X", 9), (b"Y", 9), (b"V", 1)):
                os.write(port, question)
                got = b""
                while len(got) < length:
                    got += os.read(port, length)
            took = time.monotonic() - began
            os.close(port)
            self.assertGreater(took, 0.0229 * 0.98)  # 22 bytes at 9600 baud

    def test_state_is_kept(self):
        state = self.folder / "state"
        with emulator("vxm", "--tcp", "127.0.0.1:0", "--state", state) as (ready, _):
            self.expect(run("send", "vxm@tcp:" + port_of(ready[0]), "PM0,C,I1M400", "rsm"), 0)
        with emulator("vxm", "--tcp", "127.0.0.1:0", "--state", state) as (ready, _):
            self.expect(run("send", "vxm@tcp:" + port_of(ready[0]), "PM0", "lst"), 0, "I1M400")

    def test_a_board_that_keeps_nothing_says_so(self):
        with emulator("vme58", "--bus", "127.0.0.1:0", "--state", self.folder / "state") as (_, process):
            self.assertIn("VME58 keeps nothing without power", process.stderr.readline())

    def test_motors_quirks_bench_and_speed(self):
        bench = self.file("bench.toml", "quirks = [\"e-bar\"]\n[axis.1]\nplus = 300\n[input]\n1 = true\n")
        with emulator("vxm", "--tcp", "127.0.0.1:0", "--motors", 4, "--quirk", "overrun", "--bench", bench,
                      "--speed", 20) as (ready, _):
            address = "vxm@tcp:" + port_of(ready[0]) + ",motors=4"
            self.expect(run("send", address, "T"), 0, "+0000000")
            self.expect(run("send", address, "setM1M4", "PM0,C,I1M400,R"), 0, "^")
            self.expect(run("send", address, "X"), 0, "+0000300")

    def test_what_cannot_be_served_is_said(self):
        self.expect(run("emulate", "vxm", "--tcp", "0.0.0.0:0"), 1, "--allow-remote")
        self.expect(run("emulate", "vxm", "--tcp", "here"), 2, "HOST:PORT")
        taken = self.file("taken", "text")
        self.expect(run("emulate", "vxm", "--pty", taken), 1, "taken")
        self.assertEqual(taken.read_text(), "text")
        bench = self.file("bench.toml", "[axis.1]\nplsu = 5\n")
        result = run("emulate", "vxm", "--tcp", "127.0.0.1:0", "--bench", bench)
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("bench.toml:2:8", result.stderr)
        result = run("emulate", "vxm", "--tcp", "127.0.0.1:0", "--quirk", "nonsense")
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("nonsense", result.stderr)
        result = run("emulate", "vxm", "--tcp", "127.0.0.1:0", "--motors", "9")
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("9", result.stderr)

    def test_two_on_one_port(self):
        with emulator("vxm", "--tcp", "127.0.0.1:0") as (ready, _):
            self.expect(run("emulate", "vxm", "--tcp", port_of(ready[0])), 1, port_of(ready[0]))


class Line:
    """A client on a pty, byte by byte."""
    def __init__(self, link):
        self.port = os.open(link, os.O_RDWR | os.O_NOCTTY)

    def ask(self, text):
        """The reply, with its end."""
        os.write(self.port, text.encode())
        got = b""
        while not got.endswith(b"\0") and select.select([self.port], [], [], 10)[0]:
            got += os.read(self.port, 256)
        return got

    def silence_after(self, text):
        os.write(self.port, text.encode())
        return b"" if not select.select([self.port], [], [], 0.3)[0] else os.read(self.port, 256)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        os.close(self.port)


class Babbler:
    """Stands between a client and an emulated controller, and from begin() on sends what it likes, at full speed."""
    def __init__(self, port, babble):
        self.babble = (babble * 65536)[:65536]
        self.door = socket.create_server(("127.0.0.1", 0))
        self.address = "tcp:127.0.0.1:%d" % self.door.getsockname()[1]
        self.controller = socket.create_connection(("127.0.0.1", int(port)))
        self.begun, self.over = threading.Event(), threading.Event()
        self.heard = []  # when, what
        self.thread = threading.Thread(target=self.work)
        self.thread.start()

    def begin(self):
        self.begun.set()

    def work(self):
        client = self.door.accept()[0]
        while not self.over.is_set():
            babbles = self.begun.is_set()
            ready, free, _ = select.select([self.door, client, self.controller], [client] if babbles else [], [], 0.05)
            if self.door in ready:  # it was lost, and tries again
                client.close()
                client = self.door.accept()[0]
                continue
            client.setblocking(False)
            with contextlib.suppress(BlockingIOError, ConnectionError):
                if client in ready and (heard := client.recv(4096)):
                    self.heard.append((time.monotonic(), heard))
                    self.controller.sendall(heard)
                if self.controller in ready and (said := self.controller.recv(4096)) and not babbles:
                    client.sendall(said)
                if free:
                    client.send(self.babble)
        client.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.over.set()
        self.thread.join()
        self.door.close()
        self.controller.close()


class Babbling(Case):
    """A device that never falls silent: no bytes, messages, answers."""
    SCRIPT = """
        local c = assert(hw.open(hw.args[1]))
        c:jog(1, "+")
        hw.log("babble")
        hw.sleep(0.3)
        hw.log("stop")
        c:stop()
        c:status()
        hw.log("stopped")
    """

    def stop_amid(self, babble):
        script, at = self.file("babble.lua", self.SCRIPT), {}
        with emulator("vxm", "--tcp", "127.0.0.1:0") as (ready, _), \
                Babbler(port_of(ready[0]).rsplit(":")[-1], babble) as device, \
                subprocess.Popen([PROGRAM, "run", script, f"vxm@{device.address}"], stderr=subprocess.PIPE,
                                 text=True) as process:
            while "stopped" not in at and (line := process.stderr.readline()):
                at[line.split()[-1]] = time.monotonic()
                if "babble" in at:
                    device.begin()
            process.kill()
            _, _, used = os.wait4(process.pid, 0)
            process.returncode = -signal.SIGKILL
        self.assertIn("stopped", at)
        stops = [when for when, what in device.heard if what == b"D" and when >= at["stop"] - 0.1]
        self.assertTrue(stops, device.heard)
        return stops[0] - at["stop"], used.ru_maxrss // 1024

    def test_a_stop_goes_out_at_once_and_memory_is_bounded(self):
        for babble in (b"x", b"O", b"VR"):
            with self.subTest(babble=babble):
                late, megabytes = self.stop_amid(babble)
                self.assertLess(late, 1)
                self.assertLess(megabytes, 128)


class Bus(Case):
    """Several controllers on one line."""
    def test_thirty_on_one_pty(self):
        link = self.folder / "bus"
        ids = [f"{n:02}" for n in range(1, 31)]
        with emulator("dmx-k-sa", "--pty", link, *(w for i in ids for w in ("--id", i))) as (ready, _):
            self.assertEqual(ready[0], f"ready dmx-k-sa pty {link}")
            with Line(link) as line:
                for i in ids:
                    self.assertEqual(line.ask(f"@{i}DN\r"), f"DMK{i}\0".encode())
                self.assertEqual(line.silence_after("@31DN\r"), b"", "nobody has this id")
                self.assertEqual(line.silence_after("DN\r"), b"", "on a shared line only who is asked answers")
                self.assertEqual(line.silence_after("@00EO=0\r"), b"", "all obey, nobody answers")
                for i in ("01", "17", "30"):
                    self.assertEqual(line.ask(f"@{i}EO\r"), b"0\0")
            self.expect(run("send", f"dmx-k-sa@serial:{link},id=17", "DN"), 0, "DMK17")
            result = run("send", f"dmx-k-sa@serial:{link},id=01-04", "DN")
            self.expect(result, 2, "several controllers")

    def test_each_keeps_its_memory(self):
        state = self.folder / "state"
        options = ("dmx-k-sa", "--tcp", "127.0.0.1:0", "--state", state, "--id", "01", "--id", "07")
        with emulator(*options) as (ready, _):
            address = "dmx-k-sa@tcp:" + port_of(ready[0])
            self.expect(run("send", address + ",id=07", "V60=1234", "STORE"), 0)
        self.assertTrue(pathlib.Path(f"{state}.07").exists())
        with emulator(*options) as (ready, _):
            address = "dmx-k-sa@tcp:" + port_of(ready[0])
            self.expect(run("send", address + ",id=07", "V60"), 0, "1234")
            self.assertNotIn("1234", run("send", address + ",id=01", "V60").stdout)

    def test_alone_behind_tcp_it_needs_no_prefix(self):
        for options, answers in ((("--id", "07"), True), (("--id", "07", "--id", "08"), False)):
            with emulator("dmx-k-sa", "--tcp", "127.0.0.1:0", *options) as (ready, _):
                host, port = port_of(ready[0]).split(":")
                with socket.create_connection((host, int(port)), timeout=10) as wire:
                    wire.sendall(b"ID\r@07DN\r")
                    got = b""
                    while not got.endswith(b"DMK07\0") and (chunk := wire.recv(100)):
                        got += chunk
                    self.assertEqual(got, b"DriveMax-K-SA\0DMK07\0" if answers else b"DMK07\0")

    def test_ids_that_are_none(self):
        self.expect(run("emulate", "dmx-k-sa", "--tcp", "127.0.0.1:0", "--id", "7"), 2, "--id 7", "two digits")
        self.expect(run("emulate", "vxm", "--tcp", "127.0.0.1:0", "--id", "07"), 2, "no --id")
        self.expect(run("emulate", "dmx-k-sa", "--tcp", "127.0.0.1:0", "--id", "01", "--id", "02", "--id", "01"), 2,
                    "--id 01 is given twice", "its own number")
        self.expect(run("emulate", "dmx-k-sa", "--tcp", "127.0.0.1:0", "--id", "00"), 2, "id=00", "01 to 99")
        for wrong in ("7", "007", "04-01", "01-", "1-4", "a1"):
            self.expect(run("send", f"dmx-k-sa@emulator,id={wrong}", "DN"), 2, f"id={wrong}")


class Scan(Case):
    """Two DMX on a pseudo-terminal, at another rate than the usual one."""
    @contextlib.contextmanager
    def line(self):
        link, state = self.folder / "line", self.folder / "state"
        options = ("dmx-k-sa", "--pty", link, "--state", state, "--id", "07", "--id", "11")
        with emulator(*options):
            for i in ("07", "11"):
                self.expect(run("send", f"dmx-k-sa@serial:{link},id={i}", "DB=3", "STORE"), 0)
        with emulator(*options):  # switched off and on
            yield link

    def test_the_search_over_ids(self):
        with self.line() as link:
            result = run("scan", link, "--ids", "06-12", "--baud", 9600, "--baud", 38400)
            self.expect(result, 0, f"dmx-k-sa@serial:{link},baud=38400,id=07", f"dmx-k-sa@serial:{link},baud=38400,id=11",
                        "2 found among the ids 06 to 12")
            self.expect(run("scan", link, "--ids", "20-21", "--baud", 38400), 0, "0 found")
            self.expect(run("scan", link), 0, "Nothing answers", f"handwheel scan {link} --ids 00-99")

    def test_the_usual_id_needs_no_search(self):
        link = self.folder / "line"
        with emulator("dmx-k-sa", "--pty", link):
            self.expect(run("scan", link), 0, f"dmx-k-sa@serial:{link},baud=9600,id=01")

    def test_the_connection_page_lists_them(self):
        with self.line() as link:
            self.expect(run("run", "--gui", "--realtime", HERE / "real" / "search.lua", link), 0)

    def test_wrong_usage(self):
        for ids in ("7", "00-", "12-06", "a-b", "00-999", ""):
            self.expect(run("scan", "--ids", ids), 2, "--ids", "two digits each")
        self.expect(run("scan", "--ids", "00-99", "--baud", "fast"), 2, "--baud fast")
        self.expect(run("scan", "--baud", "9600"), 2, "--baud goes with --ids")
        self.expect(run("scan", "/dev/ttyUSB77"), 1, "/dev/ttyUSB77")


class Send(Case):
    def test_in_process(self):
        self.expect(run("send", "vxm@emulator", "V", "X", "getM1M"), 0)
        self.assertEqual(run("send", "vxm@emulator", "V", "X").stdout, "R\n+0000000\n")

    def test_what_has_no_reply_prints_nothing(self):
        result = run("send", "vxm@emulator", "S1M1000", "PM0")
        self.expect(result, 0)
        self.assertEqual(result.stdout, "")

    def test_raw_status_bytes_are_written_out(self):
        self.assertEqual(run("send", "vxm@emulator", "?", "$").stdout, "\\xFF\n\\x00\n")

    def test_a_text_that_leads_past_a_limit_is_sent_and_warned_of(self):
        axis = {"unit_choice": "own", "own_unit": {"name": "mm", "per_step": 0.005}, "minus_limit": -200, "plus_limit": 100}
        texts = {"vxm": ["setM1M4,I1M400,R"], "pmx-4ex-sa": ["EO=15", "X400"], "dmx-k-sa": ["EO=1", "X400"],
                 "vme58": ["AX MA400 GO"]}
        for model, words in texts.items():
            self.profile(model + "@emulator", axis | {"limits_in_counts": model == "dmx-k-sa"})
            result = run("send", model + "@emulator", *words, settings={"XDG_CONFIG_HOME": str(self.folder)})
            self.assertEqual(result.returncode, 0, result)
            self.assertIn("This text moves past a limit: 2.000 mm lies 1.500 mm past the + limit of", result.stderr, model)
            self.assertIn("It was sent as it is.", result.stderr, model)
            self.assertNotIn("limit", run("send", model + "@emulator", *words).stderr, "there is no profile")

    def test_a_listing_is_lines(self):
        self.assertEqual(run("send", "vxm@emulator", "C,I1M400,P5", "lst").stdout, "PM0 M249\nI1M400\nP5\n")

    def test_an_error_report_is_the_reply_and_is_explained(self):
        result = run("send", "vxm@emulator", "Z")
        self.assertEqual((result.returncode, result.stdout), (1, "EB\n"), result)
        self.assertIn("EB", result.stderr)

    def test_what_the_controller_refuses_has_failed(self):
        for model, text, reply in (("pmx-4ex-sa", "BOGUS", "?BOGUS"), ("dmx-k-sa", "FOO", "?FOO")):
            result = run("send", model + "@emulator", text, "ID")
            self.assertEqual((result.returncode, result.stdout), (1, reply + "\n"), "nothing follows it")
            self.assertIn("%s: The controller answered %s (refused: " % (text, reply), result.stderr)
        self.expect(run("send", "vme58@emulator", "AX QQ"), 1, "There is no command QQ.")

    def test_a_question_that_is_dropped_has_failed(self):
        result = run("send", "vxm@emulator", "Q", "X")
        self.expect(result, 1, "X: In local mode the controller takes only a few letters and ignores X silently.")

    def test_an_unknown_command_is_named(self):
        result = run("send", "vxm@emulator", "bogus", "V")
        self.assertEqual((result.returncode, result.stdout), (0, "R\n"), result)
        self.assertIn("not commands of the VXM", result.stderr)

    def test_a_run_prints_its_prompt_when_it_ends(self):
        with emulator("vxm", "--tcp", "127.0.0.1:0", "--speed", 10) as (ready, _):
            address = "vxm@tcp:" + port_of(ready[0])
            self.assertEqual(run("send", address, "PM0,C,S1M1000,I1M4000", "R", "X").stdout, "^\n+0004000\n")

    def test_a_stop_waits_for_nothing(self):
        for model, texts, shown in (("vxm", ("S1M100,I1M0,R", "D"), "^"), ("dmx-k-sa", ("J+", "STOP"), "OK\nOK"),
                                    ("pmx-4ex-sa", ("EO=15", "JX+", "STOPX"), "OK\nOK\nOK"),
                                    ("vme58", ("AX JG1000", "AX ST"), "")):
            result = run("send", model + "@emulator", *texts, timeout=20)
            self.assertEqual((result.returncode, result.stdout.strip()), (0, shown), result)

    def test_a_stop_that_nobody_hears_says_why(self):
        with emulator("dmx-k-sa", "--tcp", "127.0.0.1:0", "--id", "01") as (ready, _):
            address = "dmx-k-sa@tcp:" + port_of(ready[0]) + ",id="
            self.assertEqual(run("send", address + "01", "STOP", "SR0=0").stdout, "OK\nOK\n")
            self.expect(run("send", address + "02", "STOP"), 1, "No DMX-K-SA answers at address 02.")

    def test_a_controller_in_an_error_state_takes_k(self):
        with emulator("vxm", "--tcp", "127.0.0.1:0") as (ready, _):
            address = "vxm@tcp:" + port_of(ready[0])
            self.assertEqual(run("send", address, "C JM0,R").stdout, "EJ\n")
            self.expect(run("send", address, "V"), 1, "send K")
            self.expect(run("send", address, "K", "V"), 0, "R")

    def test_each_reply_has_its_line(self):
        result = run("send", "pmx-4ex-sa@emulator", "POX", "SA0", "SA0=END", "SA0")
        self.assertEqual((result.returncode, result.stdout), (0, "7\n\nOK\nEND\n"), result)

    def test_brackets_are_the_controllers(self):
        self.assertEqual(run("send", "vxm@emulator,motors=4", "[V]", "V").stdout.splitlines()[-1], "R")
        for text in ("[V,X]", "[]"):
            result = run("send", "vxm@emulator", text)
            self.assertEqual((result.returncode, result.stdout), (1, "EB\n"), result)
        script = self.file("a.lua", "hw.log(#hw.args .. ' ' .. hw.args[1] .. ' ' .. hw.args[2])")
        self.assertIn("2 [a,b] --gui", run("run", script, "[a,b]", "--", "--gui").stderr)

    def test_dashes_end_the_options_wherever_they_stand(self):
        for words in (("--", "vxm@emulator", "X"), ("vxm@emulator", "--", "X"), ("vxm@emulator", "X", "--")):
            result = run("send", *words)
            self.assertEqual((result.returncode, result.stdout), (0, "+0000000\n"), result)

    def test_what_is_no_subcommand(self):
        self.expect(run("sned", "vxm@emulator", "X"), 2, 'There is no subcommand "sned"')

    def test_over_a_pty(self):
        link = self.folder / "port"
        with emulator("vxm", "--pty", link):
            self.assertEqual(run("send", f"vxm@serial:{link}", "V", "X").stdout, "R\n+0000000\n")

    def test_what_nobody_heard_is_not_kept_for_the_next_client(self):
        link = self.folder / "port"
        with emulator("vxm", "--pty", link, "--tcp", "127.0.0.1:0") as (ready, _):
            address = "vxm@tcp:" + port_of(next(line for line in ready if " tcp " in line))
            self.expect(run("send", address, "V", "X", "Y"), 0)
            client = os.open(link, os.O_RDWR | os.O_NOCTTY)
            try:
                os.set_blocking(client, False)
                time.sleep(0.2)
                self.assertRaises(BlockingIOError, os.read, client, 100)
            finally:
                os.close(client)

    def test_no_vxm_there(self):
        with socket.create_server(("127.0.0.1", 0)) as silent:
            result = run("send", f"vxm@tcp:127.0.0.1:{silent.getsockname()[1]}", "V")
            self.expect(result, 1)
            self.assertTrue(result.stderr.strip())


class Check(Case):
    def test_a_good_program(self):
        self.expect(run("check", self.file("a.vxm", "I1M400\nP5\nI1M-400\n"), "--for", "vxm"), 0)

    def test_all_programs_of_a_text_are_named(self):
        both = "PRG 0\nX100\nWAITX\nEND\nPRG 1\nV1=1\nEND\n"
        self.expect(run("check", self.file("two.prg", both), "--for", "dmx-k-sa"), 0, "Programs 0, 1: ", " of 1275 lines")
        self.expect(run("check", self.file("one.prg", "X100\nEND\n"), "--for", "dmx-k-sa"), 0, "Program 0: ")
        for name, text in (("subs.prg", "SUB 1\nV1=1\nENDSUB\n"), ("none.prg", "")):
            result = run("check", self.file(name, text), "--for", "pmx-4ex-sa")
            self.expect(result, 0, "no program in it, ", " of 1275 lines")
            self.assertNotIn("Program 0", result.stdout)

    def test_errors_have_their_place(self):
        path = self.file("b.vxm", "I1M400\nS1M9000\n")
        result = run("check", path, "--for", "vxm")
        self.assertEqual(result.returncode, 1, result)
        self.assertRegex(result.stdout, rf"(?m)^{re.escape(str(path))}:2:\d+: error: .+")

    def test_no_text(self):
        self.expect(run("check", self.file("c.vxm", b"\x00\x01\x02\xff"), "--for", "vxm"), 1, "c.vxm")
        self.expect(run("check", self.file("d.vxm", "I1M4\n"), "--for", "pmx-9"), 2, "pmx-9")


class Compile(Case):
    EXAMPLES = HERE.parent / "language" / "good"

    def test_a_listing_and_back(self):
        out, again = self.folder / "out.lst", self.folder / "again.lst"
        program = self.file("square.prg", "X1000Y1000\nWAITX\nIF DI1=1\nDO2=1\nENDIF ; done\nEND\n")
        result = run("compile", program, "--for", "pmx-4ex-sa", "-o", out, "--listing")
        self.expect(result, 0, "LISTING pmx-4ex-sa 8", "MOVE,X,1000", "8 of 1275 lines")
        self.assertTrue(result.stdout.startswith(out.read_text()), "what is shown is what is written")
        self.expect(run("compile", out, "--for", "pmx-4ex-sa", "-o", again), 0)
        self.assertEqual(out.read_text(), again.read_text())
        with emulator("pmx-4ex-sa", "--tcp", "127.0.0.1:0") as (ready, _):
            script = self.file("load.lua", "local c = assert(hw.open(hw.args[1]))\nassert(c:load(hw.args[2]))\nprint(c:program())")
            result = run("run", script, "pmx-4ex-sa@tcp:" + port_of(ready[0]), out.read_text())
            self.expect(result, 0, "X1000Y1000", "DO2=1")

    def test_every_example_of_the_manuals(self):
        for model, name in (("pmx-4ex-sa", "pmx"), ("dmx-k-sa", "dmx")):
            for n in range(1, 9):
                path, out = self.EXAMPLES / f"{name}_example_{n}.prg", self.folder / f"{name}{n}.lst"
                self.expect(run("compile", path, "--for", model, "-o", out), 0, "of 1275 lines")
                again = run("compile", out, "--for", model, "--listing")
                self.expect(again, 0)
                self.assertEqual(again.stdout, out.read_text())

    def test_every_error_with_its_place(self):
        path = self.file("bad.prg", "X1000\nFOO\nIF V1=\nENDIF\nEND\n")
        result = run("compile", path, "--for", "dmx-k-sa", "-o", self.folder / "none.lst")
        self.assertEqual(result.returncode, 1, result)
        for line in (2, 3):
            self.assertRegex(result.stderr, rf"(?m)^{re.escape(str(path))}:{line}:\d+: error: .+")
        self.assertFalse((self.folder / "none.lst").exists(), "nothing is written of a text with errors")

    def test_for_the_wrong_controller(self):
        path = self.file("four.prg", "X10U20\nEND\n")
        self.expect(run("compile", path, "--for", "pmx-4ex-sa", "--listing"), 0, "MOVE,U,20")
        self.expect(run("compile", path, "--for", "dmx-k-sa", "--listing"), 1, f"{path}:1:")
        out = self.folder / "four.lst"
        self.expect(run("compile", path, "--for", "pmx-4ex-sa", "-o", out), 0)
        self.expect(run("compile", out, "--for", "dmx-k-sa", "--listing"), 1, "pmx-4ex-sa")
        self.expect(run("compile", path, "--for", "vxm", "--listing"), 1, "nothing to compile", "check")

    def test_one_line_too_many(self):
        path = self.file("long.prg", "ABS\n" * 1275 + "END\n")
        self.expect(run("compile", path, "--for", "dmx-k-sa", "--listing"), 1, f"{path}:1276:1", "1,276 low-level lines")

    def test_wrong_usage(self):
        path = self.file("a.prg", "END\n")
        self.expect(run("compile", path, "--for", "dmx-k-sa"), 2, "-o OUT")
        self.expect(run("compile", path), 2, "--for")
        self.expect(run("compile", path, "--for", "dmx"), 2, "dmx-k-sa")
        self.expect(run("compile", self.folder / "none.prg", "--for", "dmx-k-sa", "--listing"), 1, "none.prg")
        self.expect(run("compile", path, "--for", "dmx-k-sa", "-o", self.folder / "no" / "where"), 1, "where")


class Examples(Case):
    """assets/examples: each program is without fault and does what its first lines say."""

    FOLDER = HERE.parent.parent / "assets" / "examples"

    def rehearse(self, name, model, *more):
        file = self.FOLDER / name
        self.expect(run("check", file, "--for", model), 0)
        result = run("simulate", file, "--for", model, "--json", *more)
        self.expect(result, 0)
        dry = json.loads(result.stdout)
        self.assertTrue(dry["finished"], dry)
        self.assertIsNone(dry["error"])
        return dry["axes"]

    def test_raster(self):
        axes = self.rehearse("raster.vxm", "vxm", "--bench", self.FOLDER / "slide.toml")
        self.assertEqual(axes["1"], {"position": 0, "min": 0, "max": 1600, "travel": 6 * 1600})
        self.assertEqual(axes["2"], {"position": 0, "min": 0, "max": 5 * 200, "travel": 2000})

    def test_plate(self):
        axes = self.rehearse("plate.prg", "pmx-4ex-sa")
        self.assertEqual(axes["X"], {"position": 0, "min": 0, "max": 5000, "travel": 10000})
        self.assertEqual(axes["Y"], {"position": 0, "min": 0, "max": 2000, "travel": 4000})

    def test_shuttle(self):
        axes = self.rehearse("shuttle.prg", "dmx-k-sa")
        self.assertEqual(axes["X"], {"position": 0, "min": 0, "max": 5000, "travel": 20 * 5000})

    def test_circle(self):
        for bench in ((), ("--bench", self.FOLDER / "servo.toml")):
            axes = self.rehearse("circle.vme", "vme58", *bench)
            self.assertEqual((axes["X"]["position"], axes["X"]["min"], axes["X"]["max"]), (0, 0, 20000))
            self.assertEqual((axes["Y"]["position"], axes["Y"]["min"], axes["Y"]["max"]), (0, -10000, 10000))

    def test_plate_drawn(self):
        result = run("convert", self.FOLDER / "plate.dxf", "--for", "pmx-4ex-sa", "-o", self.folder / "drawn.prg",
                     "--per-unit", "100", "--pen-output", "1", "--cut-speed", "20", "--travel-speed", "60")
        self.expect(result, 0)
        result = run("simulate", self.folder / "drawn.prg", "--for", "pmx-4ex-sa", "--json")
        self.expect(result, 0)
        dry = json.loads(result.stdout)
        self.assertTrue(dry["finished"], dry)
        self.assertEqual((dry["axes"]["X"]["min"], dry["axes"]["X"]["max"]), (0, 10000))
        self.assertEqual((dry["axes"]["Y"]["min"], dry["axes"]["Y"]["max"]), (0, 6000))

    def test_every_file_is_tried(self):
        tried = {"raster.vxm", "slide.toml", "plate.prg", "plate.dxf", "shuttle.prg", "circle.vme", "servo.toml"}
        self.assertEqual({f.name for f in self.FOLDER.iterdir() if f.suffix != ".lua"}, tried)  # Jobs runs those


class Convert(Case):
    """A drawing becomes a program; a sequence is taken wherever a program is."""

    def drawing(self, *entities, header="9\n$INSUNITS\n70\n4\n"):
        text = "0\nSECTION\n2\nHEADER\n" + header + "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n"
        for entity in entities:
            text += "".join(f"{code}\n{value}\n" for code, value in entity)
        return self.file("a.dxf", text + "0\nENDSEC\n0\nEOF\n")

    def line(self, x, y, to_x, to_y, layer="0"):
        return ((0, "LINE"), (8, layer), (10, x), (20, y), (11, to_x), (21, to_y))

    def convert(self, file, model, *more, out="out.prg"):
        return run("convert", file, "--for", model, "-o", self.folder / out, "--json", *more)

    def test_for_each_controller(self):
        file = self.drawing(self.line(1, 2, 5, 2), self.line(5, 2, 5, 4), ((0, "CIRCLE"), (8, "0"), (10, 9), (20, 9), (40, 1)))
        for model, more in (("vxm", ("--tolerance", "0.3")), ("pmx-4ex-sa", ()), ("vme58", ())):
            result = self.convert(file, model, "--per-unit", "100", "--cut-speed", "5", "--travel-speed", "10",
                                  "--pen-output", "8" if model == "vme58" else "1", *more)
            self.expect(result, 0)
            report = json.loads(result.stdout)
            self.assertEqual(report["chains"], 2)
            self.assertAlmostEqual(report["drawn"], 6 + 2 * 3.141592653589793, places=6)
            self.assertEqual(report["box"], [1, 2, 10, 10])
            self.assertEqual(report["problems"], [])
            self.assertGreater(report["duration_s"], 2)
            self.expect(run("check", self.folder / "out.prg", "--for", model), 0)
            dry = json.loads(run("simulate", self.folder / "out.prg", "--for", model, "--json").stdout)
            self.assertTrue(dry["finished"], dry)
            for axis in list(dry["axes"].values())[:2]:
                self.assertAlmostEqual(axis["max"], 1000, delta=30 if model == "vxm" else 1)

    def test_some_of_many_remarks_are_told(self):
        for corners, rest in ((7, "And 1 more remark; "), (8, "And 2 more remarks; ")):
            lines = [line for x in range(0, 10 * corners, 10)
                     for line in (self.line(x, 0, x + 5, 0), self.line(x + 5, 0, x + 5, 5))]
            result = run("convert", self.drawing(*lines), "--for", "vme58", "-o", self.folder / "out.prg",
                         "--per-unit", "100", "--cut-speed", "5", "--travel-speed", "10", "--low-speed", "1",
                         "--ramp", "200", "--pen-output", "8")
            self.expect(result, 0)
            self.assertIn(rest, result.stderr)

    def test_a_sequence_is_taken_like_a_program(self):
        file = self.drawing(self.line(1, 2, 5, 2))
        self.expect(self.convert(file, "pmx-4ex-sa", "--per-unit", "100", out="out.toml"), 0)
        sequence = self.folder / "out.toml"
        self.assertIn("handwheel_sequence = 1", sequence.read_text())
        self.expect(run("check", sequence, "--for", "pmx-4ex-sa"), 0, "of 1275 lines")
        self.expect(run("simulate", sequence, "--for", "pmx-4ex-sa"), 0, "axis X: ends at 500", "axis Y: ends at 200")
        self.expect(run("compile", sequence, "--for", "pmx-4ex-sa", "--listing"), 0, "MOVE,X,500")
        self.expect(run("check", sequence, "--for", "vxm"), 1, 'no axis "X"')
        broken = self.file("b.toml", sequence.read_text().replace("move", "fly", 1))
        self.expect(run("check", broken, "--for", "pmx-4ex-sa"), 1, 'there is no step "fly"')

    def test_the_tool_has_an_axis_delays_or_routines(self):
        file = self.drawing(self.line(1, 2, 5, 2))
        def program(*tool):
            self.expect(self.convert(file, "pmx-4ex-sa", "--per-unit", "100", *tool), 0)
            return (self.folder / "out.prg").read_text()
        self.assertRegex(program("--pen-axis", "Z:-2:3", "--pen-per-unit", "50", "--pen-down-delay", "40", "--pen-up-delay", "70"),
                         r"(?s)Z150.*DELAY=70.*Z-100.*DELAY=40")
        self.assertRegex(program("--pen-down", "Z to -2, DO1 on, wait 40", "--pen-up", "DO1 off, Z to 3", "--pen-per-unit", "50"),
                         r"(?s)DO1=0.*Z150.*Z-100.*DO1=1.*DELAY=40")
        self.assertRegex(program("--pen-axis", "Z:-2:3", "--pen-output", "1"),
                         r"(?s)SUB 1 .*DO1=0.*Z300.*SUB 2 .*Z-200.*DO1=1")  # on only when it is down, as in the window
        for wrong, says in ((("--pen-down", "hop"), '--pen-down: "hop" is not understood.'),
                            (("--pen-down", "DO1 on"), "nothing switches it back"),
                            (("--pen-down", "DO1 on", "--pen-up", "DO1 off", "--pen-output", "1"), "mean the same")):
            self.expect(self.convert(file, "pmx-4ex-sa", *wrong), 2, says)

    def test_motors_of_a_slave_draw_too(self):
        file = self.drawing(self.line(1, 2, 5, 2))
        slave = ("--motors", "4", "--per-unit", "100", "--tolerance", "0.1", "--axes")
        self.expect(self.convert(file, "vxm", *slave, "3,4"), 0)
        self.assertIn("IA3M500", (self.folder / "out.prg").read_text())
        self.expect(self.convert(file, "vxm", *slave, "1,3"), 0, "Master and Slave could start together")
        self.expect(self.convert(file, "pmx-4ex-sa", "--motors", "4"), 2, "has no --motors")

    def test_what_the_order_saves_is_told_in_seconds_too(self):
        file = self.drawing(self.line(0, 0, 1, 0), self.line(50, 0, 51, 0), self.line(2, 0, 3, 0))
        result = self.convert(file, "pmx-4ex-sa", "--per-unit", "100", "--cut-speed", "10", "--travel-speed", "10")
        travel = json.loads(result.stdout)["travel"]
        self.assertAlmostEqual(travel["saved_s"], (travel["as_drawn"] - travel["ordered"]) / 10)
        self.assertGreater(travel["saved_s"], 4)
        self.assertEqual(json.loads(self.convert(file, "pmx-4ex-sa", "--per-unit", "100").stdout)["travel"]["saved_s"], None)

    def test_a_scale_is_the_length_of_a_step_or_the_one_of_the_console(self):
        file = self.drawing(self.line(1, 2, 5, 2))
        def drawn(*scale):
            self.expect(self.convert(file, "pmx-4ex-sa", *scale), 0)
            return (self.folder / "out.prg").read_text()
        by_steps = drawn("--per-unit", "200,400")
        self.assertIn("X1000Y800", by_steps)
        self.assertEqual(drawn("--step-length", "0.005,0.0025"), by_steps)
        self.expect(self.convert(file, "pmx-4ex-sa", "--step-length", "0"), 2, "more than 0")
        self.expect(self.convert(file, "pmx-4ex-sa", "--step-length", "1", "--per-unit", "1"), 2, "mean the same")
        self.expect(self.convert(file, "pmx-4ex-sa", "--profile", "pmx-4ex-sa@emulator"), 2, "keeps no unit of length for axis X")
        self.expect(self.convert(file, "pmx-4ex-sa", "--profile", "vxm@emulator"), 2, "is not a pmx-4ex-sa")

    def test_a_box_around_all_is_named_and_left_out_by_its_entities(self):
        sides = [self.line(0, 0, 90, 0), self.line(90, 0, 90, 60), self.line(90, 60, 0, 60), self.line(0, 60, 0, 0)]
        file = self.drawing(*sides, self.line(10, 10, 20, 10))
        result = run("convert", file, "--for", "pmx-4ex-sa", "--per-unit", "10", "-o", self.folder / "out.prg")
        self.expect(result, 0, "perhaps a margin: omit it with --without 1 --without 2 --without 3 --without 4")
        report = json.loads(self.convert(file, "pmx-4ex-sa", "--per-unit", "10").stdout)
        self.assertEqual(report["box_around"], [1, 2, 3, 4])
        without = [word for entity in report["box_around"] for word in ("--without", str(entity))]
        report = json.loads(self.convert(file, "pmx-4ex-sa", "--per-unit", "10", *without).stdout)
        self.assertEqual([report["chains"], report["box_around"]], [1, []])

    def test_a_frame_goes_once_around(self):
        file = self.drawing(self.line(1, 2, 5, 2), self.line(5, 2, 5, 4))
        self.expect(self.convert(file, "pmx-4ex-sa", "--per-unit", "100", "--pen-output", "1", "--frame"), 0)
        text = (self.folder / "out.prg").read_text()
        self.assertNotIn("DO1=1", text)
        dry = json.loads(run("simulate", self.folder / "out.prg", "--for", "pmx-4ex-sa", "--json").stdout)
        self.assertEqual([dry["axes"][a]["max"] for a in "XY"], [500, 400])

    def test_a_program_that_does_not_fit_is_not_written(self):
        file = self.drawing(self.line(0, 0, 5, 5))
        result = self.convert(file, "vxm", "--per-unit", "1000", "--tolerance", "0.01")
        self.expect(result, 1, "has 256", "can be drawn in", "out.prg was not written")
        problems = json.loads(result.stdout)["problems"]
        self.assertIn("has 256", problems[0])
        self.assertIn("can be drawn in", problems[-1])
        self.assertGreater(json.loads(result.stdout)["duration_s"], 20, "in pieces, with the transfer of each")
        self.assertFalse((self.folder / "out.prg").exists())
        result = self.convert(file, "vxm", "--per-unit", "1000", "--tolerance", "0.01", out="out.toml")
        self.expect(result, 0, "has 256", "can be drawn in")
        self.assertIn("handwheel_sequence = 1", (self.folder / "out.toml").read_text())

    def test_what_is_left_out_is_named(self):
        file = self.drawing(self.line(0, 0, 5, 5), ((0, "TEXT"), (8, "0"), (10, 1), (20, 1), (40, 2), (1, "word")))
        result = self.convert(file, "pmx-4ex-sa")
        self.expect(result, 0)
        self.assertIn("TEXT 2 at 1, 1 was left out", result.stderr)
        self.assertEqual(json.loads(result.stdout)["left_out"][0]["what"], "TEXT")

    def test_layers_that_are_frozen_or_off_are_named(self):
        layers = "0\nENDSEC\n0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n70\n2\n" + "".join(
            f"0\nLAYER\n2\n{name}\n70\n{flags}\n62\n{colour}\n6\nCONTINUOUS\n"
            for name, flags, colour in (("ice", 1, 7), ("dark", 0, -7))) + "0\nENDTAB\n"
        file = self.drawing(self.line(0, 0, 5, 5), self.line(0, 0, 1, 5, "ice"), self.line(0, 0, 2, 5, "ice"),
                            self.line(0, 0, 3, 5, "dark"), header="9\n$INSUNITS\n70\n4\n" + layers)
        result = self.convert(file, "pmx-4ex-sa")
        self.expect(result, 0)
        self.assertIn('layer "ice" was left out with 2 entities', result.stderr)
        self.assertIn('layer "dark" was left out with 1 entity:', result.stderr)
        self.assertEqual(json.loads(result.stdout)["hidden_layers"],
                         [{"layer": "ice", "entities": 2}, {"layer": "dark", "entities": 1}])
        result = self.convert(file, "pmx-4ex-sa", "--layer", "ice")
        self.assertNotIn("was left out", result.stderr)
        self.assertEqual(json.loads(result.stdout)["hidden_layers"], [])

    def test_a_coordinate_that_nobody_counts_is_told_in_short(self):
        result = self.convert(self.drawing(self.line(0, 0, "1e300", 5)), "pmx-4ex-sa")
        self.expect(result, 1, "Entity 1", "1e+300 mm")
        self.assertLess(len(result.stderr.splitlines()[-1]), 200)

    def test_units_that_the_file_says_are_known(self):
        for unit, factor in ((7, 1e6), (10, 914.4), (14, 100)):
            file = self.drawing(self.line(0, 0, 0.001, 0), header=f"9\n$INSUNITS\n70\n{unit}\n")
            result = self.convert(file, "pmx-4ex-sa", "--per-unit", "100")
            self.expect(result, 0)
            self.assertAlmostEqual(json.loads(result.stdout)["drawn"], factor / 1000, places=6)

    def test_an_entity_is_left_out(self):
        file = self.drawing(self.line(0, 0, 5, 5), self.line(20, 0, 20, 30))
        result = self.convert(file, "pmx-4ex-sa", "--per-unit", "100", "--without", "2")
        self.expect(result, 0)
        self.assertEqual(json.loads(result.stdout)["box"], [0, 0, 5, 5])
        self.expect(self.convert(file, "pmx-4ex-sa", "--without", "7"), 1, "no such entity")

    def test_two_on_a_bus_draw_together(self):
        file = self.drawing(self.line(0, 0, 5, 5))
        result = self.convert(file, "dmx-k-sa", "--id", "01-02", "--per-unit", "100", "--pen-output", "1", out="both.toml")
        self.expect(result, 0, "stops at each corner", "It was not rehearsed: DO1 stays on")
        self.assertEqual(json.loads(result.stdout)["duration_s"], None)
        self.assertIn("While the link is lost the console cannot switch it off", json.loads(result.stdout)["tool"])
        result = self.convert(file, "dmx-k-sa", "--id", "01-02", "--per-unit", "100", "--pen-output", "2", "--cut-speed", "5",
                              "--travel-speed", "10", out="both.toml")
        self.assertGreater(json.loads(result.stdout)["duration_s"], 1)
        text = (self.folder / "both.toml").read_text()
        self.assertIn('name = "01"', text)
        self.assertIn('name = "02"', text)
        self.expect(self.convert(file, "dmx-k-sa", "--id", "01-02"), 2, "-o OUT.toml")
        self.expect(self.convert(file, "pmx-4ex-sa", "--id", "00-01", out="both.toml"), 2, "of one axis each")

    def test_what_is_mistyped_is_not_passed_over(self):
        file = self.drawing(self.line(0, 0, 5, 5, "Cut"))
        for wrong, status, says in ((("--axes", "X,X"), 1, "Axis X would be both axes of the drawing."),
                                    (("--pen-axis", "X:1:2"), 1, "Axis X draws, and so cannot lower the tool."),
                                    (("--unit", "furlong"), 2, "--unit furlong is not understood."),
                                    (("--ramp", "100"), 2, "Add --cut-speed and --travel-speed."),
                                    (("--table", "5,5,5,9"), 2, "lie across from each other"),
                                    (("--tolerance", "1000"), 1, "is larger than the whole drawing"),
                                    (("--per-unit", "1e-9"), 1, "is smaller than one of the pulses"),
                                    (("--layer", "bend"), 1, 'It has "Cut".')):
            self.expect(self.convert(file, "pmx-4ex-sa", "--per-unit", "100", *wrong) if wrong[0] != "--per-unit"
                        else self.convert(file, "pmx-4ex-sa", *wrong), status, says)
        for passed_over, says in ((("--layer", "CUT"), "--per-unit was not given: 1 is assumed"),
                                  (("--unit", "in"), "The file is in mm")):
            result = self.convert(file, "pmx-4ex-sa", *passed_over)
            self.expect(result, 0)
            self.assertIn(says, result.stderr)
        self.expect(self.convert(file, "vme58", "--per-unit", "100"), 1, "Give --cut-speed.")
        self.expect(self.convert(file, "dmx-k-sa"), 1, "Two controllers of one axis each on a bus draw together.")

    def test_what_cannot_be_converted_is_1(self):
        file = self.drawing(self.line(0, 0, 5, 5), header="")
        self.expect(self.convert(file, "pmx-4ex-sa"), 1, "does not name its unit")
        self.expect(self.convert(file, "pmx-4ex-sa", "--unit", "in"), 0)
        self.expect(self.convert(file, "vxm", "--unit", "mm"), 1, "how far its corners may lie from the line")
        self.expect(self.convert(file, "dmx-k-sa", "--unit", "mm"), 1, "A drawing needs two axes")
        self.expect(self.convert(file, "pmx-4ex-sa", "--unit", "mm", "--layer", "cut"), 1, 'no layer "cut"')
        self.expect(self.convert(self.folder / "none.dxf", "vxm"), 1, "none.dxf")
        self.expect(self.convert(self.file("b.dxf", "AutoCAD Binary DXF\r\n"), "vxm"), 1, "b.dxf")


class Jobs(Case):
    """assets/examples/*.lua: real jobs, on emulators in virtual time. In a copy, as they write beside themselves."""

    TOLD = {"grid_scan": "16 points", "home_repeat": "scatter 8 steps, standard deviation 2.6", "places": "measure\t10.0\t3.75",
            "jog_until_input": "found at ", "soak": "past the + limit", "two_together": "first\t4000\t3000",
            "backup_all": "board\t8 axes", "watch_and_stop": "stopped at ", "calibrate": "200.000 steps a millimetre",
            "list_parameters": "j1M\t1200\tsteps/s"}

    def test_each_does_its_work(self):
        self.assertEqual(set(self.TOLD), {path.stem for path in Examples.FOLDER.glob("*.lua")})
        for name, told in self.TOLD.items():
            with self.subTest(name):
                script = self.file(name + ".lua", (Examples.FOLDER / (name + ".lua")).read_text())
                self.expect(run("run", script), 0, told)
        rows = (self.folder / "grid.csv").read_text().splitlines()
        self.assertEqual((rows[0], len(rows), rows[4].rsplit(",", 1)[0]), ("x (mm),y (mm),millivolts", 17, "3.75,0.0"))
        for table, head, lines in (("home_repeat", "run,steps", 11), ("soak", "s,steps,encoder", 105)):
            rows = (self.folder / (table + ".csv")).read_text().splitlines()
            self.assertEqual((rows[0], len(rows)), (head, lines))
        for file in ("stage", "table", "slide", "board"):
            self.assertIn("[parameters]", (self.folder / (file + ".toml")).read_text())

    def test_each_tells_what_it_takes(self):
        for path in Examples.FOLDER.glob("*.lua"):
            with self.subTest(path.name):
                self.expect(run("run", path, "--", "--help"), 0, f"handwheel run {path} [-- OPTIONS]\n", "(default ")
                self.expect(run("run", path, "--", "--sped=1"), 2, 'There is no "--sped".')

    def test_files_stay_in_the_scripts_folder(self):
        outside = self.folder / "outside"
        outside.mkdir()
        (self.folder / "in").mkdir()
        (self.folder / "in" / "link").symlink_to(outside)
        (self.folder / "in" / "link.csv").symlink_to(outside / "a.csv")
        script = self.file("in/a.lua", """
          for _, name in ipairs{"../a.csv", "/tmp/a.csv", "a.lua", ".csv", "link/a.csv", "link.csv", "none/a.csv", "a.toml"} do
            local done, why, more = hw.write_csv(name, {{1}})
            hw.check(done == nil and #why > 10 and more.kind == "port", name)
          end
          local c = hw.open("vxm@emulator")
          hw.check(not c:backup("../a.toml") and not c:backup("a.csv") and not c:restore("none.toml"))
          hw.check(hw.write_csv("a.csv", {{'say "so", twice', 1, 2.5, true}, {"two\\nlines"}}))
          hw.check(not pcall(hw.write_csv, "b.csv", {5}) and not pcall(hw.write_csv, "b.csv", {{{}}}))""")
        self.expect(run("run", script), 0)
        self.assertEqual((script.parent / "a.csv").read_text(), '"say ""so"", twice",1,2.5,true\n"two\nlines"\n')
        self.assertEqual(list(outside.iterdir()), [])
        self.assertFalse((self.folder / "a.csv").exists())

    def test_a_script_among_files_of_root_says_to_copy_it(self):
        """The examples of an installed package."""
        script = self.file("share/a.lua", "print(hw.write_csv('a.csv', {{1}}))\n"
                                          "print(hw.open('vxm@emulator'):backup('a.toml'))")
        script.parent.chmod(0o555)
        self.folder.chmod(0o755)
        nobody = {"user": 65534} if os.geteuid() == 0 else {}
        result = run("run", script, **nobody)
        self.expect(result, 0)
        self.assertEqual(result.stdout.count("Copy the script into a folder of your own and run it there."), 2, result)
        script.parent.chmod(0o755)

    def test_upkeep_on_every_controller(self):
        for model in ("vxm", "pmx-4ex-sa", "dmx-k-sa", "vme58"):
            script = self.file("a.lua", f"""
              local c = assert(hw.open("{model}@emulator"))
              assert(c:clear_errors())
              local stored, why = c:store()
              hw.check(stored or why:find("no command to store"), why)
              assert(c:backup("a.toml") and c:restore("a.toml"))""")
            result = run("run", script)
            self.expect(result, 0)
            self.assertIn("a.toml (", result.stderr, "a script says what it has written")

    def test_units_that_the_console_keeps(self):
        self.profile("vxm@emulator", {"unit_choice": "own", "own_unit": {"name": "mm", "per_step": 0.005}})
        script = self.file("a.lua", """
          local c = assert(hw.open("vxm@emulator"))
          c:set("M1M", 4)
          assert(c:move_to({[1] = 2.5}, {unit = true}) and c:wait(30))
          print(c:position(1), c:units(1).unit)""")
        kept = {"XDG_CONFIG_HOME": str(self.folder)}
        self.expect(run("run", "--profile", script, settings=kept), 0, "500\tmm\n")
        self.expect(run("run", "--gui", "--profile", script, settings=kept), 0, "500\tmm\n")
        self.expect(run("run", script, settings=kept), 1, "axis 1 has no unit yet")  # a run is the same on every machine

    def test_an_error_side_by_side_ends_the_script(self):
        script = self.file("a.lua", "hw.spawn(function() hw.sleep(1) error('beside') end)\nhw.sleep(9)\nprint('on')")
        result = run("run", script)
        self.expect(result, 1, "a.lua:1: beside")
        self.assertEqual(result.stdout, "")


class Params(Case):
    def test_words_and_json(self):
        self.expect(run("params", "vxm"), 0, "j1M ", "First jog speed of motor 1 [steps/s]: ", "6000 (default 2000)")
        self.expect(run("params", "vxm", "--motors", "4"), 0, "j4M ")
        for model, name in (("vxm", "j1M"), ("pmx-4ex-sa", "HSX"), ("dmx-k-sa", "HSPD"), ("vme58", "VLX")):
            result = run("params", model, "--json")
            self.expect(result, 0)
            told = json.loads(result.stdout)
            self.assertEqual(told["model"], model)
            (one,) = [p for p in told["parameters"] if p["name"] == name]
            self.assertTrue(one["label"])
            self.assertLess(one["min"], one["max"])
            self.assertIn("default", one)

    def test_wrong_usage(self):
        self.expect(run("params", "vmx"), 2, 'There is no controller model "vmx". Known: ', 'Did you mean "vxm"?')
        self.expect(run("params", "dmx-k-sa", "--motors", "4"), 2, "has no --motors")


class Simulate(Case):
    def simulate(self, text, *more):
        result = run("simulate", self.file("a.vxm", text), "--for", "vxm", "--json", *more)
        return result, json.loads(result.stdout) if result.stdout else None

    def test_the_object_of_the_contract(self):
        result, got = self.simulate("S1M2000\nI1M4000\nI1M-1000\nU4\n")
        self.expect(result, 0)
        self.assertEqual(set(got), {"model", "duration_s", "finished", "error", "axes", "outputs", "sent_to_host",
                                    "program_bytes", "events"})
        self.assertEqual(got["model"], "vxm")
        self.assertTrue(got["finished"])
        self.assertFalse(got["error"])
        self.assertEqual(got["axes"]["1"], {"position": 3000, "min": 0, "max": 4000, "travel": 5000})
        self.assertEqual(got["program_bytes"]["0"], 13)
        self.assertGreater(got["duration_s"], 2)
        self.assertIn("^", got["sent_to_host"])
        for event in got["events"]:
            self.assertEqual(set(event), {"t", "what"})

    def test_a_program_without_end(self):
        result, got = self.simulate("LM0\nI1M100\nI1M-100\nL0\n", "--for-seconds", 30)
        self.assertEqual(result.returncode, 1, "a shell sees that it has no end")
        self.assertTrue(result.stderr.strip())
        self.assertFalse(got["finished"])
        self.assertAlmostEqual(got["duration_s"], 30, delta=0.01)

    def test_with_a_bench(self):
        bench = self.file("bench.toml", "[axis.1]\nplus = 500\n")
        _, got = self.simulate("I1M4000\n", "--bench", bench)
        self.assertEqual(got["axes"]["1"]["position"], 500)
        bad = self.file("bad.toml", "[axis.9]\nplus = 500\n")
        result, _ = self.simulate("I1M4000\n", "--bench", bad)
        self.expect(result, 1, "bad.toml:1:1", 'no axis "9"')

    def test_on_the_model_that_is_named(self):
        file = self.file("a.vme", "AU KP2\nAX MR10 GO ID\n")
        self.expect(run("simulate", file, "--for", "vme58"), 0, "axis X: ends at 10")
        self.expect(run("simulate", file, "--for", "vme58", "--variant", "4S4"), 1, "KP2")
        self.expect(run("simulate", file, "--for", "vme58", "--variant", "9S"), 2, "variant=9S")
        self.expect(run("simulate", self.file("b.vme", "BL3\n"), "--for", "vme58"), 1, "BL3")
        self.expect(run("simulate", self.file("b.vme", "BL3\n"), "--for", "vme58", "--jumpers", "OIO"), 0)
        self.expect(run("simulate", self.file("a.vxm", "I1M4\n"), "--for", "vxm", "--variant", "4S4"), 2,
                    "no --variant")

    def outputs(self, model, name, text):
        result = run("simulate", self.file(name, text), "--for", model, "--json")
        dry = json.loads(result.stdout)
        return result.returncode, list(dry["axes"]), dry["outputs"]

    def test_all_axes_and_outputs_with_and_without_an_error(self):
        good = self.outputs("vme58", "a.vme", "AX MR10 GO")
        self.assertEqual((good[0], good[1]), (0, list("XYZTUVRS")))
        self.assertEqual(good[2], {**{str(n): 0 for n in range(8, 14)}, **{str(n): 1 for n in range(14, 22)}})
        self.assertEqual(self.outputs("vme58", "b.vme", "AX XQ"), (1, *good[1:]))
        self.assertEqual(self.outputs("vme58", "a.vme", "BL8")[2]["8"], 1)
        for model, name, text, wrong in (("dmx-k-sa", "a.prg", "END\n", "NONSENSE\n"), ("vxm", "a.vxm", "I1M4", "S1M9000"),
                                         ("pmx-4ex-sa", "a.prg", "END\n", "NONSENSE\n")):
            good, bad = self.outputs(model, name, text), self.outputs(model, name, wrong)
            self.assertEqual((good[0], bad[0]), (0, 1), model)
            self.assertEqual(good[1:], bad[1:], model)

    def test_words(self):
        result = run("simulate", self.file("a.vxm", "I1M400\n"), "--for", "vxm")
        self.expect(result, 0, "ends after", "axis 1: ends at 400")

    def test_the_program_that_is_started(self):
        text = "PRG 0\nHSPD=1000\nLSPD=100\nACC=100\nX500\nWAITX\nEND\nPRG 1\nSR0=1\nDELAY=10\nEND\n"
        file = self.file("a.prg", text)
        for number in (0, 1):
            result = run("simulate", file, "--for", "pmx-4ex-sa", "--program", number)
            self.expect(result, 0, "axis X: ends at 500")
        self.expect(run("simulate", file, "--for", "pmx-4ex-sa", "--program", 2), 1, "There is no program 2 to start")
        self.expect(run("simulate", file, "--for", "pmx-4ex-sa", "--program", 4), 2, "--program 4")
        vxm = self.file("a.vxm", "I1M400\n")
        self.expect(run("simulate", vxm, "--for", "vxm", "--program", 3), 0, "Program 3: 4 bytes", "axis 1: ends at 400")

    def test_the_reason_of_a_stop(self):
        file = self.file("a.prg", "HSPD=1000\nLSPD=100\nACC=100\nSLX=1\nX4000Y4000\nEND\n")
        self.expect(run("simulate", file, "--for", "pmx-4ex-sa"), 1, "line 5", "StepNLoop is on for some of its axes")

    def test_limits_loops_and_what_is_assumed(self):
        bench = self.file("bench.toml", "[axis.1]\nplus = 500\n")
        result, got = self.simulate("I1M4000\nI2M5\n", "--bench", bench)
        self.expect(result, 0)
        result, strict = self.simulate("I1M4000\nI2M5\n", "--bench", bench, "--strict")
        self.assertEqual((result.returncode, strict), (1, got), "a limit is a failure for who asks for it")
        self.assertIn("limit", result.stderr)
        self.expect(self.simulate("I1M40\n", "--bench", bench, "--strict")[0], 0)
        (stop,) = got["stops"]
        self.assertEqual((stop["axis"], stop["direction"], stop["line"]), ("1", 1, 1))
        self.assertAlmostEqual(stop["t"], 0.707, delta=0.001)
        self.assertNotIn("endless", got)
        result, got = self.simulate("P5\nL0\n", "--for-seconds", 10)
        self.assertTrue(got["endless"])
        self.assertIn("the loop of lines 1 to 2 (L0) has no end", got["error"])
        like = self.file("like.toml", 'model = "vxm"\n[parameters]\nBx = 9\n[programs]\n2 = """I2M44"""\n')
        result, got = self.simulate("I1M-100\nJM2\n", "--like", like)
        self.expect(result, 0)
        self.assertEqual((got["axes"]["1"]["min"], got["axes"]["2"]["position"]), (-109, 44))
        self.assertEqual(got["assumptions"]["position of 1"], "0")
        self.assertIn("S1M", got["assumptions"])
        self.assertNotIn("Bx", got["assumptions"])
        file = self.file("a.vxm", "I1M-100\n")
        self.expect(run("simulate", file, "--for", "vxm", "--like", like), 0, "assumed: S1M 2000 steps/s")
        wrong = self.file("wrong.toml", 'model = "dmx-k-sa"\n')
        self.expect(run("simulate", file, "--for", "vxm", "--like", wrong), 1, 'a controller "dmx-k-sa"')

    # Of each controller: one that does its work, one that goes on behind a limit switch, one without end, one
    # that stops in error (a VME58 rejects what it does not know before it begins).
    ENDS = {
        "vxm": ("I1M400\n", "I1M4000\n", "P5\nL0\n", "U7,I1M400,I2M400,U9\n"),
        "pmx-4ex-sa": ("PRG 0\nEO=15\nX400\nWAITX\nEND\n", "PRG 0\nEO=15\nX4000\nEND\n",
                       "PRG 0\nWHILE 1=1\nDELAY=10\nENDWHILE\nEND\n", "PRG 0\nV1=0\nV2=5/V1\nEND\n"),
        "dmx-k-sa": ("EO=1\nX400\nWAITX\nEND\n", "EO=1\nX4000\nEND\n",
                     "WHILE 1=1\nDELAY=10\nENDWHILE\nEND\n", "V1=0\nV2=5/V1\nEND\n"),
        "vme58": ("AX VL5000 AC50000 MR400 GO ID\n", "AX VL5000 AC50000 MR4000 GO ID\n",
                  "AX WH WT100 WG\n", "AX XQ\n"),
    }

    def test_each_controller_ends_with_what_became_of_it(self):
        for model, texts in self.ENDS.items():
            axis = "1" if model == "vxm" else "X"
            bench = self.file("bench.toml", f"[axis.{axis}]\nplus = 500\n")
            for text, plain, strict in zip(texts, (0, 0, 1, 1), (0, 1, 1, 1)):
                with self.subTest(model=model, text=text):
                    job = ("simulate", self.file("a.txt", text), "--for", model, "--bench", bench, "--for-seconds", 30)
                    self.expect(run(*job), plain)
                    result = run(*job, "--strict")
                    self.expect(result, strict)
                    self.assertEqual(bool(result.stderr), strict == 1)
            job = ("simulate", self.file("a.txt", texts[1]), "--for", model, "--bench", bench)
            self.expect(run(*job, "--strict"), 1, "plus limit switch")

    def test_how_much_of_the_memory_it_takes(self):
        text = "PRG 0\nSR1=1\nEND\nPRG 1\nV1=1\nEND\n"
        self.expect(run("simulate", self.file("a.prg", text), "--for", "pmx-4ex-sa"), 0,
                    "whole text: 6 lines of 1275")
        self.expect(run("simulate", self.file("a.vxm", "I1M400\n"), "--for", "vxm"), 0,
                    "Program 0: 4 bytes of 256")

    def test_a_text_with_errors(self):
        result, got = self.simulate("PM1,P5\nPM0,S1M9000\n")
        self.expect(result, 1, "Line 2", "9000")
        self.assertFalse(got["finished"])
        self.assertIn("9000", got["error"])
        self.assertEqual(got["axes"]["1"], {"position": 0, "min": 0, "max": 0, "travel": 0})


class Backup(Case):
    def test_there_and_back(self):
        first, second = self.folder / "one.toml", self.folder / "two.toml"
        with emulator("vxm", "--tcp", "127.0.0.1:0") as (ready, _):
            address = "vxm@tcp:" + port_of(ready[0])
            self.expect(run("send", address, "setj1M700", "PM2,C,I1M123"), 0)
            self.expect(run("backup", address, "-o", first), 0)
            self.assertIn("I1M123", first.read_text())
            self.assertIn("j1M = 700", first.read_text())
        with emulator("vxm", "--tcp", "127.0.0.1:0") as (ready, _):
            address = "vxm@tcp:" + port_of(ready[0])
            self.expect(run("restore", address, first), 0)
            self.expect(run("send", address, "PM2", "lst"), 0, "I1M123")
            self.expect(run("send", address, "getj1M"), 0, "700")
            self.expect(run("backup", address, "-o", second), 0)
    def test_all_of_it_comes_back(self):
        file = self.folder / "all.toml"
        with emulator("vxm", "--tcp", "127.0.0.1:0") as (ready, _):
            address = "vxm@tcp:" + port_of(ready[0])
            self.expect(run("send", address, "setM1M4,PM3,C,U5", "PM0"), 0)
            self.expect(run("backup", address, "-o", file), 0, "1 program")
        with emulator("vxm", "--tcp", "127.0.0.1:0") as (ready, _):
            address = "vxm@tcp:" + port_of(ready[0])
            self.expect(run("send", address, "PM1,C,I1M7", "PM0"), 0)
            self.expect(run("restore", address, file, "--leave-motor-types"), 0)
            self.expect(run("send", address, "getM1M"), 0, "0")
            result = run("restore", address, file)
            self.expect(result, 0, "Parameters: 1 written")
            self.assertIn("M1M = 4 was written", result.stderr, "a motor type is never written without a word")
            self.assertEqual(run("send", address, "getM1M", "PM1,M", "PM3,lst").stdout,
                             "4\n256\nPM3 M254\nU5\n", "and what was empty is empty again")

    def test_variables_come_along(self):
        file = self.folder / "dmx.toml"
        with emulator("dmx-k-sa", "--tcp", "127.0.0.1:0") as (ready, _):
            address = "dmx-k-sa@tcp:" + port_of(ready[0])
            self.expect(run("send", address, "V7=70", "V50=-12345", "V99=134217727", "SLT=33"), 0)
            self.expect(run("backup", address, "-o", file), 0)
        text = file.read_text()
        self.assertIn("[variables]\n", text)
        self.assertIn("50 = -12345\n", text)
        self.assertIn("99 = 134217727\n", text)
        self.assertNotIn("\n7 = 70", text, "V0 to V49 are never kept by the controller")
        with emulator("dmx-k-sa", "--tcp", "127.0.0.1:0") as (ready, _):
            address = "dmx-k-sa@tcp:" + port_of(ready[0])
            self.expect(run("send", address, "V51=5"), 0)
            self.expect(run("restore", address, file), 0, "Variables: 3 written")
            self.assertEqual(run("send", address, "V50", "V51", "V99", "SLT").stdout, "-12345\n0\n134217727\n33\n")
            self.expect(run("restore", address, file), 0, "Parameters: 0 written")

    def test_variables_that_cannot_be(self):
        for line, words in (("100 = 1", "V100"), ("60 = 99999999999", "99999999999"), ('60 = "x"', "60")):
            beyond = self.file("beyond.toml", f'model = "dmx-k-sa"\n[variables]\n{line}\n')
            self.expect(run("restore", "dmx-k-sa@emulator", beyond), 1, words)

    def test_what_cannot_be_restored(self):
        beyond = self.file("beyond.toml", "model = \"vxm\"\n[parameters]\nj1M = 99999\nDA = 50\n")
        self.expect(run("restore", "vxm@emulator", beyond), 1, "j1M = 99999 is out of range")
        self.expect(run("restore", "vxm@emulator", self.folder / "none.toml"), 1, "none.toml")
        self.expect(run("restore", "vxm@emulator", self.file("bad.toml", "model = \"vxm\"\n[parameters]\nx = = 1\n")),
                    1, "bad.toml")


class BadInput(Case):
    """Each command with what it cannot take: a sentence, and the status of the contract (1 the job failed, 2 usage)."""

    def setUp(self):
        super().setUp()
        self.good = self.file("good.vxm", "I1M400\n")
        self.folder_itself = self.folder / "folder"
        self.folder_itself.mkdir()
        self.binary = self.file("binary", bytes(range(256)) * 8)
        self.empty = self.file("empty", "")

    def says(self, status, words, *arguments):
        with self.subTest(arguments=arguments):
            result = run(*arguments)
            self.assertEqual(result.returncode, status, result)
            self.assertIn(words, result.stderr)
            self.assertTrue(result.stderr.startswith("handwheel: "), result.stderr)
            self.assertTrue(result.stderr.rstrip().endswith((".", "?")), "a whole sentence: " + result.stderr)

    def test_files_that_are_none(self):
        missing = self.folder / "missing"
        commands = [lambda f: ("run", f), lambda f: ("check", f, "--for", "vxm"),
                    lambda f: ("compile", f, "--for", "dmx-k-sa", "-o", self.folder / "out"),
                    lambda f: ("simulate", f, "--for", "pmx-4ex-sa"), lambda f: ("restore", "vxm@emulator", f),
                    lambda f: ("simulate", self.good, "--for", "vxm", "--bench", f),
                    lambda f: ("emulate", "vxm", "--tcp", "127.0.0.1:0", "--bench", f),
                    lambda f: ("send", f"vxm@emulator,bench={f}", "V")]
        for command in commands:
            self.says(1, "There is no file", *command(missing))
            self.says(1, "is a folder", *command(self.folder_itself))
            self.says(1, "binary", *command(self.binary))
        self.says(1, "does not say for which controller", "restore", "vxm@emulator", self.empty)

    def test_programs_that_nobody_writes_in_good_faith(self):
        many = 100_000
        for model, text in (("vxm", "PM0," + "(" * many), ("vxm", "J0" * many), ("vxm", "U" * 10_000_000),
                            ("pmx-4ex-sa", "PRG 0\nV1=" + "(" * many + "\nEND\n"), ("dmx-k-sa", "PRG 0\nV1=" + "-" * many),
                            ("pmx-4ex-sa", "PRG 0\n" + "WHILE 1=1\n" * 50_000), ("pmx-4ex-sa", "\x1b[2J"),
                            ("vme58", "AX LS2 " * many), ("vme58", "AX MR1 GO " * 30_000 + "XX"), ("vme58", "A" * 10_000_000),
                            ("vxm", "[" + "a." * many + "a]\n"), ("vme58", "format = " + "[" * many)):
            result = run("check", self.file("a.txt", text), "--for", model, timeout=30)
            self.assertEqual(result.returncode, 1, (model, text[:30]))
            self.assertTrue(result.stdout + result.stderr)
            self.assertNotIn("\x1b", result.stdout + result.stderr)

    def assert_short_and_harmless(self, result, what):
        said = result.stdout + result.stderr
        self.assertEqual(result.returncode, 1, (what, said[:500]))
        self.assertTrue(said, what)
        self.assertLess(len(said), 60_000, (what, said[:500]))
        self.assertEqual([c for c in said if ord(c) < 32 and c not in "\n\t" or 127 <= ord(c) < 160 or c in "\u202e\u2028"], [],
                         (what, said[:500]))

    def test_every_kind_of_file_that_nobody_writes_in_good_faith(self):
        many = 100_000
        texts = {"a name of many parts": "[" + "a." * many + "a]\n", "nested lists": "a = " + "[" * many + "]" * many,
                 "a line of 10 MB": "a = \"" + "x" * 10_000_000 + "\"\n", "one of 900 kB": "J0" * 450_000,
                 "many errors": "I9M\n" * 200_000, "a name that acts": '"\\u001B[2J" = 1\n', "an escape": "\x1b[2J",
                 "a sequence that nests": 'format = "handwheel sequence"\nversion = 1\n' + "[[steps]]\n" * 10 + "a." * many + "b = 1\n",
                 "C1 and bidi": "I1M\u009b2J\u202e400\u2028\n", "bytes": bytes(range(256)) * 100}
        readers = [lambda f: ("run", f), lambda f: ("check", f, "--for", "vxm"), lambda f: ("check", f, "--for", "vme58"),
                   lambda f: ("compile", f, "--for", "pmx-4ex-sa", "-o", self.folder / "out"),
                   lambda f: ("simulate", f, "--for", "dmx-k-sa"), lambda f: ("simulate", self.good, "--for", "vxm", "--bench", f),
                   lambda f: ("simulate", self.good, "--for", "vxm", "--like", f), lambda f: ("restore", "vxm@emulator", f),
                   lambda f: ("convert", f, "--for", "vme58", "--per-unit", "100", "-o", self.folder / "out"),
                   lambda f: ("emulate", "vxm", "--tcp", "127.0.0.1:0", "--bench", f),
                   lambda f: ("emulate", "vxm", "--tcp", "127.0.0.1:0", "--state", f)]
        for what, text in texts.items():
            file = self.file("hostile", text)
            for reader in readers:
                arguments = reader(file)
                with self.subTest(what=what, arguments=arguments):
                    self.assert_short_and_harmless(run(*arguments, timeout=60), (what, arguments))
        self.assertFalse((self.folder / "out").exists())

    def test_how_many_errors_there_are_is_said_and_the_first_are_told(self):
        file = self.file("many.vxm", "?\n" * 5000 + "I9M\n" * 4000)
        result = run("check", file, "--for", "vxm")
        self.expect(result, 1)
        lines = result.stdout.splitlines()
        self.assertEqual(len(lines), 101)
        self.assertTrue(lines[0].startswith(f"{file}:5001:1: error: "), "errors before warnings: " + lines[0])
        self.assertEqual(lines[-1], f"{file}: and 8900 more. Correct these first.")

    def test_names_that_act_on_a_terminal(self):
        names = ["a\x1b[2J", "a\nhandwheel: all is well", "\u202egnp", "a\u009b2J", "\udcff\udcfe", "a\rb", "x" * 250]
        for name in names:
            path = self.folder / name
            for there in (False, True):
                if there:
                    path.write_text("I9M\n")
                for arguments in (("run", path), ("check", path, "--for", "vxm"), ("simulate", path, "--for", "vxm"),
                                  ("restore", "vxm@emulator", path), ("backup", "vxm@emulator", "-o", path / "no"),
                                  ("run", "--traffic", path / "no", self.empty), ("send", f"vxm@serial:{path}", "V"),
                                  ("convert", path, "--for", "vme58", "--per-unit", "100", "-o", path / "no")):
                    with self.subTest(name=name, arguments=arguments):
                        result = run(*arguments)
                        self.assert_short_and_harmless(result, arguments)
                        self.assertNotIn("\nhandwheel: all is well", result.stdout + result.stderr)

    def test_words_that_nobody_types_in_good_faith(self):
        long = "x" * 100_000
        script = self.file("s.lua", "hw.arguments{{name='count', kind='whole', default=3}, {name='how', choices={'a'}, default='a'}}")
        for arguments in (("send", "vxm@" + long, "V"), ("send", "\x1b[2J@emulator", "V"), ("send", "vxm@emulator,\x1b[2J=1", "V"),
                          ("send", "vxm@tcp:" + long + ":1", "V"), ("send", "vxm@serial:/dev/\x1b[2J", "V"), (long,), ("\x1b[2J",),
                          ("check", "--for", long, self.good), ("check", "--\x1b[2J", self.good), ("scan", "/dev/\x1b[2J"),
                          ("run", script, "count=" + long), ("run", script, "--", "--\x1b[2J"), ("run", script, "how=\x1b[2J"),
                          ("--log", "\x1b[2J=debug", "scan"), ("simulate", self.good, "--for", "vxm", "--for-seconds", long)):
            with self.subTest(arguments=arguments):
                result = run(*arguments)
                self.assertIn(result.returncode, (1, 2))
                result.returncode = 1
                self.assert_short_and_harmless(result, arguments)

    def test_places_that_cannot_be_written(self):
        for place, why in ((self.folder_itself, "it is a folder"), (self.folder / "no/file", "there is no such folder")):
            self.says(1, why, "backup", "vxm@emulator", "-o", place)
            self.says(1, why, "compile", self.empty, "--for", "pmx-4ex-sa", "-o", place)
            self.says(1, str(place), "backup", "vxm@emulator", "-o", place)
        self.says(1, "cannot be written", "run", "--traffic", self.folder / "no/file", self.empty)
        self.says(1, "There is no folder", "emulate", "vxm", "--tcp", "127.0.0.1:0", "--state", self.folder / "no/file")
        self.says(1, "is a folder", "emulate", "vxm", "--tcp", "127.0.0.1:0", "--state", self.folder_itself)
        self.says(1, "not the saved memory", "emulate", "vxm", "--tcp", "127.0.0.1:0", "--state", self.binary)
        self.says(1, "there is a file of that name", "emulate", "vxm", "--pty", self.good)

    def test_options(self):
        good = self.good
        for arguments, words in (
                (("check",), "FILE is required. `handwheel check --help`"),
                (("check", good), "Add --for MODEL (vxm, "),
                (("check", good, "--for"), "--for"),
                (("check", good, "--for", "vxn"), 'no controller model "vxn". Known: vxm'),
                (("check", good, "--for", "vxn"), 'Did you mean "vxm"?'),
                (("emulate", "pmx", "--tcp", "127.0.0.1:0"), 'Did you mean "pmx-4ex-sa"?'),
                (("send", "dmx@emulator", "ID"), 'Did you mean "dmx-k-sa"?'),
                (("simlate", good), 'There is no subcommand "simlate" (did you mean "simulate"?). `handwheel'),
                (("check", good, "another", "--for", "vxm"), "another"),
                (("demo", "more"), "more"),
                (("compile", self.empty, "--for", "pmx-4ex-sa"), "Add -o OUT"),
                (("simulate", good, "--for", "vxm", "--for-seconds", "-1"), "--for-seconds -1"),
                (("send", "vxm@emulator", "--wait", "soon", "V"), "--wait soon"),
                (("backup", "vxm@emulator", "-o", "a", "-o", "b"), "--output"),
                (("emulate", "vxm"), "--tcp 127.0.0.1:4001"),
                (("emulate", "vxm", "--tcp", "127.0.0.1"), "is not HOST:PORT"),
                (("emulate", "vxm", "--tcp", "127.0.0.1:99999"), "not a port number"),
                (("emulate", "vxm", "--tcp", "127.0.0.1:0", "--motors", "5"), "1 to 4 motors"),
                (("emulate", "vxm", "--tcp", "127.0.0.1:0", "--speed", "0"), "speed=0"),
                (("emulate", "vxm", "--tcp", "127.0.0.1:0", "--wire", "maybe"), "wire=maybe"),
                (("emulate", "vxm", "--tcp", "127.0.0.1:0", "--quirk", "none"), "mode-while-running and old-firmware"),
                (("emulate", "vxm", "--tcp", "127.0.0.1:0", "--id", "01"), "has no --id"),
                (("emulate", "dmx-k-sa", "--tcp", "127.0.0.1:0", "--id", "1"), "two digits")):
            self.says(2, words, *arguments)

    def test_addresses(self):
        for address, words in (
                ("vxm", "it has no @"), ("vxm@", "is not a transport"), ("@emulator", "no controller model"),
                ("vxm@serial", "does not say where"), ("vxm@usb", "has no USB"), ("vxm@tcp:localhost", "is not HOST:PORT"),
                ("vxm@emulator,motors=9", "motors=9"), ("vxm@emulator,foo=1", 'no option "foo"'),
                ("vxm@emulator,baud=x", "baud=x is not a rate"), ("dmx-k-sa@emulator,id=1", "two digits"),
                ("dmx-k-sa@emulator,id=01-02", "names several controllers")):
            self.says(2, words, "send", address, "V")
            self.says(2, words, "backup", address, "-o", self.folder / "out")
        for address, words in (
                ("vxm@serial:/dev/none", "There is no port /dev/none"),
                (f"vxm@serial:{self.folder_itself}", "is not a serial port"),
                (f"vxm@serial:{self.good}", "is not a serial port"),
                ("vxm@tcp:127.0.0.1:1", "nothing listens on that port"),
                ("vxm@rfc2217:127.0.0.1:1", "nothing listens on that port")):
            self.says(1, words, "send", address, "V")
        self.says(1, '"": There is no command in that text', "send", "vxm@emulator", "")


class Wires(Case):
    """The connection page against emulators on ports of their own."""

    def work_through(self, lines, port):
        self.expect(run("run", "--gui", "--realtime", HERE / "gui/checklist_wires.lua", lines, port, timeout=150), 0)

    def test_the_checklist_of_connections_of_a_pmx(self):
        state, pmx = self.folder / "pmx", self.folder / "pmx-line"
        with emulator("pmx-4ex-sa", "--tcp", "127.0.0.1:0", "--state", state) as (ready, _):
            address = "pmx-4ex-sa@tcp:" + port_of(ready[0])
            self.expect(run("send", address, "DB=3", "DN=4EX07", "STORE"), 0, "OK")
        with emulator("pmx-4ex-sa", "--pty", pmx, "--state", state):
            self.work_through("PMX", pmx)

    def test_the_checklist_of_connections_of_a_dmx(self):
        dmx = self.folder / "dmx-line"
        with emulator("dmx-k-sa", "--pty", dmx, "--id", "05"):
            self.work_through("DMX", dmx)


class OnePort(Case):
    def test_two_instances_on_one_port(self):
        link = self.folder / "port"
        with emulator("vxm", "--pty", link, "--wire", "off"):
            script = self.file("hold.lua", f"local c = assert(hw.open('vxm@serial:{link}'))\n"
                                           "print('open') hw.sleep(4)")
            holder = subprocess.Popen([PROGRAM, "run", str(script)], stdout=subprocess.PIPE, text=True)
            self.assertEqual(holder.stdout.readline(), "open\n")
            result = run("send", f"vxm@serial:{link}", "V")
            self.expect(result, 1, str(link))
            holder.communicate(timeout=30)
            self.assertEqual(holder.returncode, 0)
            self.expect(run("send", f"vxm@serial:{link}", "V"), 0, "R")


def each_of(suite):
    for test in suite:
        if isinstance(test, unittest.TestSuite):
            yield from each_of(test)
        else:
            yield test


def outcome_of(test):
    result, began = unittest.TestResult(), time.monotonic()
    test.run(result)
    return test, result, time.monotonic() - began


def main():
    """The tests wait nine tenths of their time for processes of their own: four at a time."""
    loader, here = unittest.defaultTestLoader, sys.modules[__name__]
    suite = loader.loadTestsFromNames(sys.argv[1:], here) if sys.argv[1:] else loader.loadTestsFromModule(here)
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        for test, result, seconds in pool.map(outcome_of, each_of(suite)):
            wrong = result.errors + result.failures
            skipped = [why for _, why in result.skipped]
            print(f"{'FAILED' if wrong else 'skipped' if skipped else 'ok':7} {seconds:6.2f} s  {test.id()}", *skipped)
            for what, why in wrong:
                print(f"{what}\n{why}")
            failed += bool(wrong)
            assert result.testsRun == 1, test
    print(f"{failed} failed")
    return 1 if failed or not suite.countTestCases() else 0


if __name__ == "__main__":
    sys.exit(main())
