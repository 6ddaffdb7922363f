#!/usr/bin/env python3
"""A sequence file as a shell sees it, for each controller: checked, rehearsed and compiled like a program."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.environ.get("HANDWHEEL", "build/handwheel")

SEQUENCE = """handwheel_sequence = 1
unit = "mm"
axes = [ {{ name = "{axis}", per_unit = 10 }} ]
pen_down = [ {{ do = "output", output = {output}, on = true }}, {{ do = "delay", ms = 20 }} ]
pen_up = [ {{ do = "output", output = {output}, on = false }} ]
steps = [
  {{ do = "speed", high = 100, ramp_ms = 200 }},
  {{ do = "move", to = {{ "{axis}" = 40 }} }},
  {{ do = "wait_motion" }},
  {{ do = "pen", down = true }},
  {{ do = "loop", times = 3, steps = [ {{ do = "move", relative = true, to = {{ "{axis}" = 5 }} }}, {{ do = "wait_motion" }} ] }},
  {{ do = "pen", down = false }},
]
"""
CONTROLLERS = {
    "vxm": {"axis": "1", "output": 1, "told": None},
    "pmx-4ex-sa": {"axis": "X", "output": 5, "told": "MOVE,X,400"},
    "dmx-k-sa": {"axis": "X", "output": 3, "told": "MOVE,X,400"},
    "vme58": {"axis": "X", "output": 8, "told": None},
}


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=60)


class Sequences(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def each(self):
        """Its name, what is of it, and its file."""
        for model, its in CONTROLLERS.items():
            file = self.folder / (model + ".toml")
            file.write_text(SEQUENCE.format(**its))
            yield model, its, file

    def test_it_is_checked(self):
        for model, its, file in self.each():
            result = run("check", file, "--for", model)
            self.assertEqual(result.returncode, 0, result)
            file.write_text(file.read_text().replace('do = "wait_motion"', 'do = "output", output = 61', 1))
            result = run("check", file, "--for", model)
            self.assertEqual(result.returncode, 1, result)
            self.assertIn("Step 3 (output): ", result.stderr)

    def test_it_is_rehearsed(self):
        for model, its, file in self.each():
            result = run("simulate", file, "--for", model, "--json")
            self.assertEqual(result.returncode, 0, result)
            told = json.loads(result.stdout)
            self.assertTrue(told["finished"], told)
            self.assertEqual(told["axes"][its["axis"]]["max"], 550, told)

    def test_it_is_compiled_where_the_controller_stores_another_form(self):
        for model, its, file in self.each():
            result = run("compile", file, "--for", model, "--listing")
            with self.subTest(model=model):
                if its["told"]:
                    self.assertEqual(result.returncode, 0, result)
                    self.assertIn(its["told"], result.stdout)
                else:
                    self.assertEqual(result.returncode, 1, result)
                    self.assertIn("there is nothing to compile", result.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
