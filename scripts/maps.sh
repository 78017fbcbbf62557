#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing, builds vcavity_maps and makes the paper's figures and tables.
# Options are passed on to 'vcavity_maps paper', such as --out DIR and --size N.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
source "$root/scripts/packages.sh"

install_packages "${tool_packages[@]}"
cmake -S "$root" -B "$root/build/maps" -G Ninja -DCMAKE_BUILD_TYPE=Release -DVCAVITY_BUILD_TESTS=OFF >/dev/null
cmake --build "$root/build/maps"
"$root/build/maps/bin/vcavity_maps" paper "$@"
echo "The program is $root/build/maps/bin/vcavity_maps; try it with --help."
