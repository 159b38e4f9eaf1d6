#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""How scans are made up: scan_statistics.py SEQUENCE_DIR... [--step=N]

Prints, for sequences in SemanticKITTI's format, a table with a column for each: points per scan,
points per beam, shares of ranges and of labels. With --step=N every N-th scan counts.
docs/simulation.md compares real and simulated drives by it.
"""

import array
import collections
import math
import os
import sys

RANGES_M = [0, 5, 10, 15, 20, 30, 40, 60, 80]
LABELS = {40: "road", 60: "lane-marking", 44: "parking", 48: "sidewalk", 49: "other-ground",
          72: "terrain", 70: "vegetation", 71: "trunk", 50: "building", 51: "fence",
          52: "other-structure", 80: "pole", 81: "traffic-sign", 10: "car", 18: "truck",
          30: "person", 11: "bicycle", 99: "other-object", 0: "unlabeled"}
BEAM_GROUPS = [(0, 8), (8, 16), (16, 32), (32, 48), (48, 56), (56, 64)]


def load(path, code):
    values = array.array(code)
    with open(path, "rb") as file:
        values.frombytes(file.read())
    return values


def beams_of(points):
    """The number of each point's beam: files list beam after beam, each once round."""
    beam, turned, last = 0, 0.0, None
    for i in range(0, len(points), 4):
        azimuth = math.atan2(points[i + 1], points[i])
        if last is not None:
            step = (azimuth - last + math.pi) % (2 * math.pi) - math.pi
            turned += step
            if turned > 2 * math.pi - 0.02 or (turned > 5.5 and abs(step) > 1.0):
                beam, turned = beam + 1, 0.0
        last = azimuth
        yield beam


class Statistics:

    def __init__(self, directory, step):
        self.scans = self.points = 0
        self.ranges = collections.Counter()
        self.labels = collections.Counter()
        self.beams = collections.Counter()
        names = sorted(os.listdir(os.path.join(directory, "velodyne")))[::step]
        for name in names:
            self.add(directory, name)

    def add(self, directory, name):
        points = load(os.path.join(directory, "velodyne", name), "f")
        label_path = os.path.join(directory, "labels", name.replace(".bin", ".label"))
        labels = load(label_path, "I") if os.path.exists(label_path) else []
        self.scans += 1
        self.points += len(points) // 4
        for i in range(0, len(points), 4):
            distance = math.sqrt(points[i] ** 2 + points[i + 1] ** 2 + points[i + 2] ** 2)
            self.ranges[sum(distance >= bound for bound in RANGES_M)] += 1
        for label in labels:
            label &= 0xffff
            self.labels["moving" if label >= 252 else LABELS.get(label, "others")] += 1
        for beam in beams_of(points):
            self.beams[beam] += 1

    def rows(self):
        yield "scans", str(self.scans)
        yield "points a scan", f"{self.points / self.scans:.0f}"
        for first, last in BEAM_GROUPS:
            total = sum(self.beams[beam] for beam in range(first, last))
            yield (f"points a beam, beams {first}-{last - 1}",
                   f"{total / (last - first) / self.scans:.0f}")
        for i, bound in enumerate(RANGES_M):
            upper = f"-{RANGES_M[i + 1]}" if i + 1 < len(RANGES_M) else " and more"
            yield f"range {bound}{upper} m, %", f"{100 * self.ranges[i + 1] / self.points:.1f}"
        for label in [*LABELS.values(), "moving", "others"]:
            yield f"{label}, %", f"{100 * self.labels[label] / self.points:.2f}"


def main(arguments):
    step = 1
    directories = []
    for argument in arguments:
        if argument.startswith("--step="):
            step = int(argument[len("--step="):])
        else:
            directories.append(argument)
    if not directories:
        print(__doc__, file=sys.stderr)
        return 2
    columns = [list(Statistics(directory, step).rows()) for directory in directories]
    print("| | " + " | ".join(os.path.normpath(directory) for directory in directories) + " |")
    print("|---" * (len(directories) + 1) + "|")
    for row in zip(*columns):
        print(f"| {row[0][0]} | " + " | ".join(cell[1] for cell in row) + " |")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
