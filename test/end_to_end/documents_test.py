#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Runs every command line that README.md and docs/ show, on one small simulated drive.

A block that is indented, or fenced as "sh", is command lines. What stands for something else in
them is replaced by what PLACEHOLDERS say; a capital word that is not there fails the test. So does
a block of a language that is not in CHECKS: commands, Lua and Python are run, "text" and "cmake"
are not.
"""

import glob
import os
import re
import shutil
import stat
import subprocess
import sys
import tempfile
import unittest

from documents import blocks_of, commands_of, mentioned_flags, mentioned_options
from program import BINARY, ProgramTest, main, read, write
from ring import simulate_ring

SOURCE = os.environ.get("SEMANTIC_KISS_SOURCE_DIR", ".")
BUILD = os.path.dirname(os.path.dirname(BINARY))

# What the reader is to fill in. The one drive serves as all sequences of all data sets.
PLACEHOLDERS = {
    "DIR": "data",
    "NN": "07",
    "DATASET": "simulated/benchmark",
    "OUTPUT": "output/benchmark",
    "SYSTEM": "semantic_kiss_loop_closure",
    "/data/semantickitti": "data",
}
SEQUENCES = ["00", "01", "05", "07", "10"]
UNLABELED_SEQUENCE = "08"  # docs/labels.md makes labels for it

# Added to each of these commands, so that all of them take a minute.
SHORTENED = {
    "run": "--num_scans=20",
    "simulate": "--num_scans=2 --lidar=vlp16",
    "relocalize": "--num_scans=25",
    "scripts/relocalization_trials.py": "--starts=1 --num_scans=12",
}
# Except where that would not do: another drive is joined to a map only where it goes on for a while.
SHORTENED_LESS = {"--map=": "--num_scans=60"}

# Not run, because they install, build and take minutes; that they are there, and bash, is checked.
BUILDS = {"scripts/benchmark.sh", "scripts/build.sh", "scripts/demo.sh", "scripts/microbenchmark.sh",
          "scripts/test.sh"}
STOCK = {"cartographer_pbstream"}  # Cartographer's own program, which is not here


# How docs/tuning.md calls two tables of options.
SHORT_FORMS = {
    "BUILDER": "local_trajectory_builder.semantic_kiss",
    "ACCEPTANCE": "pose_graph.verification.acceptance",
}


def documents():
    """(name, text) of all documents that show command lines."""
    paths = [os.path.join(SOURCE, "README.md")]
    paths += sorted(glob.glob(os.path.join(SOURCE, "docs", "**", "*.md"), recursive=True))
    return [(os.path.relpath(path, SOURCE), read(path).decode()) for path in paths]


def python_with_numpy():
    """Debian's packages are for Debian's Python, which need not be the one that runs this."""
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import numpy"], stderr=subprocess.DEVNULL,
                          check=False).returncode == 0:
            return python
    return None


class DocumentsTest(ProgramTest):
    """One workspace for all: maps and trajectories of a drive under the names that documents use."""

    @classmethod
    def setUpClass(cls):
        cls.workspace = tempfile.mkdtemp(prefix="semantic_kiss_")
        cls.addClassCleanup(shutil.rmtree, cls.workspace)
        drive = cls.at("simulated")
        os.mkdir(drive)
        simulate_ring(drive, ring_m=200., length_m=350., scan_rate_hz=5.)
        sequence = os.path.join(drive, "sequences", "00")
        os.symlink("labels", os.path.join(sequence, "predictions"))
        shutil.copy(os.path.join(sequence, "poses.txt"),
                    os.path.join(sequence, "poses_semantickitti.txt"))
        os.makedirs(cls.at("data", "sequences"))
        os.mkdir(cls.at("poses"))
        for name in SEQUENCES:
            os.symlink(sequence, cls.at("data", "sequences", name))
            shutil.copy(os.path.join(sequence, "poses.txt"), cls.at("poses", name + ".txt"))
        os.mkdir(cls.at("data", "sequences", UNLABELED_SEQUENCE))
        os.symlink(os.path.join(sequence, "velodyne"),
                   cls.at("data", "sequences", UNLABELED_SEQUENCE, "velodyne"))
        os.symlink(BUILD, cls.at("build"))
        for name in ("scripts", "configuration_files", "docs", "test"):
            os.symlink(os.path.join(os.path.abspath(SOURCE), name), cls.at(name))
        subprocess.run([BINARY, "run", "--config=semantic_kiss_6dof.lua", "--dataset=data",
                        "--output=output/whole", "--quiet"], check=True, cwd=cls.workspace,
                       stdout=subprocess.DEVNULL)
        shutil.copytree(cls.at("output", "whole"), cls.at("output", "00"))
        for name in ("cartographer", "lasting", "map", "monday", "saved", "tuesday"):
            shutil.copy(cls.at("output", "whole", "map.pbstream"), cls.at(name + ".pbstream"))

    @classmethod
    def at(cls, *names):
        return os.path.join(cls.workspace, *names)

    def shell(self, place, command):
        environment = dict(os.environ, PATH=f"{BUILD}/bin:{os.environ['PATH']}")
        result = subprocess.run(["bash", "-euo", "pipefail", "-c", command], capture_output=True,
                                text=True, cwd=self.workspace, env=environment, timeout=120,
                                check=False)
        self.assertEqual(result.returncode, 0, f"{place}: {command}\n{result.stderr}")
        return result.stdout

    # What is run.

    def filled_in(self, place, command, number):
        """The command with everything that stands for something replaced."""
        name = command.split()[0].removeprefix("build/bin/")
        kind = command.split()[1] if name == "semantic_kiss" else name
        placeholders = dict(PLACEHOLDERS, OUT="output/whole")
        if kind == "run":
            placeholders["OUT"] = f"output/{number}"
        if kind == "simulate":
            placeholders["DIR"] = f"simulated/{number}"
        for word, value in placeholders.items():
            command = re.sub(rf"(?<!\w){word}(?!\w)", value, command)
        unknown = re.findall(r"(?<![\w$])[A-Z][A-Z_]*(?![\w.])", command)
        self.assertEqual(unknown, [], f"{place}: say in PLACEHOLDERS what to put there: {command}")
        self.assertNotIn("...", command, f"{place}: a command is to be shown in full")
        extra = SHORTENED.get(kind, "")
        for flag, instead in SHORTENED_LESS.items():
            if kind == "run" and flag in command:
                extra = instead
        return f"{command} {extra}" if "|" not in command and ">" not in command else command

    def check_command(self, place, command, number):
        command = re.sub(r"^(\w+=\S+ )+", "", command)  # variables of the environment
        program = command.split()[0]
        if program in BUILDS:
            self.check_script(place, program)
        elif program in STOCK:
            return
        elif program in ("cmake", "ninja", "ctest"):
            self.check_build_command(place, command)
        elif program.endswith("_test"):
            tests = self.shell(place, f"if [[ -x {program} ]]; then {command} --gtest_list_tests; "
                                      "else echo not built; fi")
            self.assertTrue(tests, f"{place}: matches no test")
        elif program.startswith("scripts/") or program.endswith("semantic_kiss"):
            if program.startswith("scripts/"):
                self.check_script(place, program)
            self.shell(place, self.filled_in(place, command, number))
        else:
            self.fail(f"{place}: nobody has said how to try `{program}`")

    # What is not run.

    def check_script(self, place, script):
        path = os.path.join(SOURCE, script)
        self.assertTrue(os.path.isfile(path), f"{place}: there is no {script}")
        self.assertTrue(os.stat(path).st_mode & stat.S_IXUSR, f"{place}: {script} is no program")
        if script.endswith(".sh"):
            self.shell(place, f"bash -n {script}")

    def check_build_command(self, place, command):
        words = command.split()
        if words[:2] == ["cmake", "--preset"]:
            self.assertIn(f'"name": "{words[2]}"',
                          read(os.path.join(SOURCE, "CMakePresets.json")).decode(), place)
        elif words[0] == "ninja":
            self.shell(place, f"ninja {words[1]} {words[2]} -t query {words[3]}")
        elif words[0] == "ctest":
            self.assertNotIn("Total Tests: 0", self.shell(place, command + " -N"), place)
        else:
            self.assertEqual(words[:3], ["cmake", "--install", "build"], place)

    def check_lua(self, block):
        path = self.at("mine.lua")
        write(path, block.text)
        returned = re.search(r"^return (\w+|\{)", block.text, re.MULTILINE)
        self.assertTrue(returned, f"{block.place}: returns nothing")
        if returned[1] == "RUN":
            self.shell(block.place, "semantic_kiss config --config=mine.lua")
        elif returned[1] == "MAP_FILTER":
            self.shell(block.place, "semantic_kiss filter --config=mine.lua --map=map.pbstream "
                                    "--output=filtered.pbstream")
        elif returned[1] == "options":
            self.shell(block.place, "semantic_kiss simulate --config=mine.lua --num_scans=1 "
                                    f"--output=simulated/lua_{block.line}")
        else:
            os.makedirs(self.at("labels"), exist_ok=True)
            name = re.search(r'name = "(\w+)"', block.text)[1]
            shutil.move(path, self.at("labels", name + ".lua"))
            write(path, f'include "semantic_kiss.lua"\nRUN.label_set = "{name}"\nreturn RUN\n')
            self.shell(block.place, "semantic_kiss run --config=mine.lua --dataset=data "
                                    f"--num_scans=2 --output=out/lua_{block.line}")

    def check_python(self, block):
        write(self.at("snippet.py"), block.text)
        python = python_with_numpy()
        self.assertTrue(python, f"{block.place}: wants numpy; scripts/setup.sh installs it")
        self.shell(block.place, f"{python} snippet.py")

    def test_every_command_line_works(self):
        number = 0
        for name, text in documents():
            for block in blocks_of(name, text):
                if block.language == "sh":
                    for place, command in commands_of(block):
                        number += 1
                        with self.subTest(place):
                            self.check_command(place, command, number)
                    continue
                with self.subTest(block.place):
                    self.check_other(block)
        self.assertGreater(number, 30, "command lines are not found any more")

    def check_other(self, block):
        if block.language == "lua":
            self.check_lua(block)
        elif block.language == "python":
            self.check_python(block)
        else:
            self.assertIn(block.language, ("text", "cmake"), f"{block.place}: name the language")

    def commands(self):
        return re.findall(r"^  (\w+) ", self.succeed("--help"), re.MULTILINE)

    def test_the_readme_lists_the_commands(self):
        listed = re.findall(r"^\| `(\w+)` \|", dict(documents())["README.md"], re.MULTILINE)
        self.assertEqual(sorted(listed), sorted(self.commands()))

    def test_every_flag_in_prose_exists(self):
        known = {"--help", "--version"}
        for command in self.commands():
            known |= set(re.findall(r"^  (--\w+)", self.succeed(command, "--help"), re.MULTILINE))
        for path in filter(os.path.isfile, glob.glob(os.path.join(SOURCE, "scripts", "**"),
                                             recursive=True)):
            known |= set(re.findall(r"--[a-z_]+", read(path).decode()))
        for name, text in documents():
            foreign = mentioned_flags(text) - known
            self.assertEqual(foreign - {"--align", "--project_to_plane"}, set(), name)  # evo's

    def test_every_option_in_prose_exists(self):
        reference = read(os.path.join(SOURCE, "docs", "options.md")).decode()
        keys = set(re.findall(r"^(?:- \*\*|### )`([\w.]+)", reference, re.MULTILINE))
        self.assertGreater(len(keys), 200)
        found = set()
        for name, text in documents():
            options = {option for option in mentioned_options(text, SHORT_FORMS)
                       if not option.endswith((".html", ".json", ".lua", ".md"))}
            self.assertEqual(options - keys, set(), name)
            found |= options
        self.assertGreater(len(found), 20)


class ReadingTest(unittest.TestCase):
    """The reader of documents itself: what it does not see is not tested."""

    TEXT = ("Do\n\n    scripts/a.sh  # why\n    run --x=1 \\\n        --y=2\n\n- item\n    goes on\n\n"
            "```lua\nreturn RUN\n```\n\nThe flag `--z=3` is `a --w`.\n")

    def test_blocks_and_commands(self):
        blocks = blocks_of("a.md", self.TEXT)
        self.assertEqual([(block.place, block.language) for block in blocks],
                         [("a.md:3", "sh"), ("a.md:11", "lua")])
        self.assertEqual(commands_of(blocks[0]),
                         [("a.md:3", "scripts/a.sh"), ("a.md:4", "run --x=1 --y=2")])

    def test_flags(self):
        self.assertEqual(mentioned_flags(self.TEXT), {"--z", "--w"})

    def test_options(self):
        self.assertEqual(mentioned_options("`SHORT.x = 1`, `report.y`, `a.b`, not report.z",
                                           {"SHORT": "long.one"}), {"long.one.x", "report.y"})


if __name__ == "__main__":
    main()
