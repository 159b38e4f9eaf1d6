#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""The manual page and shell completion, as the build generates them."""

import os
import re
import shlex
import shutil
import subprocess
import unittest

import zsh
from program import BINARY, ProgramTest, main

MANUAL = os.path.join(os.path.dirname(BINARY), "..", "manual")
PAGE = os.path.join(MANUAL, "semantic_kiss.1")
BASH = os.path.join(MANUAL, "semantic_kiss.bash")
ZSH = os.path.join(MANUAL, "_semantic_kiss")
NO_GROFF = "there is no groff, which Debian's groff-base has"


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def may_be_bare(flag):
    return "[=" in flag


def plain(flag):
    """A flag whose value may be left out ("--live[=PORT]") like any other."""
    return flag.replace("[=", "=").rstrip("]")


class ManualTest(ProgramTest):

    def commands(self):
        """Names of all commands, from --help."""
        overview = self.succeed("--help").split("Commands\n")[1].split("\n\n")[0]
        names = re.findall(r"^  (\w+) ", overview, re.MULTILINE)
        self.assertIn("run", names)
        return names

    def flags(self, command):
        """Flags of a command with their placeholders ("--dataset=DIR", "--live[=PORT]"), from
        --help."""
        flags = re.findall(r"^  (--\S+)", self.succeed(command, "--help"), re.MULTILINE)
        self.assertTrue(flags)
        return flags


class ManPageTest(ManualTest):

    def test_every_command_has_a_section_with_all_of_its_flags(self):
        sections = dict(re.findall(r"^\.SS (\w+)\n(.*?)(?=^\.S[SH] )", read(PAGE),
                                   re.MULTILINE | re.DOTALL))
        self.assertEqual(sorted(sections), sorted(self.commands()))
        for command, section in sections.items():
            terms = [line[3:].replace("\\-", "-") for line in section.splitlines()
                     if line.startswith(".B ")]
            for flag in self.flags(command):
                self.assertIn(plain(flag), [plain(term) for term in terms], command)

    @unittest.skipUnless(shutil.which("groff"), NO_GROFF)
    def test_groff_has_nothing_to_say_against_it(self):
        result = subprocess.run(["groff", "-man", "-ww", "-Tutf8", PAGE], capture_output=True,
                                text=True, check=True)
        self.assertEqual(result.stderr, "")
        text = re.sub(".\b|\033\\[[0-9;]*m", "", result.stdout)  # bold, underlined
        self.assertTrue("--dataset=DIR" in text, "hyphens have to stay what one types")
        self.assertTrue("EXIT STATUS" in text)
        self.assertFalse("\\" in text, "something is escaped twice")


class BashTest(ManualTest):

    def complete(self, typed, setup="", directory=None):
        """What bash offers where the cursor stands at the end of the line."""
        script = (f"source {shlex.quote(BASH)}\n{setup}\n"
                  f"COMP_LINE={shlex.quote(typed)} COMP_POINT={len(typed)}\n"
                  f"{self.function} {shlex.quote(BINARY)}\n"
                  'for reply in "${COMPREPLY[@]}"; do printf "%s\\n" "$reply"; done')
        result = subprocess.run(["bash", "--norc", "-c", script], capture_output=True, text=True,
                                cwd=directory or self.directory, check=False)
        self.assertEqual(result.stderr, "")
        return result.stdout.splitlines()

    def setUp(self):
        super().setUp()
        registered = subprocess.run(
            ["bash", "--norc", "-c", f"source {shlex.quote(BASH)}; complete -p semantic_kiss"],
            capture_output=True, text=True, check=True).stdout
        self.function = re.fullmatch(r"complete -F (\w+) semantic_kiss\n", registered)[1]

    def test_commands(self):
        self.assertEqual(set(self.complete("semantic_kiss ")),
                         {*self.commands(), "help", "--help", "--version"})
        self.assertEqual(self.complete("semantic_kiss rel"), ["relocalize"])
        self.assertEqual(self.complete("semantic_kiss help si"), ["simulate"])

    def test_every_flag_of_every_command(self):
        for command in self.commands():
            flags = {re.sub("=.*", "=", plain(flag)) for flag in self.flags(command)}
            flags |= {re.sub(r"\[=.*", "", flag) for flag in self.flags(command)
                      if may_be_bare(flag)}
            self.assertEqual(set(self.complete(f"semantic_kiss {command} --")),
                             flags | {"--help"}, command)
        self.assertEqual(self.complete("semantic_kiss run --quiet --data"), ["--dataset="])

    def test_configurations_by_name_and_as_files(self):
        os.mkdir(self.path("my files"))
        open(self.path("semantic_mine.lua"), "w").close()
        for typed in ("run --config=sem", "run --config sem"):
            offered = self.complete("semantic_kiss " + typed)
            self.assertIn("semantic_kiss_6dof.lua", offered)
            self.assertIn("semantic_mine.lua", offered)
            self.assertNotIn("kiss_icp.lua", offered)
        self.assertEqual(self.complete("semantic_kiss run --config=my"), ["my files"])

    def test_files_directories_and_words(self):
        os.mkdir(self.path("data"))
        open(self.path("data.pbstream"), "w").close()
        self.assertEqual(set(self.complete("semantic_kiss info --map=da")),
                         {"data", "data.pbstream"})
        self.assertEqual(self.complete("semantic_kiss run --dataset=da"), ["data"])
        self.assertEqual(self.complete("semantic_kiss simulate --route=h"), ["highway"])
        self.assertEqual(self.complete("semantic_kiss filter --remove_role=mov"),
                         ["moving", "movable"])
        self.assertEqual(self.complete("semantic_kiss run --num_scans="), [])

    def test_a_value_that_may_be_left_out(self):
        self.assertEqual(self.complete("semantic_kiss run --liv"), ["--live", "--live="])
        self.assertIn("--dataset=", self.complete("semantic_kiss run --live --da"))
        self.assertEqual(self.complete("semantic_kiss run --live --config=kiss"), ["kiss_icp.lua"])

    def test_where_equals_signs_break_no_words(self):
        self.assertEqual(self.complete("semantic_kiss simulate --route=h", "COMP_WORDBREAKS=' '"),
                         ["--route=highway"])

    def test_patterns_on_the_line_are_left_alone(self):
        open(self.path("a_file"), "w").close()
        self.assertEqual(self.complete("semantic_kiss filter * --map=a_"), ["a_file"])


