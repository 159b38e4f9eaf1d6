#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""The static checks find what is planted in a small tree, and nothing in a tidy one."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"
LICENCE = "// SPDX-License-Identifier: Apache-2.0\n"


class CheckTest(unittest.TestCase):
    def setUp(self):
        self._directory = tempfile.TemporaryDirectory()
        self.addCleanup(self._directory.cleanup)
        self.root = pathlib.Path(self._directory.name)
        self.plant("cartographer/common/time.h", "")

    def plant(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(LICENCE + text)

    def run_check(self, name):
        program = [sys.executable] if name.endswith(".py") else ["bash"]
        return subprocess.run([*program, SCRIPTS / name, self.root], capture_output=True, text=True,
                              check=False)

    def assert_passes(self, name):
        result = self.run_check(name)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))

    def assert_finds(self, name, *words):
        result = self.run_check(name)
        self.assertNotEqual(result.returncode, 0)
        lines = (result.stdout + result.stderr).splitlines()
        self.assertTrue([line for line in lines if all(word in line for word in words)], lines)


class IncludesTest(CheckTest):
    def includes(self, path, *included):
        self.plant(path, "".join(f'#include "{name}"\n' for name in included))

    def refuses(self, path, included, reason):
        self.includes(path, "cartographer/common/time.h", included)
        self.assert_finds("check_includes.py", f"{path}:3", included, reason)

    def test_downward_own_and_foreign_are_fine(self):
        self.includes("cartographer/sensor/a.cc", "cartographer/common/time.h",
                      "cartographer/sensor/a.h", "absl/status/status.h")
        self.includes("semantic_kiss/local_trajectory_builder.cc",
                      "semantic_kiss/odometry/odometry.h",
                      "cartographer/slam/local_trajectory_builder.h")
        self.includes("semantic_kiss/cli/run.cc", "semantic_kiss/local_trajectory_builder.h")
        self.assert_passes("check_includes.py")

    def test_upward(self):
        self.refuses("cartographer/common/a.h", "cartographer/sensor/label.h", "a floor above")
        self.refuses("cartographer/slam/a.h", "semantic_kiss/dataset/a.h", "a floor above")

    def test_angle_brackets_do_not_hide(self):
        self.plant("cartographer/common/a.h", "#  include <cartographer/sensor/label.h>\n")
        self.assert_finds("check_includes.py", "cartographer/common/a.h:2", "a floor above")

    def test_same_floor(self):
        self.refuses("cartographer/map/a.h", "cartographer/scan_matching/a.h", "not know each other")
        self.refuses("semantic_kiss/evaluation/a.h", "semantic_kiss/simulation/a.h",
                     "on the same floor")

    def test_wings_meet_in_slam_alone(self):
        self.refuses("cartographer/io/a.h", "cartographer/scan_matching/a.h", "not know each other")
        self.refuses("cartographer/pose_graph/a.h", "cartographer/map/map.h", "not know each other")

    def test_odometry_stands_on_four_floors(self):
        self.refuses("semantic_kiss/odometry/a.cc", "cartographer/submap/submap.h",
                     "not know each other")

    def test_only_the_plugin_knows_the_odometry(self):
        self.refuses("semantic_kiss/cli/run.cc", "semantic_kiss/odometry/odometry.h",
                     "not know each other")

    def test_unknown_folder(self):
        self.refuses("cartographer/sensor/a.h", "cartographer/misc/a.h", "has no floor")
        self.includes("cartographer/attic/a.h")
        self.assert_finds("check_includes.py", "cartographer/attic/a.h:1", "has no floor")

    def test_path_from_the_folder(self):
        self.refuses("cartographer/common/a.h", "time.h", "from the root")

    def test_imports_of_messages(self):
        self.plant("proto/cartographer/common/proto/a.proto",
                   'import "cartographer/sensor/proto/b.proto";\n')
        self.assert_finds("check_includes.py", "proto/cartographer/common/proto/a.proto:2",
                          "a floor above")

    def test_messages_of_files_belong_to_io(self):
        self.refuses("cartographer/submap/a.cc", "cartographer/mapping/proto/grid.pb.h",
                     "may use the messages")
        self.includes("cartographer/submap/a.cc")
        self.includes("cartographer/io/a.cc", "cartographer/mapping/proto/grid.pb.h")
        self.assert_passes("check_includes.py")

    def test_wrong_root(self):
        self.root = self.root / "cartographer"
        self.assertEqual(self.run_check("check_includes.py").returncode, 2)


class BudgetsTest(CheckTest):
    def function(self, lines, above=""):
        body = "  Do();\n" * (lines - 2)
        self.plant("cartographer/common/a.cc", f"\n{above}int F(int a,\n      int b) {{\n{body[8:]}}}\n")

    def test_file(self):
        self.plant("cartographer/common/a.h", "\n" * 399)
        self.assert_passes("check_budgets.py")
        self.plant("cartographer/common/a.h", "\n" * 400)
        self.assert_finds("check_budgets.py", "cartographer/common/a.h", "401 lines")
        self.plant("cartographer/common/a.h", "// Over budget: a table.\n" + "\n" * 400)
        self.assert_passes("check_budgets.py")

    def test_function(self):
        self.function(60)
        self.assert_passes("check_budgets.py")
        self.function(61)
        self.assert_finds("check_budgets.py", "cartographer/common/a.cc:3", "61 lines")
        self.function(61, above="// Over budget: one switch.\n")
        self.assert_passes("check_budgets.py")

    def test_long_table_is_no_function(self):
        self.plant("cartographer/common/a.cc", "const int kTable[] = {\n" + "    1,\n" * 80 + "};\n")
        self.assert_passes("check_budgets.py")

    def test_licence(self):
        (self.root / "cartographer/common/time.h").write_text("// No licence.\n")
        self.assert_finds("check_budgets.py", "cartographer/common/time.h:1", "SPDX")


class LinksTest(CheckTest):
    def test_there(self):
        self.plant("docs/a.md", "[b](../cartographer/common/time.h) [c](https://x.org/y) [d](#e)\n")
        self.assert_passes("check_links.py")

    def test_missing(self):
        self.plant("docs/a.md", "[fine](a.md#top)\n![gone](images/gone.png)\n")
        self.assert_finds("check_links.py", "docs/a.md:3", "images/gone.png")


class FormatTest(CheckTest):
    def setUp(self):
        super().setUp()
        style = (SCRIPTS.parent / ".clang-format").read_text()
        (self.root / ".clang-format").write_text(style)

    def test_tidy(self):
        self.plant("cartographer/common/a.cc", "\nint* F() { return nullptr; }\n")
        self.assert_passes("check_format.sh")

    def test_untidy(self):
        self.plant("cartographer/common/a.cc", "\nint *F() {return nullptr;}\n")
        self.assert_finds("check_format.sh", "cartographer/common/a.cc:3", "clang-format")


if __name__ == "__main__":
    unittest.main()
