# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""A document as one HTML page that needs no other file."""

import base64
import html
import re

import document

STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; max-width: 76rem; margin: 2rem auto; padding: 0 1rem;
  color: #1c2024; }
table { border-collapse: collapse; margin: 1rem 0; font-variant-numeric: tabular-nums; }
div { overflow-x: auto; }
th, td { padding: .2rem .6rem; text-align: right; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; }
thead th { border-bottom: 2px solid #8a939b; }
tbody tr:nth-child(even) { background: #f3f5f7; }
pre { background: #f3f5f7; padding: .8rem; overflow-x: auto; }
img { max-width: 100%; }
"""


def _text(text):
    escaped = html.escape(text)
    escaped = re.sub(r"\*\*(.+?)\*\*", r"<b>\1</b>", escaped)
    return re.sub(r"`(.+?)`", r"<code>\1</code>", escaped)


def _row(cells, tag):
    return "<tr>" + "".join(f"<{tag}>{_text(cell)}</{tag}>" for cell in cells) + "</tr>"


def _block(block, pictures):
    if isinstance(block, document.Heading):
        return f"<h{block.level}>{_text(block.text)}</h{block.level}>"
    if isinstance(block, document.Paragraph):
        return f"<p>{_text(block.text)}</p>"
    if isinstance(block, document.Items):
        return "<ul>" + "".join(f"<li>{_text(text)}</li>" for text in block.texts) + "</ul>"
    if isinstance(block, document.Commands):
        return "<pre>" + html.escape("\n".join(block.lines)) + "</pre>"
    if isinstance(block, document.Picture):
        data = base64.b64encode(pictures[block.name]).decode()
        return f'<img alt="{html.escape(block.caption)}" src="data:image/png;base64,{data}">'
    body = "".join(_row(row, "td") for row in block.rows)
    return (f"<div><table><thead>{_row(block.header, 'th')}</thead>"
            f"<tbody>{body}</tbody></table></div>")


def write(title, blocks, pictures):
    """The whole page; `pictures` holds the bytes of each picture's file by its name."""
    body = "\n".join(_block(block, pictures) for block in blocks)
    return (f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
            f"<title>{html.escape(title)}</title>\n<style>{STYLE}</style>\n</head>\n"
            f"<body>\n{body}\n</body>\n</html>\n")
