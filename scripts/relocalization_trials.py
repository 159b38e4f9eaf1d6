#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Starts `semantic_kiss relocalize` at many scans of a drive and tells how often, how soon and how
well the drive's place in a map is found.

    scripts/relocalization_trials.py --map=lasting.pbstream --dataset=data --sequence=01 \\
        --map_ground_truth=data/sequences/00 --starts=100 --output=output/trials

Both drives need true poses in one world, as those of `semantic_kiss simulate` with one seed are.
"""

import argparse
import json
import os
import subprocess
import sys

WRONG_M = 2.0
WRONG_DEG = 5.0


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--binary", default="build/bin/semantic_kiss")
    parser.add_argument("--map", required=True)
    parser.add_argument("--dataset", required=True)
    parser.add_argument("--sequence", default="00")
    parser.add_argument("--map_ground_truth", required=True)
    parser.add_argument("--output", required=True)
    parser.add_argument("--starts", type=int, default=100)
    parser.add_argument("--num_scans", type=int, default=80, help="scans after each start")
    parser.add_argument("--seconds", type=float, default=5.0, help="what counts as found in time")
    parser.add_argument("--scan_rate", type=float, default=10.0, help="scans a second")
    parser.add_argument("--config", default="relocalize.lua")
    return parser.parse_args()


def run_trial(arguments, start):
    directory = os.path.join(arguments.output, f"{start:06d}")
    subprocess.run(
        [arguments.binary, "relocalize", f"--config={arguments.config}", f"--map={arguments.map}",
         f"--dataset={arguments.dataset}", f"--sequence={arguments.sequence}",
         f"--map_ground_truth={arguments.map_ground_truth}", f"--first_scan={start}",
         f"--num_scans={arguments.num_scans}", f"--output={directory}", "--quiet"], check=True)
    with open(os.path.join(directory, "relocalization.json")) as file:
        return json.load(file)


def quantile(values, share):
    return sorted(values)[int(share * (len(values) - 1))] if values else None


def figure(value, unit, digits=3):
    return "-" if value is None else f"{value:.{digits}f} {unit}"


def summarize(trials, arguments):
    fixes = [trial["first_fix_after_scans"] for trial in trials]
    soon = arguments.seconds * arguments.scan_rate
    localized = [pose for trial in trials for pose in trial["poses"] if pose["localized"]]
    wrong = [pose for pose in localized
             if pose["position_error_m"] > WRONG_M or pose["heading_error_deg"] > WRONG_DEG]
    return {
        "starts": len(trials),
        "found_in_time": sum(fix is not None and fix <= soon for fix in fixes),
        "found": sum(fix is not None for fix in fixes),
        "starts_with_a_wrong_place": sum(
            bool(trial["metrics"]["wrong_places"]) for trial in trials),
        "localized_scans": len(localized),
        "scans_in_a_wrong_place": len(wrong),
        "first_fix_median_s": quantile([fix / arguments.scan_rate
                                        for fix in fixes if fix is not None], 0.5),
        "first_fix_p95_s": quantile([fix / arguments.scan_rate
                                     for fix in fixes if fix is not None], 0.95),
        "position_median_m": quantile([pose["position_error_m"] for pose in localized], 0.5),
        "position_p95_m": quantile([pose["position_error_m"] for pose in localized], 0.95),
        "heading_median_deg": quantile([pose["heading_error_deg"] for pose in localized], 0.5),
        "heading_p95_deg": quantile([pose["heading_error_deg"] for pose in localized], 0.95),
    }


def main():
    arguments = parse_arguments()
    velodyne = os.path.join(arguments.dataset, "sequences", arguments.sequence, "velodyne")
    last = len(os.listdir(velodyne)) - arguments.num_scans
    if last < 0:
        sys.exit(f"{velodyne}: fewer scans than --num_scans={arguments.num_scans}")
    starts = [last * i // max(arguments.starts - 1, 1) for i in range(arguments.starts)]
    trials = []
    for start in starts:
        trials.append(run_trial(arguments, start))
        fix = trials[-1]["first_fix_after_scans"]
        print(f"scan {start}: {'not found' if fix is None else f'found after {fix} scans'}, "
              f"error {figure(trials[-1]['metrics']['position_error_median_m'], 'm')}", flush=True)
    summary = summarize(trials, arguments)
    with open(os.path.join(arguments.output, "trials.json"), "w") as file:
        json.dump(summary, file, indent=2)
    print(f"{summary['found_in_time']} of {summary['starts']} found within {arguments.seconds} s, "
          f"{summary['found']} at all, {summary['starts_with_a_wrong_place']} with a wrong place; "
          f"first fix {figure(summary['first_fix_median_s'], 's', 1)} median; position "
          f"{figure(summary['position_median_m'], 'm')} median, "
          f"{figure(summary['position_p95_m'], 'm')} at 95 %; heading "
          f"{figure(summary['heading_median_deg'], 'deg')} median, "
          f"{figure(summary['heading_p95_deg'], 'deg')} at 95 %")


if __name__ == "__main__":
    main()