class ZshTest(ManualTest):

    def test_says_what_each_flag_is_for(self):
        cases = dict(re.findall(r"^    (\w+)\)\n(.*?);;", read(ZSH), re.MULTILINE | re.DOTALL))
        self.assertEqual(sorted(cases), sorted(self.commands()))
        for command, case in cases.items():
            for flag in self.flags(command):
                self.assertRegex(case, "'" + re.sub("=.*", "", plain(flag)) + r"(=-?)?\[\w", command)


@unittest.skipUnless(shutil.which("zsh"), "there is no zsh: scripts/setup.sh --test")
class ZshTabTest(ManualTest):
    """The Tab key in a real zsh."""

    def setUp(self):
        super().setUp()
        path = os.path.dirname(BINARY) + os.pathsep + os.environ["PATH"]
        self.zsh = self.enterContext(zsh.Zsh(os.path.abspath(MANUAL), path, self.directory))

    def line(self, typed):
        return self.zsh.complete(f"semantic_kiss {typed}")[0].removeprefix("semantic_kiss ")

    def offered(self, typed):
        return self.zsh.complete(f"semantic_kiss {typed}")[1]

    def test_commands(self):
        self.assertEqual(self.offered(""), {*self.commands(), "help"})
        self.assertEqual(self.offered("--"), {"--help", "--version"})
        self.assertEqual(self.line("rel"), "relocalize ")
        self.assertEqual(self.line("help si"), "help simulate ")
        self.assertEqual(self.offered("help simulate "), set())

    def test_every_flag_of_every_command(self):
        for command in self.commands():
            flags = {re.sub("=.*", "", plain(flag)) for flag in self.flags(command)}
            self.assertEqual(self.offered(f"{command} --"), flags | {"--help"}, command)
        self.assertEqual(self.line("run --quiet --data"), "run --quiet --dataset=")

    def test_configurations_by_name_and_as_files(self):
        open(self.path("semantic_mine.lua"), "w").close()
        for typed in ("run --config=sem", "run --config sem"):
            self.assertLessEqual({"semantic_kiss_6dof.lua", "semantic_mine.lua"},
                                 self.offered(typed))
            self.assertNotIn("kiss_icp.lua", self.offered(typed))

    def test_files_directories_and_words(self):
        os.mkdir(self.path("data"))
        open(self.path("data.pbstream"), "w").close()
        self.assertEqual(self.offered("info --map=da"), {"data", "data.pbstream"})
        self.assertEqual(self.line("run --dataset=da"), "run --dataset=data/")
        self.assertEqual(self.line("simulate --route=h"), "simulate --route=highway ")
        self.assertEqual(self.offered("filter --remove_role=mov"), {"moving", "movable"})
        self.assertEqual(self.offered("run --num_scans="), set())

    def test_a_value_that_may_be_left_out(self):
        self.assertEqual(self.offered("run --liv"), {"--live"})
        self.assertEqual(self.line("run --live --da"), "run --live --dataset=")
        self.assertEqual(self.offered("run --live="), set())


if __name__ == "__main__":
    main()
