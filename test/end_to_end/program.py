# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Runs the binary and says what may be expected of it, whatever it does."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

BINARY = os.path.abspath(os.environ.get("SEMANTIC_KISS_BINARY", "build/bin/semantic_kiss"))

# What `run` writes; the last two tell times, the others are the same in every run.
REPEATABLE_FILES = ["map.png", "map.pbstream", "odometry_kitti.txt", "trajectory_kitti.txt",
                    "trajectory_tum.txt"]
RUN_FILES = sorted(REPEATABLE_FILES + ["report.html", "run.json"])


def data_directory():
    """Real data; may not exist."""
    source = os.environ.get("SEMANTIC_KISS_SOURCE_DIR", ".")
    return os.environ.get("SEMANTIC_KISS_DATA") or os.path.join(source, "..", "shared", "data")


def read(*path):
    with open(os.path.join(*path), "rb") as file:
        return file.read()


def write(path, content):
    with open(path, "wb") as file:
        file.write(content if isinstance(content, bytes) else content.encode())


class ProgramTest(unittest.TestCase):
    """A test with a directory of its own, `self.directory`."""

    def setUp(self):
        self.directory = tempfile.mkdtemp(prefix="semantic_kiss_")
        self.addCleanup(shutil.rmtree, self.directory)

    def path(self, *names):
        return os.path.join(self.directory, *names)

    def start(self, *arguments, **options):
        return subprocess.Popen([BINARY, *arguments], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, **options)

    def run_program(self, *arguments, **options):
        return subprocess.run([BINARY, *arguments], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, timeout=300, **options)

    def succeed(self, *arguments, **options):
        """Runs to the end with exit code 0; returns what was printed."""
        result = self.run_program(*arguments, **options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def fail_with(self, code, words, *arguments, **options):
        """Runs into an error: this exit code, and one line on stderr that holds all the words."""
        result = self.run_program(*arguments, **options)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertEqual(result.stdout, "")
        self.assert_one_line(result.stderr, "error: ")
        for word in words:
            self.assertIn(word, result.stderr)
        return result.stderr

    def assert_one_line(self, text, prefix):
        self.assertEqual(text.count("\n"), 1, text)
        self.assertTrue(text.endswith("\n"), text)
        self.assertTrue(text.startswith(prefix), text)

    def assert_only_whole_run_files(self, directory):
        """Some of the files of `run` may be there, nothing else, no temporary ones."""
        names = sorted(os.listdir(directory)) if os.path.exists(directory) else []
        self.assertLessEqual(set(names), set(RUN_FILES))
        for name in names:
            content = read(directory, name)
            if name.endswith(".txt"):
                self.assertTrue(content.endswith(b"\n"), name)
            if name == "map.png":
                self.assertTrue(content.endswith(b"IEND\xaeB`\x82"), name)
            if name == "report.html":
                self.assertTrue(content.endswith(b"</html>\n"), name)
        return names


def main():
    """To be called by every test's file. Quiet unless something fails or is skipped."""
    program = unittest.main(argv=[sys.argv[0]], exit=False, verbosity=0)
    for test, reason in program.result.skipped:
        print(f"SKIPPED {test}: {reason}", file=sys.stderr)
    if program.result.skipped and len(program.result.skipped) == program.result.testsRun:
        print("SKIPPED ALL", file=sys.stderr)
    sys.exit(not program.result.wasSuccessful())
