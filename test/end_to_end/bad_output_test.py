#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Outputs that cannot be written: one line says why, and what is there is whole."""

import os
import subprocess

from program import RUN_FILES, ProgramTest, main, read, write
from sequence import Sequence


class BadOutputTest(ProgramTest):

    def setUp(self):
        super().setUp()
        Sequence(self.path("data"))

    def flags(self, output):
        return ["run", f"--dataset={self.path('data')}", f"--output={output}", "--quiet"]

    def mount(self, options):
        """A small file system of its own, to be filled or locked."""
        path = self.path("mounted")
        os.makedirs(path, exist_ok=True)
        result = subprocess.run(["mount", "-t", "tmpfs", "-o", options, "tmpfs", path],
                                stderr=subprocess.PIPE, text=True)
        if result.returncode != 0:
            self.skipTest(f"mounting a tmpfs is not permitted here: {result.stderr.strip()}")
        self.addCleanup(subprocess.run, ["umount", path], check=True)
        return path

    def test_below_a_regular_file(self):
        write(self.path("file"), "")
        self.fail_with(1, [self.path("file/out"), "--output"], *self.flags(self.path("file/out")))

    def test_the_output_is_a_regular_file(self):
        write(self.path("file"), "precious")
        self.fail_with(1, [self.path("file")], *self.flags(self.path("file")))
        self.assertEqual(read(self.path("file")), b"precious")

    def test_a_read_only_file_system(self):
        mounted = self.mount("size=1m,ro")
        self.fail_with(1, [mounted, "Read-only"], *self.flags(mounted))
        self.fail_with(1, [mounted, "Read-only"], *self.flags(os.path.join(mounted, "out")))

    def test_one_of_the_files_is_a_directory(self):
        os.makedirs(self.path("out", "trajectory_tum.txt"))
        self.fail_with(1, ["trajectory_tum.txt"], *self.flags(self.path("out")))
        self.assertEqual(os.listdir(self.path("out")), ["trajectory_tum.txt"])

    def test_disk_full(self):
        # From "not even the first file" to "all but the last".
        for size_kib in (4, 16, 64, 128, 256):
            with self.subTest(size_kib=size_kib):
                mounted = self.mount(f"size={size_kib}k")
                self.fail_with(1, [mounted, "disk full"], *self.flags(mounted))
                self.assertEqual(os.listdir(mounted), [])

    def test_a_full_disk_leaves_earlier_results_alone(self):
        # Room for some of the new files, not for all.
        for size_kib in (48, 128, 256):
            with self.subTest(size_kib=size_kib):
                mounted = self.mount(f"size={size_kib}k")
                for name in RUN_FILES:
                    write(os.path.join(mounted, name), b"older: " + name.encode())
                self.fail_with(1, [mounted, "disk full"], *self.flags(mounted))
                self.assertEqual(sorted(os.listdir(mounted)), RUN_FILES)
                for name in RUN_FILES:
                    self.assertEqual(read(mounted, name), b"older: " + name.encode())


if __name__ == "__main__":
    main()
