#!/usr/bin/env python3
"""The package as far as it can be tried without installing it: made by cpack, unpacked, run from there, and what it
depends on compared with what the loader wants.   package_test.py BUILD_FOLDER [PACKAGE.deb]"""
import os
import pathlib
import pty
import re
import select
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

BUILD = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "build").resolve()
MADE = pathlib.Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else None
SOURCE = pathlib.Path(__file__).resolve().parent.parent


def said(*command, **more):
    return subprocess.run([*map(str, command)], capture_output=True, text=True, timeout=240, check=True, **more).stdout


def package_of(library):
    """The name of the package that brings this file. Debian lists some under / and some under /usr."""
    path = str(pathlib.Path(library).resolve())
    for name in (path, path.removeprefix("/usr")):
        found = subprocess.run(["dpkg-query", "-S", name], capture_output=True, text=True, check=False)
        if found.returncode == 0:
            return found.stdout.split(":")[0]
    raise AssertionError(f"no package brings {library}")


def provider_of(name):
    """The package behind a name that several may provide (libspdlog1.10-fmt9)."""
    listed = said("dpkg-query", "-W", "-f", "${Package}\t${Provides}\n")
    for line in listed.splitlines():
        package, _, provides = line.partition("\t")
        if name == package or name in re.findall(r"[\w.+-]+", re.sub(r"\(.*?\)", "", provides)):
            return package
    return name


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        work = pathlib.Path(cls.folder.name)
        if not MADE:
            # Packed in a tenth of the time that xz takes; what is in it is the same.
            said("cpack", "--config", BUILD / "CPackConfig.cmake", "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=gzip", "-B", work)
        cls.deb = MADE or next(work.glob("*.deb"))
        cls.root = work / "root"
        said("dpkg-deb", "-x", cls.deb, cls.root)
        cls.program = cls.root / "usr/bin/handwheel"
        cls.share = cls.root / "usr/share"

    def run_it(self, *arguments, **more):
        bare = {"PATH": "/usr/bin:/bin", "HOME": self.folder.name, "LC_ALL": "C.UTF-8"}  # no display
        return said(self.program, *arguments, env=bare, cwd=self.folder.name, **more)

    def programs(self):
        return [self.program, *self.root.glob("usr/libexec/handwheel/*")]

    def test_it_runs_and_names_its_commit(self):
        self.assertEqual(self.run_it("--version"), said(BUILD / "handwheel", "--version"))
        self.assertRegex(self.run_it("--version"), r"^handwheel \d+\.\d+\.\d+( \(\w+(, changed)?\))?\n$")

    def test_it_finds_its_manual_and_examples_where_it_lies(self):
        self.assertIn(f"Manual and examples: {self.share}/handwheel.", self.run_it("--help"))
        self.assertIn(f"Manual and examples: {SOURCE}/assets.", said(BUILD / "handwheel", "--help"))

    def test_it_moves_an_emulated_axis_and_draws_the_console(self):
        script = pathlib.Path(self.folder.name) / "try.lua"
        picture = pathlib.Path(self.folder.name) / "try.png"
        script.write_text('local c = hw.check(hw.open("vxm@emulator"))\n'
                          'hw.check(c:move_by{[1] = 400} and c:wait(10))\n'
                          f'ui.frame(2)\nui.screenshot("{picture}")\nprint(c:position(1))\n')
        self.assertEqual(self.run_it("run", "--gui", script), "400\n")
        self.assertTrue(picture.read_bytes().startswith(b"\x89PNG"))

    def test_its_examples_run_from_there(self):
        self.run_it("run", self.share / "handwheel/examples/home_repeat.lua")

    def test_it_depends_on_what_the_loader_wants_and_on_nothing_else(self):
        wanted = set()
        for program in self.programs():
            needed = re.findall(r"NEEDED\s+(\S+)", said("objdump", "-p", program))
            loaded = dict(re.findall(r"(\S+) => (\S+)", said("ldd", program)))
            self.assertNotIn("not", loaded.values(), "not found")
            wanted |= {package_of(loaded[library]) for library in needed if library in loaded}
        depends = said("dpkg-deb", "-f", self.deb, "Depends")
        names = [re.match(r"[\w.+-]+", part.strip()).group() for part in depends.split(",")]
        self.assertEqual({provider_of(name) for name in names}, wanted)

    def test_it_writes_below_usr_and_has_nothing_to_undo(self):
        listed = [line.split()[-1] for line in said("dpkg-deb", "-c", self.deb).splitlines()]
        self.assertEqual([name for name in listed if not name.startswith("./usr/")], [])
        control = pathlib.Path(self.folder.name) / "control"
        said("dpkg-deb", "-e", self.deb, control)
        self.assertLessEqual({path.name for path in control.iterdir()}, {"control", "md5sums", "shlibs", "triggers"})

    def test_everything_is_there(self):
        for name in ("usr/lib/udev/rules.d/70-handwheel.rules", "usr/share/applications/handwheel.desktop",
                     "usr/share/icons/hicolor/scalable/apps/handwheel.svg", "usr/share/man/man1/handwheel.1.gz",
                     "usr/share/metainfo/org.handwheel.handwheel.metainfo.xml",
                     "usr/share/bash-completion/completions/handwheel", "usr/share/zsh/vendor-completions/_handwheel",
                     "usr/share/fish/vendor_completions.d/handwheel.fish", "usr/share/doc/handwheel/copyright",
                     "usr/share/doc/handwheel/changelog.gz", "usr/share/doc/handwheel/CHANGELOG.md.gz",
                     "usr/share/doc/handwheel/licenses/fonts-inter"):
            self.assertTrue((self.root / name).is_file(), name)
        for folder in ("manual", "examples"):
            there = {path.name for path in (self.share / "handwheel" / folder).iterdir()}
            self.assertEqual(there, {path.name for path in (SOURCE / "assets" / folder).iterdir()})

    def test_the_links_of_the_manual_lead_somewhere(self):
        for page in (self.share / "handwheel/manual").glob("*.md"):
            for target in re.findall(r"\]\(([^)#\s]+)", re.sub(r"```.*?```", "", page.read_text(), flags=re.DOTALL)):
                if "://" not in target:
                    self.assertTrue((page.parent / target).exists(), f"{page.name}: {target}")

    def test_the_manual_page_is_read_without_a_warning(self):
        if not shutil.which("man"):
            self.skipTest("man-db is not installed")
        page = self.share / "man/man1/handwheel.1.gz"
        shown = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", page], capture_output=True, text=True,
                               check=True, env={"PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8", "MANWIDTH": "100"})
        self.assertEqual(shown.stderr, "")
        for text in ("handwheel simulate FILE [options]", "--for-seconds", "vxm@emulator", "EXIT STATUS"):
            self.assertIn(text, shown.stdout.replace("\u2010", "-"))

    def test_desktop_entry_and_metadata_are_valid(self):
        for tool, *arguments in (("desktop-file-validate", self.share / "applications/handwheel.desktop"),
                                 ("appstreamcli", "validate", "--no-net",
                                  self.share / "metainfo/org.handwheel.handwheel.metainfo.xml")):
            if not shutil.which(tool):
                self.skipTest(f"{tool} is not installed")
            said(tool, *arguments)

    def completed(self, line):
        """What bash offers behind this line."""
        script = self.share / "bash-completion/completions/handwheel"
        return said("bash", "--norc", "-c", f'source "{script}"; COMP_LINE=$1; COMP_POINT=${{#1}}; _handwheel; '
                    'printf "%s\\n" "${COMPREPLY[@]}"', "bash", line, cwd=self.share / "handwheel/examples").split()

    def test_bash_completes_commands_options_and_what_stands_behind_them(self):
        self.assertEqual(self.completed("handwheel sim"), ["simulate"])
        self.assertEqual(self.completed("handwheel simulate --for-"), ["--for-seconds"])
        self.assertEqual(self.completed("handwheel simulate x.vxm --for vx"), ["vxm"])
        self.assertIn("pmx-4ex-sa", self.completed("handwheel check --for "))
        self.assertEqual(self.completed("handwheel emulate vxm --wire r"), ["real"])
        self.assertEqual(self.completed("handwheel convert pla"), ["plate.dxf"], "and not plate.prg")
        self.assertEqual(self.completed("handwheel simulate x --bench sl"), ["slide.toml"])
        self.assertEqual(self.completed("handwheel send vxm@em"), ["emulator"], "only what stands behind the @")
        self.assertEqual(self.completed("handwheel restore vxm@emulator sl"), ["slide.toml"])
        self.assertIn("link=debug", self.completed("handwheel --log link"))
        self.assertEqual(self.completed("handwheel emulate vxm --tcp "), [], "nobody knows which")

    def test_fish_completes_them_too(self):
        if not shutil.which("fish"):
            self.skipTest("fish is not installed")
        self.check_offers(lambda line: [offer.split("\t")[0] for offer in said(
            "fish", "--no-config", "-c", 'source "$argv[1]"; complete -C "$argv[2]"',
            self.share / "fish/vendor_completions.d/handwheel.fish", line,
            cwd=self.share / "handwheel/examples", env=self.shell_environment()).splitlines()])

    def test_zsh_completes_them_too(self):
        if not shutil.which("zsh"):
            self.skipTest("zsh is not installed")
        self.check_offers(self.offered_by_zsh)

    def shell_environment(self):
        return {"PATH": f"{self.program.parent}:/usr/bin:/bin", "HOME": self.folder.name, "TERM": "dumb",
                "LC_ALL": "C.UTF-8"}

    def check_offers(self, offers):
        for line, word, other in (("handwheel sim", "simulate", "run"),
                                  ("handwheel simulate x --for-", "--for-seconds", "--json"),
                                  ("handwheel simulate x.vxm --for ", "pmx-4ex-sa", "plate.dxf"),
                                  ("handwheel emulate vxm --wire r", "real", "off"),
                                  ("handwheel send vxm@em", "vxm@emulator", "vme58@emulator"),
                                  ("handwheel restore vxm@emulator ", "slide.toml", "vxm@emulator"),
                                  ("handwheel run pla", "places.lua", "simulate"),
                                  ("handwheel open --log driver.v", "driver.vxm=debug", "link=debug")):
            with self.subTest(line):
                offered = offers(line)
                self.assertIn(word, offered)
                self.assertNotIn(other, offered)
        self.assertEqual(offers("handwheel send vxm@emulator "), [], "a text is not to be guessed")

    def offered_by_zsh(self, line):
        """An interactive zsh completes the line on a pseudo-terminal; its compadd prints what is added."""
        setup = pathlib.Path(self.folder.name) / "setup.zsh"
        setup.write_text(f"""PROMPT=; RPROMPT=; fpath=({self.share}/zsh/vendor-completions $fpath)
autoload -Uz compinit && compinit -u -D
bindkey '^I' complete-word
compprefuncs=(begin_); begin_() {{ print -r -- $'\\n@begin' }}
comppostfuncs=(end_); end_() {{ print -r -- @end; exit }}
compadd() {{
  if [[ ${{@[1,(i)(-|--)]}} == *-(O|A|D)\\ * ]]; then builtin compadd "$@"; return; fi
  local -a hits; local word
  builtin compadd -A hits "$@"
  for word in $hits; do print -r -- "@offers $word"; done
  builtin compadd "$@"
}}
print @ready
""")
        child, terminal = pty.fork()
        if child == 0:
            os.chdir(self.share / "handwheel/examples")
            os.execvpe("zsh", ["zsh", "-f", "-i"], self.shell_environment())

        def read_until(mark):
            heard, end = b"", time.monotonic() + 60
            while mark not in heard:
                self.assertLess(time.monotonic(), end, heard)
                if select.select([terminal], [], [], 0.2)[0]:
                    heard += os.read(terminal, 65536)
            return heard.decode(errors="replace")

        try:
            os.write(terminal, f"source {setup}\n".encode())
            read_until(b"\n@ready")
            os.write(terminal, line.encode() + b"\t")
            return re.findall(r"@offers (\S+)", read_until(b"@end"))
        finally:
            os.close(terminal)
            os.waitpid(child, 0)

    def test_other_shells_understand_theirs(self):
        for shell, flag, name in (("zsh", "-n", "zsh/vendor-completions/_handwheel"),
                                  ("fish", "--no-execute", "fish/vendor_completions.d/handwheel.fish")):
            with self.subTest(shell):
                if not shutil.which(shell):
                    self.skipTest(f"{shell} is not installed")
                self.assertEqual(said(shell, flag, self.share / name), "")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
