#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Checks that what documents point to is there: check_links.py [ROOT]

Looks at relative links and pictures of all .md files outside build trees. Prints one line per broken
link. Exit status: 0 none, 1 some.
"""

import os
import re
import sys

LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")
ELSEWHERE = re.compile(r"[a-z]+:")


def documents(root):
    """Yields the paths of all .md files."""
    for directory, folders, files in os.walk(root):
        folders[:] = sorted(name for name in folders if not name.startswith((".", "build")))
        for name in sorted(files):
            if name.endswith(".md"):
                yield os.path.join(directory, name)


def broken_links(root):
    """Yields a line for each link to a file or folder that does not exist."""
    for path in documents(root):
        with open(path, encoding="utf-8") as file:
            for number, line in enumerate(file, 1):
                for target in LINK.findall(line):
                    if ELSEWHERE.match(target):
                        continue
                    if not os.path.exists(os.path.join(os.path.dirname(path), target)):
                        yield f"{os.path.relpath(path, root)}:{number}: there is no {target}"


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(__file__), "..")
    found = list(broken_links(root))
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
