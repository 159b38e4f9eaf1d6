#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""`simulate`: small drives with fixed seeds, what `run` makes of them, interruption, bad input."""

import json
import os
import signal
import struct
import time

from program import ProgramTest, main, read, write

DEADLINE_S = 120
# 16 beams, so that a scan takes milliseconds.
SMALL = ["--lidar=vlp16", "--seed=5", "--quiet"]


def files_below(directory):
    return {os.path.relpath(os.path.join(folder, name), directory)
            for folder, _, names in os.walk(directory) for name in names}


class SimulateTest(ProgramTest):

    def simulate(self, *flags, output="drive"):
        return self.succeed("simulate", f"--output={self.path(output)}", *SMALL, *flags)

    def run_on(self, drive, *flags, output="out"):
        self.succeed("run", f"--dataset={self.path(drive)}", f"--output={self.path(output)}",
                     "--quiet", *flags)
        return json.loads(read(self.path(output), "run.json"))

    def test_drives_of_every_kind_are_tracked(self):
        for route, bound_m in (("city", 0.3), ("loop", 0.3), ("highway", 1.5)):
            with self.subTest(route):
                self.simulate(f"--route={route}", "--num_scans=60", output=route)
                run = self.run_on(route, output=route + "_out")
                self.assertEqual(run["scans"], 60)
                self.assertLess(run["metrics"]["ate_3d_m"], bound_m)

    def test_a_shorter_command_leaves_a_longer_drive_whole(self):
        self.simulate("--route=loop", "--num_scans=8")
        before = {name: read(self.path("drive"), name) for name in files_below(self.path("drive"))}
        self.simulate("--route=loop", "--num_scans=3")
        for name, content in before.items():
            self.assertEqual(read(self.path("drive"), name), content, name)

    def test_a_drive_of_a_single_scan_is_refused(self):
        write(self.path("poses.txt"), "".join(f"1 0 0 0 0 1 0 0 0 0 1 {1.5 * i}\n"
                                              for i in range(3)))
        self.fail_with(1, ["fewer than two scans"], "simulate", *SMALL, "--speed_factor=4",
                       f"--poses={self.path('poses.txt')}", f"--output={self.path('drive')}")

    def test_label_noise_comes_with_certainties(self):
        self.simulate("--num_scans=8", output="exact")
        self.simulate("--num_scans=8", "--label_noise=0.1", output="noisy")
        wrong = total = 0
        for scan in range(8):
            names = [f"sequences/00/labels/{scan:06d}.label" for _ in range(2)]
            exact, noisy = (struct.unpack(f"<{len(b) // 4}I", b) for b in
                            (read(self.path("exact"), names[0]), read(self.path("noisy"), names[1])))
            conf = read(self.path("noisy"), f"sequences/00/confidences/{scan:06d}.conf")
            certainties = struct.unpack(f"<{len(conf) // 4}f", conf)
            self.assertEqual(len(exact), len(noisy))
            self.assertEqual(len(exact), len(certainties))
            self.assertGreaterEqual(min(certainties), 0.5)
            self.assertLessEqual(max(certainties), 1.0)
            wrong += sum(a & 0xffff != b & 0xffff for a, b in zip(exact, noisy))
            total += len(exact)
            points = f"sequences/00/velodyne/{scan:06d}.bin"
            self.assertEqual(read(self.path("exact"), points), read(self.path("noisy"), points))
        self.assertGreater(wrong / total, 0.02)
        self.assertLess(wrong / total, 0.3)
        self.run_on("noisy")

    def test_raw_points_come_with_their_times(self):
        self.simulate("--num_scans=30", "--raw")
        times = read(self.path("drive"), "sequences/00/point_times/000007.bin")
        points = read(self.path("drive"), "sequences/00/velodyne/000007.bin")
        self.assertEqual(len(times) * 4, len(points))
        values = struct.unpack(f"<{len(times) // 4}f", times)
        self.assertGreaterEqual(min(values), -0.1)
        self.assertLessEqual(max(values), 0.0)
        self.assertLess(self.run_on("drive")["metrics"]["ate_3d_m"], 0.3)

    def test_bytes_do_not_depend_on_threads(self):
        for threads in (1, 8):
            self.simulate("--num_scans=20", f"--threads={threads}", output=f"drive{threads}")
        names = files_below(self.path("drive1"))
        self.assertEqual(names, files_below(self.path("drive8")))
        for name in names:
            self.assertEqual(read(self.path("drive1"), name), read(self.path("drive8"), name), name)

    def test_draws_the_town(self):
        picture = self.path("town.png")
        self.succeed("simulate", f"--preview={picture}", "--length=100", "--quiet")
        self.assertTrue(read(picture).startswith(b"\x89PNG"))
        self.assertEqual(os.listdir(self.directory), ["town.png"])

    def test_an_interrupted_drive_goes_on(self):
        process = self.start("simulate", f"--output={self.path('drive')}", *SMALL)
        self.addCleanup(process.kill)
        first = self.path("drive", "sequences/00/velodyne/000000.bin")
        deadline = time.monotonic() + DEADLINE_S
        while not os.path.exists(first):
            self.assertIsNone(process.poll(), "the simulation ended by itself")
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        _, problem = process.communicate(timeout=DEADLINE_S)
        self.assertEqual(process.returncode, 130, problem)
        self.assertIn("the same command goes on from there", problem)
        names = files_below(self.path("drive"))
        self.assertFalse([name for name in names if os.path.basename(name).startswith(".")])
        self.assertNotIn("sequences/00/poses.txt", names)
        written = os.stat(first).st_mtime_ns
        scans = len([name for name in names if name.endswith(".bin")])
        self.simulate(f"--num_scans={scans + 3}")
        self.assertEqual(os.stat(first).st_mtime_ns, written)
        self.assertIn("sequences/00/poses.txt", files_below(self.path("drive")))

    def test_errors_name_cause_and_remedy(self):
        out = f"--output={self.path('drive')}"
        self.fail_with(1, ["nothing to do", "--output=DIR", "--preview=FILE"], "simulate")
        self.fail_with(1, ["route.kind", "cty", "did you mean \"city\""], "simulate", out,
                       "--route=cty")
        self.fail_with(1, ["label_noise.share = 0.7", "0.25"], "simulate", out,
                       "--label_noise=0.7")
        self.fail_with(1, ["vlp17", "hdl64, os1_128, vlp16"], "simulate", out, "--lidar=vlp17")
        self.fail_with(1, ["/nowhere/00.txt"], "simulate", out, "--poses=/nowhere/00.txt")
        write(self.path("bad.txt"), "1 0 0\n")
        self.fail_with(1, ["bad.txt"], "simulate", out, f"--poses={self.path('bad.txt')}")
        self.assertFalse(os.path.exists(self.path("drive")))
        self.simulate("--num_scans=1")
        self.fail_with(1, ["simulation.lua", "other options", "another directory"], "simulate",
                       out, "--lidar=vlp16", "--seed=6", "--num_scans=1", "--quiet")
        write(self.path("file"), "")
        self.fail_with(1, ["file", "directory"], "simulate", f"--output={self.path('file')}",
                       "--num_scans=1", "--lidar=vlp16")


if __name__ == "__main__":
    main()
