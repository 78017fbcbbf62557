# SPDX-License-Identifier: BSD-3-Clause
# To be sourced: install_packages NAME... installs the Debian packages that are missing, and asks for root only then.

install_packages() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "This is not Debian; please see to it yourself that these are installed: $*" >&2
    return 0
  fi
  local package missing=()
  for package in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0

  echo "Installing ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "Root or sudo is needed to install: ${missing[*]}" >&2; return 1; }
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends "${missing[@]}" >/dev/null
}

# What vcavity_maps is built with, and what the tests need on top.
tool_packages=(g++ cmake ninja-build pkgconf libglm-dev libopenexr-dev libcairo2-dev libyaml-cpp-dev libcli11-dev
               nlohmann-json3-dev libtbb-dev fonts-dejavu-core)
test_packages=(catch2 libboost-dev libembree-dev openexr)
# What the benchmarks are built and run with on top of the tools.
bench_packages=(libbenchmark-dev libembree-dev python3)
