#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Checks sizes and licence headers: check_budgets.py [ROOT]

A file of C++ has at most 400 lines and a function at most 60, unless the line above the function
(or the first lines of the file) says why, in a comment that begins with "Over budget:". Every
source and script names its licence in its first lines.

Prints one line per breach. Exit status: 0 none, 1 some, 2 the tree cannot be read.
"""

import os
import re
import sys

MAX_FILE_LINES = 400
MAX_FUNCTION_LINES = 60
HEADER_LINES = 5
TOPS = ("cartographer", "semantic_kiss", "proto", "scripts", "test")
WITH_LICENCE = (".h", ".cc", ".proto", ".py", ".sh")
REASON = "Over budget:"
LICENCE = "SPDX-License-Identifier: Apache-2.0"

# clang-format puts what is at namespace scope into the first column, and so its closing brace;
# functions that a class defines in place are short by nature and not looked at.
NOT_A_FUNCTION = re.compile(r"(namespace|class|struct|union|enum|extern|using|#|//|/\*|\})")


def functions(lines):
    """Yields (first line, number of lines) of the functions at namespace scope, counted from 0."""
    start = None
    for number, line in enumerate(lines):
        if start is None and line[:1].strip() and not NOT_A_FUNCTION.match(line):
            start = number
        if start is None or not line[:1].strip():
            continue
        if line == "}":
            yield start, number - start + 1
        if line.endswith((";", "}")):
            start = None


def breaches_of(path, name):
    """Yields a line for each breach of the file `path`, called `name`."""
    with open(path, encoding="utf-8", errors="replace") as file:
        lines = file.read().splitlines()
    head = "\n".join(lines[:HEADER_LINES])
    if LICENCE not in head:
        yield f"{name}:1: no line '{LICENCE}' among the first {HEADER_LINES}"
    if not name.endswith((".h", ".cc")):
        return
    if len(lines) > MAX_FILE_LINES and REASON not in head:
        yield f"{name}:{MAX_FILE_LINES}: the file has {len(lines)} lines, allowed are {MAX_FILE_LINES}"
    for start, length in functions(lines):
        if length > MAX_FUNCTION_LINES and REASON not in "".join(lines[max(0, start - 1):start]):
            yield (f"{name}:{start + 1}: the function has {length} lines, "
                   f"allowed are {MAX_FUNCTION_LINES}")


def breaches(root):
    """Yields a line for each breach in the tree."""
    for top in TOPS:
        for directory, folders, files in os.walk(os.path.join(root, top)):
            folders.sort()
            for file in sorted(files):
                path = os.path.join(directory, file)
                if file.endswith(WITH_LICENCE):
                    yield from breaches_of(path, os.path.relpath(path, root))


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(__file__), "..")
    if not any(os.path.isdir(os.path.join(root, top)) for top in TOPS):
        print(f"{root}: has none of {', '.join(TOPS)}", file=sys.stderr)
        return 2
    found = list(breaches(root))
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
