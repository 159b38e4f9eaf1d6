#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Bad input: `run` says in one line what is wrong where, and what to do, and leaves nothing."""

import os
import resource
import shutil
import struct

from program import ProgramTest, main, write
from sequence import Sequence


class BadInputTest(ProgramTest):

    def setUp(self):
        super().setUp()
        self.sequence = Sequence(self.path("data"))

    def assert_rejected(self, words, *flags):
        """`run` fails, names all the words, and leaves neither files nor the output directory."""
        self.fail_with(1, words, "run", f"--dataset={self.path('data')}",
                       f"--output={self.path('deep', 'out')}", *flags)
        self.assertFalse(os.path.exists(self.path("deep")), "the output directory was left behind")

    def append_to(self, name, content):
        with open(self.sequence.file(name), "ab") as file:
            file.write(content)

    def configuration(self, lua):
        """A configuration of the user's own that changes the default one."""
        write(self.path("mine.lua"), 'include "semantic_kiss.lua"\n' + lua + "\nreturn RUN\n")
        return f"--config={self.path('mine.lua')}"


class TooLargeTest(BadInputTest):

    def test_a_map_that_cannot_be_written_is_refused_before_the_drive_is_over(self):
        configuration = self.configuration("""
            local SUBMAPS = RUN.local_trajectory_builder.semantic_kiss.submaps
            SUBMAPS.resolution_m = 0.002
            SUBMAPS.scans_per_submap = 2
        """)
        flags = ["run", f"--dataset={self.path('data')}", f"--output={self.path('out')}",
                 configuration]
        result = self.run_program(*flags)
        self.assertEqual(result.returncode, 1)
        self.assertIn("submap 0: a grid of ", result.stderr)
        self.assertIn("larger cells", result.stderr)
        self.assertNotIn("6/6 scans", result.stderr)
        self.assertFalse(os.path.exists(self.path("out")))


class MissingInputTest(BadInputTest):

    def test_no_such_directory(self):
        self.assert_rejected([self.path("nowhere")], f"--dataset={self.path('nowhere')}")

    def test_no_such_sequence(self):
        self.assert_rejected(["07"], "--sequence=07")

    def test_no_scans(self):
        shutil.rmtree(self.sequence.file("velodyne"))
        os.mkdir(self.sequence.file("velodyne"))
        self.assert_rejected([self.sequence.file("velodyne")])

    def test_no_such_labels(self):
        self.assert_rejected(["predictions"], "--labels_dir=predictions")

    def test_a_scan_is_missing_in_between(self):
        os.remove(self.sequence.file("velodyne/000003.bin"))
        self.assert_rejected(["scan 3 is missing"])

    def test_a_number_that_is_too_large(self):
        os.rename(self.sequence.file("velodyne/000005.bin"),
                  self.sequence.file("velodyne/3000000000.bin"))
        self.assert_rejected(["3000000000.bin", "too large"])

    def test_a_scan_beyond_the_end(self):
        self.assert_rejected(["100"], "--first_scan=100")

    def test_a_label_file_is_missing(self):
        os.remove(self.sequence.file("labels/000004.label"))
        self.assert_rejected(["000004"])

    def test_no_such_configuration(self):
        self.assert_rejected(["semantic_kis.lua", "semantic_kiss.lua"],
                             "--config=semantic_kis.lua")


