#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""What a person sees: progress and summary on terminals of several widths."""

import fcntl
import os
import pty
import re
import struct
import subprocess
import termios

from program import BINARY, ProgramTest, main
from sequence import Sequence

COLOR = re.compile(r"\033\[[0-9;]*m")
CLEAR_TO_END = "\033[K"


class TerminalTest(ProgramTest):

    def setUp(self):
        super().setUp()
        # Long enough for the bar to be drawn more than once.
        Sequence(self.path("data"), num_scans=60)

    def watch(self, columns, *arguments, **environment):
        """Runs in a terminal of this width; returns the exit code and all that was shown."""
        leader, follower = pty.openpty()
        fcntl.ioctl(follower, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
        variables = {key: value for key, value in os.environ.items() if key != "NO_COLOR"}
        variables.update({"TERM": "xterm", **environment})
        process = subprocess.Popen([BINARY, *arguments], stdin=follower, stdout=follower,
                                   stderr=follower, env=variables)
        os.close(follower)
        shown = b""
        while True:
            try:
                part = os.read(leader, 65536)
            except OSError:  # how Linux says that the other side is closed
                break
            if not part:
                break
            shown += part
        os.close(leader)
        return process.wait(), shown.decode().replace("\r\n", "\n")

    def drive(self, columns, **environment):
        code, shown = self.watch(columns, "run", f"--dataset={self.path('data')}",
                                 f"--output={self.path('out')}", **environment)
        self.assertEqual(code, 0, shown)
        return shown

    def test_a_bar_and_a_coloured_summary(self):
        shown = self.drive(100)
        self.assertIn("\r[", shown)
        self.assertRegex(shown, r"100% 60/60 ETA 0:00 .*/s odometry off by .* m" +
                         re.escape(CLEAR_TO_END))
        # What came after the scans was told, and taken back before the summary.
        self.assertRegex(shown, "\\rmap, pictures and report" + r"[^\r]*\r" +
                         re.escape(CLEAR_TO_END) + r"\S*scans")
        self.assertRegex(shown, COLOR)

    def test_nothing_is_wider_than_the_terminal(self):
        for columns in (100, 60, 40):
            shown = COLOR.sub("", self.drive(columns)).replace(CLEAR_TO_END, "")
            for line in re.split("[\r\n]", shown):
                if "/" in line and " " not in line.strip().replace("output", "").strip():
                    continue  # paths stay whole
                self.assertLessEqual(len(line), columns, line)

    def test_no_color_is_respected(self):
        self.assertIsNone(COLOR.search(self.drive(80, NO_COLOR="1")))
        self.assertIsNone(COLOR.search(self.drive(80, TERM="dumb")))

    def test_an_error_begins_a_line_of_its_own(self):
        with open(self.path("data", "sequences", "00", "labels", "000050.label"), "ab") as file:
            file.write(b"\0\0\0\0")
        code, shown = self.watch(80, "run", f"--dataset={self.path('data')}",
                                 f"--output={self.path('out')}", NO_COLOR="1")
        self.assertEqual(code, 1)
        self.assertRegex(shown, r"(^|\n)error: .*000050\.label")


if __name__ == "__main__":
    main()
