#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Maps whose names or texts are not UTF-8: nothing is lost for them, and JSON stays JSON."""

import json
import os

from pbstream import field, read_records, write_records
from program import ProgramTest, main, read
from sequence import Sequence

# Python's way to name the byte 0xFF, which UTF-8 never has.
ODD = "\udcff"
# Of the header's message, and of that: semantic_map.proto.
DESCRIPTION, HISTORY = 1000, 3


class OddBytesTest(ProgramTest):

    def setUp(self):
        super().setUp()
        self.data = self.path("data")
        Sequence(self.data)
        self.succeed("run", f"--dataset={self.data}", f"--output={self.path('out')}", "--quiet")
        self.map = self.path("out", "map.pbstream")

    def test_relocalize_writes_all_of_its_files(self):
        odd_map = self.path(f"map{ODD}.pbstream")
        os.rename(self.map, odd_map)
        self.succeed("relocalize", f"--map={odd_map}", f"--dataset={self.data}",
                     f"--output={self.path('day2')}", "--quiet")
        told = json.loads(read(self.path("day2"), "relocalization.json"))
        self.assertEqual(told["map"], self.path("map\ufffd.pbstream"))

    def test_info_prints_the_history_of_a_foreign_map(self):
        records = read_records(self.map)
        records[0] += field(DESCRIPTION, field(HISTORY, b"caf\xe9"))
        write_records(self.path("foreign.pbstream"), records)
        told = json.loads(self.succeed("info", f"--map={self.path('foreign.pbstream')}", "--json"))
        self.assertEqual(told["history"][-1], "caf\ufffd")


if __name__ == "__main__":
    main()
