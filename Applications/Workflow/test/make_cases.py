#!/usr/bin/env python3
"""Labelmaps to mesh: ellipsoids in NRRD, each of other axes, and one that is cut off in the middle.

    make_cases.py FOLDER COUNT [NAME_OF_THE_BAD_ONE]

Writes case-01.nrrd ..., all good where no bad one is named, and cases.csv, which lists them. Standard library only.
"""
import os
import sys


def ellipsoid(size, axes):
    centre = (size - 1) / 2
    inside = bytearray(size**3)
    for k in range(size):
        for j in range(size):
            for i in range(size):
                distance = sum(((x - centre) / axis) ** 2 for x, axis in zip((i, j, k), axes))
                inside[i + size * (j + size * k)] = distance < 1
    return bytes(inside)


def nrrd(size, voxels):
    header = (
        "NRRD0004\n"
        "type: uint8\n"
        "dimension: 3\n"
        "space: left-posterior-superior\n"
        f"sizes: {size} {size} {size}\n"
        "space directions: (1.5,0,0) (0,1.5,0) (0,0,1.5)\n"
        "kinds: domain domain domain\n"
        "encoding: raw\n"
        "space origin: (0,0,0)\n\n"
    )
    return header.encode() + voxels


def main():
    folder, count, *bad = sys.argv[1:]
    size = 24
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "cases.csv"), "w", encoding="utf-8") as table:
        table.write("input\n")
        for number in range(1, int(count) + 1):
            name = f"case-{number:02}"
            content = nrrd(size, ellipsoid(size, (8 + number % 3, 7 + number % 4, 8 + number % 2)))
            if name in bad:
                content = content[: len(content) // 2]
            with open(os.path.join(folder, name + ".nrrd"), "wb") as file:
                file.write(content)
            table.write(f"{name}.nrrd\n")


if __name__ == "__main__":
    main()
