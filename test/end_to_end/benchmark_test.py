#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""`scripts/benchmark.sh` on a tiny grid: figures, resumption, the page; on this machine and on Slurm."""

import csv
import json
import os
import shutil
import subprocess
import unittest

from program import BINARY, ProgramTest, main, read, write

SOURCE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SCANS = 12
SETTINGS = """
simulation: {lidar: vlp16, label_noise: 0.06}
sequences: [4]
ablation_sequences: ["04"]
standing_drives: 1
"""
HAS_SNAKEMAKE = shutil.which("snakemake") is not None
HAS_SLURM = os.path.exists("/usr/sbin/slurmctld") and os.path.exists("/usr/sbin/munged")


def straight_on(num_poses):
    """KITTI's rows of a camera that looks where it goes, 1 m a scan."""
    return "".join(f"1 0 0 0 0 1 0 0 0 0 1 {i}\n" for i in range(num_poses))


@unittest.skipUnless(HAS_SNAKEMAKE, "Snakemake is not installed: scripts/setup.sh --benchmark")
class BenchmarkTest(ProgramTest):

    def setUp(self):
        super().setUp()
        os.mkdir(self.path("poses"))
        write(self.path("poses", "04.txt"), straight_on(40))
        write(self.path("settings.yaml"), SETTINGS)

    def benchmark(self, *flags, output="out", code=0, environment=None):
        """Runs the script; returns all that it printed."""
        result = subprocess.run(
            [os.path.join(SOURCE, "scripts", "benchmark.sh"), f"--binary={BINARY}",
             f"--poses={self.path('poses')}", f"--output={self.path(output)}",
             f"--settings={self.path('settings.yaml')}", f"--num_scans={SCANS}",
             "--systems=kiss_icp,semantic_kiss", "--ablations=true_labels", *flags],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300, check=False,
            env={**os.environ, **(environment or {})})
        self.assertEqual(result.returncode, code, result.stdout)
        return result.stdout

    def rows(self, output="out"):
        with open(self.path(output, "page", "cells.csv"), encoding="utf-8") as file:
            return {row["system"]: row for row in csv.DictReader(file)}

    def test_a_grid_is_run_once_and_repaired(self):
        self.benchmark()
        rows = self.rows()
        self.assertEqual(list(rows), ["kiss_icp", "semantic_kiss", "true_labels"])
        for name, row in rows.items():
            self.assertEqual((row["sequence"], row["scans"]), ("04", str(SCANS)))
            run = json.loads(read(self.path("out", "runs", name, "04", "0"), "run.json"))
            self.assertAlmostEqual(float(row["ate_3d_m"]), run["metrics"]["ate_3d_m"], places=4)
            self.assertLess(float(row["ate_3d_m"]), 0.5)
        self.check_page()
        self.check_drawn_errors(rows)
        # Both drives were made, one after the other, and are gone.
        left = [files for _, _, files in os.walk(self.path("out", "drives")) if files]
        self.assertEqual(left, [])
        self.check_resumption(rows)

    def check_drawn_errors(self, rows):
        """What is drawn along the way has the root mean square that the program calls ATE-3D."""
        script = ("import sys; sys.path.insert(0, sys.argv[1]); import trajectories as t\n"
                  "e, h = t.errors(*map(t.read_positions, sys.argv[2:]))\n"
                  "print((e ** 2).mean() ** 0.5, abs(h).max() <= e.max())")
        run = self.path("out", "runs", "kiss_icp", "04", "0")
        answer = subprocess.run(
            ["/usr/bin/python3", "-B", "-c", script, os.path.join(SOURCE, "scripts", "benchmark"),
             os.path.join(run, "trajectory_kitti.txt"), os.path.join(run, "truth_kitti.txt")],
            check=True, capture_output=True, text=True).stdout.split()
        self.assertAlmostEqual(float(answer[0]), float(rows["kiss_icp"]["ate_3d_m"]), places=6)
        self.assertEqual(answer[1], "True")

    def check_page(self):
        text = read(self.path("out", "page"), "README.md").decode()
        self.assertIn("of 04 the first 12 scans alone", text)
        self.assertIn("--seed=5 --sequence=04", text)
        for name in ("`kiss_icp`", "`semantic_kiss`", "true labels"):
            self.assertIn(name, text)
        html = read(self.path("out", "page"), "index.html").decode()
        self.assertTrue(html.endswith("</html>\n"))
        self.assertEqual(html.count("data:image/png;base64,"), 1)
        self.assertTrue(read(self.path("out", "page"), "04.png").startswith(b"\x89PNG"))

    def check_resumption(self, rows):
        cells = {name: self.path("out", "runs", name, "04", "0", "cell.json") for name in rows}
        times = {name: os.stat(path).st_mtime_ns for name, path in cells.items()}
        self.assertIn("Nothing to be done", self.benchmark())
        os.remove(cells["kiss_icp"])
        self.benchmark()
        for name, path in cells.items():
            self.assertEqual(os.stat(path).st_mtime_ns == times[name], name != "kiss_icp", name)
        self.assertEqual(self.rows()["kiss_icp"]["ate_3d_m"], rows["kiss_icp"]["ate_3d_m"])
        # Of another length every record tells of other flags.
        self.benchmark(f"--num_scans={SCANS + 1}")
        self.assertEqual({row["scans"] for row in self.rows().values()}, {str(SCANS + 1)})

    @unittest.skipUnless(HAS_SLURM, "Slurm is not installed: scripts/setup.sh --slurm")
    def test_slurm_comes_to_the_same(self):
        slurm = os.path.join(SOURCE, "scripts", "benchmark", "one_node_slurm.sh")
        subprocess.run([slurm, "start", self.path("slurm")], check=True)
        self.addCleanup(subprocess.run, [slurm, "stop", self.path("slurm")], check=True)
        self.benchmark("--slurm", output="cluster",
                       environment={"SLURM_CONF": self.path("slurm", "slurm.conf"),
                                    "CI": "true"})  # asks every second, not every ten
        logs = [name for name in os.listdir(self.path("cluster")) if name.startswith("slurm-")]
        self.assertEqual(len(logs), 6)  # two drives, three cells, a page
        self.assertIn("true_labels/04: rte_percent None, rte_deg_per_m None, ate_3d_m 0.",
                      self.benchmark("--cell=true_labels/04", output="here"))
        one, other = (json.loads(read(self.path(output, "runs/true_labels/04/0"), "cell.json"))
                      for output in ("cluster", "here"))
        self.assertEqual(one["metrics"], other["metrics"])
        self.assertEqual(one["config_sha256"], other["config_sha256"])

    @unittest.skipUnless(HAS_SLURM, "Slurm is not installed: scripts/setup.sh --slurm")
    def test_a_cluster_that_does_not_start_leaves_no_daemon(self):
        os.mkdir(self.path("bin"))
        with open(self.path("bin", "slurmd"), "w", encoding="utf-8") as file:
            file.write("#!/bin/sh\nexit 1\n")
        os.chmod(self.path("bin", "slurmd"), 0o755)
        result = subprocess.run(
            [os.path.join(SOURCE, "scripts", "benchmark", "one_node_slurm.sh"), "start",
             self.path("slurm")], capture_output=True, text=True, check=False,
            env={**os.environ, "PATH": self.path("bin") + ":" + os.environ["PATH"]})
        self.assertEqual(result.returncode, 1)
        self.assertIn("Slurm does not start; see ", result.stderr)
        self.assertEqual(self.processes_that_name(self.path("slurm")), [])

    def processes_that_name(self, text):
        """Command lines of processes that have the text in theirs or in their environment."""
        named = []
        for process in filter(str.isdigit, os.listdir("/proc")):
            try:
                command, environment = (read("/proc", process, name)
                                        for name in ("cmdline", "environ"))
            except OSError:  # ended meanwhile
                continue
            if text.encode() in command + environment:
                named.append(command)
        return named

    def test_errors_name_cause_and_remedy(self):
        self.assertIn("there is no kis_icp; there are kiss_icp, sage_icp",
                      self.benchmark("--systems=kis_icp", code=1))
        self.assertIn("kiss_icp is no cell; write SYSTEM/SEQUENCE",
                      self.benchmark("--cell=kiss_icp", code=1))
        self.assertIn("--drives=/nowhere: no such directory",
                      self.benchmark("--drives=/nowhere", code=1))


if __name__ == "__main__":
    main()
