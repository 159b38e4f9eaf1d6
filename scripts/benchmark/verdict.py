# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Where ours loses, computed, so that no page can forget it."""

import results as results_module

NAMES = {"rte_percent": "RTE", "ate_3d_m": "ATE-3D", "ate_2d_m": "ATE-2D"}
# What is equal as far as tables show it is a draw.
DIGITS = 3
UNITS = {"rte_percent": "%", "ate_3d_m": "m", "ate_2d_m": "m"}


def _best(systems, table, sequence):
    """(figure, system) of the best one; None if none has a figure."""
    there = [(table[(system.name, sequence)], system) for system in systems
             if table.get((system.name, sequence)) is not None]
    return min(there, key=lambda pair: pair[0], default=None)


def _less(one, other):
    return round(one, DIGITS) < round(other, DIGITS)


def losses(systems, table, sequences):
    """(sequence, ours, others): each a pair of figure and system, where others are better.

    Ours are the systems of the settings that are marked so. Whoever closes loops competes with those
    who do, the others among themselves.
    """
    found = []
    for closes_loops in (False, True):
        members = [system for system in systems if system.closes_loops == closes_loops]
        for sequence in sequences:
            ours = _best([s for s in members if s.ours], table, sequence)
            others = _best([s for s in members if not s.ours], table, sequence)
            if ours and others and _less(others[0], ours[0]):
                found.append((sequence, ours, others))
    return found


def loop_closure_harms(systems, table, sequences):
    """(sequence, figure, system, best odometry's figure): ours with loops closed, worse than ours
    without."""
    odometries = [system for system in systems if system.ours and not system.closes_loops]
    closing = [system for system in systems if system.ours and system.closes_loops]
    found = []
    for sequence in sequences:
        before = _best(odometries, table, sequence)
        for system in closing:
            after = table.get((system.name, sequence))
            if before and after is not None and _less(before[0], after):
                found.append((sequence, after, system, before[0]))
    return found


def with_means(table, systems, sequences):
    """The table with a further "sequence", the mean over all."""
    means = {(system.name, "mean"): results_module.mean_over(table, system.name, sequences)
             for system in systems}
    return {**table, **means}


def comparisons(systems, table, sequences):
    """How many columns of the table have figures of ours and of others, so that someone wins."""
    count = 0
    for closes_loops in (False, True):
        members = [system for system in systems if system.closes_loops == closes_loops]
        for sequence in sequences:
            count += all(_best([s for s in members if s.ours == ours], table, sequence)
                         for ours in (True, False))
    return count


def loss_lines(metric, systems, table, sequences):
    """Texts for a table: metric, sequence, who is better, by which figure, ours, ratio."""
    return [(f"{NAMES[metric]}, {UNITS[metric]}", sequence, f"`{other.name}`", f"{theirs:.3f}",
             f"`{own.name}`", f"{ours:.3f}", f"{ours / theirs:.2f}" if theirs else "")
            for sequence, (ours, own), (theirs, other) in losses(systems, table, sequences)]


def harm_lines(metric, systems, table, sequences):
    """Texts for a table: metric, sequence, which system, its figure, the odometry's, ratio."""
    return [(f"{NAMES[metric]}, {UNITS[metric]}", sequence, f"`{system.name}`", f"{after:.3f}",
             f"{before:.3f}", f"{after / before:.2f}" if before else "")
            for sequence, after, system, before in loop_closure_harms(systems, table, sequences)]
