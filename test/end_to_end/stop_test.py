#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Signals: a run that is told to stop writes what it has; told twice, it leaves no half files."""

import json
import os
import re
import shutil
import signal
import tempfile
import time

from program import RUN_FILES, ProgramTest, main, read
from sequence import Sequence

# Enough that no machine comes to the end before the signal.
NUM_SCANS = 20_000
DEADLINE_S = 60


class StopTest(ProgramTest):

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.data = tempfile.mkdtemp(prefix="semantic_kiss_")
        cls.addClassCleanup(shutil.rmtree, cls.data)
        sequence = Sequence(cls.data, num_scans=2)
        for name in ("times.txt", "poses.txt"):
            os.remove(sequence.file(name))
        # Links to one scan: a car that stands for half an hour.
        for index in range(2, NUM_SCANS):
            for name in ("velodyne/{:06d}.bin", "labels/{:06d}.label"):
                os.link(sequence.file(name.format(1)), sequence.file(name.format(index)))

    def start_driving(self, *flags):
        """Starts a run and returns it when it is in the midst of its scans."""
        process = self.start("run", f"--dataset={self.data}",
                             f"--output={self.path('out')}", *flags)
        self.addCleanup(process.kill)
        deadline = time.monotonic() + DEADLINE_S
        while not os.path.exists(self.path("out")):
            self.assertIsNone(process.poll(), "the run ended by itself")
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)
        time.sleep(0.5)
        return process

    def test_a_signal_stops_the_run_in_good_order(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            process = self.start_driving("--quiet")
            process.send_signal(number)
            output, problem = process.communicate(timeout=DEADLINE_S)
            self.assertEqual(process.returncode, code, problem)
            self.assertEqual(output, "")
            self.assert_one_line(problem, "stopped: ")
            num_scans = int(re.search(rf"after (\d+) of {NUM_SCANS} scans", problem).group(1))
            self.assertGreater(num_scans, 0)
            self.assertEqual(self.assert_only_whole_run_files(self.path("out")), RUN_FILES)
            run = json.loads(read(self.path("out"), "run.json"))
            self.assertEqual((run["scans"], run["scans_available"]), (num_scans, NUM_SCANS))
            for name in ("odometry_kitti.txt", "trajectory_kitti.txt", "trajectory_tum.txt"):
                self.assertEqual(read(self.path("out"), name).count(b"\n"), num_scans)
            self.succeed("info", f"--map={self.path('out', 'map.pbstream')}")

    def test_a_second_signal_ends_it_at_once(self):
        for delay_ms in (0, 1, 3, 10, 30):
            process = self.start_driving("--quiet")
            process.send_signal(signal.SIGINT)
            time.sleep(delay_ms / 1000)
            # Another number than the first, as two of one kind may arrive as one.
            process.send_signal(signal.SIGTERM)
            process.communicate(timeout=DEADLINE_S)
            self.assertIn(process.returncode, (130, 143))
            self.assert_only_whole_run_files(self.path("out"))

    def test_before_the_first_scan_there_is_nothing_to_write(self):
        process = self.start("run", f"--dataset={self.data}", f"--output={self.path('out')}")
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=DEADLINE_S)
        # How far it came is left to chance: the default action of the signal may have met it even
        # before main() did anything.
        self.assertIn(process.returncode, (130, -signal.SIGINT))
        self.assert_only_whole_run_files(self.path("out"))


if __name__ == "__main__":
    main()
