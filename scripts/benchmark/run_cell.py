# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Runs one cell and records it: run_cell.py --binary=B --sequence_folder=D --output=O -- FLAGS

FLAGS are those of `semantic_kiss run`, in which DATASET and OUTPUT stand for the folders. Besides
what the program writes, O then holds
  cell.json        the program's figures, how much processor time and memory it took, its version,
                   the hash of the resolved configuration; written last, so a cell that has it is
                   whole
  truth_kitti.txt  the true poses of the scans that were used, if there are any
"""

import argparse
import hashlib
import json
import os
import re
import resource
import shutil
import subprocess
import sys
import time

LARGE_FILES = ("map.pbstream", "report.html", "trajectory_tum.txt")
TRUTH_NOTE = "ground truth from "


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--binary", required=True)
    parser.add_argument("--sequence_folder", required=True, help="DATASET/sequences/NN")
    parser.add_argument("--output", required=True)
    parser.add_argument("--threads", default="1")
    parser.add_argument("--keep_maps", default="False", choices=["True", "False"])
    parser.add_argument("--drive_flags", default="", help="what the drive was simulated with")
    parser.add_argument("flags", nargs="+")
    return parser.parse_args()


def sha256(content):
    return hashlib.sha256(content).hexdigest()


def read(path):
    with open(path, "rb") as file:
        return file.read()


def resolve_config(flag):
    """A configuration in this folder gets its path; others are the program's to find."""
    beside = os.path.join(os.path.dirname(os.path.abspath(__file__)), flag)
    return beside if os.path.exists(beside) else flag


def resolve(flag, dataset, output):
    """FLAGS are written for every machine; this is the flag for this one."""
    name, _, value = flag.partition("=")
    if name == "--config":
        value = resolve_config(value)
    return {"--dataset": f"--dataset={dataset}", "--output": f"--output={output}",
            "--config": f"--config={value}"}.get(name, flag)


def first_scan(flags):
    values = [flag.partition("=")[2] for flag in flags if flag.startswith("--first_scan=")]
    return int(values[0]) if values else 0


def copy_truth(run, first, output):
    """The true poses of the scans that were used; False if the sequence has none."""
    notes = [note[len(TRUTH_NOTE):] for note in run["notes"] if note.startswith(TRUTH_NOTE)]
    if not notes:
        return False
    rows = read(notes[0]).decode().splitlines()[first:first + run["scans"]]
    with open(os.path.join(output, "truth_kitti.txt"), "w", encoding="utf-8") as file:
        file.write("".join(row + "\n" for row in rows))
    return True


def odometry_metrics(binary, output):
    """The errors of the drive as the odometry saw it, before loops were closed."""
    text = subprocess.run(
        [binary, "evaluate", f"--ground_truth={output}/truth_kitti.txt",
         f"--estimate={output}/odometry_kitti.txt", "--json"],
        check=True, capture_output=True, text=True).stdout
    return json.loads(text)


def record(arguments, run, cpu_s, wall_s):
    """What the page needs of a cell, and what says how it came about."""
    stages = {name: stage["median_ms"] for name, stage in run["stages"].items()}
    has_truth = copy_truth(run, first_scan(arguments.flags), arguments.output)
    return {
        "flags": arguments.flags,
        "drive_flags": arguments.drive_flags.split(),
        "version": run["version"],
        "binary_sha256": sha256(read(arguments.binary)),
        "config_sha256": sha256(run["config"].encode()),
        "threads": int(arguments.threads),
        "scans": run["scans"],
        "scans_available": run["scans_available"],
        "metrics": run["metrics"],
        "odometry_metrics":
            odometry_metrics(arguments.binary, arguments.output) if has_truth else None,
        "closures": len(run["loop_closures"]),
        "false_closures": run["closure_search"]["false"],
        "stage_median_ms": stages,
        "peak_memory_mib": run["peak_memory_mib"],
        "cpu_s": round(cpu_s, 2),
        "wall_s": round(wall_s, 2),
    }


def main():
    arguments = parse_arguments()
    dataset = re.sub(r"/sequences/[^/]+/?$", "", os.path.abspath(arguments.sequence_folder))
    flags = [resolve(flag, dataset, arguments.output) for flag in arguments.flags]
    began = time.monotonic()
    status = subprocess.run([arguments.binary, *flags, f"--threads={arguments.threads}", "--quiet"],
                            check=False).returncode
    if status:
        return status
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(os.path.join(arguments.output, "run.json"), encoding="utf-8") as file:
        run = json.load(file)
    result = record(arguments, run, used.ru_utime + used.ru_stime, time.monotonic() - began)
    if arguments.keep_maps == "False":
        for name in LARGE_FILES:
            os.remove(os.path.join(arguments.output, name))
    partial = os.path.join(arguments.output, "cell.json.partial")
    with open(partial, "w", encoding="utf-8") as file:
        json.dump(result, file, indent=1)
    shutil.move(partial, os.path.join(arguments.output, "cell.json"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
