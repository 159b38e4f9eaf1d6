# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""Takes map files apart into their records and puts records together, to make maps of others."""

import gzip
import struct

HEADER_BYTES = 8


def read_records(path):
    """The records of a map file, decompressed; the first is the header, the second the graph."""
    with open(path, "rb") as file:
        content = file.read()
    records, offset = [], HEADER_BYTES
    while offset < len(content):
        size, = struct.unpack_from("<Q", content, offset)
        offset += 8
        records.append(gzip.decompress(content[offset:offset + size]))
        offset += size
    return records


def write_records(path, records):
    with open(path, "wb") as file:
        file.write(struct.pack("<Q", 0x7b1d1f7b5bf501db))
        for record in records:
            compressed = gzip.compress(record)
            file.write(struct.pack("<Q", len(compressed)) + compressed)


def varint(value):
    encoded = b""
    while value >= 0x80:
        encoded += bytes([value & 0x7f | 0x80])
        value >>= 7
    return encoded + bytes([value])


def field(number, content):
    """A field that is a message or bytes. Behind a message it is merged into it."""
    return varint(number << 3 | 2) + varint(len(content)) + content
