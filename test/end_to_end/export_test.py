#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""`render` as an exporter: occupancy grids, point clouds and trajectories of a small drive."""

import json
import os
import struct

from picture import read_pgm
from program import ProgramTest, data_directory, main, read, write
from sequence import BUILDING, CAR, POLE, ROAD, Sequence, TRUNK

PLY_TYPES = {"float": "f", "uchar": "B", "ushort": "H"}


def read_ply(content):
    """A list of points, each a dictionary."""
    header, body = content.split(b"end_header\n", 1)
    lines = header.decode().splitlines()
    assert lines[:2] == ["ply", "format binary_little_endian 1.0"]
    count = next(int(line.split()[2]) for line in lines if line.startswith("element vertex"))
    fields = [line.split()[1:] for line in lines if line.startswith("property")]
    layout = struct.Struct("<" + "".join(PLY_TYPES[kind] for kind, _ in fields))
    assert len(body) == count * layout.size
    return [dict(zip((name for _, name in fields), values)) for values in layout.iter_unpack(body)]


def read_pcd(content):
    header, body = content.split(b"DATA binary\n", 1)
    lines = dict(line.split(" ", 1) for line in header.decode().splitlines() if line[0] != "#")
    names = lines["FIELDS"].split()
    # The colour is called a float, but is an integer.
    kinds = ["I" if name == "rgb" else {"F": "f", "U": "I"}[kind]
             for name, kind in zip(names, lines["TYPE"].split())]
    assert set(lines["SIZE"].split()) == {"4"} and set(lines["COUNT"].split()) == {"1"}
    assert int(lines["WIDTH"]) * int(lines["HEIGHT"]) == int(lines["POINTS"])
    layout = struct.Struct("<" + "".join(kinds))
    assert len(body) == int(lines["POINTS"]) * layout.size
    return [dict(zip(names, values)) for values in layout.iter_unpack(body)]


class ExportTest(ProgramTest):

    def setUp(self):
        super().setUp()
        Sequence(self.path("data"), num_scans=8)
        self.map = self.path("out", "map.pbstream")
        self.succeed("run", f"--dataset={self.path('data')}", f"--output={self.path('out')}",
                     "--quiet")

    def render(self, name, *flags):
        self.succeed("render", f"--map={self.map}", f"--output={self.path(name)}", *flags)
        return read(self.path(name))

    def refuse(self, words, name, *flags):
        self.fail_with(1, words, "render", f"--map={self.map}", f"--output={self.path(name)}",
                       *flags)
        self.assertFalse(os.path.exists(self.path(name)))


class OccupancyGridTest(ExportTest):

    def grid(self, *flags):
        """A function that tells the value at a place in the map."""
        width, height, rows = read_pgm(self.render("grid.pgm", *flags))
        self.yaml = dict(line.split(": ") for line in
                         read(self.path("grid.yaml")).decode().splitlines())
        resolution = float(self.yaml["resolution"])
        origin = json.loads(self.yaml["origin"])

        def value(x, y):
            column, row = int((x - origin[0]) / resolution), int((y - origin[1]) / resolution)
            self.assertTrue(0 <= column < width and 0 <= row < height)
            return rows[height - 1 - row][column]
        return value

    def test_it_is_a_map_of_ros(self):
        value = self.grid()
        self.assertEqual(self.yaml["image"], '"grid.pgm"')
        self.assertEqual(self.yaml["mode"], "trinary")
        self.assertEqual(self.yaml["negate"], "0")
        self.assertEqual(self.yaml["resolution"], "0.2")
        self.assertEqual(json.loads(self.yaml["origin"])[2], 0)
        occupied, free = float(self.yaml["occupied_thresh"]), float(self.yaml["free_thresh"])
        self.assertGreater((255 - 0) / 255, occupied)
        self.assertLess((255 - 254) / 255, free)
        self.assertTrue(free < (255 - 205) / 255 < occupied)
        # The road is free, behind the houses nothing is known.
        # The road has few points, and so holes.
        road = [value(x, 0.1 * y) for x in range(-5, 10) for y in range(-20, 20)]
        self.assertLessEqual(set(road), {254, 205})
        self.assertIn(254, road)
        self.assertEqual({value(x, y) for x in range(-5, 10) for y in (-13, 13)}, {205})
        self.assertIn(0, {value(x, 0.2 * y) for x in range(-5, 10) for y in range(36, 60)})

    def test_what_is_an_obstacle_can_be_chosen(self):
        places = [(0.5 * x, side * 0.25 * y) for x in range(-40, 60) for y in range(16, 22)
                  for side in (-1, 1)]

        def occupied(*flags):
            value = self.grid(*flags)
            return {place for place in places if value(*place) == 0}
        with_cars, without_cars = occupied(), occupied("--hide=car")
        self.assertLess(without_cars, with_cars)
        self.assertEqual(occupied("--show=car") | without_cars, with_cars)

    def test_resolution_is_kept_or_refused(self):
        self.grid("--resolution=0.1")
        self.assertEqual(self.yaml["resolution"], "0.1")
        self.refuse(["resolution: ", "0.001 m", "4000 pixels"], "fine.pgm", "--resolution=0.001")
        self.assertFalse(os.path.exists(self.path("fine.yaml")))


