#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Lets the compiler of a configured build folder look at every file of this project, without making code.

    cmake --preset clang -G Ninja && ./scripts/compiler_warnings.py build/clang

Exits with 1 if any file has a warning that the flags make an error.
"""

import json
import os
import pathlib
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor


def checked(command):
    words = shlex.split(command["command"])
    output = words.index("-o")
    del words[output:output + 2]
    done = subprocess.run(words + ["-fsyntax-only"], cwd=command["directory"], capture_output=True, text=True)
    sys.stderr.write(done.stderr)
    return done.returncode == 0


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: compiler_warnings.py BUILD_FOLDER")
    commands = json.loads((pathlib.Path(sys.argv[1]) / "compile_commands.json").read_text(encoding="utf-8"))
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        good = list(pool.map(checked, commands))
    print(f"{good.count(True)} of {len(good)} files without a warning")
    sys.exit(0 if all(good) and good else 1)


if __name__ == "__main__":
    main()
