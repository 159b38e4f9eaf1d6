# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Takes documents apart: code blocks, command lines, flags that prose mentions."""

import re

FENCE = re.compile(r"^```(\w*)\s*$")
INDENTED = "    "


class Block:
    """A block of code: `language` of its fence, "sh" if it is indented; `line` of its first line."""

    def __init__(self, document, line, language):
        self.document, self.line, self.language = document, line, language
        self.text = ""

    @property
    def place(self):
        return f"{self.document}:{self.line}"


def blocks_of(document, text):
    """All code blocks of a document. A block that is indented begins after an empty line."""
    blocks, fenced, indented, previous = [], None, None, ""
    for number, line in enumerate(text.splitlines(), 1):
        fence = FENCE.match(line)
        if fence and fenced is None:
            fenced = Block(document, number + 1, fence[1])
            blocks.append(fenced)
        elif fence:
            fenced = None
        elif fenced is not None:
            fenced.text += line + "\n"
        elif line.startswith(INDENTED) and (indented is not None or not previous.strip()):
            if indented is None:
                indented = Block(document, number, "sh")
                blocks.append(indented)
            indented.text += line[len(INDENTED):] + "\n"
        else:
            indented = None
        previous = line
    return blocks


def commands_of(block):
    """(place, command) of each command line: continued lines joined, comments gone."""
    commands, begun, first = [], "", 0
    for number, line in enumerate(block.text.splitlines(), block.line):
        if not begun:
            first = number
        begun += line
        if begun.endswith("\\"):
            begun = begun[:-1] + " "
            continue
        command = re.sub(r"\s+", " ", re.sub(r"(^|\s)#.*", "", begun)).strip()
        if command:
            commands.append((f"{block.document}:{first}", command))
        begun = ""
    return commands


def code_spans(text):
    """What stands as `code` within prose."""
    prose = re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)
    return re.findall(r"`([^`\n]+)`", prose)


def mentioned_flags(text):
    """Flags in code within prose: "--labels_dir" of "`--labels_dir=none`"."""
    return {flag for span in code_spans(text)
            for flag in re.findall(r"(?<![\w-])--[a-z][a-z_]*", span)}


def mentioned_options(text, short_forms):
    """Keys of options in code within prose, those that begin with a short form in full."""
    keys = set()
    tables = "dataset|map_image|pose_graph|relocalization|report|" + "|".join(short_forms)
    for span in code_spans(text):
        for table, rest in re.findall(rf"^({tables})\.([\w.]+)(?: = .*)?$", span):
            keys.add(f"{short_forms.get(table, table)}.{rest}")
    return keys
