# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Trajectories in KITTI's format, laid over the true ones as ATE-3D does, and their errors."""

import numpy


def read_positions(path):
    """N x 3 positions of the camera (x right, y down, z ahead), metres."""
    poses = numpy.loadtxt(path, ndmin=2)
    return poses[:, [3, 7, 11]]


def travelled(positions):
    """N distances along the way, metres, the first one 0."""
    steps = numpy.linalg.norm(numpy.diff(positions, axis=0), axis=1)
    return numpy.concatenate([[0.0], numpy.cumsum(steps)])


def aligned(estimate, truth):
    """The estimate turned and shifted, not scaled, to lie as near as it can to the truth.

    Both N x 3, N >= 1. Source: Umeyama, "Least-Squares Estimation of Transformation Parameters
    Between Two Point Patterns", PAMI 1991.
    """
    center, goal = estimate.mean(axis=0), truth.mean(axis=0)
    left, _, right = numpy.linalg.svd((truth - goal).T @ (estimate - center))
    signs = numpy.diag([1.0, 1.0, numpy.sign(numpy.linalg.det(left @ right))])
    return (estimate - center) @ (left @ signs @ right).T + goal


def errors(estimate, truth):
    """N distances between the aligned estimate and the truth, metres; and how much of each is
    height (upwards is positive)."""
    difference = aligned(estimate, truth) - truth
    return numpy.linalg.norm(difference, axis=1), -difference[:, 1]
