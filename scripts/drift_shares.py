#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""What an odometry's drift consists of: drift_shares.py GROUND_TRUTH ESTIMATE

Takes two files of poses in KITTI's format (left camera's frame: x right, y down, z ahead) and looks
at KITTI's segments (100, 200, ... 800 m, beginning at every tenth pose). Prints the relative
translation error and the shares of its mean square, all as KITTI has them relative to the
segment's length:

  height   the error along the vertical
  heading  what the error of the heading explains of the error in the plane: the true steps are
           laid out again, each turned by the error of the heading that the estimate has there;
           what this path misses the true end by is taken away from the error, and the share is
           by how much the square becomes smaller
  rest     scale along the way, slip aside, and what none of it explains
"""

import cmath
import math
import sys

LENGTHS_M = range(100, 900, 100)
STEP = 10


class Pose:
    """A camera's pose: rotation rows and position."""

    def __init__(self, numbers):
        self.rotation = [numbers[0:3], numbers[4:7], numbers[8:11]]
        self.position = [numbers[3], numbers[7], numbers[11]]

    def rotate(self, vector):
        return [sum(row[k] * vector[k] for k in range(3)) for row in self.rotation]

    def rotate_back(self, vector):
        return [sum(self.rotation[k][i] * vector[k] for k in range(3)) for i in range(3)]

    def plan(self):
        """Position seen from above, as a complex number."""
        return complex(self.position[0], self.position[2])

    def heading(self):
        return cmath.phase(complex(self.rotation[0][2], self.rotation[2][2]))


def read_poses(path):
    with open(path, encoding="utf-8") as file:
        return [Pose([float(word) for word in line.split()]) for line in file if line.strip()]


def difference(a, b):
    return [x - y for x, y in zip(a, b)]


def travelled(poses):
    lengths = [0.0]
    for last, pose in zip(poses, poses[1:]):
        lengths.append(lengths[-1] + math.dist(last.position, pose.position))
    return lengths


class Drift:

    def __init__(self, truth, estimate):
        self.truth, self.estimate = truth, estimate
        self.lengths = travelled(truth)
        self.heading_errors = [e.heading() - t.heading() for t, e in zip(truth, estimate)]
        # The true way with every step turned by the error of the heading there.
        self.turned = [0j]
        for i in range(1, len(truth)):
            turn = cmath.exp(1j * self.heading_errors[i - 1])
            self.turned.append(self.turned[-1] + turn * (truth[i].plan() - truth[i - 1].plan()))

    def segment_end(self, first, length):
        target = self.lengths[first] + length
        for last in range(first, len(self.lengths)):
            if self.lengths[last] > target:
                return last
        return None

    def error(self, first, last):
        """The end's error after the starts are laid on each other, along the world's axes."""
        t, e = self.truth, self.estimate
        estimated = e[first].rotate_back(difference(e[last].position, e[first].position))
        true = t[first].rotate_back(difference(t[last].position, t[first].position))
        return t[first].rotate(difference(estimated, true))

    def error_by_heading(self, first, last):
        turn_back = cmath.exp(-1j * self.heading_errors[first])
        return (turn_back * (self.turned[last] - self.turned[first]) -
                (self.truth[last].plan() - self.truth[first].plan()))

    def shares(self):
        count, linear, square, height, heading = 0, 0.0, 0.0, 0.0, 0.0
        for first in range(0, len(self.truth), STEP):
            for length in LENGTHS_M:
                last = self.segment_end(first, length)
                if last is None:
                    break
                x, y, z = self.error(first, last)
                plan = complex(x, z)
                unexplained = plan - self.error_by_heading(first, last)
                count += 1
                linear += math.hypot(x, y, z) / length
                square += (x * x + y * y + z * z) / length**2
                height += y * y / length**2
                heading += (abs(plan)**2 - abs(unexplained)**2) / length**2
        if count == 0:
            return None
        return {"rte_percent": 100 * linear / count, "height": height / square,
                "heading": heading / square, "rest": 1 - (height + heading) / square}


def main(arguments):
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    truth, estimate = (read_poses(path) for path in arguments)
    if len(truth) != len(estimate):
        print(f"{arguments[1]}: {len(estimate)} poses, but the truth has {len(truth)}; give two "
              "files of the same drive", file=sys.stderr)
        return 1
    shares = Drift(truth, estimate).shares()
    if shares is None:
        print(f"{arguments[0]}: shorter than 100 m", file=sys.stderr)
        return 1
    print(f"RTE {shares['rte_percent']:.3f} %, of whose square height {100 * shares['height']:.0f} "
          f"%, heading {100 * shares['heading']:.0f} %, rest {100 * shares['rest']:.0f} %")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
