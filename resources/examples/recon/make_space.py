#!/usr/bin/env python3
"""Writes the four sections of space.toml: a fold train whose axis plunges and bends, sampled as people draw it.

One section is drawn from east to west, each has vertices of its own, and one lacks a horizon.
"""
import math

TRACES = [
    ((0.0, 0.0), (6000.0, 0.0)),
    ((0.0, 1500.0), (6000.0, 1700.0)),
    ((6000.0, 3100.0), (0.0, 3000.0)),
    ((0.0, 4600.0), (6000.0, 4500.0)),
]
HORIZONS = [("Top", 0.0), ("Middle", -250.0), ("Base", -600.0)]


def height(x, y):
    """The top; the others are parallel to it along the vertical."""
    phase = 2.0 * math.pi * (x - 1100.0 - 0.15 * y) / 3000.0
    return 700.0 - 0.06 * y + (260.0 - 0.015 * y) * math.cos(phase)


for k, (start, end) in enumerate(TRACES, 1):
    length = math.dist(start, end)
    with open(f"space_section_{k}.csv", "w") as out:
        out.write("x,z,name,kind\n")
        for h, (name, depth) in enumerate(HORIZONS):
            if k == 2 and name == "Base":
                continue
            n = 60 + 7 * k + 5 * h
            for i in range(n + 1):
                s = length * i / n
                x = start[0] + (end[0] - start[0]) * i / n
                y = start[1] + (end[1] - start[1]) * i / n
                out.write(f"{s:.1f},{height(x, y) + depth:.2f},{name},horizon\n")
            out.write("\n")
