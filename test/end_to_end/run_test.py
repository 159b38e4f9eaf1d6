#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""`run` on a small drive: its files, what they say, and that they do not depend on threads."""

import json
import os
import re

from program import REPEATABLE_FILES, RUN_FILES, ProgramTest, main, read
from sequence import STEP_M, Sequence


def kitti_poses(path):
    with open(path) as file:
        return [[float(number) for number in line.split()] for line in file]


class RunTest(ProgramTest):

    def drive(self, *flags, output="out"):
        return self.succeed("run", f"--dataset={self.directory}",
                            f"--output={self.path(output)}", *flags)

    def test_writes_every_file(self):
        Sequence(self.directory)
        summary = self.drive()
        self.assertEqual(sorted(os.listdir(self.path("out"))), RUN_FILES)
        self.assert_only_whole_run_files(self.path("out"))
        self.assertIn("6, ", summary)
        self.assertIn(self.path("out"), summary)

    def test_finds_the_trajectory_in_the_cameras_frame(self):
        Sequence(self.directory)
        self.drive("--quiet")
        for name in ("odometry_kitti.txt", "trajectory_kitti.txt"):
            poses = kitti_poses(self.path("out", name))
            self.assertEqual(len(poses), 6)
            for i, pose in enumerate(poses):
                self.assertAlmostEqual(pose[11], STEP_M * i, delta=0.1)  # z: forward
                self.assertAlmostEqual(pose[3], 0, delta=0.1)
        with open(self.path("out", "trajectory_tum.txt")) as file:
            last = [float(number) for number in file.readlines()[-1].split()]
        self.assertAlmostEqual(last[0], 0.5, places=6)
        self.assertAlmostEqual(last[1], STEP_M * 5, delta=0.1)  # x: the lidar's forward

    def test_without_a_calibration_poses_are_the_lidars(self):
        sequence = Sequence(self.directory)
        for name in ("calib.txt", "poses.txt"):
            os.remove(sequence.file(name))
        self.drive("--quiet")
        self.assertAlmostEqual(kitti_poses(self.path("out", "trajectory_kitti.txt"))[-1][3],
                               STEP_M * 5, delta=0.1)
        metrics = json.loads(read(self.path("out"), "run.json"))["metrics"]
        self.assertEqual(set(metrics.values()), {None})

    def test_run_json_has_what_scripts_rely_on(self):
        Sequence(self.directory)
        self.drive("--quiet")
        run = json.loads(read(self.path("out"), "run.json"))
        for key in ("version", "config", "scans", "stages", "scans_per_second", "peak_memory_mib",
                    "odometry_outcomes", "loop_closures", "metrics"):
            self.assertIn(key, run)
        self.assertEqual(run["scans"], 6)
        self.assertEqual(sum(run["odometry_outcomes"].values()), 6)
        for stage in ("reading", "odometry", "submaps", "map_file", "map_image"):
            self.assertEqual(set(run["stages"][stage]), {"median_ms", "p95_ms", "total_s"})
        self.assertEqual(set(run["metrics"]),
                         {"rte_percent", "rte_deg_per_m", "ate_3d_m", "ate_2d_m"})
        self.assertIsNone(run["metrics"]["rte_percent"])  # under 100 m
        self.assertLess(run["metrics"]["ate_3d_m"], 0.1)
        self.assertGreater(run["peak_memory_mib"], 1)

    def test_the_report_needs_no_other_file(self):
        Sequence(self.directory)
        self.drive("--quiet")
        report = read(self.path("out"), "report.html").decode()
        self.assertIn("data:image/png;base64,", report)
        self.assertIn("default-src 'none'", report)  # browsers are told to load nothing
        self.assertIsNone(re.search(r'(\bsrc|<link[^>]*href)="(?!data:)', report))
        self.assertIn("pose_graph", report)

    def test_takes_a_part_of_the_sequence(self):
        Sequence(self.directory)
        self.drive("--first_scan=2", "--num_scans=3", "--quiet")
        self.assertEqual(len(kitti_poses(self.path("out", "trajectory_kitti.txt"))), 3)
        with open(self.path("out", "trajectory_tum.txt")) as file:
            self.assertAlmostEqual(float(file.readline().split()[0]), 0.2, places=6)

    def test_drives_without_labels(self):
        Sequence(self.directory)
        self.drive("--labels_dir=none", "--config=kiss_icp.lua", "--quiet")
        self.assertAlmostEqual(kitti_poses(self.path("out", "trajectory_kitti.txt"))[-1][11],
                               STEP_M * 5, delta=0.1)

    def test_unlisted_labels_are_counted(self):
        sequence = Sequence(self.directory)
        labels = bytearray(read(sequence.file("labels/000001.label")))
        labels[0:4] = (777).to_bytes(4, "little")
        sequence.write("labels/000001.label", bytes(labels))
        summary = self.drive()
        self.assertIn("id 777: 1 points", summary)
        run = json.loads(read(self.path("out"), "run.json"))
        self.assertEqual(run["unknown_label_ids"], {"777": 1})

    def test_results_do_not_depend_on_threads_nor_on_the_time(self):
        Sequence(self.directory, num_scans=25)
        for threads in (1, 2, 8):
            self.drive(f"--threads={threads}", "--quiet", output=f"out{threads}")
        for name in REPEATABLE_FILES:
            first = read(self.path("out1"), name)
            self.assertTrue(first)
            self.assertEqual(first, read(self.path("out2"), name), name)
            self.assertEqual(first, read(self.path("out8"), name), name)

    def test_a_second_run_replaces_the_first(self):
        Sequence(self.directory)
        self.drive("--num_scans=2", "--quiet")
        self.drive("--quiet")
        self.assertEqual(sorted(os.listdir(self.path("out"))), RUN_FILES)
        self.assertEqual(json.loads(read(self.path("out"), "run.json"))["scans"], 6)

    def test_progress_goes_to_stderr_and_quiet_silences_all(self):
        Sequence(self.directory)
        flags = ["run", f"--dataset={self.directory}", f"--output={self.path('out')}"]
        result = self.run_program(*flags)
        self.assertIn("6/6 scans", result.stderr)
        self.assertNotIn("\r", result.stderr)
        result = self.run_program(*flags, "--quiet")
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))

    def test_scans_without_overlap_or_points_are_survived(self):
        sequence = Sequence(self.directory)
        sequence.write("velodyne/000002.bin", b"")
        sequence.write("labels/000002.label", b"")
        sequence.write("velodyne/000003.bin", b"\x00\x00\xc0\x7f" * 40)  # ten NaN points
        sequence.write("labels/000003.label", b"\0" * 40)
        self.drive("--quiet")
        run = json.loads(read(self.path("out"), "run.json"))
        self.assertEqual(run["scans"], 6)
        self.assertGreater(len(run["odometry_outcomes"]), 2)

    def test_names_need_not_be_utf8(self):
        dataset = os.path.join(os.fsencode(self.directory), b"data_\xff")
        Sequence(os.fsdecode(dataset))
        self.succeed("run", b"--dataset=" + dataset, f"--output={self.path('out')}", "--quiet")
        self.assertEqual(sorted(os.listdir(self.path("out"))), RUN_FILES)
        notes = json.loads(read(self.path("out"), "run.json"))["notes"]
        self.assertIn("data_\ufffd", " ".join(notes))

    def test_a_drive_that_is_lost_is_written_and_compared(self):
        sequence = Sequence(self.directory)
        # As far as the odometry, but along another axis.
        sequence.write("poses.txt", "".join(f"1 0 0 {STEP_M * i} 0 1 0 0 0 0 1 0\n"
                                            for i in range(sequence.num_scans)))
        summary = self.drive()
        self.assertIn("another axis than the ground truth", summary)
        self.assertEqual(sorted(os.listdir(self.path("out"))), RUN_FILES)
        run = json.loads(read(self.path("out"), "run.json"))
        self.assertGreater(run["metrics"]["ate_3d_m"], 0.)


if __name__ == "__main__":
    main()
