# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Command line of scripts/benchmark.sh: checks it, writes OUTPUT/settings.json, starts Snakemake.

What is not a flag of ours goes on to Snakemake: --cores=N, --dry-run, --keep-going, --unlock ...
"""

import argparse
import json
import os
import subprocess
import sys

import grid

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
EXAMPLES = """examples:
  scripts/benchmark.sh --dataset=/data/semantickitti --output=output/benchmark
  scripts/benchmark.sh --poses=/data/kitti/poses --output=output/benchmark --cores=8
  scripts/benchmark.sh --poses=/data/kitti/poses --output=output/benchmark --slurm
  scripts/benchmark.sh --poses=/data/kitti/poses --output=output/one --cell=semantic_kiss_6dof/07
"""


def names(text):
    return [word for word in text.split(",") if word]


def scan_limits(text):
    """"2000" for all sequences, or "02:2000,08:2000"."""
    if text.isdigit():
        return int(text)
    return {name: int(limit) for name, limit in (word.split(":") for word in names(text))}


def parser():
    flags = argparse.ArgumentParser(
        prog="scripts/benchmark.sh", allow_abbrev=False, epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Runs systems over sequences and makes the page that compares them. The same "
        "command goes on where it was stopped.")
    source = flags.add_mutually_exclusive_group(required=True)
    source.add_argument("--dataset", metavar="DIR", help="a data set in SemanticKITTI's layout")
    source.add_argument("--poses", metavar="DIR",
                        help="KITTI's poses/: simulates a drive along each NN.txt")
    source.add_argument("--page", action="store_true", default=None,
                        help="make the page again from the cells that are done so far")
    flags.add_argument("--output", metavar="DIR", required=True)
    flags.add_argument("--drives", metavar="DIR",
                       help="simulated drives that are there already, DIR/sequences/NN")
    flags.add_argument("--settings", metavar="FILE", action="append", default=[],
                       help="YAML over scripts/benchmark/settings.yaml; may be repeated")
    flags.add_argument("--systems", type=names, metavar="A,B")
    flags.add_argument("--ablations", metavar="A,B", type=names, help='"" for none')
    flags.add_argument("--sequences", type=names, metavar="00,05")
    flags.add_argument("--ablation_sequences", type=names, metavar="06,07")
    flags.add_argument("--cell", metavar="SYSTEM/SEQUENCE[/SEED]", help="run this cell alone")
    flags.add_argument("--seeds", type=int, metavar="N")
    flags.add_argument("--first_scan", type=int, metavar="N")
    flags.add_argument("--num_scans", type=scan_limits, metavar="N or 02:N,08:N")
    flags.add_argument("--threads", type=int, metavar="N", help="of one run")
    flags.add_argument("--standing_drives", type=int, metavar="N",
                       help="simulated drives on the disk at once")
    flags.add_argument("--note", metavar="TEXT", help="what the page says beside times")
    flags.add_argument("--binary", metavar="FILE", help="the program, if not the one of this tree")
    flags.add_argument("--slurm", action="store_true", help="jobs on a Slurm cluster")
    return flags


def command_line_settings(arguments):
    """The keys of settings.yaml that flags say otherwise."""
    keys = ("sequences", "ablation_sequences", "seeds", "first_scan", "num_scans", "threads",
            "standing_drives", "note")
    changes = {key: getattr(arguments, key) for key in keys if getattr(arguments, key) is not None}
    for key in ("dataset", "poses", "drives"):
        value = getattr(arguments, key)
        if value and not os.path.isdir(value):
            raise ValueError(f"--{key}={value}: no such directory")
        changes[key] = os.path.abspath(value) if value else ""
    changes["binary"] = os.path.abspath(
        arguments.binary or os.path.join(ROOT, "build", "bin", "semantic_kiss"))
    changes["commit"] = commit()
    return changes


def commit():
    """The commit of this tree, with a + if files differ from it; empty outside a checkout."""
    def git(*words):
        return subprocess.run(["git", "-C", ROOT, *words], capture_output=True, text=True,
                              check=False).stdout.strip()
    changed = git("status", "--porcelain", "--untracked-files=no")
    return git("rev-parse", "HEAD") + ("+" if changed else "")


def ready_sequences(drives):
    folder = os.path.join(drives, "sequences")
    return sorted(os.listdir(folder)) if drives and os.path.isdir(folder) else []


def snakemake(arguments, rest):
    """The command that starts Snakemake."""
    words = ["snakemake", "--snakefile", os.path.join(HERE, "Snakefile"),
             "--directory", arguments.output, "--configfile", os.path.join(HERE, "settings.yaml"),
             *map(os.path.abspath, arguments.settings),
             os.path.join(arguments.output, "settings.json"),
             "--rerun-incomplete", "--rerun-triggers", "mtime"]
    if arguments.slurm:
        words += ["--profile", os.path.join(HERE, "profiles", "slurm")]
    elif not [word for word in rest if word.startswith(("--cores", "-c", "-j", "--jobs"))]:
        words += ["--cores", "all"]
    if arguments.cell:
        words += ["runs"]
    return words + rest


def outcome(arguments):
    """What to look at: the figures of a single cell, or the page."""
    if not arguments.cell:
        return f"Look at {arguments.output}/page/index.html"
    cell = grid.single_cell(arguments.cell)
    with open(os.path.join(arguments.output, cell.folder, "cell.json"), encoding="utf-8") as file:
        metrics = json.load(file)["metrics"]
    return f"{arguments.cell}: " + ", ".join(f"{key} {value}" for key, value in metrics.items())


def main():
    arguments, rest = parser().parse_known_args()
    arguments.output = os.path.abspath(arguments.output)
    if arguments.page:
        return subprocess.run([sys.executable, os.path.join(HERE, "make_page.py"),
                               f"--output={arguments.output}"], check=False).returncode
    try:
        settings = command_line_settings(arguments)
    except ValueError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    settings["ready_sequences"] = ready_sequences(settings["drives"])
    settings["only"] = {"systems": arguments.systems, "ablations": arguments.ablations,
                        "cell": arguments.cell}
    os.makedirs(arguments.output, exist_ok=True)
    with open(os.path.join(arguments.output, "settings.json"), "w", encoding="utf-8") as file:
        json.dump(settings, file, indent=1)
    status = subprocess.run(snakemake(arguments, rest), check=False).returncode
    if status == 0 and not {"-n", "--dry-run"} & set(rest):
        print(outcome(arguments))
    return status


if __name__ == "__main__":
    sys.exit(main())
