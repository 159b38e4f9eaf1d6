#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""`info` and `render` on the map of a small drive, and on maps that are none."""

import json
import os
import struct

from program import ProgramTest, data_directory, main, read, write
from sequence import Sequence


def png_size(content):
    return struct.unpack(">II", content[16:24])


class MapTest(ProgramTest):

    def setUp(self):
        super().setUp()
        Sequence(self.path("data"))
        self.map = self.path("out", "map.pbstream")
        self.succeed("run", f"--dataset={self.path('data')}", f"--output={self.path('out')}",
                     "--quiet")

    def test_info_tells_what_is_in_it(self):
        info = json.loads(self.succeed("info", f"--map={self.map}", "--json"))
        self.assertTrue(info["made_by_us"])
        self.assertEqual(info["file_bytes"], os.path.getsize(self.map))
        self.assertEqual(info["label_set"], "semantic_kitti")
        self.assertAlmostEqual(info["trajectories"][0]["length_m"], 4, delta=0.2)
        for label in ("road", "building", "car", "pole"):
            self.assertGreater(info["labels"][label]["hits"], 0)
        self.assertNotIn("moving-car", info["labels"])
        self.assertEqual(info["configuration"], self.succeed("config"))
        text = self.succeed("info", f"--map={self.map}")
        for word in ("building", "1 submaps", "semantic_kiss"):
            self.assertIn(word, text)

    def test_render_draws_what_run_drew(self):
        self.succeed("render", f"--map={self.map}", f"--output={self.path('map.png')}")
        picture = read(self.path("map.png"))
        # Not the same bytes: files hold positions in steps of a millimetre.
        self.assertEqual(png_size(picture), png_size(read(self.path("out", "map.png"))))
        self.succeed("render", f"--map={self.map}", f"--output={self.path('again.png')}",
                     "--threads=1")
        self.assertEqual(read(self.path("again.png")), picture)

    def test_hidden_labels_and_resolution_change_the_picture(self):
        pictures = set()
        for flag in ("--hide=", "--hide=car", "--hide=car, building", "--resolution=0.5"):
            self.succeed("render", f"--map={self.map}", f"--output={self.path('map.png')}", flag)
            pictures.add(read(self.path("map.png")))
        self.assertEqual(len(pictures), 4)
        for picture in pictures:
            self.assertGreater(min(png_size(picture)), 16)

    def test_render_says_what_it_can(self):
        for name in ("map.bmp", "map"):
            self.fail_with(1, [name, ".png"], "render", f"--map={self.map}",
                           f"--output={self.path(name)}")
        self.fail_with(1, ["hide", "trukc", "truck"], "render", f"--map={self.map}",
                       f"--output={self.path('map.png')}", "--hide=trukc")
        self.fail_with(1, ["map.png"], "render", f"--map={self.map}",
                       f"--output={self.path('nowhere', 'map.png')}")
        self.assertFalse(os.path.exists(self.path("map.png")))

    def test_bad_maps(self):
        content = read(self.map)
        flipped = bytearray(content)
        flipped[len(content) // 2] ^= 0x10
        bad = {"empty": b"", "text": b"no map at all", "truncated": content[:len(content) // 2],
               "flipped": bytes(flipped)}
        for name, damaged in bad.items():
            path = self.path(name)
            write(path, damaged)
            self.fail_with(1, [path], "info", f"--map={path}")
            self.fail_with(1, [path], "render", f"--map={path}",
                           f"--output={self.path('map.png')}")
        self.fail_with(1, [self.path("nowhere")], "info", f"--map={self.path('nowhere')}")
        self.assertFalse(os.path.exists(self.path("map.png")))


class StockMapTest(ProgramTest):

    def test_maps_of_cartographer_are_understood(self):
        folder = os.path.join(data_directory(), "pbstream")
        if not os.path.isdir(folder):
            self.skipTest(f"no real data: {folder} does not exist (set SEMANTIC_KISS_DATA)")
        path = os.path.join(folder, "stock_kitti_16_scans.pbstream")
        info = json.loads(self.succeed("info", f"--map={path}", "--json"))
        self.assertFalse(info["made_by_us"])
        self.assertEqual(info["trajectories"][0]["nodes"], 16)
        self.succeed("render", f"--map={path}", f"--output={self.path('stock.png')}")
        self.assertGreater(min(png_size(read(self.path("stock.png")))), 16)


if __name__ == "__main__":
    main()
