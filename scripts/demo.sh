#!/usr/bin/env bash
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
#
# Sets up, builds, drives and says which pictures to look at: demo.sh [OUTPUT], by default
# output/demo. Drives through the labeled scans in $SEMANTIC_KISS_DATA/semantickitti, else in
# ../shared/data/semantickitti beside the source tree; if there are none, round the blocks of a
# simulated town.
set -euo pipefail
source=$(realpath "$(dirname "$0")/..")
output=$(realpath -m "${1:-$source/output/demo}")
dataset=$(realpath -m "${SEMANTIC_KISS_DATA:-$source/../shared/data}/semantickitti")
cd "$source"

scripts/build.sh release semantic_kiss
semantic_kiss=build/bin/semantic_kiss

run_flags=()
if [[ -d "$dataset/sequences/00/velodyne" ]]; then
  echo "Driving through the scans in $dataset"
  # On some stretches KITTI's own ground truth is worse than what it is to judge.
  better_truth=$dataset/sequences/00/poses_semantickitti.txt
  if [[ -f "$better_truth" ]]; then run_flags+=(--ground_truth="$better_truth"); fi
else
  echo "There are no scans in $dataset: simulating some"
  dataset=$output/simulated
  "$semantic_kiss" simulate --route=city --length=800 --lidar=hdl64 --output="$dataset"
fi

"$semantic_kiss" run --config=semantic_kiss_6dof.lua --dataset="$dataset" --sequence=00 \
  --output="$output" "${run_flags[@]}"

cat <<MESSAGE

Look at
  $output/map.png       what was driven through, in the colours of its classes
  $output/report.html   the same with all figures, in a browser
MESSAGE
