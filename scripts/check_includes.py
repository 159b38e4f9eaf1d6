#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Checks who includes whom: check_includes.py [ROOT]

The folders are floors of one house. A file may include its own folder and lower floors, never a
floor above and never another folder of its own floor; so there can be no cycles. FLOORS and the two
tables below it are the whole law; docs/data_flow.md draws it. The imports of .proto files count as
the includes of the folder that they belong to (proto/cartographer/sensor/proto/x.proto belongs to
cartographer/sensor).

Prints one line per violation. Exit status: 0 none, 1 some, 2 the tree cannot be read.
"""

import os
import re
import sys

FLOORS = [
    ["cartographer/common"],
    ["cartographer/transform"],
    ["cartographer/sensor"],
    ["cartographer/registration"],
    ["cartographer/submap"],
    ["cartographer/scan_matching", "cartographer/map"],
    ["cartographer/pose_graph", "cartographer/io"],
    ["cartographer/slam"],
    ["semantic_kiss/odometry"],
    ["semantic_kiss/local_trajectory_builder"],  # the plugin: PLUGIN_FILES
    ["semantic_kiss/dataset"],
    ["semantic_kiss/evaluation", "semantic_kiss/simulation"],
    ["semantic_kiss/report"],
    ["semantic_kiss/live"],
    ["semantic_kiss/cli"],
    ["semantic_kiss/manual"],
]

# Folders of messages alone: what files carry, in the packages of other programs. Their generated
# headers may be included by the named folders.
MESSAGES = {"cartographer/mapping": ["cartographer/io"]}

# Folders that must not know each other although their floors would allow it.
APART = [
    # One wing looks for agreement, the other keeps what was found; they meet in slam/.
    (["cartographer/scan_matching", "cartographer/pose_graph"],
     ["cartographer/map", "cartographer/io"]),
    # The odometry stands on the first four floors alone, and only its seat in the framework, the
    # local trajectory builder, knows it.
    (["semantic_kiss/odometry"],
     ["cartographer/submap", "cartographer/scan_matching", "cartographer/map",
      "cartographer/pose_graph", "cartographer/io", "cartographer/slam", "semantic_kiss/dataset",
      "semantic_kiss/evaluation", "semantic_kiss/simulation", "semantic_kiss/report",
      "semantic_kiss/live", "semantic_kiss/cli"]),
]

PLUGIN = "semantic_kiss/local_trajectory_builder"
PLUGIN_FILES = ("semantic_kiss/local_trajectory_builder", "semantic_kiss/trace_odometry",
                "semantic_kiss/proto/")
FLOOR_OF = {folder: floor for floor, folders in enumerate(FLOORS) for folder in folders}
TREES = ("cartographer", "semantic_kiss")
INCLUDE = re.compile(r'^\s*#\s*include\s+(["<])([^">]+)[">]')
IMPORT = re.compile(r'^\s*import\s+(?:public\s+|weak\s+)?"([^"]+)"')


def folder_of(path):
    """The folder of the tables that `path` (relative to the root, '/'-separated) belongs to."""
    if path.startswith(PLUGIN_FILES):
        return PLUGIN
    return "/".join(path.split("/")[:2])


def includes_of(path):
    """Yields (line number, included path, written with quotes) of a source or .proto file."""
    with open(path, encoding="utf-8", errors="replace") as file:
        for number, line in enumerate(file, 1):
            match = INCLUDE.match(line)
            if match:
                yield number, match.group(2), match.group(1) == '"'
            elif path.endswith(".proto"):
                match = IMPORT.match(line)
                if match:
                    yield number, match.group(1), True


def sources(root):
    """Yields (path, path as if it lay in its stage's folder) of all files under the law."""
    for top in (*TREES, "proto"):
        for directory, folders, files in os.walk(os.path.join(root, top)):
            folders.sort()
            for name in sorted(files):
                if name.endswith((".h", ".cc", ".proto")):
                    path = os.path.relpath(os.path.join(directory, name), root).replace(os.sep, "/")
                    yield path, path.removeprefix("proto/")


def objection(user, used):
    """Why a file of the folder `user` must not include one of `used`; None if it may."""
    if user == used:
        return None
    for folder in (user, used):
        if folder not in FLOOR_OF and folder not in MESSAGES:
            return f"{folder} has no floor (FLOORS in scripts/check_includes.py)"
    if user in MESSAGES:
        user = MESSAGES[user][0]
    if used in MESSAGES:
        if user not in MESSAGES[used]:
            return f"only {', '.join(MESSAGES[used])} may use the messages of {used}"
        return None
    for one, other in APART:
        if (user in one and used in other) or (user in other and used in one):
            return f"{user} and {used} must not know each other"
    if FLOOR_OF[used] > FLOOR_OF[user]:
        return f"{used} is a floor above {user}"
    if FLOOR_OF[used] == FLOOR_OF[user] and used != user:
        return f"{used} is beside {user}, on the same floor"
    return None


def violations(root):
    """Yields a line for each include that breaks the law."""
    for path, place in sources(root):
        user = folder_of(place)
        if user not in FLOOR_OF and user not in MESSAGES:
            yield f"{path}:1: {user} has no floor (FLOORS in scripts/check_includes.py)"
            continue
        for number, included, quoted in includes_of(os.path.join(root, path)):
            if included.split("/")[0] in TREES:
                reason = objection(user, folder_of(included))
            elif quoted and os.path.exists(os.path.join(root, os.path.dirname(path), included)):
                reason = "write the path from the root of the tree"
            else:
                reason = None
            if reason:
                yield f"{path}:{number}: includes {included}: {reason}"


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(__file__), "..")
    if not any(os.path.isdir(os.path.join(root, tree)) for tree in TREES):
        print(f"{root}: has neither cartographer/ nor semantic_kiss/", file=sys.stderr)
        return 2
    found = list(violations(root))
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
