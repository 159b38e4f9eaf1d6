#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""`run --trace_scan`: does it tell what became of a scan's points, and leave the results alone?"""

import json
import math
import os
import shutil
import struct
import subprocess
import tempfile
from collections import Counter

from program import BINARY, REPEATABLE_FILES, ProgramTest, main, read
from ring import simulate_ring

SCANS = (0, 105)
MAX_RANGE_M = 40


class TraceTest(ProgramTest):

    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.mkdtemp(prefix="semantic_kiss_")
        cls.addClassCleanup(shutil.rmtree, cls.work)
        simulate_ring(cls.work, ring_m=150., length_m=200., scan_rate_hz=5.)
        with open(os.path.join(cls.work, "near.lua"), "w") as file:
            file.write('local options = include "semantic_kiss_6dof.lua"\n'
                       "local odometry = options.local_trajectory_builder.semantic_kiss.odometry\n"
                       f"odometry.preprocessing.max_range_m = {MAX_RANGE_M}\nreturn options\n")
        cls.plain = os.path.join(cls.work, "plain")
        cls.traced = os.path.join(cls.work, "traced")
        arguments = [BINARY, "run", f"--config={cls.work}/near.lua", f"--dataset={cls.work}"]
        subprocess.run([*arguments, f"--output={cls.plain}", "--quiet"], check=True)
        cls.text = subprocess.run(
            [*arguments, f"--output={cls.traced}", "--trace_scan=" + ",".join(map(str, SCANS))],
            check=True, text=True, stdout=subprocess.PIPE).stdout
        traces = json.loads(read(cls.traced, "run.json"))["traces"]
        cls.traces = {trace["scan"]: trace for trace in traces}

    def steps(self, scan):
        return {step["stage"]: step for step in self.traces[scan]["steps"]}

    def points(self, scan):
        """What the files have: (range, name of the class or None if it is no moving one)."""
        path = os.path.join(self.work, "sequences", "00")
        points = list(struct.iter_unpack("<4f", read(path, "velodyne", f"{scan:06d}.bin")))
        labels = [label & 0xffff for (label,) in
                  struct.iter_unpack("<I", read(path, "labels", f"{scan:06d}.label"))]
        return [(math.sqrt(x * x + y * y + z * z), label)
                for (x, y, z, _), label in zip(points, labels)]

    def test_changes_no_result(self):
        for name in REPEATABLE_FILES:
            self.assertEqual(read(self.plain, name), read(self.traced, name), name)
        self.assertEqual(json.loads(read(self.plain, "run.json"))["traces"], [])

    def test_every_step_takes_what_another_one_gave(self):
        for scan in SCANS:
            steps = self.steps(scan)
            self.assertEqual(len(steps), len(self.traces[scan]["steps"]))
            self.assertIsNone(steps["reading"]["from"])
            chained = 0
            for step in steps.values():
                if step["from"] is None:
                    self.assertIsNone(step["points_in"])
                    continue
                chained += 1
                self.assertEqual(step["points_in"], steps[step["from"]]["points_out"],
                                 step["stage"])
                self.assertLessEqual(step["points_out"], step["points_in"])
            self.assertGreaterEqual(chained, 9)
            for step in steps.values():
                if step["labels"]:
                    self.assertEqual(sum(step["labels"].values()), step["points_out"],
                                     step["stage"])

    def test_tells_what_the_files_have(self):
        for scan in SCANS:
            points = self.points(scan)
            steps = self.steps(scan)
            self.assertEqual(steps["reading"]["points_out"], len(points))
            near = [label for distance, label in points if 0 < distance < MAX_RANGE_M]
            self.assertLess(len(near), len(points))
            self.assertEqual(steps["range"]["points_out"], len(near))
            moving = sum(label >= 250 for label in near)
            self.assertEqual(steps["moving"]["points_out"], len(near) - moving)
            road = Counter(near)[40]
            self.assertGreater(road, 0)
            # Lane markings are road as well.
            self.assertEqual(steps["range"]["labels"]["road"], road + Counter(near)[60])

    def test_tells_how_the_scan_was_placed(self):
        first, later = (self.steps(scan) for scan in SCANS)
        self.assertIn("first", first["registration"]["outcome"])
        self.assertRegex(first["closures"]["outcome"], r"\d+ of \d+ candidates accepted")
        self.assertRegex(later["registration"]["outcome"], r"converged in \d+ iterations")
        self.assertGreater(later["registration"]["points_out"],
                           0.5 * later["registration"]["points_in"])
        self.assertIn("sigma", later["prediction"]["outcome"])
        self.assertIn("closures", later)
        with open(os.path.join(self.traced, "trajectory_tum.txt")) as file:
            x, y = file.readlines()[SCANS[1]].split()[1:3]
        self.assertIn(f"x {float(x):.2f}, y {float(y):.2f}, ", later["place"]["outcome"])

    def test_is_printed_as_a_table(self):
        for scan in SCANS:
            self.assertIn(f"The way of scan {scan}\n", self.text)
            for step in self.traces[scan]["steps"]:
                self.assertRegex(self.text, rf"\n  {step['stage']} +{step['frame']} +")

    def test_quiet_prints_nothing(self):
        self.assertEqual(self.succeed("run", f"--dataset={self.work}", "--num_scans=3", "--quiet",
                                      f"--output={self.path('out')}", "--trace_scan=1"), "")

    def test_the_planar_builder_is_traced_too(self):
        self.succeed("run", "--config=cartographer.lua", f"--dataset={self.work}", "--num_scans=3",
                     f"--output={self.path('out')}", "--trace_scan=2", "--quiet")
        trace, = json.loads(read(self.path("out"), "run.json"))["traces"]
        steps = {step["stage"]: step for step in trace["steps"]}
        self.assertIn("matching", steps)
        self.assertEqual(steps["height band"]["points_in"], steps["reading"]["points_out"])

    def test_scans_that_are_not_driven_through_are_refused(self):
        flags = (f"--dataset={self.work}", f"--output={self.path('out')}", "--first_scan=3",
                 "--num_scans=4", "--quiet")
        for scan in (2, 7):
            self.fail_with(1, ["--trace_scan", f"scan {scan} ", "from 3 to 6"], "run", *flags,
                           f"--trace_scan={scan}")
        self.fail_with(1, ["--trace_scan", "`x`"], "run", *flags, "--trace_scan=4,x")


if __name__ == "__main__":
    main()
