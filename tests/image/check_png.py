#!/usr/bin/env python3
"""Reads PNGs of the command with nothing of ours: the container by hand, the stream by Python's zlib, the filters as the standard states them.

check_png.py LUSTRO   the command; exits 1 and says what is wrong
"""

import io
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

try:
    from PIL import Image
except ImportError:
    Image = None


def chunks(png: bytes):
    assert png[:8] == b"\x89PNG\r\n\x1a\n", "no signature"
    at = 8
    while at < len(png):
        (length,) = struct.unpack(">I", png[at : at + 4])
        body = png[at + 4 : at + 8 + length]
        assert struct.unpack(">I", png[at + 8 + length : at + 12 + length])[0] == zlib.crc32(body), "a wrong checksum"
        yield body[:4], body[4:]
        at += 12 + length


def paeth(a: int, b: int, c: int) -> int:
    p = a + b - c
    return min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]


def pixels(png: bytes):
    """Width, height, bytes a pixel, how many IDAT chunks there are, and the bytes of all rows."""
    parts = list(chunks(png))
    width, height, depth, kind = struct.unpack(">IIBB", parts[0][1][:10])
    step = {0: 1, 4: 2, 2: 3, 6: 4}[kind] * depth // 8
    data = [body for name, body in parts if name == b"IDAT"]
    stream = zlib.decompressobj()
    filtered = stream.decompress(b"".join(data)) + stream.flush()
    assert stream.eof and not stream.unused_data, "the stream does not end with the last chunk"
    assert len(filtered) == height * (width * step + 1), "too few or too many rows"
    rows, up = [], bytes(width * step)
    for y in range(height):
        line = filtered[y * (width * step + 1) : (y + 1) * (width * step + 1)]
        row = bytearray(line[1:])
        for i in range(len(row)):
            a, c = (row[i - step], up[i - step]) if i >= step else (0, 0)
            row[i] = (row[i] + (0, a, up[i], (a + up[i]) // 2, paeth(a, up[i], c))[line[0]]) & 255
        rows.append(bytes(row))
        up = rows[-1]
    return width, height, step, len(data), b"".join(rows)


def main() -> int:
    lustro = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        for flags, step in ((["--size", "300x400"], 3), (["--size", "257x300", "--transparent"], 4)):
            seen = []
            for level in ([], ["--png-level", "6"], ["--threads", "3"]):
                file = pathlib.Path(folder) / "a.png"
                subprocess.run([lustro, "render", "primitive:torus", "-o", file, *flags, *level], check=True, capture_output=True)
                png = file.read_bytes()
                seen.append((pixels(png), png))
                if Image is not None:
                    assert Image.open(io.BytesIO(png)).tobytes() == seen[-1][0][4], "PIL reads other pixels"
            (fast, fast_file), (small, _), (again, again_file) = seen
            assert fast[2] == step and fast[3] > 1 and small[3] == 1, f"not the chunks that were expected: {fast[:4]}, {small[:4]}"
            assert len(set(fast[4])) > 50, "hardly a picture"
            assert fast[4] == small[4], "the fast packer stores other pixels"
            assert fast_file == again_file, "the bytes depend on the threads"
    return 0


if __name__ == "__main__":
    sys.exit(main())
