#!/usr/bin/env python3
"""The table of docs/algorithms/offset.md from one run of the benchmark:
build/bench/bin/offset_bench --benchmark_out=ob.json --benchmark_out_format=json && tests/bench/offset_table.py ob.json
(1): GEOS ran once, as one run took more than 2 s; else medians of at least five runs."""
import json
import math
import sys

runs = {}
for b in json.load(open(sys.argv[1]))["benchmarks"]:
    if b.get("run_type") == "iteration" and "ns_point_curve" in b:
        name, n = b["name"].split("/")[:2]
        runs.setdefault(name, []).append((int(n), b))


def size(name, n):
    """Points of the base: coasts double until they have enough, rough arcs are cut from them."""
    if not name.startswith(("coast", "rough")):
        return n
    m = 6
    while m < n:
        m *= 2
    return m if name.startswith("coast") else m // 2 + m // 6


def short(x):
    return "-" if x == 0 else f"{x:.0f}" if x >= 10 else f"{x:.1f}"


print("| family | n | ns a point and curve | x raw | GEOS / ours | exponent | bytes a point |")
print("|---|---|---|---|---|---|---|")
for name, points in runs.items():
    points.sort(key=lambda p: p[0])
    ns = [b["ns_point_curve"] for _, b in points]
    first, last = size(name, points[0][0]), size(name, points[-1][0])
    exponent = 1 + math.log(ns[-1] / ns[0]) / math.log(last / first) if last > first else float("nan")
    row = lambda key: ", ".join(short(b[key]) for _, b in points)
    geos = ", ".join(short(b["geos"]) + (" (1)" if b["geos_runs"] == 1 else "") for _, b in points)
    sizes = ", ".join(f"1e{round(math.log10(n))}" for n, _ in points)
    print(f"| {name} | {sizes} | {row('ns_point_curve')} | {row('raw')} | {geos} | {exponent:.2f} | {row('peak_bytes')} |")
