# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Which cells need not be run again.

Snakemake alone would run all cells of a drive again as soon as one of them needs the drive, which is
gone by then. So a cell that is done needs no drive.
"""

import json
import os

import commands
import grid


def drive_flags(settings, cell):
    """What the cell's drive was made with; none for sequences of a data set."""
    if not settings.get("poses"):
        return []
    return commands.simulate(settings, grid.drive(settings, cell), "POSES", "DATASET")


def is_done(settings, cell, output="."):
    """Whether the cell's record is there and tells of the same drive and the same flags."""
    try:
        with open(os.path.join(output, cell.folder, "cell.json"), encoding="utf-8") as file:
            record = json.load(file)
    except (FileNotFoundError, json.JSONDecodeError):
        return False
    return (record.get("flags") == commands.run(settings, cell, "DATASET", "OUTPUT")
            and record.get("drive_flags") == drive_flags(settings, cell))


def drop_outdated(settings, output="."):
    """Removes the records of cells that were run with other flags, so that they are run again."""
    for cell in grid.cells(settings):
        path = os.path.join(output, cell.folder, "cell.json")
        if os.path.exists(path) and not is_done(settings, cell, output):
            os.remove(path)
