#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Loop closure on a simulated ring road that is driven round one and a half times."""

import json
import os
import shutil
import tempfile

from program import REPEATABLE_FILES, ProgramTest, main, read, write
from ring import simulate_ring


class LoopClosureTest(ProgramTest):

    @classmethod
    def setUpClass(cls):
        cls.ring = tempfile.mkdtemp(prefix="semantic_kiss_")
        cls.addClassCleanup(shutil.rmtree, cls.ring)
        simulate_ring(cls.ring)

    def drive(self, config, *flags, output):
        self.succeed("run", f"--config={config}", f"--dataset={self.ring}",
                     f"--output={self.path(output)}", "--quiet", *flags)
        return json.loads(read(self.path(output), "run.json"))

    def numbers(self, output):
        return [float(word) for word in read(self.path(output), "trajectory_kitti.txt").split()]

    def assert_closed_rightly(self, run):
        """Closures with everything that scripts rely on, none of them false, all of the revisit."""
        self.assertGreater(len(run["loop_closures"]), 5)
        for closure in run["loop_closures"]:
            self.assertEqual(
                set(closure),
                {"node", "trajectory", "submap", "submap_trajectory", "by", "score", "overlap",
                 "inlier_ratio", "correction_m", "correction_deg", "true_error_m", "true_error_deg"})
            self.assertLess(closure["true_error_m"], 0.3)
            self.assertLess(closure["true_error_deg"], 1.5)
        # What is found nearby and recognized as well is one closure.
        pairs = [(closure["node"], closure["submap"]) for closure in run["loop_closures"]]
        self.assertEqual(len(set(pairs)), len(pairs))
        search = run["closure_search"]
        self.assertEqual(search["false"], 0)
        self.assertEqual(search["candidates"]["accepted"], len(run["loop_closures"]))
        self.assertGreater(search["revisited_m"], 60)
        self.assertGreater(search["closed_share"], 0.8)
        self.assertEqual(search["optimization"],
                         {"solved": True, "converged": True, "loops_outweighed": 0,
                          "loops": len(run["loop_closures"])})

    def test_an_optimization_that_was_cut_short_is_told(self):
        write(self.path("mine.lua"), 'include "semantic_kiss_6dof.lua"\n'
              "RUN.pose_graph.optimization.max_iterations = 1\nreturn RUN\n")
        summary = self.succeed("run", f"--config={self.path('mine.lua')}",
                               f"--dataset={self.ring}", f"--output={self.path('out')}")
        self.assertIn("the optimization did not converge", summary)

    def test_closing_loops_makes_the_trajectory_better(self):
        odometry = self.drive("semantic_kiss.lua", output="odometry")
        self.assertEqual(odometry["loop_closures"], [])
        self.assertEqual(odometry["closure_search"]["candidates"], {})
        self.assertEqual(odometry["closure_search"]["closed_share"], 0)
        six = self.drive("semantic_kiss_6dof.lua", output="six")
        self.assert_closed_rightly(six)
        self.assertLess(six["metrics"]["ate_3d_m"], odometry["metrics"]["ate_3d_m"])
        # The odometry is the same; what differs is what the map makes of it.
        name = "odometry_kitti.txt"
        self.assertEqual(read(self.path("odometry"), name), read(self.path("six"), name))
        info = json.loads(self.succeed("info", f"--map={self.path('six', 'map.pbstream')}",
                                       "--json"))
        self.assertIn(str(len(six["loop_closures"])), json.dumps(info))

    def test_in_the_plane_heights_stay(self):
        run = self.drive("semantic_kiss_loop_closure.lua", output="three")
        self.assert_closed_rightly(run)
        heights = [[float(line.split()[7]) for line in read(self.path("three"), name).splitlines()]
                   for name in ("odometry_kitti.txt", "trajectory_kitti.txt")]
        for of_odometry, of_map in zip(*heights):
            # The camera is not mounted quite level.
            self.assertAlmostEqual(of_odometry, of_map, delta=1e-3)

    def test_the_baseline_in_the_plane_closes_the_loop(self):
        odometry = self.drive("cartographer.lua", output="grids")
        self.assertEqual(odometry["loop_closures"], [])
        closed = self.drive("cartographer_loop_closure.lua", output="closed_grids")
        self.assert_closed_rightly(closed)
        self.assertEqual({closure["by"] for closure in closed["loop_closures"]}, {"nearby"})
        self.assertLess(closed["metrics"]["ate_2d_m"], odometry["metrics"]["ate_2d_m"])
        # Without labels the odometry is the same; the back end does not drop what is seen to move.
        self.drive("cartographer_loop_closure.lua", "--labels_dir=none", output="unlabeled")
        name = "odometry_kitti.txt"
        self.assertEqual(read(self.path("closed_grids"), name), read(self.path("unlabeled"), name))
        for labeled, unlabeled in zip(self.numbers("closed_grids"), self.numbers("unlabeled")):
            self.assertAlmostEqual(labeled, unlabeled, delta=0.05)

    def test_threads_change_nothing(self):
        for threads in (1, 2, 8):
            self.drive("semantic_kiss_6dof.lua", f"--threads={threads}", output=f"out{threads}")
        for name in REPEATABLE_FILES:
            first = read(self.path("out1"), name)
            self.assertEqual(first, read(self.path("out2"), name), name)
            self.assertEqual(first, read(self.path("out8"), name), name)


if __name__ == "__main__":
    main()
