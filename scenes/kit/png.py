"""PNG files whose bytes do not depend on the zlib at hand: the pixels are stored, not compressed."""

import struct
import zlib


def _chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def _stored(data):
    """A zlib stream of stored blocks (RFC 1950, RFC 1951 3.2.4)."""
    blocks = [data[i : i + 65535] for i in range(0, len(data), 65535)]
    out = b"\x78\x01"
    for number, block in enumerate(blocks):
        last = number + 1 == len(blocks)
        out += struct.pack("<BHH", last, len(block), len(block) ^ 0xFFFF) + block
    return out + struct.pack(">I", zlib.adler32(data))


def rgb_png(width, height, pixel):
    """pixel(x, y) -> (r, g, b), 0..255, row 0 on top."""
    rows = b"".join(
        b"\0" + bytes(value for x in range(width) for value in pixel(x, y)) for y in range(height)
    )
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return _file(header, [], rows)


def palette_png(width, height, palette, index):
    """Up to 16 colours [(r, g, b)], index(x, y) into them, row 0 on top; two texels a byte, so width is even."""
    assert width % 2 == 0 and len(palette) <= 16
    rows = b"".join(
        b"\0" + bytes(index(x, y) << 4 | index(x + 1, y) for x in range(0, width, 2)) for y in range(height)
    )
    header = struct.pack(">IIBBBBB", width, height, 4, 3, 0, 0, 0)
    return _file(header, [_chunk(b"PLTE", bytes(v for colour in palette for v in colour))], rows)


def _file(header, middle, rows):
    return b"".join(
        [b"\x89PNG\r\n\x1a\n", _chunk(b"IHDR", header), *middle, _chunk(b"IDAT", _stored(rows)), _chunk(b"IEND", b"")]
    )
