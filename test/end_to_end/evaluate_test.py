#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""`evaluate` on made-up trajectories and, where they are, on published ones."""

import json
import os

from program import ProgramTest, data_directory, main, write

# RTE %, RTE deg/m, ATE-3D m, ATE-2D m of the trajectories in estimates/simple_online, as the
# KITTI development kit and independent code have them.
PUBLISHED = {
    "00": ("0.6667", "0.00345", "4.858", "3.332"), "01": ("0.7749", "0.00113", "2.847", "0.984"),
    "02": ("0.6263", "0.00205", "5.238", "4.618"), "03": ("0.7369", "0.00140", "0.341", "0.270"),
    "04": ("0.4067", "0.00164", "0.328", "0.324"), "05": ("0.3372", "0.00280", "2.288", "1.183"),
    "06": ("0.2613", "0.00099", "0.556", "0.545"), "07": ("0.4706", "0.00444", "0.783", "0.282"),
    "08": ("0.8236", "0.00221", "2.130", "1.294"), "09": ("0.5684", "0.00178", "1.448", "0.828"),
    "10": ("0.6454", "0.00356", "1.027", "0.585"),
}


def along_z(num_poses, step_m):
    """A camera that drives forward."""
    return "".join(f"1 0 0 0 0 1 0 0 0 0 1 {step_m * i}\n" for i in range(num_poses))


def along_x(num_poses, step_m):
    """A lidar that drives forward."""
    return "".join(f"1 0 0 {step_m * i} 0 1 0 0 0 0 1 0\n" for i in range(num_poses))


class EvaluateTest(ProgramTest):

    def evaluate(self, truth, estimate, *flags):
        write(self.path("truth.txt"), truth)
        write(self.path("estimate.txt"), estimate)
        return ["evaluate", f"--ground_truth={self.path('truth.txt')}",
                f"--estimate={self.path('estimate.txt')}", *flags]

    def test_a_scale_error_of_two_per_cent(self):
        arguments = self.evaluate(along_z(200, 1.0), along_z(200, 1.02))
        metrics = json.loads(self.succeed(*arguments, "--json"))
        self.assertEqual(list(metrics), ["rte_percent", "rte_deg_per_m", "ate_3d_m", "ate_2d_m"])
        # A segment ends at the first pose beyond 100 m: 101 m driven, 1 % of 100 m a metre.
        self.assertAlmostEqual(metrics["rte_percent"], 2.02, places=9)
        self.assertAlmostEqual(metrics["rte_deg_per_m"], 0, places=9)
        text = self.succeed(*arguments)
        self.assertIn("2.0200 %", text)
        self.assertIn("200 poses", text)

    def test_figures_that_do_not_exist_are_null(self):
        arguments = self.evaluate(along_z(5, 1.0), along_z(5, 1.0))
        metrics = json.loads(self.succeed(*arguments, "--json"))
        self.assertIsNone(metrics["rte_percent"])
        self.assertIsNone(metrics["rte_deg_per_m"])
        self.assertAlmostEqual(metrics["ate_3d_m"], 0, places=9)
        self.assertIn("RTE        -", self.succeed(*arguments))

    def test_the_calibration_makes_lidar_poses_comparable(self):
        write(self.path("calib.txt"), "Tr: 0 -1 0 0 0 0 -1 0 1 0 0 0\n")
        calib = f"--calib={self.path('calib.txt')}"
        arguments = self.evaluate(along_z(9, 1.0), along_x(9, 1.0), calib, "--json")
        self.assertAlmostEqual(json.loads(self.succeed(*arguments))["ate_3d_m"], 0, places=9)
        # Poses that are the camera's already stay as they are.
        arguments = self.evaluate(along_z(9, 1.0), along_z(9, 1.0), calib, "--json")
        self.assertAlmostEqual(json.loads(self.succeed(*arguments))["ate_3d_m"], 0, places=9)
        self.fail_with(1, ["camera", "lidar", "calib"],
                       *self.evaluate(along_z(9, 1.0), along_x(9, 1.0)))

    def test_a_part_of_the_drive(self):
        arguments = self.evaluate(along_z(20, 1.0), along_z(5, 1.0))
        self.fail_with(1, ["5 poses", "20", "--first_scan"], *arguments)
        self.succeed(*arguments, "--first_scan=0")
        self.succeed(*arguments, "--first_scan=15")
        self.fail_with(1, ["truth.txt", "20"], *arguments, "--first_scan=16")

    def test_bad_files(self):
        self.fail_with(1, ["nowhere.txt"], "evaluate", "--ground_truth=nowhere.txt",
                       "--estimate=nowhere.txt")
        self.fail_with(1, ["estimate.txt:1", "12"], *self.evaluate(along_z(1, 1.0), "1 2 3\n"))
        self.fail_with(1, ["estimate.txt"], *self.evaluate(along_z(1, 1.0), ""))
        self.fail_with(1, ["truth.txt:1", "nan"],
                       *self.evaluate("nan 0 0 0 0 1 0 0 0 0 1 0\n", along_z(1, 1.0)))
        self.fail_with(2, ["--estimate"], "evaluate", "--ground_truth=x")


class PublishedTrajectoriesTest(ProgramTest):

    def test_figures_are_those_of_the_development_kit(self):
        data = os.path.join(data_directory(), "kitti_odometry")
        if not os.path.isdir(data):
            self.skipTest(f"no real data: {data} does not exist (set SEMANTIC_KISS_DATA)")
        for sequence, figures in PUBLISHED.items():
            metrics = json.loads(self.succeed(
                "evaluate", f"--ground_truth={data}/poses/{sequence}.txt",
                f"--estimate={data}/estimates/simple_online/{sequence}.txt", "--json"))
            printed = tuple(f"{metrics[key]:.{decimals}f}" for key, decimals in (
                ("rte_percent", 4), ("rte_deg_per_m", 5), ("ate_3d_m", 3), ("ate_2d_m", 3)))
            self.assertEqual(printed, figures, sequence)


if __name__ == "__main__":
    main()
