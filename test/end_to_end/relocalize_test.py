#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""The life of a map: made on one day, cleaned, localized in on another, continued, merged."""

import hashlib
import json
import os

from program import ProgramTest, main, read, write
from ring import simulate_ring


def sha256(path):
    with open(path, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


class MapLifeTest(ProgramTest):

    def simulate(self, name, *flags):
        """A drive in the town of the ring."""
        self.succeed("simulate", f"--config={self.path('day0', 'ring.lua')}",
                     f"--output={self.path(name)}", "--quiet", *flags)

    def setUp(self):
        super().setUp()
        os.makedirs(self.path("day0"))
        simulate_ring(self.path("day0"), ring_m=200., length_m=220.)
        self.succeed("run", "--config=semantic_kiss_6dof.lua", f"--dataset={self.path('day0')}",
                     f"--output={self.path('map')}", "--quiet")
        self.map = self.path("lasting.pbstream")
        self.succeed("filter", f"--map={self.path('map', 'map.pbstream')}",
                     f"--output={self.map}", "--remove_role=movable", "--quiet")
        self.simulate("day1", "--epoch=1", "--lane_offset=0.4", "--speed_factor=1.3")

    def relocalize(self, output, *flags, data="day1"):
        self.succeed("relocalize", f"--map={self.map}", f"--dataset={self.path(data)}",
                     f"--map_ground_truth={self.path('day0', 'sequences', '00')}",
                     f"--output={self.path(output)}", "--quiet", *flags)
        return json.loads(read(self.path(output), "relocalization.json"))

    def test_another_day_finds_its_place(self):
        before = sha256(self.map)
        found = self.relocalize("anywhere", "--first_scan=60", "--threads=1")
        self.assertEqual((found["map_sha256_before"], found["map_sha256_after"]), (before, before))
        self.assertEqual(sha256(self.map), before)
        self.assertLessEqual(found["first_fix_after_scans"], 50)
        self.assertEqual(found["first_fix_scan"], 60 + found["first_fix_after_scans"])
        self.assertEqual(found["metrics"]["wrong_places"], 0)
        self.assertLess(found["metrics"]["position_error_median_m"], 0.15)
        self.assertLess(found["metrics"]["heading_error_median_deg"], 0.3)
        self.assertEqual([event["state"] for event in found["events"]], ["searching", "localized"])
        self.assertEqual(len(found["poses"]), found["scans"])
        localized = sum(pose["localized"] for pose in found["poses"])
        for name in ("relocalization_kitti.txt", "relocalization_tum.txt"):
            self.assertEqual(len(read(self.path("anywhere"), name).splitlines()), localized)
        # What came before the fix is known in the end.
        smoothed = read(self.path("anywhere"), "smoothed_tum.txt").splitlines()
        self.assertEqual(len(smoothed), found["scans"])

        again = self.relocalize("again", "--first_scan=60", "--threads=3")
        for name in ("relocalization_kitti.txt", "relocalization_tum.txt", "smoothed_tum.txt"):
            self.assertEqual(read(self.path("anywhere"), name), read(self.path("again"), name))
        self.assertEqual(again["poses"], found["poses"])

    def test_a_known_start_is_enough_and_a_bad_one_is_refused(self):
        known = self.relocalize("known", "--initial_pose=1,1,3", "--num_scans=60")
        self.assertEqual(known["poses"][0]["scan"], 0)
        # The next node agrees with the first; no submap has to be finished.
        self.assertLessEqual(known["first_fix_after_scans"], 15)
        self.assertEqual(known["metrics"]["wrong_places"], 0)
        self.fail_with(1, ["--initial_pose", "three"], "relocalize", f"--map={self.map}",
                       f"--dataset={self.path('day1')}", f"--output={self.path('bad')}",
                       "--initial_pose=1,2")
        self.fail_with(1, ["--initial_pose", "finite"], "relocalize", f"--map={self.map}",
                       f"--dataset={self.path('day1')}", f"--output={self.path('bad')}",
                       "--initial_pose=nan,0,0")
        for far in ("0,0,1e308", "1e308,0,0", "0,-2e7,0"):
            self.fail_with(1, [f"--initial_pose={far}", "out of range"], "relocalize",
                           f"--map={self.map}", f"--dataset={self.path('day1')}",
                           f"--output={self.path('bad')}", f"--initial_pose={far}")
        self.fail_with(1, ["optimize_every_n_nodes"], "relocalize", f"--map={self.map}",
                       f"--dataset={self.path('day1')}", f"--output={self.path('bad')}",
                       "--config=semantic_kiss.lua")
        # Known before the drive, not after it.
        self.fail_with(1, ["poses.txt"], "relocalize", f"--map={self.map}",
                       f"--dataset={self.path('day1')}", f"--output={self.path('bad')}",
                       f"--map_ground_truth={self.path('day1')}")
        self.assertFalse(os.path.exists(self.path("bad")))

    def test_scans_are_numbered_as_the_files_are(self):
        folder = self.path("day1", "sequences", "00", "velodyne")
        for scan in range(60):
            os.remove(os.path.join(folder, f"{scan:06d}.bin"))
        found = self.relocalize("late", "--num_scans=50")
        self.assertEqual([pose["scan"] for pose in found["poses"]], list(range(60, 110)))
        self.assertEqual(found["events"][0]["scan"], 60)
        self.assertEqual(found["first_fix_scan"], 60 + found["first_fix_after_scans"])

    def test_a_map_is_not_replaced_by_what_goes_on_with_it(self):
        before = sha256(self.path("map", "map.pbstream"))
        self.fail_with(1, ["is the map itself"], "run", "--config=semantic_kiss_6dof.lua",
                       f"--map={self.path('map', 'map.pbstream')}",
                       f"--dataset={self.path('day1')}", f"--output={self.path('map')}")
        self.assertEqual(sha256(self.path("map", "map.pbstream")), before)

    def test_a_kidnapped_vehicle_says_so_and_is_found_again(self):
        source, jumping = (self.path(name, "sequences", "00") for name in ("day1", "jumping"))
        # From one side of the ring to the other within a scan.
        scans = list(range(0, 60)) + list(range(110, 165))
        for folder, ending in (("velodyne", "bin"), ("labels", "label"), ("confidences", "conf")):
            os.makedirs(os.path.join(jumping, folder))
            for i, scan in enumerate(scans):
                os.symlink(os.path.join(source, folder, f"{scan:06d}.{ending}"),
                           os.path.join(jumping, folder, f"{i:06d}.{ending}"))
        poses = read(source, "poses.txt").splitlines()
        write(os.path.join(jumping, "poses.txt"), b"".join(poses[scan] + b"\n" for scan in scans))
        write(os.path.join(jumping, "times.txt"),
              "".join(f"{0.1 * i:e}\n" for i in range(len(scans))))
        write(os.path.join(jumping, "calib.txt"), read(source, "calib.txt"))

        found = self.relocalize("kidnapped", data="jumping")
        states = [event["state"] for event in found["events"]]
        self.assertEqual(states[:3], ["searching", "localized", "lost"])
        self.assertEqual(states[-1], "localized")
        lost = found["events"][2]
        self.assertGreaterEqual(lost["scan"], 60)
        self.assertLessEqual(lost["scan"], 90)
        self.assertNotEqual(lost["reason"], "")
        for pose in found["poses"][:60] + found["poses"][-5:]:
            if pose["localized"]:
                self.assertLess(pose["position_error_m"], 0.5)

    def test_elsewhere_nothing_is_claimed(self):
        self.simulate("elsewhere", "--seed=99", "--route=city", "--length=90")
        lost = self.relocalize("lost", data="elsewhere")
        self.assertIsNone(lost["first_fix_scan"])
        self.assertEqual({pose["state"] for pose in lost["poses"]}, {"searching"})
        self.assertNotEqual(lost["poses"][-1]["reason"], "")
        self.fail_with(1, ["nothing joins them"], "run", "--config=semantic_kiss_6dof.lua",
                       f"--map={self.map}", f"--dataset={self.path('elsewhere')}",
                       f"--output={self.path('apart')}", "--quiet")

    def test_drives_are_joined(self):
        self.succeed("run", "--config=semantic_kiss_6dof.lua", f"--map={self.map}",
                     f"--dataset={self.path('day1')}", f"--output={self.path('both')}", "--quiet")
        both = json.loads(self.succeed("info", f"--map={self.path('both', 'map.pbstream')}",
                                       "--json"))
        self.assertEqual(len(both["trajectories"]), 2)
        self.assertIn("added trajectory 1", both["history"][-1])

        self.succeed("run", "--config=semantic_kiss_6dof.lua", f"--dataset={self.path('day1')}",
                     f"--output={self.path('alone')}", "--quiet")
        self.succeed("merge", f"--map={self.map}",
                     f"--other_map={self.path('alone', 'map.pbstream')}",
                     f"--output={self.path('merged.pbstream')}", "--quiet")
        merged = json.loads(self.succeed("info", f"--map={self.path('merged.pbstream')}", "--json"))
        self.assertEqual(len(merged["trajectories"]), 2)
        self.assertIn("closures join the two", merged["history"][-1])


if __name__ == "__main__":
    main()