class PointCloudTest(ExportTest):

    def test_ply_and_pcd_hold_the_same_points(self):
        ply, pcd = read_ply(self.render("cloud.ply")), read_pcd(self.render("cloud.pcd"))
        self.assertEqual(len(ply), len(pcd))
        for point, same in zip(ply, pcd):
            for name in ("x", "y", "z", "label", "certainty"):
                self.assertEqual(point[name], same[name])
            self.assertEqual(point["red"] << 16 | point["green"] << 8 | point["blue"], same["rgb"])

    def test_points_are_where_and_what_they_are(self):
        points = read_ply(self.render("cloud.ply"))
        self.assertEqual({p["label"] for p in points}, {ROAD, BUILDING, CAR, POLE, TRUNK})
        for point in points:
            self.assertAlmostEqual(point["certainty"], 0.9, delta=1 / 255)
            if point["label"] == ROAD:
                self.assertAlmostEqual(point["z"], -1.7, delta=0.15)
                self.assertLess(abs(point["y"]), 6.2)
            if point["label"] == CAR:
                self.assertTrue(3.8 < abs(point["y"]) < 5.7)

    def test_one_point_in_a_cube(self):
        def thinned(resolution):
            points = read_ply(self.render("cloud.ply", f"--resolution={resolution}"))
            cubes = {tuple(int(p[c] // resolution) for c in "xyz") for p in points}
            return len(points), len(cubes)
        for resolution in (0.5, 2.0):
            number, cubes = thinned(resolution)
            self.assertEqual(number, cubes)
        whole = json.loads(self.succeed("info", f"--map={self.map}", "--json"))["labels"]
        for flag, key in (("--nonode_clouds", "submap_points"), ("--node_clouds", "node_points")):
            points = read_ply(self.render("cloud.ply", "--resolution=0", flag))
            self.assertEqual(len(points), sum(label[key] for label in whole.values()))

    def test_labels_can_be_chosen(self):
        self.assertEqual({p["label"] for p in read_ply(self.render("a.ply", "--show=car,pole"))},
                         {CAR, POLE})
        self.assertEqual({p["label"] for p in read_pcd(self.render("a.pcd", "--hide=car, road"))},
                         {BUILDING, POLE, TRUNK})
        self.refuse(["no points to write"], "b.ply", "--show=fence")
        self.refuse(["show: ", "fense", "fence"], "b.ply", "--show=fense")

    def test_bytes_do_not_depend_on_threads(self):
        self.assertEqual(self.render("a.ply", "--threads=1"), self.render("b.ply", "--threads=3"))


class TrajectoryTest(ExportTest):

    def test_tum_is_what_run_wrote(self):
        written = read(self.path("out", "trajectory_tum.txt"))
        self.assertEqual(self.render("trajectory.tum"), written)
        self.assertEqual(self.render("my_tum.txt"), written)

    def test_kitti_is_of_the_lidar(self):
        rows = [list(map(float, line.split()))
                for line in self.render("trajectory.kitti").decode().splitlines()]
        tum = [list(map(float, line.split()))
               for line in read(self.path("out", "trajectory_tum.txt")).decode().splitlines()]
        self.assertEqual([[row[3], row[7], row[11]] for row in rows], [row[1:4] for row in tum])
        self.assertEqual(self.render("my_kitti.txt"), read(self.path("trajectory.kitti")))

    def test_trajectories_by_number(self):
        self.assertEqual(self.render("a.tum", "--trajectory=0"), self.render("b.tum"))
        self.refuse(["no trajectory 2", "it has 0"], "c.tum", "--trajectory=2")
        self.refuse(["--trajectory=0,1"], "c.tum", "--trajectory=0,1")

    def test_stock_maps_have_trajectories_as_well(self):
        path = os.path.join(data_directory(), "pbstream", "stock_aces.pbstream")
        if not os.path.exists(path):
            self.skipTest(f"no real data: {path} does not exist (set SEMANTIC_KISS_DATA)")
        self.succeed("render", f"--map={path}", f"--output={self.path('aces.tum')}")
        self.assertEqual(read(self.path("aces.tum")).count(b"\n"), 2822)
        self.fail_with(1, ["no points to write", "only the nodes"], "render", f"--map={path}",
                       f"--output={self.path('aces.ply')}")
        self.succeed("render", f"--map={path}", f"--output={self.path('aces.ply')}",
                     "--node_clouds")
        self.succeed("render", f"--map={path}", f"--output={self.path('aces.pgm')}")
        self.assertIn(0, set().union(*read_pgm(read(self.path("aces.pgm")))[2]))


class MisuseTest(ExportTest):

    def test_flags_that_say_nothing_are_refused(self):
        self.refuse(["--trajectory", ".png"], "a.png", "--trajectory=0")
        self.refuse(["--node_clouds", ".pgm"], "a.pgm", "--node_clouds")
        self.refuse(["--hide", ".tum"], "a.tum", "--hide=car")
        self.refuse(["--resolution", "_kitti.txt"], "a_kitti.txt", "--resolution=1")

    def test_endings_are_listed(self):
        for name in ("a.txt", "a.bmp", "a"):
            self.refuse([".png", ".pgm", ".ply", ".pcd", ".tum", "_kitti.txt"], name)

    def test_files_appear_whole_or_not_at_all(self):
        for name in ("a.pgm", "a.ply", "a.pcd", "a.tum", "a.kitti"):
            self.refuse([os.path.join("no", name)], os.path.join("no", name))
            damaged = self.path("damaged.pbstream")
            content = read(self.map)
            write(damaged, content[:len(content) // 2] if name[-3:] in ("pgm", "ply", "pcd")
                  else content[:100])
            self.fail_with(1, [damaged], "render", f"--map={damaged}",
                           f"--output={self.path(name)}")
            self.assertFalse(os.path.exists(self.path(name)))


if __name__ == "__main__":
    main()
