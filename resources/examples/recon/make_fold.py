#!/usr/bin/env python3
"""Makes the files of fold.toml: five horizons of a train of folds, digitised at uneven steps and rounded to 0.1 m.

The top is a sum of two sines on a gentle dip; the lower horizons lie at slowly varying depths along its normals.
Needs nothing but Python. Run it in this folder; the same files come out each time.
"""
import json
import math


def top(x):
    return (900 + 0.012 * x + 200 * math.sin(2 * math.pi * (x - 450) / 2400)
            + 12 * math.sin(2 * math.pi * (x + 130) / 1100))


def slope(x):
    return (top(x + 0.01) - top(x - 0.01)) / 0.02


def digitised(depth, start, step, phase):
    points, x, k = [], start, 0
    while x < 6400:
        n = math.hypot(1, slope(x))
        d = depth(x)
        points.append((round(x + d * slope(x) / n, 1), round(top(x) - d / n, 1)))
        k += 1
        x += step * (1 + 0.13 * math.sin(2.3 * k + phase))
    return points


horizons = {
    "Upper Sandstone": digitised(lambda x: 0, 0, 26, 0.0),
    "Red Marl": digitised(lambda x: 84 + 5 * math.sin(x / 900), 24, 31, 1.0),
    "Limestone": digitised(lambda x: 165 + 9 * math.sin(x / 1300 + 1), 30, 29, 2.0),
    "Grey Shale": digitised(lambda x: 276 - 10 * math.cos(x / 1700), 22, 33, 3.0),
    "Lower Sandstone": digitised(lambda x: 362 + 8 * math.sin(x / 1100 + 2), 33, 30, 4.0),
}


def rows(name, separator):
    return "".join(f"{x:.1f}{separator}{z:.1f}\n" for x, z in horizons[name])


with open("fold_upper_sandstone.csv", "w") as out:
    out.write("x,z\n" + rows("Upper Sandstone", ","))
with open("fold_grey_shale.txt", "w") as out:
    out.write("# x z, m\n" + rows("Grey Shale", " "))
with open("fold_lower_sandstone.csv", "w") as out:
    out.write("x;z\n" + rows("Lower Sandstone", ";"))
with open("fold_middle.geojson", "w") as out:
    features = [{"type": "Feature", "properties": {"name": name, "kind": "horizon"},
                 "geometry": {"type": "LineString", "coordinates": horizons[name]}} for name in ("Red Marl", "Limestone")]
    out.write('{"type": "FeatureCollection", "features": [\n' + ",\n".join(json.dumps(f) for f in features) + "\n]}\n")
