# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Draws every sequence of a benchmark's output into the folder of its page."""

import os

import charts
import trajectories


def draw(output, folder, systems, results):
    """Returns {sequence: name of its picture}; sequences without ground truth have none.

    Of several seeds the first is drawn, since each has a route of its own.
    """
    names = {}
    for sequence in sorted({result.cell.sequence for result in results}):
        cells = {result.cell.system: os.path.join(output, result.cell.folder) for result in results
                 if result.cell.sequence == sequence and result.cell.seed == 0}
        cells = {name: path for name, path in cells.items()
                 if os.path.exists(os.path.join(path, "truth_kitti.txt"))}
        if cells:
            names[sequence] = f"{sequence}.png"
            _draw_one(os.path.join(folder, names[sequence]), f"Sequence {sequence}", systems, cells)
    return names


def _draw_one(path, title, systems, cells):
    truth = trajectories.read_positions(
        os.path.join(next(iter(cells.values())), "truth_kitti.txt"))
    runs = []
    for index, system in enumerate(systems):
        if system.name in cells:
            estimate = trajectories.read_positions(
                os.path.join(cells[system.name], "trajectory_kitti.txt"))
            if len(estimate) == len(truth):
                runs.append((system.name, charts.style_of(index, system), estimate))
    charts.draw_sequence(path, title, truth, runs)
