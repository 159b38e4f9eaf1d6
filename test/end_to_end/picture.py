# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Reads pictures that the program writes: PNG (8 bits a channel, no alpha) and PGM."""

import struct
import zlib


def read_png(content):
    """(width, height, rows), a row as bytes of three channels a pixel."""
    assert content[:8] == b"\x89PNG\r\n\x1a\n", "no PNG"
    position, data = 8, b""
    while position < len(content):
        size, kind = struct.unpack(">I4s", content[position:position + 8])
        chunk = content[position + 8:position + 8 + size]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", chunk[:10])
            assert (depth, color) == (8, 2), "not three channels of 8 bits"
        if kind == b"IDAT":
            data += chunk
        position += size + 12
    return width, height, _unfilter(zlib.decompress(data), 3 * width, height)


def _unfilter(data, stride, height):
    rows, above = [], bytes(stride)
    for y in range(height):
        kind, line = data[y * (stride + 1)], data[y * (stride + 1) + 1:(y + 1) * (stride + 1)]
        row = bytearray(line)
        for i in range(stride):
            left = row[i - 3] if i >= 3 else 0
            corner = above[i - 3] if i >= 3 else 0
            row[i] = (line[i] + _predict(kind, left, above[i], corner)) & 255
        rows.append(bytes(row))
        above = row
    return rows


def _predict(kind, left, above, corner):
    if kind == 4:  # Paeth: whichever is nearest to left + above - corner
        guess = left + above - corner
        return min((abs(guess - left), 0, left), (abs(guess - above), 1, above),
                   (abs(guess - corner), 2, corner))[2]
    return (0, left, above, (left + above) // 2)[kind]


def read_pgm(content):
    """(width, height, rows), a row as bytes."""
    magic, size, maximum, pixels = content.split(b"\n", 3)
    assert (magic, maximum) == (b"P5", b"255"), "no binary PGM of 8 bits"
    width, height = map(int, size.split())
    assert len(pixels) == width * height
    return width, height, [pixels[y * width:(y + 1) * width] for y in range(height)]
