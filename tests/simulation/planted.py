#!/usr/bin/env python3
"""Shows that the judge bites: small faults are planted in the production code, one at a time, in a scratch
worktree, and the search has to find each of them. By hand; it takes about an hour.

    planted.py [--check] [--soon] [FAULT...]
        --check: only whether each of them still applies; --soon: 2,000 sessions of each model at most
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from planted_faults import FAULTS

ROOT = Path(__file__).resolve().parents[2]
SCRATCH = ROOT / "build-planted"
SOON, AT_MOST = 2000, 20000  # sessions of a simulated minute


def find_function(root, folder, signature):
    """Its file, and where its body begins and ends there. A fault that no longer applies fails."""
    found = []
    for path in sorted((root / "core" / folder).rglob("*.[ch]*")):
        text = path.read_text()
        for match in re.finditer(re.escape(signature), text):
            begin = text.find("{", match.end())
            semicolon = text.find(";", match.end())
            if begin < 0 or 0 <= semicolon < begin:
                continue  # a declaration, or a call
            depth, end = 0, begin
            while end == begin or depth:
                depth += {"{": 1, "}": -1}.get(text[end], 0)
                end += 1
            found.append((path, begin, end))
    if len(found) != 1:
        sys.exit(f"core/{folder}: {len(found)} functions are called {signature})")
    return found[0]


def plant(fault, root):
    for folder, signature, old, new in fault["edits"]:
        path, begin, end = find_function(root, folder, signature)
        text = path.read_text()
        body = text[begin:end]
        if old == "{":  # at its beginning
            body = "{ " + new + body[1:]
        elif body.count(old) != 1:
            sys.exit(f"{fault['name']}: {body.count(old)} times in {signature}: {old}")
        else:
            body = body.replace(old, new)
        path.write_text(text[:begin] + body + text[end:])


def check(faults):
    """On a copy of the sources: neither a worktree nor a compiler is needed."""
    for fault in faults:
        with tempfile.TemporaryDirectory() as copy:
            for folder in {edit[0] for edit in fault["edits"]}:
                shutil.copytree(ROOT / "core" / folder, Path(copy) / "core" / folder)
            plant(fault, Path(copy))
    print(f"{len(faults)} faults apply.")


def restore():
    subprocess.run(["git", "checkout", "-q", "--", "core"], cwd=SCRATCH, check=True)


def prepare():
    if not SCRATCH.exists():
        subprocess.run(["git", "worktree", "add", "-q", "--detach", str(SCRATCH)], cwd=ROOT, check=True)
    head = subprocess.run(["git", "rev-parse", "HEAD"], cwd=ROOT, check=True, capture_output=True, text=True)
    restore()
    subprocess.run(["git", "checkout", "-q", "--detach", head.stdout.strip()], cwd=SCRATCH, check=True)


def build():
    """hw_simulation of the scratch worktree, built; the fault's own compiler warnings do not matter."""
    if not (SCRATCH / "build" / "build.ninja").exists():
        subprocess.run(["cmake", "--preset", "release", "-DHW_TESTS=ON", "-DCMAKE_CXX_FLAGS=-Wno-error"],
                       cwd=SCRATCH, check=True, stdout=subprocess.DEVNULL)
    run = subprocess.run(["ninja", "-C", "build", "hw_simulation"], cwd=SCRATCH, capture_output=True, text=True)
    if run.returncode:
        sys.exit(run.stdout[-3000:])
    return SCRATCH / "build" / "tests" / "simulation" / "hw_simulation"


def play(binary, model, seed, seeds, until_failure):
    words = model.split()
    command = [str(binary), "--model", *words, "--no-shrink", "--seed", str(seed)]
    command += ["--until-failure"] if until_failure else []
    run = subprocess.run([*command, "--seeds", str(seeds)], capture_output=True, text=True)
    if run.returncode not in (0, 1):
        return seed, "it spins" if run.returncode == 3 else "it crashed"
    found = re.search(r"^\S+ seed (\d+)\n  (.*)", run.stdout, re.M)
    return (int(found[1]), found[2]) if found else None


def search(binary, honest, model, first, last):
    """How many sessions it takes to find something that the honest build does not do, and what."""
    seed = first
    while seed <= last:
        found = play(binary, model, seed, last - seed + 1, True)
        if not found:
            return None
        if not play(honest, model, found[0], 1, False):
            return found
        seed = found[0] + 1
    return None


def search_models(name, binary, honest, models, at_most):
    """The first sessions of all models come before the later ones of any."""
    stretches = [(1, SOON)] + ([(SOON + 1, at_most)] if at_most > SOON else [])
    searches = (search(binary, honest, model, *stretch) for stretch in stretches for model in models)
    found = next(filter(None, searches), None)
    binary.unlink()
    print(f"{name:36} " + (f"{found[0]:6} sessions: {found[1]}" if found else "NOT FOUND"), flush=True)
    return found


def keep(binary, name):
    kept = SCRATCH / "build" / name
    kept.write_bytes(binary.read_bytes())
    kept.chmod(0o755)
    return kept


def main(words):
    only_check = "--check" in words
    at_most = SOON if "--soon" in words else AT_MOST
    names = [word for word in words if not word.startswith("--")]
    faults = [fault for fault in FAULTS if not names or fault["name"] in names]
    check(faults)
    if only_check:
        return
    prepare()
    honest = keep(build(), "honest")
    soon = late = 0
    with ThreadPoolExecutor(max_workers=os.cpu_count()) as players:
        played = []
        for number, fault in enumerate(faults):  # the next is built while those before are played
            plant(fault, SCRATCH)
            binary = keep(build(), f"planted-{number}")
            restore()
            played.append(players.submit(search_models, fault["name"], binary, honest, fault["models"], at_most))
        for result in played:
            found = result.result()
            soon += bool(found and found[0] <= SOON)
            late += bool(found and found[0] > SOON)
    print(f"{soon} of {len(faults)} found within {SOON} sessions, {late} more within {AT_MOST}.")
    sys.exit(soon + late != len(faults))


if __name__ == "__main__":
    main(sys.argv[1:])
