#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""The pages of `run` and `render` in a real browser: do they work for those who look at them?"""

import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest

import browser
from picture import read_png
from program import BINARY, ProgramTest, main, read, write
from ring import simulate_ring

TAB, RIGHT = "\ue004", "\ue014"
LABELED = "[...document.querySelectorAll('.layer')].find((row) => row.innerText.trim() == '{}')"


def run_program(*arguments):
    subprocess.run([BINARY, *arguments], check=True)


def orange_pixels(png):
    """How many are of the colour that buildings have in the simulator's label set."""
    _, _, rows = read_png(png)
    return sum(r > 200 and 140 < g < 190 and b < 70
               for row in rows for r, g, b in zip(row[0::3], row[1::3], row[2::3]))


def brightness(color):
    """Relative luminance of "rgb(r, g, b)" (https://www.w3.org/TR/WCAG21/#dfn-relative-luminance)."""
    channels = [int(number) / 255 for number in re.findall(r"\d+", color)[:3]]
    linear = [c / 12.92 if c <= 0.03928 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one, other):
    bright, dark = sorted((brightness(one), brightness(other)), reverse=True)
    return (bright + 0.05) / (dark + 0.05)


@unittest.skipIf(browser.missing(), f"{browser.missing()} is not installed: scripts/setup.sh --test")
class ReportTest(ProgramTest):

    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.mkdtemp(prefix="semantic_kiss_")
        cls.addClassCleanup(shutil.rmtree, cls.work)
        simulate_ring(cls.work, ring_m=150., length_m=200., scan_rate_hz=5.)
        out = os.path.join(cls.work, "out")
        # So strict that some candidates are rejected.
        strict = os.path.join(cls.work, "strict.lua")
        write(strict, 'local options = include "semantic_kiss_6dof.lua"\n'
                      "options.pose_graph.verification.acceptance.min_inlier_ratio = 0.87\nreturn options\n")
        run_program("run", f"--config={strict}", f"--dataset={cls.work}", f"--output={out}",
                    "--quiet")
        cls.page = os.path.join(out, "report.html")
        cls.map = os.path.join(out, "map.pbstream")
        cls.browser = browser.Browser()
        cls.addClassCleanup(cls.browser.close)

    def setUp(self):
        super().setUp()
        self.browser.emulate()

    def tearDown(self):
        self.assertEqual(self.browser.log(), [])
        super().tearDown()

    def open(self, page=None):
        self.browser.open(page or self.page)
        self.wait_for_tiles()

    def wait_for_tiles(self):
        """Until all pictures are there."""
        self.browser.wait_until(
            "document.querySelector('.leaflet-tile-loaded[src]') && "
            "[...document.querySelectorAll('.leaflet-tile')].every((tile) => "
            "tile.classList.contains('leaflet-tile-loaded'))")

    def click(self, expression):
        self.browser.run(f"({expression}).click()")
        self.wait_for_tiles()

    def orange(self, selector=".map"):
        self.browser.run("return new Promise((done) => "
                         "requestAnimationFrame(() => requestAnimationFrame(done)))")
        return orange_pixels(self.browser.screenshot(selector))

    def text(self, selector):
        return self.browser.run(f"return document.querySelector('{selector}').innerText")

    def test_tells_what_the_run_found(self):
        self.open()
        page = self.text("body")
        for words in ("Driven", "Loop closures", "of position", "Height", "Error along the way",
                      "Drift by length", "Time of the stages", "accepted", "Changed options",
                      "pose_graph.optimize_every_n_nodes"):
            self.assertIn(words, page)
        self.assertEqual(self.browser.run("return document.querySelectorAll('.plot svg').length"),
                         6)

    def test_labels_can_be_hidden_and_faded(self):
        self.browser.emulate(width=1000, height=420)
        self.open()
        self.browser.run("document.querySelector('.map').scrollIntoView()")
        self.click("document.querySelector('.panel input')")  # the trajectory has many colours
        buildings = self.orange()
        self.assertGreater(buildings, 100)
        row = LABELED.format("building")
        self.click(f"{row}.querySelector('[type=checkbox]')")
        self.assertEqual(self.orange(), 0)
        self.click(f"{row}.querySelector('[type=checkbox]')")
        self.assertEqual(self.orange(), buildings)
        self.browser.run(f"const slider = {row}.querySelector('[type=range]'); slider.value = 5;"
                         "slider.dispatchEvent(new Event('input'))")
        self.assertEqual(self.orange(), 0)

    def test_a_group_is_hidden_as_one(self):
        self.open()
        boxes = ("[...[...document.querySelectorAll('fieldset')].find((group) => "
                 "group.innerText.startsWith('Standing')).querySelectorAll('[type=checkbox]')]")
        self.click(f"{boxes}[1]")
        self.assertTrue(self.browser.run(f"return {boxes}[0].indeterminate"))
        self.click(f"{boxes}[0]")
        self.assertEqual(self.browser.run(f"return {boxes}.filter((box) => box.checked).length"), 0)

    def test_zooms(self):
        self.open()
        far = self.text(".leaflet-control-scale-line")
        self.click("document.querySelector('.leaflet-control-zoom-in')")
        near = self.text(".leaflet-control-scale-line")
        self.assertNotEqual(near, far)
        self.browser.run("document.querySelector('.map').focus()")
        self.browser.press("-")
        self.browser.wait_until("document.querySelector('.leaflet-control-scale-line').innerText "
                                f"== '{far}'")

    def test_closures_tell_about_themselves(self):
        self.open()
        self.click("document.querySelector('#closures button')")
        for words in ("score", "inliers", "correction", "true error"):
            self.assertIn(words, self.text(".leaflet-popup"))
        # Seven pixels above the end of its tip is the line, which opens it as well.
        tip = self.browser.box(".leaflet-popup-tip-container")
        self.click("document.querySelector('.leaflet-popup-close-button')")
        self.browser.wait_until("!document.querySelector('.leaflet-popup')")
        self.browser.click_at(tip["x"] + tip["width"] / 2, tip["y"] + tip["height"] - 7)
        self.browser.wait_until("document.querySelector('.leaflet-popup .facts')")

    def test_rejected_closures_tell_why(self):
        self.open()
        box = ("[...document.querySelectorAll('.check')].find((label) => "
               "label.innerText.trim() == 'Rejected closures').querySelector('input')")
        self.assertFalse(self.browser.run(f"return {box}.checked"))
        self.click("document.querySelectorAll('#closures section')[1].querySelector('button')")
        self.assertTrue(self.browser.run(f"return {box}.checked"))
        with open(os.path.join(os.path.dirname(self.page), "run.json")) as file:
            first = json.load(file)["closure_search"]["rejected"][0]
        facts = self.text(".leaflet-popup .facts")
        for words in (first["verdict"], "why", "found by", f"node\n{first['node']}",
                      f"submap\n{first['submap']}"):
            self.assertIn(words, facts)
        self.click("document.querySelector('.leaflet-popup-close-button')")
        self.click(box)
        self.assertFalse(self.browser.run(f"return {box}.checked"))

    def test_everything_can_be_reached_with_the_keyboard(self):
        self.open()
        reached = set()
        for _ in range(150):
            self.browser.press(TAB)
            focused = self.browser.run(
                "const e = document.activeElement; return [e.tagName, e.type, e.className].join()")
            reached.add(str(focused).split(" ")[0].lower())
            if "summary" in str(focused).lower():
                break
        for control in ("a,,skip", "div,,map", "input,checkbox,", "input,range,", "select",
                        "svg", "button,button,", "summary"):
            self.assertTrue(any(name.startswith(control) for name in reached),
                            f"{control} is not among {reached}")

    def test_arrows_read_charts(self):
        self.open()
        self.browser.run("document.querySelector('.plot svg').focus()")
        self.browser.press(RIGHT, RIGHT, RIGHT)
        values = self.text(".readout")
        self.assertIn("ground truth", values)
        self.browser.press(RIGHT)
        self.assertNotEqual(self.text(".readout"), values)

    def test_can_be_read_in_dark_and_light(self):
        for scheme, bright in (("light", True), ("dark", False)):
            self.browser.emulate(scheme)
            self.open()
            style = "return getComputedStyle(document.querySelector('{}'))['{}']"
            paper = self.browser.run(style.format("body", "background-color"))
            self.assertEqual(brightness(paper) > 0.5, bright)
            for selector, property_name in (
                    ("h1", "color"), (".note", "color"), (".figure small", "color"),
                    ("td", "color"), (".plot text", "fill"), (".leaflet-bar a", "color")):
                ink = self.browser.run(style.format(selector, property_name))
                self.assertGreater(contrast(ink, paper), 4.5, f"{selector} in {scheme}")

    def test_fits_narrow_screens(self):
        self.browser.emulate(width=360, height=740)
        self.open()
        self.assertLessEqual(
            self.browser.run("return document.documentElement.scrollWidth"), 360)
        self.assertGreater(self.browser.box(".map")["width"], 300)
        self.assertGreater(self.browser.box(".panel")["y"], self.browser.box(".map")["y"] + 300)

    def test_two_maps_move_together(self):
        bare, page = self.path("bare.pbstream"), self.path("both.html")
        self.succeed("filter", f"--map={self.map}", f"--output={bare}", "--remove=building",
                     "--quiet")
        self.succeed("render", f"--map={self.map}", f"--compare={bare}", f"--output={page}")
        self.browser.emulate(width=1000, height=500)
        self.open(page)
        self.browser.run("document.querySelector('.map').scrollIntoView()")
        self.click("document.querySelector('.panel input')")
        self.assertGreater(self.orange("figure:nth-child(1) .map"), 50)
        self.assertEqual(self.orange("figure:nth-child(2) .map"), 0)
        self.click("document.querySelectorAll('.leaflet-control-zoom-in')[1]")
        scales = self.browser.run("return [...document.querySelectorAll("
                                  "'.leaflet-control-scale-line')].map((line) => line.innerText)")
        self.assertEqual(scales[0], scales[1])
        self.assertIn("bare.pbstream", self.text("body"))

    def test_a_drive_added_to_a_map_is_shown_with_those_before(self):
        self.succeed("run", "--config=semantic_kiss_6dof.lua", f"--dataset={self.work}",
                     f"--map={self.map}", "--num_scans=60", f"--output={self.path('both')}",
                     "--quiet")
        self.open(self.path("both", "report.html"))
        self.assertIn("added to a map of 1 drive", self.text(".subtitle"))
        roles = self.browser.run("return JSON.parse(document.getElementById('data').textContent)"
                                 ".maps[0].paths.map((path) => [path.role, path.x.length])")
        lengths = dict(roles)
        self.assertEqual(lengths["trajectory"], 60)
        self.assertGreater(lengths["earlier"], 60)
        self.assertIn("Earlier drives", self.text(".panel"))

    def test_a_map_gives_the_same_page_again(self):
        pages = [self.path("a.html"), self.path("b.html")]
        for threads, page in enumerate(pages, 1):
            self.succeed("render", f"--map={self.map}", f"--output={page}", f"--threads={threads}")
        self.assertEqual(read(pages[0]), read(pages[1]))
        self.open(pages[0])


if __name__ == "__main__":
    main()
