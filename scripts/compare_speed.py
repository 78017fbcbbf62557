#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares what the symmetric groove of one bare material costs in this version and in that of a commit.

    scripts/compare_speed.py 58d3728
    scripts/compare_speed.py 58d3728 --into docs/performance.md
    CXX=clang++ scripts/compare_speed.py 58d3728

The same program, bench/symmetric_cost.cpp, is compiled with the headers of either and run in turn. Times and ratios are
medians over the rounds, so that a ratio is not one of quiet and busy minutes.
"""

import argparse
import os
import pathlib
import subprocess
import sys
import tarfile
import tempfile
from io import BytesIO
from statistics import median

ROOT = pathlib.Path(__file__).resolve().parent.parent
BEGIN = "<!-- printed by scripts/compare_speed.py: begin -->\n"
END = "<!-- printed by scripts/compare_speed.py: end -->\n"
COMPILER = os.environ.get("CXX", "g++")


def compiled(headers, program):
    """Compiled as a user would."""
    subprocess.run([COMPILER, "-std=c++20", "-O3", "-fno-math-errno", "-I", headers, ROOT / "bench/symmetric_cost.cpp",
                    "-o", program], check=True)
    return program


def nanoseconds(program):
    """Processor time by quantity, on one core."""
    core = sorted(os.sched_getaffinity(0))[:1]
    output = subprocess.run([program], check=True, text=True, stdout=subprocess.PIPE,
                            preexec_fn=lambda: os.sched_setaffinity(0, core)).stdout
    return {name: float(time) for name, time in (line.split("\t") for line in output.splitlines())}


def digits(value):
    return f"{value:.1f}" if value < 100 else f"{value:,.0f}"


def table(commit, rounds):
    version = subprocess.run([COMPILER, "-dumpfullversion", "-dumpversion"], check=True, text=True,
                             stdout=subprocess.PIPE).stdout.strip()
    lines = [f"{pathlib.Path(COMPILER).name} {version}, nanoseconds, medians of {len(rounds)} rounds.", "",
             f"| reflectance | {commit} | now | ratio |", "|---|---|---|---|"]
    for name in rounds[0][0]:
        before, now = (median(both[i][name] for both in rounds) for i in (0, 1))
        ratio = median(both[1][name] / both[0][name] for both in rounds)
        lines.append(f"| {name} | {digits(before)} | {digits(now)} | {ratio:.2f} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("commit", help="the commit to compare with")
    parser.add_argument("--rounds", type=int, default=9, help="how often both versions run (default 9)")
    parser.add_argument("--into", type=pathlib.Path, help="replace the table of this page instead of printing it")
    options = parser.parse_args()

    with tempfile.TemporaryDirectory() as folder:
        before = pathlib.Path(folder)
        archive = subprocess.run(["git", "-C", ROOT, "archive", options.commit, "include"], check=True,
                                 stdout=subprocess.PIPE).stdout
        with tarfile.open(fileobj=BytesIO(archive)) as tree:
            tree.extractall(before)
        programs = (compiled(before / "include", before / "before"), compiled(ROOT / "include", before / "now"))
        rounds = []
        for number in range(options.rounds):
            print(f"round {number + 1} of {options.rounds}", file=sys.stderr)
            rounds.append([nanoseconds(program) for program in programs])

    text = table(options.commit, rounds)
    if not options.into:
        print(text, end="")
        return
    page = options.into.read_text(encoding="utf-8")
    before, rest = page.split(BEGIN)
    options.into.write_text(before + BEGIN + "\n" + text + "\n" + END + rest.split(END)[1], encoding="utf-8")


if __name__ == "__main__":
    main()
