# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Every cell as a line of CSV."""

import csv
import io

import results as results_module

FIGURES = ("scans", "scans_available", "threads", "closures", "false_closures", "peak_memory_mib",
           "cpu_s", "wall_s", "version", "binary_sha256", "config_sha256")


def _number(value):
    return f"{value:.6g}" if isinstance(value, float) else value


def write(results):
    """The whole file. Figures that do not exist are empty."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    odometry = [f"odometry_{name}" for name in results_module.METRICS]
    table.writerow(["system", "sequence", "seed", *results_module.METRICS, *odometry, *FIGURES])
    for result in results:
        before = result.record["odometry_metrics"] or {}
        table.writerow([result.cell.system, result.cell.sequence, result.cell.seed]
                       + [_number(result.metric(name)) for name in results_module.METRICS]
                       + [_number(before.get(name)) for name in results_module.METRICS]
                       + [_number(result.record[name]) for name in FIGURES])
    return text.getvalue()
