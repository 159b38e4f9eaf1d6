# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Figures that others published about the real sequences (published.csv)."""

import csv
import dataclasses
import os

FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "published.csv")


@dataclasses.dataclass(frozen=True)
class Row:
    """A system's figures of one metric; `values` by sequence, and by "mean"."""
    system: str
    closes_loops: bool
    source: str
    values: dict


def read(metric, path=FILE):
    """The rows of a metric, in the file's order."""
    rows = {}
    with open(path, encoding="utf-8", newline="") as file:
        for line in csv.DictReader(file):
            if line["metric"] == metric:
                key = (line["system"], line["closes_loops"] == "yes", line["source"])
                rows.setdefault(key, {})[line["sequence"]] = float(line["value"])
    return [Row(*key, values) for key, values in rows.items()]
