# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Pictures of a sequence: all trajectories over the true one, and their errors along the way."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as pyplot  # noqa: E402
import numpy  # noqa: E402
from matplotlib import ticker  # noqa: E402

import trajectories  # noqa: E402

# Ours are solid, the baselines dashed; colours that differ in brightness, too.
COLOURS = ["#8a939b", "#d08a1e", "#4aa564", "#2b6cb0", "#333333", "#7b3fa0", "#c0262d", "#0a7d8c"]
DPI = 90


def style_of(index, system):
    return {"color": COLOURS[index % len(COLOURS)], "linewidth": 1.6 if system.ours else 1.2,
            "linestyle": "-" if system.ours else (0, (4, 1.5))}


def _square(axes, positions):
    """Equal scales, with the whole route in a square."""
    low, high = positions.min(axis=0), positions.max(axis=0)
    middle, half = (low + high) / 2, 0.54 * max(high - low)
    axes.set_xlim(middle[0] - half, middle[0] + half)
    axes.set_ylim(middle[1] - half, middle[1] + half)
    axes.set_aspect("equal")


def _draw_from_above(axes, truth, runs):
    axes.plot(truth[:, 0], truth[:, 2], color="#d5d9dd", linewidth=5, label="truth",
              solid_capstyle="round")
    for label, style, estimate in runs:
        placed = trajectories.aligned(estimate, truth)
        axes.plot(placed[:, 0], placed[:, 2], label=label, **style)
    _square(axes, truth[:, [0, 2]])
    axes.set_xlabel("right, m")
    axes.set_ylabel("ahead, m")


def _draw_errors(upper, lower, truth, runs):
    way = trajectories.travelled(truth)
    for label, style, estimate in runs:
        distance, height = trajectories.errors(estimate, truth)
        upper.plot(way, numpy.maximum(distance, 1e-3), label=label, **style)
        lower.plot(way, height, **style)
    upper.set_yscale("log")
    # 0.1, 0.5, 2: plain numbers, and some between the powers of ten.
    upper.yaxis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5)))
    upper.yaxis.set_major_formatter(ticker.FormatStrFormatter("%g"))
    upper.yaxis.set_minor_locator(ticker.NullLocator())
    upper.set_ylabel("error, m")
    upper.tick_params(labelbottom=False)
    lower.set_ylabel("of which height, m")
    lower.set_xlabel("driven, m")
    for axes in (upper, lower):
        axes.set_xlim(way[0], way[-1])


def draw_sequence(path, title, truth, runs):
    """Writes a PNG. `runs`: (label, style, N x 3 positions), as many as `truth` has."""
    figure = pyplot.figure(figsize=(12.5, 6.2), layout="constrained")
    grid = figure.add_gridspec(3, 2, width_ratios=[1, 1.25], height_ratios=[1.5, 1, 0.12])
    above = figure.add_subplot(grid[:2, 0])
    upper, lower = figure.add_subplot(grid[0, 1]), figure.add_subplot(grid[1, 1])
    _draw_from_above(above, truth, runs)
    _draw_errors(upper, lower, truth, runs)
    for axes in (above, upper, lower):
        axes.grid(color="#e6e9ec", linewidth=0.6)
        axes.set_axisbelow(True)
        axes.spines[["top", "right"]].set_visible(False)
    below = figure.add_subplot(grid[2, :])
    below.set_axis_off()
    below.legend(*above.get_legend_handles_labels(), loc="center", ncols=4, frameon=False)
    figure.suptitle(title, x=0.01, ha="left", fontsize=13)
    figure.savefig(path, dpi=DPI, metadata={"Software": None})
    pyplot.close(figure)
