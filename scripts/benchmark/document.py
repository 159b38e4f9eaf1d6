# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""A page as a list of blocks, which markdown.py and html.py write down.

Texts may contain `code`, **bold** and nothing else.
"""

import dataclasses


@dataclasses.dataclass(frozen=True)
class Heading:
    text: str
    level: int = 2


@dataclasses.dataclass(frozen=True)
class Paragraph:
    text: str


@dataclasses.dataclass(frozen=True)
class Items:
    texts: tuple


@dataclasses.dataclass(frozen=True)
class Commands:
    """Lines for a shell."""
    lines: tuple


@dataclasses.dataclass(frozen=True)
class Table:
    """Cells are texts; every row has as many as the header. The first column is left-aligned."""
    header: tuple
    rows: tuple


@dataclasses.dataclass(frozen=True)
class Picture:
    """A PNG file, by its name in the folder of the page."""
    name: str
    caption: str
