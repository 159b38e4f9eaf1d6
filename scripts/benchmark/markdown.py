# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""A document as Markdown."""

import document


def _escape(text):
    return text.replace("|", "\\|")


def _row(cells):
    return "| " + " | ".join(_escape(cell) for cell in cells) + " |"


def _block(block):
    if isinstance(block, document.Heading):
        return "#" * block.level + " " + block.text
    if isinstance(block, document.Paragraph):
        return block.text
    if isinstance(block, document.Items):
        return "\n".join(f"- {text}" for text in block.texts)
    if isinstance(block, document.Commands):
        return "\n".join("    " + line for line in block.lines)
    if isinstance(block, document.Picture):
        return f"![{block.caption}]({block.name})"
    line = "|---" + "|--:" * (len(block.header) - 1) + "|"
    return "\n".join([_row(block.header), line, *map(_row, block.rows)])


def write(blocks):
    """The whole page; ends with a newline."""
    return "\n\n".join(_block(block) for block in blocks) + "\n"
