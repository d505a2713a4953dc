#!/usr/bin/env python3
"""A rough closed contour, as coastlines are: what `narrow` costs on it.

coast.py POINTS FILE.geojson            writes the contour
coast.py POINTS FILE.geojson QUEBRA     and meshes it with `narrow` 0 and 1: triangles and seconds of each phase, the least of 3 runs
"""
import json
import math
import random
import subprocess
import sys


def contour(count, seed=1):
    """Star-shaped, so that it cannot cross itself: octaves of waves, the shorter the lower."""
    random.seed(seed)
    waves = []
    k = 3
    while k < count / 4:
        waves.append((k, 0.35 * (3.0 / k) ** 0.75, random.uniform(0.0, 2.0 * math.pi)))
        k = int(k * 1.6) + 1
    points = []
    for i in range(count):
        angle = 2.0 * math.pi * i / count
        r = 1.0 + sum(a * math.sin(k * angle + phase) for k, a, phase in waves)
        r = max(r, 0.05)
        r *= 1.0 + 0.3 / math.sqrt(count) * random.uniform(-1.0, 1.0)
        points.append([1000.0 * r * math.cos(angle), 1000.0 * r * math.sin(angle)])
    return points + points[:1]


def meshed(quebra, file, narrow):
    best = None
    for _ in range(3):
        done = subprocess.run([quebra, "mesh", file, "--narrow", str(narrow), "--json", "--quiet"], capture_output=True, text=True, check=True)
        figures = json.loads(done.stdout)
        if best is None or figures["seconds"]["total"] < best["seconds"]["total"]:
            best = figures
    return best


def main():
    count, file = int(sys.argv[1]), sys.argv[2]
    with open(file, "w", encoding="utf-8") as out:
        json.dump({"type": "Polygon", "coordinates": [contour(count)]}, out)
    for narrow in (0, 1) if len(sys.argv) > 3 else ():
        figures = meshed(sys.argv[3], file, narrow)
        seconds = figures["seconds"]
        print(f"narrow {narrow}: {figures['elements']:.0f} triangles, least alpha {figures['alpha_min']:.2f}, " + ", ".join(f"{name} {value:.3f} s" for name, value in seconds.items()))


if __name__ == "__main__":
    main()
