# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""The commands of the program that make a drive and a cell: pure functions of the settings.

The same functions serve the workflow and the page, so what the page says can be typed.
"""

import grid


def simulate(settings, drive, poses, output):
    """Flags that simulate `drive` along the pose files in `poses` into the data set `output`."""
    flags = ["simulate", f"--poses={poses}/{drive.sequence}.txt",
             f"--lidar={settings['simulation']['lidar']}",
             f"--label_noise={drive.label_noise:g}", f"--seed={simulation_seed(drive)}",
             f"--sequence={drive.sequence}", f"--output={output}"]
    scans = grid.num_scans(settings, drive.sequence)
    if scans:
        flags.append(f"--num_scans={int(settings['first_scan']) + scans}")
    return flags


def simulation_seed(drive):
    """The world's seed: another one for each sequence and each of the benchmark's seeds."""
    number = int(drive.sequence) if drive.sequence.isdigit() else 0
    return number + 1 + drive.seed


def run(settings, cell, dataset, output):
    """Flags that run a cell's system on its sequence of the data set."""
    system = grid.systems(settings)[cell.system]
    flags = ["run", f"--config={system.config}", f"--dataset={dataset}",
             f"--sequence={cell.sequence}", f"--output={output}"]
    if system.labels_dir:
        flags.append(f"--labels_dir={system.labels_dir}")
    if int(settings["first_scan"]):
        flags.append(f"--first_scan={int(settings['first_scan'])}")
    scans = grid.num_scans(settings, cell.sequence)
    if scans:
        flags.append(f"--num_scans={scans}")
    return flags
