#!/usr/bin/env bash
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
#
# Runs systems over sequences and makes the page that compares them: benchmark.sh --help
# Sets up and builds first, unless --binary=FILE names a program that is there.
set -euo pipefail
source=$(realpath "$(dirname "$0")/..")

"$source/scripts/setup.sh" --benchmark
if [[ " $*" != *" --binary="* && " $*" != *" --help"* && " $*" != *" --page"* ]]; then
  "$source/scripts/build.sh" release semantic_kiss
fi
# Snakemake and what draws are Debian's, so they are in Debian's Python.
exec /usr/bin/python3 "$source/scripts/benchmark/launch.py" "$@"
