#!/usr/bin/env python3
"""Keeps the arrows of the house: which folder may include which, who may name a device, and who writes to a shell."""
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
FORBIDDEN_FOLDERS = {
    "core": ("gui/", "panels/", "transports/"),
    "transports": ("gui/", "panels/"),
    "gui": ("panels/", "transports/"),
    "panels": ("transports/",),
}
CORE_ORDER = ["base", "time", "motion", "sequence", "drawing", "link", "device", "emulation", "devices", "session", "script"]
GUI_ORDER = ["model", "input", "surface", "widgets", "shell", "app"]
EMULATOR_USERS = ("core/session/track_together.cpp", "core/script/bind_bench.cpp", "gui/app/cmd_simulate.cpp")
MAKERS = ["velmex"]  # those that no folder is named after
FAMILIES = [d.name.split("_")[0] for d in (ROOT / "core/devices").iterdir() if d.is_dir()]
DEVICE_NAME = re.compile(rf"\b({'|'.join(MAKERS + FAMILIES)})", re.IGNORECASE)
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)
OUTPUT = re.compile(r"\bfmt::print\(|\bstd::(cout|cerr|printf|puts)\b|\b(stdout|stderr)\b")
WORDS = re.compile(r'"(\\.|[^"\\])*"')
problems = []


def knows_emulators(parts, stem):
    """Emulators and rehearsals, those who serve them, and the bench in scripts and on the command line."""
    if parts[:2] == ["core", "devices"]:
        return stem.startswith(("emulator", "program"))
    return parts[:2] == ["core", "emulation"] or parts[0] == "transports" or "/".join(parts) in EMULATOR_USERS


def check(path):
    name = path.relative_to(ROOT).as_posix()
    parts = name.split("/")
    text = path.read_text(encoding="utf-8")
    top, stem = parts[0], path.stem
    app = name.startswith("gui/app/")
    for header in INCLUDE.findall(text):
        say = lambda why: problems.append(f"{name}: includes {header}: {why}")
        if not app:
            for folder in FORBIDDEN_FOLDERS[top]:
                if header.startswith(folder):
                    say(f"{top} may not know {folder}")
        if header.startswith("boost/asio") and not name.startswith("core/base/asio.") and top != "transports":
            say("Boost.Asio comes through core/base/asio.h")
        if ("imgui" in header or "GLFW" in header) and top in ("core", "transports"):
            say("no window below the gui")
        if top == "core" and header.startswith("core/"):
            here, there = parts[1], header.split("/")[1]
            if here in CORE_ORDER and there in CORE_ORDER and CORE_ORDER.index(there) > CORE_ORDER.index(here):
                say("core: base <- time <- motion <- sequence <- drawing <- link <- device <- emulation <- devices <- session <- script")
        if top == "gui" and header.startswith("gui/"):
            here, there = parts[1], header.split("/")[1]
            if GUI_ORDER.index(there) > GUI_ORDER.index(here):
                say("gui: model <- input <- surface <- widgets <- shell <- app")
        if name.startswith("gui/model/") and ("imgui" in header or "GLFW" in header):
            say("the model has no window")
        if header.startswith("core/emulation/") and not knows_emulators(parts, stem):
            say("the console's side knows no emulator")
        if name.startswith("core/devices/") and header.startswith("core/devices/"):
            mine, other = parts[2], header.split("/")[2]
            if mine != other and "." not in mine and other != "arcus":
                say("a device knows no other device")
            told = header.rsplit("/", 1)[1]
            controller_side = ("emulator", "program", "report")
            host_side = ("driver", "codec", "conversation", "signals", "parameters", "slots", "identification", "reply_kinds")
            if stem.startswith(controller_side) and told.startswith(host_side):
                say("emulator and driver share facts.h only")
            if stem.startswith(host_side) and told.startswith(("emulator", "report")):
                say("emulator and driver share facts.h only")
        if header in ("core/base/asio.h", "core/time/scheduler.h") and (
            parts[1] == "motion" or (top == "core" and stem.startswith(("emulator", "codec", "program", "report")))
        ):
            say("motion, codec and emulator are pure")
    for number, line in enumerate(text.splitlines(), 1):
        if stem != "output" and OUTPUT.search(WORDS.sub("", line).split("//")[0]):
            problems.append(f"{name}:{number}: writes by itself; gui/app/output.h notices what is lost")
    if top in ("panels", "gui") and not app:
        for number, line in enumerate(text.splitlines(), 1):
            if DEVICE_NAME.search(line):
                problems.append(f"{name}:{number}: names a device; ask the catalog")


for folder in FORBIDDEN_FOLDERS:
    for suffix in ("*.h", "*.cpp"):
        for file in sorted((ROOT / folder).rglob(suffix)):
            check(file)
print("\n".join(problems) or "include rules: all arrows point the right way")
sys.exit(bool(problems))
