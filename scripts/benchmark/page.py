# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""What the page says: from settings and results to a document. No files are read here."""

import collections

import commands
import grid
import results as results_module
import tables
import verdict
from document import Commands, Heading, Items, Paragraph, Picture, Table

TITLES = {
    "rte_percent": "RTE, % (drift by KITTI's rule)",
    "ate_3d_m": "ATE-3D, m (error in space)",
    "ate_2d_m": "ATE-2D, m (error in the plane)",
}

# Where a scan is registered, by the builders' names for it: the odometry's, and the planar one's.
ODOMETRY_STAGES = ("odometry", "filters", "matching")


def compose(settings, results, published, pictures):
    """The blocks of the page.

    published  {metric: published.Row list}
    pictures   {sequence: name of a PNG}
    """
    rows = grid.systems(settings)
    systems = [row for row in rows.values() if not row.ablation]
    main = [result for result in results if not rows[result.cell.system].ablation]
    systems = [row for row in systems if row.name in {result.cell.system for result in main}]
    sequences = results_module.sequences(main)
    metric_tables = {metric: results_module.figures(main, lambda result: result.metric(metric))
                     for metric in results_module.METRICS}
    blocks = [Heading("The systems compared", 1), *_introduction(settings, main)]
    for metric, table in metric_tables.items():
        blocks += [Heading(TITLES[metric]),
                   tables.metric_table(systems, table, sequences, published[metric])]
    blocks += [Heading("Where ours loses"), *_losses(systems, metric_tables, sequences)]
    blocks += _ablations(rows, results)
    blocks += [Heading("Time and memory"), *_cost(settings, systems, main)]
    if pictures:
        blocks += [Heading("Trajectories, and errors along the way"), Paragraph(
            "All are laid over the true trajectory as a whole, as for ATE-3D.")]
        blocks += [Picture(name, f"Sequence {sequence}") for sequence, name in pictures.items()]
    return blocks + [Heading("How to repeat it"), *_provenance(settings, results)]


def _introduction(settings, results):
    simulated = bool(settings.get("poses"))
    text = ("**Simulated drives** along the routes of KITTI's sequences, not KITTI's scans: "
            f"lidar `{settings['simulation']['lidar']}`, "
            f"{100 * settings['simulation']['label_noise']:g} % of the labels wrong. Published "
            "figures are of the real sequences; they stand here for orientation and do not compete."
            if simulated else "Sequences of a data set in SemanticKITTI's layout.")
    blocks = [Paragraph(text + " Best figures of each column in bold, systems that close loops "
                        "(LC) apart from those that do not. The mean is that of the sequences shown.")]
    cut = sorted({(result.cell.sequence, result.record["scans"]) for result in results
                  if result.record["scans"] < result.record["scans_available"]
                  or grid.num_scans(settings, result.cell.sequence)})
    if cut:
        blocks.append(Paragraph("**Thinned:** " + ", ".join(
            f"of {sequence} the first {scans} scans alone" for sequence, scans in cut) + "."))
    blocks += [Paragraph(text) for text in settings.get("remarks") or []]
    missing = _not_run(results)
    if missing:
        blocks.append(Paragraph(f"**Not run yet** (shown as {tables.NONE}, and without a mean): "
                                f"{missing}."))
    return blocks


def _not_run(results):
    """Which systems lack which of the sequences that others have; empty if none does."""
    there = {(result.cell.system, result.cell.sequence) for result in results}
    sequences = results_module.sequences(results)
    lacks = {name: [sequence for sequence in sequences if (name, sequence) not in there]
             for name in dict.fromkeys(result.cell.system for result in results)}
    return "; ".join(f"`{name}` on {', '.join(missing)}" for name, missing in lacks.items() if missing)


def _losses(systems, metric_tables, sequences):
    """Two tables at most, and how often ours is not worse."""
    places = [*sequences, "mean"]
    worse, harmed, compared = [], [], 0
    for metric, table in metric_tables.items():
        full = verdict.with_means(table, systems, sequences)
        compared += verdict.comparisons(systems, full, places)
        worse += verdict.loss_lines(metric, systems, full, places)
        harmed += verdict.harm_lines(metric, systems, full, places)
    if not compared:
        return [Paragraph("There is nothing to compare: the rows are all ours, or none is.")]
    blocks = [Paragraph(
        f"A column of a table counts twice, for the odometries and for the systems that close loops. "
        f"Of {compared} such comparisons the best of ours loses {len(worse)} to the best of the "
        "others.")]
    if worse:
        blocks.append(Table(("", "", "better", "", "best of ours", "", "ratio"), tuple(worse)))
    if harmed:
        blocks += [Paragraph("Where closing loops makes ours worse than the best of our odometries:"),
                   Table(("", "", "loops closed", "", "odometry", "ratio"), tuple(harmed))]
    return blocks


