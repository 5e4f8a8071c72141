#!/usr/bin/env python3
"""Draws MoserHex.png, the icon of the extension: a cube in parallel projection, its faces coloured by shell."""
import os
import struct
import zlib

SIZE = 128
SAMPLES = 4  # a side of each pixel
SHELLS = 4
CELLS = 2 * SHELLS
COLOURS = ((68, 1, 84), (49, 104, 142), (53, 183, 121), (253, 231, 37))
LINE = 0.07  # half width, of a cell
HALF_WIDTH = 0.86 * 62
HALF_HEIGHT = 31.0
TOP = 2.0
#       origin, first edge, second edge, brightness: the top, the left and the right face
MIDDLE = SIZE / 2
FACES = (
    ((MIDDLE, TOP), (HALF_WIDTH, HALF_HEIGHT), (-HALF_WIDTH, HALF_HEIGHT), 1.0),
    ((MIDDLE - HALF_WIDTH, TOP + HALF_HEIGHT), (HALF_WIDTH, HALF_HEIGHT), (0.0, 2 * HALF_HEIGHT), 0.82),
    ((MIDDLE, TOP + 2 * HALF_HEIGHT), (HALF_WIDTH, -HALF_HEIGHT), (0.0, 2 * HALF_HEIGHT), 0.64),
)


def colour_at(x, y):
    """(red, green, blue, alpha) from 0 to 1, alpha 0 beside the cube."""
    for (ox, oy), (ax, ay), (bx, by), brightness in FACES:
        determinant = ax * by - ay * bx
        u = ((x - ox) * by - (y - oy) * bx) / determinant
        v = ((y - oy) * ax - (x - ox) * ay) / determinant
        if 0 <= u <= 1 and 0 <= v <= 1:
            shell = min(int(CELLS * min(u, v, 1 - u, 1 - v)), SHELLS - 1)
            from_line = min(abs(CELLS * w - round(CELLS * w)) for w in (u, v))
            light = brightness * (0.55 if from_line < LINE else 1.0)
            return tuple(light * part / 255 for part in COLOURS[shell]) + (1.0,)
    return 0.0, 0.0, 0.0, 0.0


def pixel_at(column, row):
    total = [0.0] * 4
    for i in range(SAMPLES):
        for j in range(SAMPLES):
            sample = colour_at(column + (i + 0.5) / SAMPLES, row + (j + 0.5) / SAMPLES)
            total = [a + b for a, b in zip(total, sample)]
    covered = total[3]
    colours = [round(255 * part / covered) if covered else 0 for part in total[:3]]
    return bytes(colours + [round(255 * covered / SAMPLES**2)])


def chunk(name, content):
    return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))


def main():
    rows = b"".join(b"\0" + b"".join(pixel_at(column, row) for column in range(SIZE)) for row in range(SIZE))
    header = struct.pack(">IIBBBBB", SIZE, SIZE, 8, 6, 0, 0, 0)
    file_name = os.path.join(os.path.dirname(os.path.abspath(__file__)), "MoserHex.png")
    with open(file_name, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))
    print(file_name)


if __name__ == "__main__":
    main()