class MalformedScanTest(BadInputTest):

    def test_size_is_no_multiple_of_16(self):
        self.append_to("velodyne/000003.bin", b"12345")
        size = os.path.getsize(self.sequence.file("velodyne/000003.bin"))
        self.assert_rejected(["velodyne/000003.bin", str(size), "16"])

    def test_more_labels_than_points(self):
        num_points = self.sequence.num_points(2)
        self.append_to("labels/000002.label", b"\0\0\0\0")
        self.assert_rejected(["labels/000002.label", str(num_points), str(num_points + 1)])

    def test_a_label_file_of_odd_size(self):
        self.append_to("labels/000002.label", b"\0")
        self.assert_rejected(["labels/000002.label"])

    def test_certainty_outside_0_to_1(self):
        os.mkdir(self.sequence.file("confidences"))
        for index in range(6):
            certainties = [0.9] * self.sequence.num_points(index)
            if index == 4:
                certainties[17] = 1.5
            self.sequence.write(f"confidences/{index:06d}.conf",
                                struct.pack(f"<{len(certainties)}f", *certainties))
        self.assert_rejected(["confidences/000004.conf", "17", "1.5"])

    def test_certainties_of_another_size(self):
        os.mkdir(self.sequence.file("confidences"))
        for index in range(6):
            self.sequence.write(f"confidences/{index:06d}.conf", b"\0" * 12)
        self.assert_rejected(["confidences/000000.conf"])


    def test_more_than_there_is_memory_for(self):
        os.truncate(self.sequence.file("velodyne/000003.bin"), 1 << 30)
        limit = 1 << 30
        self.fail_with(1, ["not enough memory"], "run", f"--dataset={self.path('data')}",
                       f"--output={self.path('deep', 'out')}", "--threads=1", "--quiet",
                       preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
        self.assertFalse(os.path.exists(self.path("deep")))

    def test_not_one_point_in_all_scans(self):
        for index in range(6):
            self.sequence.write(f"velodyne/{index:06d}.bin", b"")
            self.sequence.write(f"labels/{index:06d}.label", b"")
        self.assert_rejected(["nothing to draw"], "--quiet")


class MalformedTextTest(BadInputTest):

    def test_times_do_not_increase(self):
        self.sequence.write("times.txt", "0\n0.1\n0.2\n0.2\n0.4\n0.5\n")
        self.assert_rejected(["times.txt", "0.2"])

    def test_too_few_times(self):
        self.sequence.write("times.txt", "0\n0.1\n")
        self.assert_rejected(["times.txt", "2"])

    def test_times_are_a_pipe(self):
        os.remove(self.sequence.file("times.txt"))
        os.mkfifo(self.sequence.file("times.txt"))
        self.assert_rejected(["times.txt", "not a regular file"])

    def test_times_are_no_numbers(self):
        self.sequence.write("times.txt", "0\n0.1\nsoon\n0.3\n0.4\n0.5\n")
        self.assert_rejected(["times.txt", "soon"])

    def test_malformed_calibration(self):
        self.sequence.write("calib.txt", "Tr: 1 2 3\n")
        self.assert_rejected(["calib.txt:1", "12"])

    def test_a_calibration_that_is_no_rotation(self):
        self.sequence.write("calib.txt", "Tr: 2 0 0 0 0 2 0 0 0 0 2 0\n")
        self.assert_rejected(["calib.txt:1", "rotation"])

    def test_malformed_poses(self):
        self.sequence.write("poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 one 0 0 0 0 1 0\n")
        self.assert_rejected(["poses.txt:2", "one"])

    def test_too_few_poses(self):
        self.sequence.write("poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n")
        self.assert_rejected(["poses.txt"])


class BadConfigurationTest(BadInputTest):

    def test_unknown_key(self):
        self.assert_rejected(["mine.lua", "dataset.vertical_corection_deg",
                              "vertical_correction_deg"],
                             self.configuration("RUN.dataset.vertical_corection_deg = 1"))

    def test_missing_key(self):
        self.assert_rejected(["mine.lua", "dataset.assumed_rate_hz"],
                             self.configuration("RUN.dataset.assumed_rate_hz = nil"))

    def test_out_of_range(self):
        self.assert_rejected(["mine.lua", "dataset.assumed_rate_hz", "-3"],
                             self.configuration("RUN.dataset.assumed_rate_hz = -3"))

    def test_numbers_so_small_that_nothing_could_be_computed_with_them(self):
        self.assert_rejected(["mine.lua", "dataset.assumed_rate_hz", "1e-300"],
                             self.configuration("RUN.dataset.assumed_rate_hz = 1e-300"))
        for option, value in (("hit_probability", "0.5000001"), ("resolution_m", "1e-06")):
            write(self.path("mine.lua"), f"""include "cartographer.lua"
                RUN.local_trajectory_builder.planar.submaps.grid.{option} = {value}
                return RUN""")
            self.assert_rejected(["mine.lua", f"submaps.grid.{option}", value],
                                 f"--config={self.path('mine.lua')}")

    def test_wrong_type(self):
        self.assert_rejected(["mine.lua", "dataset.assumed_rate_hz"],
                             self.configuration('RUN.dataset.assumed_rate_hz = "fast"'))

    def test_syntax(self):
        self.assert_rejected(["mine.lua"], self.configuration("RUN = = 3"))

    def test_unknown_builder(self):
        self.assert_rejected(["local_trajectory_builder.name", "magic"],
                             self.configuration('RUN.local_trajectory_builder.name = "magic"'))

    def test_unknown_label_set(self):
        self.assert_rejected(["label_set", "semantic_kity"],
                             self.configuration('RUN.label_set = "semantic_kity"'))

    def test_unknown_label_to_hide(self):
        self.assert_rejected(["trukc", "truck"],
                             self.configuration('RUN.map_image.hide = { "trukc" }'))


if __name__ == "__main__":
    main()
