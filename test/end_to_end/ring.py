# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Simulates a drive round a small ring road, farther than once: a loop to close."""

import os
import subprocess

from program import BINARY, write

RING_LUA = """
local options = include "simulation.lua"
options.lidar = "vlp16"
options.seed = 4
options.route.kind = "loop"
options.route.ring_m = {ring_m}
options.route.length_m = {length_m}
options.scan_rate_hz = {scan_rate_hz}
options.label_noise.share = 0.06
return options
"""


def simulate_ring(directory, ring_m=200., length_m=300., scan_rate_hz=10.):
    lua = RING_LUA.format(ring_m=ring_m, length_m=length_m, scan_rate_hz=scan_rate_hz)
    write(os.path.join(directory, "ring.lua"), lua)
    subprocess.run([BINARY, "simulate", f"--config={directory}/ring.lua", f"--output={directory}",
                    "--quiet"], check=True)
