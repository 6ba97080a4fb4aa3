"""Reads and writes small EXR files without any library: what the kit writes is checked by other code than its own.

Single-part scan-line files of 32-bit float channels; read with ZIP, ZIPS or no compression, written with none.
"""

import array
import itertools
import struct
import sys
import zlib

_MAGIC = 20000630
_FLOAT = 2
_LINES_A_BLOCK = {0: 1, 2: 1, 3: 16}  # by compression: none, ZIPS, ZIP


class Image:
    """Channel name to an array of width * height floats, row by row from the top."""

    def __init__(self, width, height, channels):
        self.width = width
        self.height = height
        self.channels = channels

    def bits(self):
        """By channel name; two images with equal bits are the same image."""
        return {name: values.tobytes() for name, values in self.channels.items()}


def _attribute(name, kind, value):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<I", len(value)) + value


def encode(width, height, channels):
    """The bytes of a file; `channels` maps each name to width * height numbers, or to one for all texels."""
    rows = {}
    for name, values in channels.items():
        filled = [values] * (width * height) if isinstance(values, (int, float)) else values
        rows[name] = array.array("f", filled)
    names = sorted(rows)
    channel_list = b"".join(n.encode() + b"\0" + struct.pack("<IIii", _FLOAT, 0, 1, 1) for n in names) + b"\0"
    box = struct.pack("<iiii", 0, 0, width - 1, height - 1)
    header = struct.pack("<II", _MAGIC, 2)
    header += _attribute("channels", "chlist", channel_list)
    header += _attribute("compression", "compression", b"\0")
    header += _attribute("dataWindow", "box2i", box) + _attribute("displayWindow", "box2i", box)
    header += _attribute("lineOrder", "lineOrder", b"\0")
    header += _attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
    header += _attribute("screenWindowCenter", "v2f", struct.pack("<ff", 0, 0))
    header += _attribute("screenWindowWidth", "float", struct.pack("<f", 1)) + b"\0"
    line_bytes = 4 * width * len(names)
    first = len(header) + 8 * height
    offsets = b"".join(struct.pack("<Q", first + y * (line_bytes + 8)) for y in range(height))
    lines = b""
    for y in range(height):
        texels = b"".join(rows[name][y * width:(y + 1) * width].tobytes() for name in names)
        lines += struct.pack("<ii", y, line_bytes) + texels
    return header + offsets + lines


def write(path, width, height, channels):
    with open(path, "wb") as file:
        file.write(encode(width, height, channels))


def _read_header(data):
    magic, version = struct.unpack_from("<II", data)
    if magic != _MAGIC or version & 0x1800:
        raise ValueError("not a flat single-part EXR file")
    at = 8
    attributes = {}
    while data[at] != 0:
        name_end = data.index(b"\0", at)
        kind_end = data.index(b"\0", name_end + 1)
        (size,) = struct.unpack_from("<I", data, kind_end + 1)
        start = kind_end + 5
        attributes[data[at:name_end].decode()] = data[start:start + size]
        at = start + size
    return attributes, at + 1


def _channel_names(channel_list):
    names = []
    at = 0
    while channel_list[at] != 0:
        end = channel_list.index(b"\0", at)
        (kind,) = struct.unpack_from("<I", channel_list, end + 1)
        if kind != _FLOAT:
            raise ValueError("a channel is not 32-bit float")
        names.append(channel_list[at:end].decode())
        at = end + 17
    return names


def _inflate(block, size):
    if len(block) == size:  # a block that would grow is stored as it is
        return block
    differences = zlib.decompress(block)
    packed = bytes(itertools.accumulate(differences, lambda last, step: (last + step - 128) & 255))
    half = (len(packed) + 1) // 2
    plain = bytearray(len(packed))
    plain[0::2] = packed[:half]
    plain[1::2] = packed[half:]
    return bytes(plain)


def read(path):
    """Raises on anything but a whole, valid file."""
    with open(path, "rb") as file:
        data = file.read()
    attributes, at = _read_header(data)
    x_min, y_min, x_max, y_max = struct.unpack("<iiii", attributes["dataWindow"])
    width, height = x_max - x_min + 1, y_max - y_min + 1
    compression = attributes["compression"][0]
    block_lines = _LINES_A_BLOCK[compression]
    names = _channel_names(attributes["channels"])
    channels = {name: array.array("f") for name in names}
    for block in range((height + block_lines - 1) // block_lines):
        (offset,) = struct.unpack_from("<Q", data, at + 8 * block)
        y, size = struct.unpack_from("<ii", data, offset)
        lines = min(block_lines, y_max + 1 - y)
        if y != y_min + block * block_lines or offset + 8 + size > len(data):
            raise ValueError(f"{path}: block {block} is not whole")
        texels = _inflate(data[offset + 8:offset + 8 + size], 4 * width * lines * len(names))
        if len(texels) != 4 * width * lines * len(names):
            raise ValueError(f"{path}: block {block} has the wrong size")
        for line in range(lines):
            for i, name in enumerate(names):
                start = 4 * width * (line * len(names) + i)
                channels[name].frombytes(texels[start:start + 4 * width])
    if sys.byteorder != "little":
        for values in channels.values():
            values.byteswap()
    return Image(width, height, channels)
