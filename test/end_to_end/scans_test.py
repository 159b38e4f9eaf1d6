#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""The scans of a map, taken out again: driven anew, and localized in a map of other makers."""

import array
import json
import os

from program import ProgramTest, data_directory, main, read

WITHOUT_LOOPS = "include \"semantic_kiss.lua\"\nRUN.dataset.vertical_correction_deg = 0.0\n"


class ScansTest(ProgramTest):

    def test_a_drive_comes_out_as_it_went_in(self):
        drive, out = self.path("drive"), self.path("out")
        self.succeed("simulate", "--route=loop", "--length=200", "--lidar=vlp16", "--num_scans=30",
                     "--label_noise=0.06", f"--output={drive}", "--quiet")
        self.succeed("run", f"--dataset={drive}", f"--output={out}", "--quiet")
        map_file, taken = os.path.join(out, "map.pbstream"), self.path("taken")
        self.succeed("scans", f"--map={map_file}", f"--output={taken}", "--sequence=05", "--quiet")
        sequence = os.path.join(taken, "sequences", "05")
        info = json.loads(self.succeed("info", f"--map={map_file}", "--json"))
        nodes = sum(trajectory["nodes"] for trajectory in info["trajectories"])
        self.assertGreater(nodes, 5)
        for folder, ending, bytes_a_point in (("velodyne", "bin", 16), ("labels", "label", 4),
                                              ("confidences", "conf", 4)):
            self.assertEqual(len(os.listdir(os.path.join(sequence, folder))), nodes)
            self.assertGreater(len(read(sequence, folder, f"000000.{ending}")), bytes_a_point * 100)
        # The same classes, merged as the label set says; the same times to the microsecond.
        words = array.array("I", read(sequence, "labels", "000000.label"))
        given = array.array("I", read(drive, "sequences", "00", "labels", "000000.label"))
        self.assertLessEqual(set(words), {word & 0xffff for word in given} | {0})
        self.assertGreater(len(set(words)), 3)
        times = [float(line) for line in read(sequence, "times.txt").split()]
        first = [float(line) for line in read(drive, "sequences", "00", "times.txt").split()]
        for time in times:
            self.assertLess(min(abs(time - other) for other in first), 1e-6)
        # A drive through them finds the way that poses.txt has from the map.
        with open(self.path("level.lua"), "w") as file:
            file.write(WITHOUT_LOOPS + "return RUN\n")
        self.succeed("run", f"--config={self.path('level.lua')}", f"--dataset={taken}",
                     "--sequence=05", f"--output={self.path('anew')}", "--quiet")
        run = json.loads(read(self.path("anew"), "run.json"))
        self.assertEqual(run["scans"], nodes)
        self.assertLess(run["metrics"]["ate_3d_m"], 0.1)

    def test_what_is_there_is_left_alone(self):
        os.makedirs(self.path("out", "sequences", "00"))
        self.fail_with(1, ["sequences/00", "already"], "scans", f"--map={self.path('x.pbstream')}",
                       f"--output={self.path('out')}")

    def test_nothing_is_written_elsewhere_or_by_halves(self):
        for sequence in ("../../elsewhere", "..", "a/b"):
            for command in (["scans", f"--map={self.path('x.pbstream')}"], ["simulate"]):
                self.fail_with(1, ["name of a sequence"], *command, f"--sequence={sequence}",
                               f"--output={self.path('out')}")
        self.assertEqual(os.listdir(self.path()), [])
        self.succeed("simulate", "--route=loop", "--length=60", "--lidar=vlp16", "--num_scans=12",
                     f"--output={self.path('drive')}", "--quiet")
        self.succeed("run", f"--dataset={self.path('drive')}", f"--output={self.path('run')}",
                     "--quiet")
        sequences = self.path("out", "sequences")
        os.makedirs(os.path.join(sequences, "00.partial", "velodyne"))
        # What a program left that was killed is no obstacle.
        self.succeed("scans", f"--output={self.path('out')}", "--quiet",
                     f"--map={self.path('run', 'map.pbstream')}")
        self.assertEqual(os.listdir(sequences), ["00"])
        self.fail_with(1, ["too long"], "scans", f"--map={self.path('run', 'map.pbstream')}",
                       f"--output={'x' * 300}")

    def test_scans_of_a_building_in_cartographers_map_of_it(self):
        stock = os.path.join(data_directory(), "pbstream", "stock_aces.pbstream")
        if not os.path.exists(stock):
            self.skipTest(f"no real data: {stock} does not exist (set SEMANTIC_KISS_DATA)")
        taken = self.path("taken")
        self.succeed("scans", f"--map={stock}", f"--output={taken}", "--quiet")
        self.fail_with(1, ["trajectories", "--trajectory"], "scans", f"--map={stock}",
                       f"--output={self.path('other')}", "--trajectory=7")
        for start in (300, 800):
            out = self.path(f"from_{start}")
            self.succeed("relocalize", f"--map={stock}", "--config=relocalize_in_plane.lua",
                         f"--dataset={taken}", f"--first_scan={start}", "--num_scans=50",
                         f"--map_ground_truth={taken}/sequences/00", f"--output={out}", "--quiet")
            found = json.loads(read(out, "relocalization.json"))
            self.assertLessEqual(found["first_fix_after_scans"], 50)
            self.assertEqual(found["metrics"]["wrong_places"], 0)
            self.assertLess(found["metrics"]["position_error_median_m"], 0.25)
            self.assertEqual(found["map_sha256_before"], found["map_sha256_after"])


if __name__ == "__main__":
    main()
