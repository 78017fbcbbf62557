#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing, builds the benchmarks, runs them in about two minutes once built and prints tables.
# Options: --csv FILE for every median; --plot FILE.svg for a picture; --into docs/performance.md to replace the
# tables there.
# CXX=clang++ chooses another compiler.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
source "$root/scripts/packages.sh"

build=$root/build/bench${CXX:+-$(basename "$CXX")}
install_packages "${tool_packages[@]}" "${bench_packages[@]}"
case " $* " in *" --plot "*) install_packages python3-matplotlib ;; esac
{
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DVCAVITY_BUILD_TESTS=OFF \
        -DVCAVITY_BUILD_EXAMPLES=OFF -DVCAVITY_BUILD_TRACER=ON -DVCAVITY_BUILD_BENCH=ON
  cmake --build "$build"
} >&2
exec python3 "$root/scripts/bench_report.py" --build "$build" "$@"
