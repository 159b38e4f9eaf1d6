#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""The benchmark's grid, tables, verdict and page, against oracles that look at every pair."""

import csv
import json
import pathlib
import random
import re
import sys
import tempfile
import unittest

BENCHMARK = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "benchmark"
sys.path.insert(0, str(BENCHMARK))

import commands  # noqa: E402
import document  # noqa: E402
import grid  # noqa: E402
import markdown  # noqa: E402
import page  # noqa: E402
import published  # noqa: E402
import results as results_module  # noqa: E402
import spreadsheet  # noqa: E402
import tables  # noqa: E402
import verdict  # noqa: E402
import web_page  # noqa: E402

SEED = 20261126


def settings(**changes):
    return {
        "systems": {"plain": {"config": "plain.lua"},
                    "mine": {"config": "mine.lua", "ours": True},
                    "closing": {"config": "closing.lua", "closes_loops": True},
                    "mine_closing": {"config": "mine_closing.lua", "ours": True,
                                     "closes_loops": True}},
        "ablations": {"true_labels": {"config": "mine.lua", "label_noise": 0, "title": "truth"},
                      "no_labels": {"config": "mine.lua", "labels_dir": "none", "title": "none"}},
        "sequences": ["00", 7], "ablation_sequences": ["07"], "seeds": 2, "poses": "/poses",
        "simulation": {"lidar": "vlp16", "label_noise": 0.06}, "standing_drives": 2,
        "first_scan": 0, "num_scans": {}, "threads": 1, **changes}


def result(system, sequence, figure, seed=0, **changes):
    metrics = dict.fromkeys(results_module.METRICS, figure)
    return results_module.Result(grid.Cell(system, sequence, seed), {
        "metrics": metrics, "odometry_metrics": metrics, "scans": 10, "scans_available": 10,
        "closures": 3, "false_closures": 1, "stage_median_ms": {"odometry": 5.0}, "version": "1.2",
        "binary_sha256": "b" * 64, "config_sha256": "c" * 64, "peak_memory_mib": 100.5,
        "cpu_s": 0.2, "wall_s": 0.3, "threads": 1, **changes})


def random_results(rng, digits=3):
    """Every system on both sequences, a tenth of the figures missing."""
    return [result(system, sequence,
                   None if rng.random() < 0.1 else round(rng.uniform(0, 0.02), digits))
            for system in settings()["systems"] for sequence in ("00", "07")]


class GridTest(unittest.TestCase):

    def test_all_cells(self):
        cells = grid.cells(settings())
        self.assertEqual(len(cells), len(set(cells)))
        self.assertEqual({cell for cell in cells if cell.sequence == "00"},
                         {grid.Cell(name, "00", seed) for name in settings()["systems"]
                          for seed in range(2)})
        self.assertEqual(len([cell for cell in cells if cell.sequence == "07"]), 6 * 2)

    def test_a_data_set_has_no_other_label_noise(self):
        names = {cell.system for cell in grid.cells(settings(poses="", dataset="/data"))}
        self.assertNotIn("true_labels", names)
        self.assertIn("no_labels", names)

    def test_the_command_line_chooses(self):
        only = {"systems": ["mine"], "ablations": [], "cell": None}
        self.assertEqual({cell.system for cell in grid.cells(settings(only=only))}, {"mine"})
        self.assertEqual(grid.cells(settings(only={"cell": "no_labels/7/1"})),
                         [grid.Cell("no_labels", "07", 1)])
        for wrong in ({"systems": ["yours"]}, {"cell": "yours/07"}, {"cell": "mine"}):
            with self.assertRaises(grid.SettingsError):
                grid.cells(settings(only=wrong))

    def test_what_is_the_same_is_run_once(self):
        ablations = {"full": {"same_as": "mine", "title": "all of it"}}
        chosen = settings(ablations=ablations, ablation_sequences=["07", "09"])
        cells = grid.cells(chosen)
        self.assertEqual(len(cells), len(set(cells)))
        self.assertNotIn("full", {cell.system for cell in cells})
        self.assertIn(grid.Cell("mine", "09", 0), cells)
        self.assertNotIn(grid.Cell("plain", "09", 0), cells)

    def test_wrong_settings(self):
        for systems in ({"a": {}}, {"a": {"config": "a.lua", "our": True}},
                        {"no_labels": {"config": "a.lua"}}, {"a": {"same_as": "b"}},
                        {"a": {"config": "a.lua", "same_as": "a"}}):
            with self.assertRaises(grid.SettingsError):
                grid.systems(settings(systems=systems))

    def test_no_more_drives_stand_than_allowed(self):
        for allowed in (1, 2, 3):
            chosen = settings(standing_drives=allowed)
            order = grid.drives_to_simulate(chosen)
            self.assertEqual(len(order), 2 + 2 + 2)  # 00; 07 with wrong labels and with true ones
            # Whatever else is done, a drive begins when those cells are done, so when these drives
            # are gone.
            for number, drive in enumerate(order):
                before = {grid.drive(chosen, cell) for cell in grid.cells_before(chosen, drive)}
                self.assertEqual(before, set(order[:number][-allowed:][:1] if number >= allowed
                                             else []))

    def test_ready_made_drives(self):
        chosen = settings(drives="/ready", ready_sequences=["07"])
        self.assertNotIn(grid.Drive("07", 0, 0.06), grid.drives_to_simulate(chosen))
        self.assertIn(grid.Drive("07", 1, 0.06), grid.drives_to_simulate(chosen))
        self.assertIn(grid.Drive("07", 0, 0.0), grid.drives_to_simulate(chosen))

    def test_commands(self):
        chosen = settings(num_scans={7: 50}, first_scan=10)
        self.assertEqual(
            " ".join(commands.simulate(chosen, grid.Drive("07", 1, 0.06), "P", "D")),
            "simulate --poses=P/07.txt --lidar=vlp16 --label_noise=0.06 --seed=9 --sequence=07 "
            "--output=D --num_scans=60")
        self.assertEqual(
            " ".join(commands.run(chosen, grid.Cell("no_labels", "07", 1), "D", "O")),
            "run --config=mine.lua --dataset=D --sequence=07 --output=O --labels_dir=none "
            "--first_scan=10 --num_scans=50")


