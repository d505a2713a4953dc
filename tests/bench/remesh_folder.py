#!/usr/bin/env python3
"""All meshes of a folder (.off .stl .obj .ply) meshed anew, with sides of a part of the diagonal of their box.

    tests/bench/remesh_folder.py build/release/bin/quebra FOLDER [--part 40] [--seconds 60] [--only NAME ...]

One line a mesh: triangles before and after, mean and least alpha, deviation in sides, flipped triangles, seconds, codes
of findings; a refusal with its code and message. Last: how many were meshed, refused, out of time or ended without JSON,
and how many of the meshed have a mean alpha of 0.97 and no flipped triangle. Ends with 1 where one took too long or
ended without JSON. The size is found by a first run with the program's own size, so nothing here reads the meshes.
"""
import argparse, json, os, subprocess, sys, tempfile, time


def run(program, mesh, seconds, *more):
    start = time.time()
    try:
        done = subprocess.run([program, "remesh", mesh, "--json", *more], capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return None, seconds
    try:
        return json.loads(done.stdout), time.time() - start
    except ValueError:
        return {}, time.time() - start


def diagonal(obj):
    lows, highs = [float("inf")] * 3, [float("-inf")] * 3
    for line in open(obj):
        if line.startswith("v "):
            for i, word in enumerate(line.split()[1:4]):
                lows[i], highs[i] = min(lows[i], float(word)), max(highs[i], float(word))
    return sum((high - low) ** 2 for low, high in zip(lows, highs)) ** 0.5


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder")
    parser.add_argument("--part", type=float, default=40.0)
    parser.add_argument("--seconds", type=float, default=60.0)
    parser.add_argument("--only", nargs="*", default=[])
    args = parser.parse_args()
    counts = {"meshed": 0, "refused": 0, "out of time": 0, "without JSON": 0}
    good = 0
    names = sorted(n for n in os.listdir(args.folder) if n.rsplit(".", 1)[-1] in ("off", "stl", "obj", "ply"))
    with tempfile.TemporaryDirectory() as scratch:
        box = os.path.join(scratch, "box.obj")
        for name in names:
            if args.only and name.rsplit(".", 1)[0] not in args.only:
                continue
            mesh = os.path.join(args.folder, name)
            if os.path.exists(box):
                os.remove(box)
            made, took = run(args.program, mesh, args.seconds, "--out", box)
            size = None
            if made and os.path.exists(box):
                size = diagonal(box) / args.part
                made, took = run(args.program, mesh, args.seconds, "--size", repr(size))
            if made is None:
                counts["out of time"] += 1
                print(f"{name:28} out of time")
            elif not made:
                counts["without JSON"] += 1
                print(f"{name:28} ended without JSON")
            elif "elements" not in made:
                counts["refused"] += 1
                finding = made["findings"][-1]
                print(f"{name:28} refused in {took:.1f} s: {finding['code']}: {finding['message'][:90]}")
            else:
                counts["meshed"] += 1
                good += made["alpha_mean"] >= 0.97 and made["flipped"] == 0
                codes = " ".join(finding["code"] for finding in made["findings"])
                print(f"{name:28} {made['elements']:7d} triangles  alpha {made['alpha_mean']:.3f} {made['alpha_min']:.3f}  "
                      f"deviation {made['deviation'] / size:.3f}  flipped {made['flipped']}  {took:.1f} s  {codes}")
            sys.stdout.flush()
    print(", ".join(f"{number} {what}" for what, number in counts.items()) +
          f"; {good} of the meshed with a mean alpha of 0.97 and nothing flipped")
    return 1 if counts["out of time"] or counts["without JSON"] else 0


sys.exit(main())
