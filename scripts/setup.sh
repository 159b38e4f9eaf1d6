#!/usr/bin/env bash
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
#
# Installs what Semantic KISS is built with, from Debian 12's own packages. Prints nothing and
# touches nothing if all of it is there. Needs root or sudo only if something is missing.
#   setup.sh              what building and testing need
#   setup.sh --test       besides, the browser in which a test looks at reports, and zsh, in which one
#                         completes commands; without them these tests are skipped
#   setup.sh --benchmark  besides, what scripts/benchmark.sh needs
#   setup.sh --slurm      besides, a Slurm for this machine, with which a test tries the benchmark on a
#                         cluster; without it that test is skipped
set -euo pipefail

# README.md says what each package is for; keep both lists alike.
packages=(
  ccache
  clang-format
  cmake
  fonts-dejavu-core
  g++
  groff-base
  libabsl-dev
  libbenchmark-dev
  libcairo2-dev
  libceres-dev
  libcpp-httplib-dev
  libdeflate-dev
  libeigen3-dev
  libgflags-dev
  libgmock-dev
  libgoogle-glog-dev
  libgtest-dev
  libjs-leaflet
  liblua5.3-dev
  libprotobuf-dev
  libtbb-dev
  nettle-dev
  ninja-build
  nlohmann-json3-dev
  pkg-config
  protobuf-compiler
  python3
  python3-numpy
  zlib1g-dev
)

for argument in "$@"; do
  case "$argument" in
    --test) packages+=(chromium chromium-driver zsh) ;;
    --benchmark) packages+=(python3-matplotlib snakemake) ;;
    --slurm) packages+=(munge slurm-client slurmctld slurmd) ;;
    *)
      echo "scripts/setup.sh: unknown argument $argument (there are --test, --benchmark and" \
        "--slurm)" >&2
      exit 2
      ;;
  esac
done

if ! command -v dpkg-query >/dev/null; then
  echo "scripts/setup.sh: this system has no dpkg. Semantic KISS is built on Debian 12; elsewhere" \
    "install the equivalents of: ${packages[*]}" >&2
  exit 1
fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  if [[ "$status" != installed ]]; then missing+=("$package"); fi
done
if [[ ${#missing[@]} == 0 ]]; then exit 0; fi

as_root=()
if [[ $EUID != 0 ]]; then
  if ! command -v sudo >/dev/null; then
    echo "scripts/setup.sh: run it as root, or install sudo: missing are ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

echo "Installing ${missing[*]}"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
run() {
  if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive "$@" >"$log" 2>&1 </dev/null; then
    cat "$log" >&2
    echo "scripts/setup.sh: failed: $*" >&2
    exit 1
  fi
}
run apt-get -q update
run apt-get -q install -y --no-install-recommends "${missing[@]}"
