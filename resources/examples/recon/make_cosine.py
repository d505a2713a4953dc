#!/usr/bin/env python3
"""Makes the files of cosine.toml: y = -cos x at 129 equal steps over [0, 4 pi], and its mitre offset 0.5 below. Every digit is kept."""
import math

top = [(4 * math.pi * i / 128, -math.cos(4 * math.pi * i / 128)) for i in range(129)]


def offset(points, d):
    normals = []
    for a, b in zip(points, points[1:]):
        length = math.dist(a, b)
        normals.append(((b[1] - a[1]) / length, (a[0] - b[0]) / length))
    normals = [normals[0], *normals, normals[-1]]
    out = []
    for (x, y), (ax, ay), (bx, by) in zip(points, normals, normals[1:]):
        f = d / (1 + ax * bx + ay * by)
        out.append((x + f * (ax + bx), y + f * (ay + by)))
    return out


for name, points in (("cosine_top.csv", top), ("cosine_bed.csv", offset(top, 0.5))):
    with open(name, "w") as out:
        out.write("x,z\n" + "".join(f"{x!r},{y!r}\n" for x, y in points))
