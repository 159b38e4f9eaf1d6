# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""The tables of the page: from figures to texts, best ones in bold."""

import results as results_module
from document import Table

NONE = "–"


def number(value, digits):
    return NONE if value is None else f"{value:.{digits}f}"


def best(values, digits):
    """Whether each value is the least as far as its digits show; never where there is but one."""
    shown = [None if value is None else round(value, digits) for value in values]
    there = [value for value in shown if value is not None]
    if len(there) < 2:
        return [False] * len(values)
    return [value == min(there) for value in shown]


def _bold_columns(columns, digits):
    """Columns of numbers as columns of texts."""
    texts = []
    for column in columns:
        marks = best(column, digits)
        texts.append([f"**{number(value, digits)}**" if mark else number(value, digits)
                      for value, mark in zip(column, marks)])
    return texts


def group(titles, columns, digits, marker):
    """Rows that compete with one another: texts, with the best of each column in bold."""
    texts = _bold_columns(columns, digits)
    return [(title, marker, *(column[i] for column in texts)) for i, title in enumerate(titles)]


def columns_of(table, names, sequences):
    """A column for each sequence and one for the mean; a line for each of the systems `names`."""
    by_sequence = [[table.get((name, sequence)) for name in names] for sequence in sequences]
    means = [results_module.mean_over(table, name, sequences) for name in names]
    return by_sequence + [means]


def metric_table(systems, table, sequences, published, digits=3):
    """A metric of all systems: those that close loops and those that do not compete apart.

    systems    rows of the grid
    table      (system, sequence) -> figure or None
    published  published.Row list, shown below, not competing
    """
    rows = []
    for closes_loops in (False, True):
        members = [system for system in systems if system.closes_loops == closes_loops]
        columns = columns_of(table, [system.name for system in members], sequences)
        titles = [f"`{system.name}`" for system in members]
        rows += group(titles, columns, digits, "LC" if closes_loops else "")
    for row in published:
        values = [row.values.get(sequence) for sequence in (*sequences, "mean")]
        rows.append((f"published: {row.system}", "LC" if row.closes_loops else "",
                     *(number(value, 2) for value in values)))
    return Table(("", "", *sequences, "mean"), tuple(rows))


def ablation_table(systems, columns, digits=3):
    """Rows of ablations; `columns` maps a header to {system name: figure or None}."""
    texts = _bold_columns([[column.get(system.name) for system in systems]
                           for column in columns.values()], digits)
    return Table(("", *columns),
                 tuple((system.title, *(column[i] for column in texts))
                       for i, system in enumerate(systems)))
