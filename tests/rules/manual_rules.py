#!/usr/bin/env python3
"""Pages for readers: their links lead somewhere, their contents are complete, each call of a script is explained and shown,
and with the program as a second argument each of its commands and options is listed, and the examples do what they say.
manual_rules.py [ROOT [HANDWHEEL]]"""
import concurrent.futures
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
HANDWHEEL = pathlib.Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else None
MANUAL = ROOT / "assets/manual"
PAGES = [ROOT / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")] + sorted(MANUAL.glob("*.md"))
LINK = re.compile(r"\]\(([^)\s]+)\)")
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```", re.MULTILINE | re.DOTALL)
ENTRY = re.compile(r"^- \[(.+)\]\(#(.+)\)$", re.MULTILINE)
problems = []


def without_blocks(text):
    return BLOCK.sub("", text)


def headings(text, marks="#{1,6}"):
    return re.findall(rf"^{marks} (.+)$", without_blocks(text), re.MULTILINE)


def anchor(heading):
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def check_links(page, text):
    for target in LINK.findall(without_blocks(text)):
        if "://" in target:
            continue
        file, _, place = target.partition("#")
        there = (page.parent / file).resolve() if file else page
        if not there.exists():
            problems.append(f"{page}: {target} leads nowhere")
        elif place and place not in map(anchor, headings(there.read_text(encoding="utf-8"))):
            problems.append(f"{page}: {there.name} has no heading for #{place}")


def check_contents(page, text):
    parts = headings(text, "##")
    listed = ENTRY.findall(text.split("\n## ")[0])
    if parts and listed != [(part, anchor(part)) for part in parts]:
        problems.append(f"{page}: its contents are not its headings")


def code_of(text):
    """What stands between backticks, outside of blocks."""
    return re.findall(r"`([^`]+)`", without_blocks(text))


def calls_of_scripts():
    """The names that Lua sees, from the tables that bind them."""
    for file in [*sorted((ROOT / "core/script").glob("bind_*.cpp")), ROOT / "gui/app/bind_ui.cpp"]:
        source = file.read_text(encoding="utf-8")
        for table, functions in re.findall(r"Function (\w+)\[\] = \{(.*?)\};", source, re.DOTALL):
            if table != "news_table":  # of hw.on, in Lua
                yield from re.findall(r'\{"(\w+)",', functions)


def check_calls():
    text = (MANUAL / "scripts.md").read_text(encoding="utf-8")
    explained, shown = "\n".join(code_of(text)), "\n".join(block for language, block in BLOCK.findall(text) if language == "lua")
    calls = list(calls_of_scripts())
    if len(calls) < 80:
        problems.append("the tables of the calls of scripts were not found")
    for call in calls:
        if not re.search(rf"\b{call}[({{]", explained):
            problems.append(f"assets/manual/scripts.md: {call} is not explained")
        if not re.search(rf"\b{call}[({{]", shown):
            problems.append(f"assets/manual/scripts.md: no example calls {call}")


def check_options():
    """Each command stands in the page, and each of its options, as code."""
    page = MANUAL / "command-line.md"
    text = page.read_text(encoding="utf-8")
    code = " ".join(code_of(text))
    listed = subprocess.run([HANDWHEEL, "--help"], capture_output=True, text=True, timeout=60, check=True).stdout
    names = re.findall(r"^  (\w+)  ", listed.partition("Subcommands:")[2].partition("\n\n")[0], re.MULTILINE)
    if len(names) < 14:
        problems.append("the commands of --help were not found")
    for name in names:
        if not re.search(rf"(`|\bhandwheel ){name}\b", text):
            problems.append(f"{page}: the command {name} is not listed")
    for option in sorted(set().union(*map(options_of, [None, *names]))):
        if not re.search(rf"{option}(?![\w-])", code):
            problems.append(f"{page}: the option {option} is not listed")


def commands(text):
    for _, block in BLOCK.findall(text):
        yield from re.findall(r"^(build/handwheel [a-z].*)$", block, re.MULTILINE)
    yield from re.findall(r"`(build/handwheel [a-z][^`]*)`", re.sub(r"\s*\n\s*", " ", without_blocks(text)))


def options_of(command=None):
    """None: those that every command takes."""
    words = [command] if command else []
    run = subprocess.run([HANDWHEEL, *words, "--help"], capture_output=True, text=True, timeout=60, check=False)
    return set(re.findall(r"--[a-z-]+", run.stdout)) if run.returncode == 0 else None


def check_commands(page, text, known):
    if None not in known:
        known[None] = options_of()
    for line in commands(text):
        words = shlex.split(re.split(r"\s{2,}", line)[0])
        command = words[1]
        if command not in known:
            known[command] = options_of(command)
        if known[command] is None:
            problems.append(f"{page}: there is no command {command}: {line}")
            continue
        for word in words[2:]:
            if word.startswith("--") and word not in known[command] | known[None]:
                problems.append(f"{page}: {command} takes no {word}: {line}")


def example(page, language, block):
    """The command that tries it; none: it is no example of that kind."""
    if language == "lua":
        return "x.lua", ["run", "--gui", "x.lua"]
    if language == "toml" and "handwheel_sequence" in block:
        return "x.toml", ["check", "x.toml", "--for", "pmx-4ex-sa"]
    if language == "toml":
        return "x.toml", ["simulate", "empty.vxm", "--for", "vxm", "--bench", "x.toml"]
    return None


def try_example(page, number, block, file, words):
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / file).write_text(block, encoding="utf-8")
        (pathlib.Path(folder) / "empty.vxm").write_text("P1\n", encoding="utf-8")
        run = subprocess.run([HANDWHEEL, *words], cwd=folder, capture_output=True, text=True, timeout=120, check=False)
    if run.returncode != 0:
        problems.append(f"{page}: example {number} fails: {run.stderr.strip() or run.stdout.strip()}")


def main():
    linked = set()
    known = {}
    check_calls()
    if HANDWHEEL:
        check_options()
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for page in PAGES:
            text = page.read_text(encoding="utf-8")
            check_links(page, text)
            linked.update((page.parent / target.partition("#")[0]).resolve() for target in LINK.findall(text))
            if page.name not in ("README.md", "CHANGELOG.md"):
                check_contents(page, text)
            if not HANDWHEEL:
                continue
            check_commands(page, text, known)
            for number, (language, block) in enumerate(BLOCK.findall(text), 1):
                if tried := example(page, language, block):
                    pool.submit(try_example, page, number, block, *tried)
    problems.extend(f"{page}: no other page leads here" for page in PAGES if page not in linked and page.name != "README.md")
    for problem in problems:
        print(problem.replace(f"{ROOT}/", ""))
    return 1 if problems else 0


sys.exit(main())
