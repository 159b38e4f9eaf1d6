#!/usr/bin/env bash
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
#
# Sets up, builds and tests: unit tests, end-to-end tests, the installed package, static checks.
#   test.sh               the release build, as shipped
#   test.sh --sanitizers  afterwards also the unit tests under address + undefined behaviour
#                         sanitizers, and under the thread sanitizer
# The real excerpts that some tests read are looked for in $SEMANTIC_KISS_DATA, else ../shared/data
# beside the source tree; without them those tests are skipped and say so.
set -euo pipefail
if [[ -n "${SEMANTIC_KISS_DATA:-}" ]]; then
  SEMANTIC_KISS_DATA=$(realpath -m "$SEMANTIC_KISS_DATA")
  export SEMANTIC_KISS_DATA
fi
cd "$(dirname "$0")/.."

presets=(release)
for argument in "$@"; do
  case "$argument" in
    --sanitizers) presets+=(asan tsan) ;;
    *)
      echo "scripts/test.sh: unknown argument $argument (there is --sanitizers)" >&2
      exit 2
      ;;
  esac
done

scripts/setup.sh --test --benchmark --slurm
for preset in "${presets[@]}"; do
  scripts/build.sh "$preset"
  ctest --preset "$preset" --parallel "$(nproc)" --progress
done

data=${SEMANTIC_KISS_DATA:-../shared/data}
if [[ ! -d "$data" ]]; then
  echo "Skipped: the tests that read real scans, for there is no $data (see README.md)"
fi
