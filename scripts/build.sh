#!/usr/bin/env bash
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
#
# Sets up, configures and builds a preset: build.sh [PRESET [TARGET...]], by default all of "release"
# into build/. Says little unless something fails.
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
targets=("${@:2}")
build=(cmake --build --preset "$preset")
if [[ ${#targets[@]} != 0 ]]; then build+=(--target "${targets[@]}"); fi

scripts/setup.sh

log=$(mktemp)
trap 'rm -f "$log"' EXIT
if ! cmake --preset "$preset" >"$log" 2>&1; then
  cat "$log" >&2
  exit 1
fi

# Ninja's own progress line is for terminals; a log needs only what went wrong.
if [[ -t 1 ]]; then
  "${build[@]}"
elif ! "${build[@]}" >"$log" 2>&1; then
  cat "$log" >&2
  exit 1
fi
