# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""What the cells of a benchmark came to: reading the records, and means over seeds."""

import dataclasses
import glob
import json
import os

import grid

# Smaller is better for all of them.
METRICS = ("rte_percent", "ate_3d_m", "ate_2d_m")


@dataclasses.dataclass(frozen=True)
class Result:
    """A cell that was run, and what run_cell.py recorded of it."""
    cell: grid.Cell
    record: dict

    def metric(self, name):
        """None where there is no such figure: no ground truth, or too short a drive."""
        return (self.record["metrics"] or {}).get(name)


def read(output, settings):
    """All cells of the settings' rows that are done, in the order of the grid."""
    rows = grid.systems(settings)
    found = []
    for path in glob.glob(os.path.join(output, "runs", "*", "*", "*", "cell.json")):
        system, sequence, seed = path.split(os.sep)[-4:-1]
        if system in rows:
            with open(path, encoding="utf-8") as file:
                found.append(Result(grid.Cell(system, sequence, int(seed)), json.load(file)))
    found += _borrowed(found, settings)
    order = list(rows)
    return sorted(found, key=lambda result: (order.index(result.cell.system), result.cell.sequence,
                                             result.cell.seed))


def _borrowed(results, settings):
    """The cells of ablations that are the same as a system, for the ablations' sequences."""
    narrow = [grid.sequence_name(name) for name in settings.get("ablation_sequences") or []]
    return [Result(dataclasses.replace(result.cell, system=row.name), result.record)
            for row in grid.systems(settings).values() if row.same_as
            for result in results
            if result.cell.system == row.same_as and result.cell.sequence in narrow]


def sequences(results):
    return sorted({result.cell.sequence for result in results})


def mean(values):
    """None if there are none, or if one of them is None."""
    values = list(values)
    return None if not values or None in values else sum(values) / len(values)


def figures(results, value):
    """(system, sequence) -> mean over the seeds of value(result)."""
    groups = {}
    for result in results:
        groups.setdefault((result.cell.system, result.cell.sequence), []).append(value(result))
    return {key: mean(values) for key, values in groups.items()}


def mean_over(table, system, sequences_):
    """The mean of a system's figures over the sequences; None if one is missing."""
    return mean(table.get((system, sequence)) for sequence in sequences_)
