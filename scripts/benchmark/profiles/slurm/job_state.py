#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Tells Snakemake how a Slurm job stands: job_state.py JOB prints running, success or failed.

Asks the controller, which forgets a job some minutes after its end, then the accounting, which not
every cluster has.
"""

import re
import subprocess
import sys

RUNNING = ("PENDING", "CONFIGURING", "RUNNING", "COMPLETING", "SUSPENDED", "STOPPED", "REQUEUED",
           "RESIZING", "SIGNALING", "STAGE_OUT")


def answer(command):
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    return result.stdout if result.returncode == 0 else ""


def slurm_state(job):
    """Slurm's word for the state of a job; empty if nobody knows the job."""
    told = re.search(r"JobState=(\w+)", answer(["scontrol", "show", "job", "--oneliner", job]))
    if told:
        return told.group(1)
    accounted = answer(["sacct", "--allocations", "--noheader", "--format=State", f"--jobs={job}"])
    return accounted.split()[0].rstrip("+") if accounted.split() else ""


def snakemake_state(state):
    if state == "COMPLETED":
        return "success"
    return "running" if state in RUNNING else "failed"


if __name__ == "__main__":
    print(snakemake_state(slurm_state(sys.argv[1])))