def _ablations(rows, results):
    ablations = [row for row in rows.values() if row.ablation]
    names = {row.name for row in ablations}
    cells = [result for result in results if result.cell.system in names]
    if not cells:
        return []
    done = {result.cell.system for result in cells}
    ablations = [row for row in ablations if row.name in done]
    sequences = results_module.sequences(cells)
    columns = {}
    for title, key in (("odometry", "odometry_metrics"), ("loops closed", "metrics")):
        for metric in results_module.METRICS:
            table = results_module.figures(
                cells, lambda result, k=key, m=metric: (result.record[k] or {}).get(m))
            columns[f"{title}: {verdict.NAMES[metric]} {verdict.UNITS[metric]}"] = {
                row.name: results_module.mean_over(table, row.name, sequences)
                for row in ablations}
    return [Heading("What single parts are worth"), Paragraph(
        f"Means over {', '.join(sequences)}. Of each run the drive as the odometry saw it, and as it "
        "is after loops were closed."), tables.ablation_table(ablations, columns)]


def _cost(settings, systems, results):
    lines = []
    for system in systems:
        records = [result.record for result in results if result.cell.system == system.name]
        scans = sum(record["scans"] for record in records)
        medians = [sum(record["stage_median_ms"].get(stage, 0) for stage in ODOMETRY_STAGES)
                   for record in records]
        closures = [sum(record[key] or 0 for record in records)
                    for key in ("closures", "false_closures")]
        lines.append((
            f"`{system.name}`",
            tables.number(1000 * sum(record["cpu_s"] for record in records) / scans, 1),
            tables.number(results_module.mean(medians), 1),
            tables.number(max(record["peak_memory_mib"] for record in records), 0),
            f"{closures[0]}, {closures[1]}" if system.closes_loops else tables.NONE))
    note = ("Processor time is that of the whole program (reading, map and pictures included) by "
            "scans. The odometry's is time on the clock, the mean over the sequences of the median "
            f"scan. Memory is the largest of all. One run used {settings['threads']} thread"
            f"{'s' * (settings['threads'] != 1)}. {settings.get('note', '')}")
    header = ("", "processor ms a scan", "odometry, ms a scan", "peak MiB", "closures, false")
    return [Paragraph(note.strip()), Table(header, tuple(lines))]


def _provenance(settings, results):
    rows = grid.systems(settings)
    results = [result for result in results if not rows[result.cell.system].same_as]
    versions = collections.Counter(
        (result.record["version"], result.record["binary_sha256"][:12]) for result in results)
    configurations = {(result.cell.system, result.record["config_sha256"][:12])
                      for result in results}
    # Hashes in the order of the rows.
    order = list(rows)
    lines = [(f"`{name}`", f"`{digest}`", f"`{rows[name].config}`")
             for name, digest in sorted(configurations, key=lambda pair: order.index(pair[0]))]
    seeds = sorted({result.cell.seed for result in results})
    programs = "; ".join(f"version {version}, binary `{digest}`, {count} cells"
                         for (version, digest), count in sorted(versions.items()))
    return [
        Paragraph(f"{programs}. Commit `{settings.get('commit') or 'unknown'}`. "
                  f"Seeds {', '.join(map(str, seeds))}."),
        Paragraph("All of it, resumed where it was stopped:"), Commands((_everything(settings),)),
        Paragraph("One cell from scratch:"), *_one_cell(settings, results),
        Paragraph("Configurations, with the hash of what they resolve to (`semantic_kiss config`):"),
        Table(("row", "SHA-256", "file"), tuple(lines)),
    ]


def _source(settings):
    return "--poses=poses" if settings.get("poses") else "--dataset=DIR"


def _everything(settings):
    words = ["scripts/benchmark.sh", _source(settings), "--output=output/benchmark"]
    limit = settings.get("num_scans")
    if limit:
        words.append("--num_scans=" + (",".join(f"{key}:{value}" for key, value in limit.items())
                                       if isinstance(limit, dict) else str(limit)))
    return " ".join(words)


def _one_cell(settings, results):
    """The commands for the last cell of the grid; others differ by name."""
    rows = grid.systems(settings)
    cell = results[-1].cell
    for result in results:
        if rows[result.cell.system].ours:
            cell = result.cell
    short = " ".join(["scripts/benchmark.sh", _source(settings), "--output=output/one",
                      f"--cell={cell.system}/{cell.sequence}/{cell.seed}"])
    lines = []
    if settings.get("poses"):
        drive = grid.drive(settings, cell)
        lines.append(commands.simulate(settings, drive, "poses", "DATASET"))
    lines.append(commands.run(settings, cell, "DATASET", "OUTPUT"))
    return [Commands((short,)), Paragraph("which is"),
            Commands(tuple("semantic_kiss " + " ".join(line) for line in lines))]
