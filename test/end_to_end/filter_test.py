#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""`filter` on the map of a small drive: what goes, what stays, what it refuses."""

import json
import os

from picture import read_png
from program import ProgramTest, data_directory, main, read, write
from sequence import CAR, Sequence

# The street: road up to 6 m to both sides, cars from 4 m on, houses from 8 m on.
LEFT_SIDE = "--box=-100,0,100,100"


class FilterTest(ProgramTest):

    def setUp(self):
        super().setUp()
        Sequence(self.path("data"))
        self.map = self.path("out", "map.pbstream")
        self.succeed("run", f"--dataset={self.path('data')}", f"--output={self.path('out')}",
                     "--quiet")

    def filter(self, *flags, source=None, output="filtered.pbstream"):
        """Returns the path of the filtered map."""
        path = self.path(output)
        self.succeed("filter", f"--map={source or self.map}", f"--output={path}", "--quiet", *flags)
        return path

    def refuse(self, words, *flags):
        self.fail_with(1, words, "filter", f"--map={self.map}",
                       f"--output={self.path('refused.pbstream')}", *flags)
        self.assertFalse(os.path.exists(self.path("refused.pbstream")))

    def info(self, path):
        return json.loads(self.succeed("info", f"--map={path}", "--json"))

    def picture(self, path, *flags):
        """The map alone as a picture, a pixel 5 cm."""
        write(self.path("picture.lua"),
              'include "semantic_kiss.lua"\n'
              "RUN.map_image.crop_share = 0\nRUN.map_image.draw_frame = false\n"
              "RUN.map_image.draw_trajectory = false\nreturn RUN\n")
        self.succeed("render", f"--map={path}", f"--output={self.path('picture.png')}",
                     f"--config={self.path('picture.lua')}", "--resolution=0.05", *flags)
        return read(self.path("picture.png"))


class RemovedTest(FilterTest):

    def test_a_class_goes_and_all_else_stays(self):
        before, after = self.info(self.map), self.info(self.filter("--remove=car"))
        self.assertNotIn("car", after["labels"])
        del before["labels"]["car"]
        for key in ("labels", "trajectories", "constraints", "configuration", "label_set",
                    "node_bounds_m"):
            self.assertEqual(after[key], before[key])
        self.assertEqual(after["history"][:-1], before["history"])
        self.assertIn("filter --remove=car: removed ", after["history"][-1])

    def test_a_summary_tells_what_went(self):
        cars = self.info(self.map)["labels"]["car"]
        text = self.succeed("filter", f"--map={self.map}", f"--output={self.path('a')}",
                            "--remove=car,truck")
        self.assertEqual(len(text.splitlines()), 2)
        self.assertEqual(text.splitlines()[1].split(),
                         ["car", *(str(cars[key]) for key in ("hits", "submap_points",
                                                              "node_points"))])
        text = self.succeed("filter", f"--map={self.map}", f"--output={self.path('a')}",
                            "--remove=truck")
        self.assertEqual(text, "nothing was removed\n")

    def test_the_picture_is_that_without_the_class(self):
        hidden = self.picture(self.map, "--hide=car")
        self.assertEqual(self.picture(self.filter("--remove=car")), hidden)
        self.assertEqual(self.picture(self.filter("--remove_role=movable")), hidden)

    def test_pixels_change_only_near_the_removed(self):
        width, height, before = read_png(self.picture(self.map))
        filtered = self.picture(self.filter("--remove=car"))
        self.assertEqual(read_png(filtered)[:2], (width, height))
        after = read_png(filtered)[2]
        # Cars are blue as nothing else is; their shadows fall up to half a metre aside.
        reach = 20
        near = [bytearray(width) for _ in range(height)]
        for y, row in enumerate(before):
            for x in range(width):
                red, _, blue = row[3 * x:3 * x + 3]
                if blue < red + 40:
                    continue
                for other in near[max(0, y - reach):y + reach + 1]:
                    left, right = max(0, x - reach), min(width, x + reach + 1)
                    other[left:right] = b"\1" * (right - left)
        changed = [(x, y) for y in range(height) for x in range(width)
                   if before[y][3 * x:3 * x + 3] != after[y][3 * x:3 * x + 3]]
        self.assertGreater(len(changed), 1000)
        self.assertEqual([place for place in changed if not near[place[1]][place[0]]], [])
        self.assertLess(sum(map(sum, near)), width * height / 2)

    def test_twice_is_once(self):
        for flags in (["--remove=car"], ["--min_hits=3"], [LEFT_SIDE],
                      ["--keep_role=ground", LEFT_SIDE, "--outside"]):
            with self.subTest(flags):
                once = self.filter(*flags)
                twice = self.filter(*flags, source=once, output="twice.pbstream")
                self.assertNotEqual(read(once), read(self.map))
                self.assertEqual(read(once), read(twice))

    def test_one_after_the_other_is_both(self):
        both = self.info(self.filter("--remove=car,pole"))
        first = self.filter("--remove=pole", output="first.pbstream")
        second = self.info(self.filter("--remove=car", source=first))
        self.assertEqual(second["labels"], both["labels"])
        self.assertEqual(second["grid_bounds_m"], both["grid_bounds_m"])
        self.assertEqual(len(second["history"]), len(both["history"]) + 1)

    def test_a_region_confines(self):
        cars = self.info(self.map)["labels"]["car"]
        left = self.info(self.filter("--remove=car", "--outside", LEFT_SIDE))["labels"]["car"]
        right = self.info(self.filter("--remove=car", LEFT_SIDE))["labels"]["car"]
        for key in cars:
            self.assertGreater(left[key], 0)
            self.assertEqual(left[key] + right[key], cars[key])
        nothing = self.info(self.filter(LEFT_SIDE, "--outside"))
        self.assertEqual(nothing["labels"]["car"], left)
        self.assertLess(nothing["labels"]["road"]["hits"],
                        self.info(self.map)["labels"]["road"]["hits"])
        triangle = self.info(self.filter("--remove=car", "--polygon=-100,0,100,0,0,1000"))
        self.assertLess(triangle["labels"]["car"]["hits"], cars["hits"])

    def test_an_emptied_map_is_still_a_map(self):
        empty = self.filter("--box=-1000,-1000,1000,1000")
        self.assertEqual(self.info(empty)["labels"], {})
        self.assertEqual(self.info(empty)["trajectories"], self.info(self.map)["trajectories"])
        self.fail_with(1, ["nothing to draw"], "render", f"--map={empty}",
                       f"--output={self.path('empty.png')}")

    def test_bytes_do_not_depend_on_threads(self):
        flags = ["--remove=car", "--min_hits=2", "--remove_transient"]
        one = self.filter(*flags, "--threads=1", output="one.pbstream")
        self.assertEqual(read(one), read(self.filter(*flags, "--threads=3")))

    def test_a_filter_as_a_file(self):
        write(self.path("mine.lua"), 'include "defaults/map_filter.lua"\n'
              'MAP_FILTER.remove_roles = { "movable" }\nreturn MAP_FILTER\n')
        by_file = read(self.filter(f"--config={self.path('mine.lua')}", output="a.pbstream"))
        self.assertEqual(by_file, read(self.filter("--remove_role=movable")))
        by_both = self.filter(f"--config={self.path('mine.lua')}", "--remove_role=critical")
        self.assertIn("--remove_role=critical:", self.info(by_both)["history"][-1])


