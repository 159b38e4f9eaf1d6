#!/usr/bin/env bash
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
#
# microbenchmark.sh [FLAGS OF GOOGLE BENCHMARK]
#
# Builds and runs the benchmarks of test/benchmark, on the real scans of ../shared/data (or
# $SEMANTIC_KISS_DATA) where they are there. A quiet machine is needed for figures that mean
# something.
set -euo pipefail
cd "$(dirname "$0")/.."

cmake --preset release -D SEMANTIC_KISS_BENCHMARKS=ON >/dev/null
cmake --build --preset release --target benchmarks
for source in test/benchmark/*_benchmark.cc; do
  SEMANTIC_KISS_SOURCE_DIR=$PWD build/bin/"$(basename "$source" .cc)" "$@"
done
