#!/usr/bin/env python3
"""Every lie of a driver is noticed by the contract suite, on every controller on which it can be told.

    lies.py CONTRACT_TESTS [LIE [MODEL]]
    lies.py CONTRACT_TESTS --remember    writes into noticed.txt which test has noticed which lie

That test is asked first the next time, which saves most of the time. What it says there proves nothing: where it is content
now, or gone, the whole suite is asked as ever. A lie that stands there and can no longer be told is an error too, and so is
one that does not stand there: the list is what the suite has been shown to notice, and shrinks only by hand.
"""
import os
import pathlib
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

# Lie and model: why no contract test can notice it.
UNNOTICED = {}
MOST_UNNOTICED = 2  # of a model

# What finds most of them soonest, then the rest of the suite. The bus is opened without lies.
SUITES = ["*Truth*/{0}", "*/TextTest.*/{0}:*/ForeignTest.*/{0}:*/ProgramStopTest.*/{0}",
          "*/ContractTest.*/{0}:*/TrustContract.*/{0}:-*ForAnHour*"]


REMEMBERED = pathlib.Path(__file__).with_name("noticed.txt")


def remembered():
    """Lie and model: the test that has noticed it."""
    lines = REMEMBERED.read_text(encoding="utf-8").splitlines() if REMEMBERED.exists() else []
    return {(lie, model): test for lie, model, test in map(str.split, lines)}


def failed_test(binary, lie, model, suites):
    """The first test of these suites that fails under this lie; None: all are content."""
    for suite in suites:
        run = subprocess.run(
            [binary, f"--lie={lie}", "--gtest_fail_fast", "--gtest_brief=1",
             "--gtest_filter=" + suite.format(model.replace("-", "_"))],
            capture_output=True, text=True, timeout=120)
        failed = [line.split()[3].rstrip(",") for line in run.stdout.splitlines()
                  if line.startswith("[  FAILED  ] ") and "/" in line]
        if run.returncode not in (0, 1) or bool(failed) != bool(run.returncode):
            sys.exit(f"{lie} on {model}: no verdict, exit status {run.returncode}\n{run.stdout}{run.stderr}")
        if failed:
            return failed[0]
    return None


def main(binary, only_lie=None, only_model=None):
    remember = only_lie == "--remember"
    if remember:
        only_lie = None
    known = {} if remember else remembered()
    listed = subprocess.run([binary, "--lies"], capture_output=True, text=True, check=True).stdout
    lies = [(lie, model) for lie, *models in map(str.split, listed.splitlines()) for model in models
            if only_lie in (None, lie) and only_model in (None, model)]
    models = sorted({model for _, model in lies})
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        by = list(pool.map(lambda told: failed_test(binary, *told, [*known.get(told, "").split(), *SUITES]), lies))
        # What has noticed a lie is content without one. The rest of the suite is run by itself, with all models.
        witnesses = {model: sorted({test for (_, m), test in zip(lies, by) if test and m == model}) for model in models}
        content = list(pool.map(lambda model: failed_test(binary, "honest", model, [":".join(witnesses[model])]), models))
    if remember:
        REMEMBERED.write_text("".join(f"{lie} {model} {test}\n" for (lie, model), test in zip(lies, by) if test),
                              encoding="utf-8")
    wrong = [f"{model}: {test} fails without any lie" for model, test in zip(models, content) if test]
    if not remember and not (only_lie or only_model):
        wrong += [f"{lie} on {model}: was noticed once, and can no longer be told" for lie, model in known.keys() - set(lies)]
        wrong += [f"{lie} on {model}: does not stand in {REMEMBERED.name}: --remember" for lie, model in set(lies) - known.keys()
                  if (lie, model) not in UNNOTICED]
    for (lie, model), test in zip(lies, by):
        print(f"{lie:32} {model:12} {test or 'NOT NOTICED'}")
        if (test is None) != ((lie, model) in UNNOTICED):
            wrong.append(f"{lie} on {model}: " + ("not noticed" if test is None else "noticed, and excused"))
    for model in models:
        told = [test for (_, m), test in zip(lies, by) if m == model]
        print(f"{model}: {len(told) - told.count(None)} of {len(told)} lies noticed")
        if told.count(None) > MOST_UNNOTICED:
            wrong.append(f"{model}: more than {MOST_UNNOTICED} lies are not noticed")
    sys.exit("\n".join(wrong) or 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
