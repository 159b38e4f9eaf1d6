# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Makes the page of what is done so far: make_page.py --output=OUTPUT

Reads OUTPUT/settings.json and OUTPUT/runs; writes OUTPUT/page/{README.md,index.html,cells.csv} and
the pictures of both.
"""

import argparse
import json
import os
import sys

import yaml

import markdown
import page
import pictures
import published
import grid
import results as results_module
import spreadsheet
import web_page

DEFAULTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "settings.yaml")


def read_settings(output):
    """The shipped settings, and over them what the benchmark was started with."""
    with open(DEFAULTS, encoding="utf-8") as file:
        settings = yaml.safe_load(file)
    with open(os.path.join(output, "settings.json"), encoding="utf-8") as file:
        settings.update(json.load(file))
    return settings


def write(folder, name, text):
    with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
        file.write(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--output", required=True)
    output = parser.parse_args().output
    settings = read_settings(output)
    results = results_module.read(output, settings)
    if not results:
        print(f"error: {output}/runs holds no cell that is done", file=sys.stderr)
        return 1
    folder = os.path.join(output, "page")
    os.makedirs(folder, exist_ok=True)
    systems = [row for row in grid.systems(settings).values() if not row.ablation]
    names = pictures.draw(output, folder, systems, [
        result for result in results if result.cell.system in {row.name for row in systems}])
    blocks = page.compose(settings, results,
                          {metric: published.read(metric) for metric in results_module.METRICS},
                          names)
    write(folder, "README.md", markdown.write(blocks))
    write(folder, "cells.csv", spreadsheet.write(results))
    contents = {}
    for name in names.values():
        with open(os.path.join(folder, name), "rb") as file:
            contents[name] = file.read()
    write(folder, "index.html", web_page.write("The systems compared", blocks, contents))
    return 0


if __name__ == "__main__":
    sys.exit(main())
