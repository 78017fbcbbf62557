#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Puts the faults of scripts/mutants.txt into the code, one at a time, and prints which of them the tests notice. Each
# needs a build of one file of tests: half an hour for all of them. Usage: scripts/mutate.sh [BUILD-FOLDER] [NAME...]; the
# folder is made if it is not yet there (default build/mutate), names pick some of the mutants. Exit status 1 if one
# survives or does not apply any more.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build=${1:-$root/build/mutate}
shift || true

copy= mutated=
restore() {
  [ -n "$copy" ] && cp "$copy" "$mutated" && rm -f "$copy"
  copy=
}
trap restore EXIT
trap 'exit 130' INT TERM

[ -f "$build/CMakeCache.txt" ] ||
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS=-O1 >/dev/null

trim() { sed 's/^ *//; s/ *$//' <<<"$1"; }

killed=0 survived=0 stale=0
while IFS='|' read -r name file expression place tests; do
  name=$(trim "$name") file=$(trim "$file") expression=$(trim "$expression")
  place=$(trim "$place") tests=$(trim "$tests")
  target=${place%/*}
  case $name in '' | \#*) continue ;; esac
  if [ $# -gt 0 ] && [[ " $* " != *" $name "* ]]; then continue; fi
  mutated=$root/$file
  copy=$(mktemp)
  cp "$mutated" "$copy"
  sed -i "$expression" "$mutated"
  if cmp -s "$copy" "$mutated"; then
    verdict="does not apply" stale=$((stale + 1))
  elif ! { cmake "$build" -DVCAVITY_TEST_FILES="${place#*/}" >/dev/null &&
           cmake --build "$build" --target "$target"; } >"$build/mutant.log" 2>&1; then
    verdict="killed (does not compile)" killed=$((killed + 1))
  elif program=$(find "$build/tests" -type f -name "$target" -perm -u+x | head -n 1)
       "$program" --list-tests "$tests" | grep -q '^0 matching'; then
    verdict="has no such test" stale=$((stale + 1))
  elif "$program" "$tests" >>"$build/mutant.log" 2>&1; then
    verdict=SURVIVED survived=$((survived + 1))
  else
    verdict=killed killed=$((killed + 1))
  fi
  restore
  printf '%-28s %s\n' "$name" "$verdict"
done < <(grep -v '^#' "$root/scripts/mutants.txt")

echo "$killed killed, $survived survived, $stale do not apply"
[ $survived -eq 0 ] && [ $stale -eq 0 ]
