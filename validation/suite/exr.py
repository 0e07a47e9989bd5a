# SPDX-License-Identifier: AGPL-3.0-or-later
"""The numbers of a picture of one pixel (OpenEXR, single precision, compressed or not), of which the suite wants no package."""

import struct
import zlib

import numpy

RAW, ZIP = 0, 3


def read_pixel(path):
    """Its channels by name."""
    data = path.read_bytes()
    if struct.unpack_from("<i", data)[0] != 20000630:
        raise ValueError(f"{path} is no OpenEXR file")
    attributes, at = read_header(data, 8)
    names = channel_names(attributes["channels"])
    if attributes["dataWindow"] != bytes(16) or attributes["compression"][0] not in (RAW, ZIP):
        raise ValueError(f"{path} is not one pixel, raw or compressed by ZIP")
    chunk = struct.unpack_from("<q", data, at)[0]
    size = struct.unpack_from("<i", data, chunk + 4)[0]
    packed = data[chunk + 8:chunk + 8 + size]
    # What does not become shorter stays as it is.
    values = packed if size == 4 * len(names) else unpacked(packed)
    return dict(zip(names, struct.unpack(f"<{len(names)}f", values)))


def read_header(data, at):
    """Attributes as bytes, and where they end."""
    found = {}
    while data[at]:
        name, kind_at = text_at(data, at)
        _, size_at = text_at(data, kind_at)
        size = struct.unpack_from("<i", data, size_at)[0]
        at = size_at + 4 + size
        found[name] = data[size_at + 4:at]
    return found, at + 1


def text_at(data, at):
    end = data.index(0, at)
    return data[at:end].decode(), end + 1


def channel_names(data):
    """A name, then the type and how it is sampled, 16 bytes."""
    found, at = [], 0
    while data[at]:
        name, after = text_at(data, at)
        found.append(name)
        at = after + 16
    return found


def unpacked(packed):
    """Bytes are differences from the one before, first all even ones, then all odd ones."""
    steps = numpy.frombuffer(zlib.decompress(packed), numpy.uint8).astype(int)
    steps[1:] -= 128
    split = (numpy.cumsum(steps) % 256).astype(numpy.uint8)
    joined = numpy.empty_like(split)
    half = (len(split) + 1) // 2
    joined[0::2], joined[1::2] = split[:half], split[half:]
    return joined.tobytes()
