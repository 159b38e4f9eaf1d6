# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Writes tiny drives in SemanticKITTI's format: a straight street with houses, parked cars, poles.

All scans see the same points of the world, so that an odometry has an easy time; what is tested
with these drives is the program around it.
"""

import os
import random
import struct

ROAD, BUILDING, CAR, MOVING_CAR, POLE, TRUNK = 40, 50, 10, 252, 80, 71
STEP_M = 0.8
LIDAR_HEIGHT_M = 1.7
# The camera looks along the lidar's x axis: x right, y down, z forward.
CALIBRATION = "Tr: 0 -1 0 0.1 0 0 -1 -0.2 1 0 0 -0.3\n"


def _street(length_m):
    """Points (x, y, z, label) of the world, z = 0 on the road."""
    rng = random.Random(20260101)
    points = []
    for i in range(int(length_m * 14)):
        x = rng.uniform(-30, length_m + 30)
        points.append((x, rng.uniform(-6, 6), rng.gauss(0, 0.01), ROAD))
    for side in (-8.0, 8.0):
        x = -30.0
        while x < length_m + 30:
            width, depth = rng.uniform(5, 12), rng.uniform(0, 3)
            y = side + (depth if side > 0 else -depth)
            for _ in range(int(width * 12)):
                points.append((x + rng.uniform(0, width), y, rng.uniform(0, 6), BUILDING))
            for _ in range(20):  # the wall between two houses
                points.append((x, side + (y - side) * rng.random(), rng.uniform(0, 6), BUILDING))
            x += width + rng.uniform(0, 2)
    x = -25.0
    while x < length_m + 30:
        side = rng.choice((-6.5, 6.5))
        label = rng.choice((POLE, TRUNK))
        points.extend((x, side, 0.1 * z, label) for z in range(40))
        for _ in range(60):
            points.append((x + 3 + rng.uniform(0, 4), rng.choice((-1, 1)) * rng.uniform(4, 5.5),
                           rng.uniform(0, 1.5), CAR))
        x += rng.uniform(8, 14)
    return points


class Sequence:
    """A drive of `num_scans` scans along the street, written to `directory`."""

    def __init__(self, directory, num_scans=6, name="00"):
        self.directory = directory
        self.path = os.path.join(directory, "sequences", name)
        self.num_scans = num_scans
        for folder in ("velodyne", "labels"):
            os.makedirs(os.path.join(self.path, folder))
        self._write_scans()
        self.write("calib.txt", CALIBRATION)
        self.write("times.txt", "".join(f"{0.1 * i:.6e}\n" for i in range(num_scans)))
        # Driving along the lidar's x is driving along the camera's z.
        self.write("poses.txt", "".join(f"1 0 0 0 0 1 0 0 0 0 1 {STEP_M * i}\n"
                                        for i in range(num_scans)))

    def _write_scans(self):
        street = _street(STEP_M * self.num_scans)
        for index in range(self.num_scans):
            here = STEP_M * index
            seen = [p for p in street if abs(p[0] - here) < 25]
            seen += [(here + 8 + 0.1 * i, 1.0, 0.5, MOVING_CAR) for i in range(10)]
            self.write(f"velodyne/{index:06d}.bin",
                       b"".join(struct.pack("<4f", x - here, y, z - LIDAR_HEIGHT_M, 0.3)
                                for x, y, z, _ in seen))
            self.write(f"labels/{index:06d}.label",
                       b"".join(struct.pack("<I", p[3]) for p in seen))

    def file(self, name):
        return os.path.join(self.path, name)

    def write(self, name, content):
        with open(self.file(name), "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())

    def num_points(self, index):
        return os.path.getsize(self.file(f"velodyne/{index:06d}.bin")) // 16