class RefusedTest(FilterTest):

    def test_names(self):
        self.refuse(["remove: ", "trukc", "truck"], "--remove=car,trukc")
        self.refuse(["keep: ", "rode", "road"], "--keep=rode")
        self.refuse(["remove_role: ", "movabel", "movable"], "--remove_role=movabel")
        self.refuse(["keep: ", "one of the two"], "--keep=road", "--remove=car")

    def test_regions(self):
        self.refuse(["polygon: has 5 numbers"], "--polygon=0,0,1,0,1")
        self.refuse(["polygon: has 2 corners"], "--polygon=0,0,1,0")
        self.refuse(["box: ", "no area"], "--box=0,0,-1,5")
        self.refuse(["box: ", "`five`"], "--box=0,0,1,five")
        self.refuse(["box: has 3 numbers"], "--box=0,0,1")
        self.refuse(["polygon: ", "one of the two"], "--box=0,0,1,1", "--polygon=0,0,1,0,1,1")
        self.refuse(["outside: "], "--remove=car", "--outside")

    def test_trajectories(self):
        self.refuse(["trajectory: ", "no trajectory 3", "it has 0"], "--trajectory=3")
        self.refuse(["trajectory: ", "`x` is not a whole number"], "--trajectory=0,x")
        self.refuse(["nothing would be left"], "--trajectory=0")

    def test_nothing_to_do(self):
        self.refuse(["nothing to remove"])

    def test_configurations(self):
        self.refuse(["nowhere.lua"], "--config=nowhere.lua")
        write(self.path("bad.lua"), 'include "defaults/map_filter.lua"\n'
              "MAP_FILTER.transient.tolerance_m = -1\nreturn MAP_FILTER\n")
        self.refuse(["bad.lua", "transient.tolerance_m", "-1"], f"--config={self.path('bad.lua')}")

    def test_the_map_itself_as_output(self):
        content = read(self.map)
        os.symlink(self.map, self.path("link"))
        for output in (self.map, self.path("link"), self.path("out", "..", "out", "map.pbstream")):
            self.fail_with(1, ["is the map itself"], "filter", f"--map={self.map}",
                           f"--output={output}", "--remove=car")
        self.assertEqual(read(self.map), content)

    def test_files(self):
        self.fail_with(1, [self.path("nowhere")], "filter", f"--map={self.path('nowhere')}",
                       f"--output={self.path('a')}", "--remove=car")
        self.fail_with(1, [self.path("no", "a")], "filter", f"--map={self.map}",
                       f"--output={self.path('no', 'a')}", "--remove=car")
        self.fail_with(2, ["--output"], "filter", f"--map={self.map}", "--remove=car")
        write(self.path("damaged"), read(self.map)[:-1000])
        self.fail_with(1, [self.path("damaged")], "filter", f"--map={self.path('damaged')}",
                       f"--output={self.path('a')}", "--remove=car")
        self.assertFalse(os.path.exists(self.path("a")))


class StockMapTest(ProgramTest):

    def test_maps_of_cartographer_can_be_cut(self):
        path = os.path.join(data_directory(), "pbstream", "stock_kitti_16_scans.pbstream")
        if not os.path.exists(path):
            self.skipTest(f"no real data: {path} does not exist (set SEMANTIC_KISS_DATA)")
        output = self.path("cut.pbstream")
        self.succeed("filter", f"--map={path}", f"--output={output}", "--box=-10,-10,10,10",
                     "--outside", "--quiet")
        bounds = json.loads(self.succeed("info", f"--map={output}", "--json"))["grid_bounds_m"]
        self.assertLess(bounds["max"][0] - bounds["min"][0], 40)


if __name__ == "__main__":
    main()
