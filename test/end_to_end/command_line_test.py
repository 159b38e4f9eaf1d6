#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""The command line itself: help, version, usage errors."""

import os
import shutil
import subprocess

from program import BINARY, ProgramTest, main

COMMANDS = ["run", "evaluate", "info", "render", "config"]


class CommandLineTest(ProgramTest):

    def test_help_lists_the_commands(self):
        help_text = self.succeed("--help")
        for command in COMMANDS:
            self.assertIn(f"  {command} ", help_text)
        self.assertEqual(self.succeed("help"), help_text)

    def test_every_command_explains_itself(self):
        for command in COMMANDS:
            help_text = self.succeed(command, "--help")
            self.assertIn(f"semantic_kiss {command}", help_text)
            self.assertIn("Examples", help_text)
            self.assertEqual(self.succeed("help", command), help_text)

    def test_version(self):
        self.assertRegex(self.succeed("--version"), r"^semantic_kiss \d+\.\d+\.\d+\n$")

    def test_usage_errors_name_what_was_meant(self):
        self.fail_with(2, ["--help"])
        self.fail_with(2, ["rnu", "run"], "rnu")
        self.fail_with(2, ["--datset", "--dataset"], "run", "--datset=x")
        self.fail_with(2, ["--dataset=DIR"], "run", "--output=x")
        self.fail_with(2, ["--num_scans=-3"], "run", "--num_scans=-3")
        self.fail_with(2, ["--threads=two"], "run", "--threads=two")
        self.fail_with(2, ["--threads=2000000000", "at most 1024"], "run", "--threads=2000000000")
        self.fail_with(2, ["--resolution=inf", "at most 100"], "render", "--resolution=inf")
        self.fail_with(2, ["surplus"], "run", "surplus")

    def test_nothing_is_coloured_in_a_file(self):
        self.assertNotIn("\033", self.succeed("run", "--help"))

    def test_a_full_standard_output_is_an_error(self):
        with open("/dev/full", "wb") as full:
            result = subprocess.run([BINARY, "config"], stdout=full, stderr=subprocess.PIPE,
                                    text=True)
        self.assertEqual(result.returncode, 1)
        self.assert_one_line(result.stderr, "error: ")


class ConfigTest(ProgramTest):

    def test_what_is_printed_resolves_to_itself(self):
        for system in ("semantic_kiss.lua", "semantic_kiss_loop_closure.lua", "semantic_kiss_6dof.lua",
                       "kiss_icp.lua", "sage_icp.lua", "cartographer.lua",
                       "cartographer_loop_closure.lua"):
            resolved = self.succeed("config", f"--config={system}")
            path = self.path("resolved.lua")
            with open(path, "w") as file:
                file.write(resolved)
            self.assertEqual(self.succeed("config", f"--config={path}"), resolved)

    def test_systems_differ_in_their_mode(self):
        self.assertIn('mode = "semantic_kiss"', self.succeed("config"))
        self.assertIn('mode = "kiss_icp"', self.succeed("config", "--config=kiss_icp.lua"))

    def test_a_file_of_ones_own_changes_a_few_keys(self):
        path = self.path("mine.lua")
        with open(path, "w") as file:
            file.write('include "semantic_kiss.lua"\n'
                       "RUN.dataset.vertical_correction_deg = 0\nreturn RUN\n")
        self.assertIn("vertical_correction_deg = 0,", self.succeed("config", "--config", path))
        # By its bare name as well, from the directory where it is.
        self.assertIn("vertical_correction_deg = 0,",
                      self.succeed("config", "--config=mine.lua", cwd=self.directory))

    def test_the_programs_own_files_stand_beside_its_folder(self):
        os.mkdir(self.path("bin"))
        program = shutil.copy(BINARY, self.path("bin"))
        result = subprocess.run([program, "config"], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, cwd=self.directory)
        self.assertEqual(result.returncode, 1)
        self.assert_one_line(result.stderr, "error: ")
        self.assertIn(self.path("share/semantic_kiss/configuration_files"), result.stderr)
        source = os.environ.get("SEMANTIC_KISS_SOURCE_DIR", ".")
        shutil.copytree(os.path.join(source, "configuration_files"),
                        self.path("share", "semantic_kiss", "configuration_files"))
        self.assertEqual(subprocess.check_output([program, "config"], text=True,
                                                 cwd=self.directory), self.succeed("config"))

    def test_a_label_set_of_ones_own_lies_beside_the_file(self):
        os.mkdir(self.path("labels"))
        with open(self.path("labels", "mine.lua"), "w") as file:
            file.write('return { name = "mine", default_certainty = 1, classes = {\n'
                       '  { id = 0, name = "nothing", color = {0, 0, 0}, roles = {"unlabeled"} },\n'
                       "} }\n")
        with open(self.path("mine.lua"), "w") as file:
            file.write('include "semantic_kiss.lua"\nRUN.label_set = "mine"\nreturn RUN\n')
        self.assertIn('label_set = "mine"',
                      self.succeed("config", "--config", self.path("mine.lua")))


if __name__ == "__main__":
    main()
