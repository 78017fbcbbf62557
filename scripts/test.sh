#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing, builds everything and runs the tests. Arguments are passed on to ctest.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
source "$root/scripts/packages.sh"

install_packages "${tool_packages[@]}" "${test_packages[@]}"
cmake -S "$root" -B "$root/build/test" -G Ninja -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$root/build/test"
ctest --test-dir "$root/build/test" --output-on-failure --no-tests=error --parallel "$(nproc)" "$@"
