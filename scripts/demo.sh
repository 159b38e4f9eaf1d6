#!/usr/bin/env bash
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
#
# Sets up, builds and drives: demo.sh [OUTPUT], by default output/demo.
# Runs semantic KISS-ICP over labeled scans in SemanticKITTI's format and says which pictures to
# look at. The scans are looked for in $SEMANTIC_KISS_DATA/semantickitti, else in
# ../shared/data/semantickitti beside the source tree.
set -euo pipefail
source=$(realpath "$(dirname "$0")/..")
output=$(realpath -m "${1:-$source/output/demo}")
dataset=$(realpath -m "${SEMANTIC_KISS_DATA:-$source/../shared/data}/semantickitti")
cd "$source"

if [[ ! -d "$dataset/sequences/00/velodyne" ]]; then
  cat >&2 <<MESSAGE
scripts/demo.sh: there are no scans in $dataset/sequences/00/velodyne.
The demo drives through labeled scans in SemanticKITTI's format:
  sequences/00/velodyne/000000.bin   float32 x, y, z, remission per point
  sequences/00/labels/000000.label   uint32 per point
  sequences/00/{calib,times}.txt     as KITTI gives them
Set SEMANTIC_KISS_DATA to the folder that holds semantickitti/ and run this again.
MESSAGE
  exit 1
fi

scripts/build.sh release

build/bin/semantic_kiss run --config=semantic_kiss.lua --dataset="$dataset" --sequence=00 \
  --output="$output"

cat <<MESSAGE

Look at
  $output/map.png              what was driven through, in the colours of its classes
  $output/run.json             the figures: speed, memory, accuracy
  $output/trajectory_tum.txt   the trajectory
MESSAGE