class TablesTest(unittest.TestCase):

    def check_table(self, results):
        chosen = settings()
        systems = [row for row in grid.systems(chosen).values() if not row.ablation]
        figures = results_module.figures(results, lambda r: r.metric("ate_3d_m"))
        text = markdown.write([tables.metric_table(systems, figures, ["00", "07"], [])])
        lines = [[word.strip() for word in line.split("|")[1:-1]] for line in text.splitlines()[2:]]
        shown = {line[0].strip("`"): line for line in lines}
        for system in systems:
            own = [figures.get((system.name, sequence)) for sequence in ("00", "07")]
            own.append(None if None in own else sum(own) / 2)
            for column, value in enumerate(own):
                word = shown[system.name][2 + column]
                self.assertEqual(word.strip("*"), "–" if value is None else f"{value:.3f}")
                rivals = [shown[other.name][2 + column].strip("*") for other in systems
                          if other.closes_loops == system.closes_loops]
                rivals = [rival for rival in rivals if rival != "–"]
                self.assertEqual("**" in word, value is not None and len(rivals) > 1
                                 and word.strip("*") == min(rivals), (shown, system.name, column))

    def test_best_ones_are_bold(self):
        print(f"seed {SEED}")
        rng = random.Random(SEED)
        for _ in range(200):
            self.check_table(random_results(rng))
        self.check_table([])

    def test_means_over_seeds(self):
        results = [result("mine", "00", 1.0), result("mine", "00", 2.0, seed=1)]
        figures = results_module.figures(results, lambda r: r.metric("rte_percent"))
        self.assertEqual(figures, {("mine", "00"): 1.5})

    def test_records_are_read_and_borrowed(self):
        chosen = settings(ablations={"full": {"same_as": "mine"}})
        with tempfile.TemporaryDirectory() as output:
            for cell, scans in ((grid.Cell("mine", "00", 0), 5), (grid.Cell("mine", "07", 0), 7),
                                (grid.Cell("stranger", "07", 0), 9)):
                folder = pathlib.Path(output, cell.folder)
                folder.mkdir(parents=True)
                (folder / "cell.json").write_text(json.dumps({"scans": scans}))
            self.assertEqual([(r.cell.system, r.cell.sequence, r.record["scans"])
                              for r in results_module.read(output, chosen)],
                             [("mine", "00", 5), ("mine", "07", 7), ("full", "07", 7)])

    def test_published_figures_do_not_compete(self):
        rows = [published.Row("Theirs", True, "a paper", {"00": 0.001, "mean": 0.5})]
        systems = list(grid.systems(settings()).values())[:2]
        table = tables.metric_table(systems, {("plain", "00"): 1.0, ("mine", "00"): 2.0}, ["00"],
                                    rows)
        self.assertEqual(table.rows, (("`plain`", "", "**1.000**", "**1.000**"),
                                      ("`mine`", "", "2.000", "2.000"),
                                      ("published: Theirs", "LC", "0.00", "0.50")))

    def test_shipped_figures(self):
        rows = {row.system: row for row in published.read("ate_3d_m") if row.closes_loops}
        self.assertEqual(rows["the paper, loop closure"].values["mean"], 1.25)
        # The rounded figures of the eleven sequences have the mean that was published with them.
        for metric in results_module.METRICS:
            for row in published.read(metric):
                self.assertTrue(row.source)
                single = [value for name, value in row.values.items() if name != "mean"]
                if len(single) == 11:
                    self.assertAlmostEqual(sum(single) / 11, row.values["mean"], delta=0.0101)


