#!/usr/bin/env python3
"""Restores lines to a flat datum by constant thickness, by brute force and without any of the C++ code.

usage: oracle_restore.py TOP LINE...     (text or CSV files of x and z)
Prints for each line: length before and after, least, mean (over the given points) and greatest depth.
A point belongs to the nearest segment of the top whose trapezoid between the two bisectors holds it.
The lines are cut 20 times between their points; corners at the rungs between the cuts are missed, so lengths come out a little short.
"""
import math
import re
import sys


def read(name):
    points = []
    for text in open(name):
        fields = re.split(r"[\s,;]+", text.split("#")[0].strip())
        try:
            points.append((float(fields[0]), float(fields[1])))
        except (ValueError, IndexError):
            continue
    return points if points[0][0] < points[-1][0] else points[::-1]


def restored(top, p):
    n = len(top) - 1
    unit = [((b[0] - a[0]) / math.dist(a, b), (b[1] - a[1]) / math.dist(a, b)) for a, b in zip(top, top[1:])]
    arc = [0.0]
    for a, b in zip(top, top[1:]):
        arc.append(arc[-1] + math.dist(a, b))

    def lean(i, j):  # of the rung at corner j along segment i, per metre of depth
        a, b = unit[max(j - 1, 0)], unit[min(j, n - 1)]
        angle = math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]) / 2
        return math.tan(angle) if i == j - 1 else -math.tan(angle)

    best = None
    for i in range(n):
        (tx, tz), (x, z) = unit[i], (p[0] - top[i][0], p[1] - top[i][1])
        along, depth = x * tx + z * tz, x * tz - z * tx
        length = arc[i + 1] - arc[i]
        left, right = depth * lean(i, i), length + depth * lean(i, i + 1)
        edge = right - left
        if edge > 0 and left - 1e-9 <= along <= right + 1e-9:
            s = arc[i] + (along - left) / edge * length
        elif (i == 0 and along < 0) or (i == n - 1 and along > length):  # beyond the ends: straight on
            s = arc[i] + along
        else:
            continue
        foot = min(max(along, 0.0), length)
        distance = math.hypot(along - foot, depth)
        if best is None or distance < best[0] - 1e-12:
            best = (distance, s, depth)
    return best[1], -best[2]


if __name__ == "__main__":
    base = read(sys.argv[1])
    for name in sys.argv[1:]:
        line = read(name)
        cuts = 20
        fine = [(a[0] + (b[0] - a[0]) * k / cuts, a[1] + (b[1] - a[1]) * k / cuts)
                for a, b in zip(line, line[1:]) for k in range(cuts)] + [line[-1]]
        image = [restored(base, p) for p in fine]
        depths = [-z for _, z in image[::cuts]]
        length = lambda q: sum(math.dist(a, b) for a, b in zip(q, q[1:]))
        print(f"{name}: before {length(line):.6f} after {length(image):.6f} "
              f"depth {min(depths):.6f} {sum(depths) / len(depths):.6f} {max(depths):.6f}")