class VerdictTest(unittest.TestCase):

    def test_every_loss_and_nothing_else(self):
        print(f"seed {SEED}")
        rng = random.Random(SEED)
        systems = [row for row in grid.systems(settings()).values() if not row.ablation]
        for _ in range(200):
            figures = results_module.figures(random_results(rng), lambda r: r.metric("ate_2d_m"))
            lost = {(sequence, theirs[1].name)
                    for sequence, _, theirs in verdict.losses(systems, figures, ["00", "07"])}
            expected = set()
            for sequence in ("00", "07"):
                for mine, other in (("mine", "plain"), ("mine_closing", "closing")):
                    a, b = figures[(mine, sequence)], figures[(other, sequence)]
                    if a is not None and b is not None and b < a:
                        expected.add((sequence, other))
            self.assertEqual(lost, expected)

    def test_lines(self):
        systems = [row for row in grid.systems(settings()).values() if not row.ablation]
        figures = {("plain", "00"): 1.0, ("mine", "00"): 1.1, ("closing", "00"): 3.0,
                   ("mine_closing", "00"): 2.0}
        self.assertEqual(verdict.loss_lines("ate_3d_m", systems, figures, ["00"]), [
            ("ATE-3D, m", "00", "`plain`", "1.000", "`mine`", "1.100", "1.10")])
        self.assertEqual(verdict.harm_lines("ate_3d_m", systems, figures, ["00"]), [
            ("ATE-3D, m", "00", "`mine_closing`", "2.000", "1.100", "1.82")])
        self.assertEqual(verdict.comparisons(systems, figures, ["00", "07"]), 2)


class PageTest(unittest.TestCase):

    def compose(self, results, **changes):
        return page.compose(settings(**changes), results, {
            metric: published.read(metric) for metric in results_module.METRICS}, {"00": "00.png"})

    def test_everything_is_said(self):
        results = [result(name, "00", 0.5 + i) for i, name in enumerate(settings()["systems"])]
        results.append(result("no_labels", "07", 0.25))
        results[0].record.update(scans=9)
        text = markdown.write(self.compose(results, commit="abc", remarks=["Mark this."]))
        for words in ("Simulated drives", "Mark this.", "of 00 the first 9 scans", "Where ours loses",
                      "| `plain` | 0.500 | `mine` | 1.500 | 3.00 |", "Of 12 such comparisons", "| none | 0.250", "![Sequence 00](00.png)",
                      "Commit `abc`", "--cell=mine_closing/00/0",
                      "semantic_kiss simulate --poses=poses/00.txt", "`cccccccccccc`"):
            self.assertIn(words, text)

    def test_what_is_missing(self):
        results = [result("mine", "00", 1.0), result("mine", "07", 1.0), result("plain", "00", 1.0)]
        text = markdown.write(self.compose(results))
        self.assertIn("(shown as –, and without a mean): `plain` on 07.", text)
        self.assertNotIn("Not run", markdown.write(self.compose(results[:1])))

    def test_a_single_cell_is_enough(self):
        text = markdown.write(self.compose([result("plain", "00", None)], poses="", dataset="/d"))
        self.assertIn("There is nothing to compare", text)
        self.assertNotIn("Simulated", text)
        self.assertNotIn("/d", text)

    def test_web_page(self):
        blocks = [document.Heading("a < b"), document.Paragraph("**x** and `y*z`"),
                  document.Table(("", "n"), (("`a`", "**1**"),)),
                  document.Picture("p.png", "P")]
        text = web_page.write("T", blocks, {"p.png": b"\x89PNG"})
        for words in ("<h2>a &lt; b</h2>", "<b>x</b> and <code>y*z</code>", "<td><b>1</b></td>",
                      'src="data:image/png;base64,iVBORw=="'):
            self.assertIn(words, text)
        self.assertFalse(re.search(r"(src|href)=\"(?!data:)", text))

    def test_spreadsheet(self):
        lines = list(csv.DictReader(spreadsheet.write(
            [result("mine", "00", 1.25), result("plain", "00", None)]).splitlines()))
        self.assertEqual([line["ate_3d_m"] for line in lines], ["1.25", ""])
        self.assertEqual(lines[0]["binary_sha256"], "b" * 64)


if __name__ == "__main__":
    unittest.main(verbosity=0)
