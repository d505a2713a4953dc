#!/usr/bin/env python3
"""The tables of the paper on meshes of trimmed surfaces [miranda2009surface], on stand-ins in dimensions of our own:
the paper's published figures, Gmsh's three meshers of surfaces, the paper's mesher as we wrote it, and our front.

    tests/bench/surface_table.py build/release/bin/quebra [NAME]... [--skip-gmsh] [--gmsh-most SECONDS]
    tests/bench/surface_table.py build/release/bin/quebra --large [RUNS]

Gmsh has the same surfaces from its geometry kernel OpenCASCADE (quadrics exactly; the Coons patch and the saddle as
Bezier patches, which they are; the bell and the waves as bicubic splines through 41 x 41 points), MeshSizeMax = L and
MeshSizeFromCurvature = 360 / A. Quality is measured here for all, on the triangles as each program wrote them. Speed is
triangles a second on one thread: Gmsh's by the CPU time of its log of the 2D phase, ours by the clock of the phase
`fill`. Ends with 1 where a figure misses what is asked of it.
"""
import argparse, json, math, os, re, resource, subprocess, sys, tempfile, time

HERE = os.path.dirname(os.path.abspath(__file__))
EXAMPLES = os.path.join(HERE, "..", "..", "resources", "examples", "surfaces")

# name: scenario, L, A, and what the paper has: NE, NN, mean alpha, alpha90, least alpha.
ROWS = {
    "6a": ("6", 1, 10, (994, 535, 0.943, 81.2, 0.604)),
    "6b": ("6", 0.5, 5, (3249, 1696, 0.955, 86.7, 0.416)),
    "6c": ("6", 0.3, 3, (9016, 4625, 0.968, 93.1, 0.423)),
    "7a": ("7a", 0.5, 10, (1710, 916, 0.986, 98.7, 0.658)),
    "7b": ("7b", 1, 10, (4776, 2489, 0.965, 96.9, 0.583)),
    "7c": ("7c", 0.5, 10, (3812, 2015, 0.962, 90.1, 0.484)),
    "7d": ("7d", 0.5, 10, (6521, 3360, 0.965, 92.2, 0.448)),
    "7e": ("7e", 1, 5, (2774, 1454, 0.948, 83.6, 0.462)),
    "7f": ("7f", 0.5, 5, (13781, 7020, 0.953, 87.2, 0.326)),
    "8a": ("8a", 0.5, 15, (1178, 680, 0.944, 84.2, 0.433)),
    "8b": ("8b", 0.25, 15, (2053, 1231, 0.974, 95.6, 0.558)),
    "8c": ("8c", 0.25, 10, (2202, 1279, 0.963, 92.1, 0.229)),
    "8d": ("8d", 0.5, 10, (2567, 1396, 0.983, 97.8, 0.402)),
    "8e": ("8e", 1, 5, (2242, 1261, 0.943, 80.4, 0.326)),
    "8f": ("8f", 1, 10, (2746, 1472, 0.950, 87.0, 0.354)),
}
CRITICAL = ("6", 3, 3)  # the prose of the paper has L = 3 where its table has 0.3
MESHERS = {"MeshAdapt": 1, "Delaunay": 5, "frontal": 6}


# --- quality of a mesh file


class Mesh:
    def __init__(self, points, triangles):
        self.points, self.triangles = points, triangles

    def alphas(self):
        values = []
        for a, b, c in self.triangles:
            p, q, r = self.points[a], self.points[b], self.points[c]
            u, v, w = minus(q, p), minus(r, p), minus(r, q)
            sides = dot(u, u) + dot(v, v) + dot(w, w)
            n = cross(u, v)
            values.append(2 * math.sqrt(3) * math.sqrt(dot(n, n)) / sides if sides > 0 else 0.0)
        return values

    def corner_bound(self):
        """The best least alpha that the corners of the border allow: sqrt(3) sin g / (2 - cos g) in a corner of one triangle."""
        border = {}
        for t in self.triangles:
            for i in range(3):
                border[(t[i], t[(i + 1) % 3])] = t
        sides = {e for e in border if (e[1], e[0]) not in border}
        angle = {}
        for t in self.triangles:
            for i in range(3):
                u, v = minus(self.points[t[(i + 1) % 3]], self.points[t[i]]), minus(self.points[t[(i + 2) % 3]], self.points[t[i]])
                angle[t[i]] = angle.get(t[i], 0) + math.acos(max(-1, min(1, dot(u, v) / math.sqrt(dot(u, u) * dot(v, v)))))
        ends = {n for e in sides for n in e}
        bound = 1.0
        for n in ends:
            g = angle[n]
            if g < math.pi / 2:
                bound = min(bound, math.sqrt(3) * math.sin(g) / (2 - math.cos(g)))
        return bound

    def counts(self):
        """Nodes, triangles, sides of the border, closed contours of it."""
        used = {n for t in self.triangles for n in t}
        sides = {}
        for t in self.triangles:
            for i in range(3):
                sides[(t[i], t[(i + 1) % 3])] = True
        border = {e[0]: e[1] for e in sides if (e[1], e[0]) not in sides}
        loops, seen = 0, set()
        for start in border:
            if start in seen:
                continue
            loops += 1
            n = start
            while n not in seen:
                seen.add(n)
                n = border[n]
        return len(used), len(self.triangles), len(border), loops


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def read_msh2(path):
    lines = open(path).read().split("\n")
    first = lines.index("$Nodes")
    points = {}
    for line in lines[first + 2 : first + 2 + int(lines[first + 1])]:
        number, x, y, z = line.split()
        points[number] = (float(x), float(y), float(z))
    first = lines.index("$Elements")
    elements = [line.split() for line in lines[first + 2 : first + 2 + int(lines[first + 1])]]
    return Mesh(points, [tuple(e[-3:]) for e in elements if e[1] == "2"])


def figures(mesh):
    values = mesh.alphas()
    if not values:
        return None
    return {
        "NE": len(values),
        "mean": sum(values) / len(values),
        "a90": 100.0 * sum(v >= 0.90 for v in values) / len(values),
        "min": min(values),
    }


# --- the stand-ins for Gmsh


def patch_brep(rows, degree, knots):
    """A face of a B-spline surface with its four borders, in OCCT's text format. rows[i][j]: control points, u by rows."""
    n, m = len(rows), len(rows[0])
    distinct = sorted(set(knots))
    knot_text = " ".join(f"{k!r} {knots.count(k)}" for k in distinct) + "\n"
    low, high = knots[0], knots[-1]
    text = "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\nLocations 0\n"
    corners = [(low, low), (high, low), (high, high), (low, high)]
    text += "Curve2ds 4\n"
    for (u, v), (du, dv) in zip(corners, [(1, 0), (0, 1), (-1, 0), (0, -1)]):
        text += f"1 {u!r} {v!r} {du} {dv} \n"
    border = [[r[0] for r in rows], rows[-1], [r[-1] for r in rows][::-1], rows[0][::-1]]
    text += "Curves 4\n"
    for i, curve in enumerate(border):
        shifted = [k - low for k in knots] if i < 2 else [high - k for k in reversed(knots)]
        each = sorted(set(shifted))
        text += f"7 0 0  {degree} {len(curve)} {len(each)} " + " ".join(f"{c!r}" for p in curve for c in p) + "\n"
        text += " " + " ".join(f"{k!r} {shifted.count(k)}" for k in each) + "\n"
    text += "Polygon3D 0\nPolygonOnTriangulations 0\nSurfaces 1\n"
    text += f"9 0 0 0 0 {degree} {degree} {n} {m} {len(distinct)} {len(distinct)} "
    text += " ".join(f"{c!r}" for row in rows for p in row for c in p) + "\n" + knot_text + knot_text
    text += "Triangulations 0\n\nTShapes 10\n"
    for x, y, z in (rows[0][0], rows[-1][0], rows[-1][-1], rows[0][-1]):
        text += f"Ve\n1e-07\n{x!r} {y!r} {z!r}\n0 0\n\n0101101\n*\n"
    span = high - low
    for i in range(4):
        text += f"Ed\n 1e-07 1 1 0\n1  {i + 1} 0 0 {span!r}\n2  {i + 1} 1 0 0 {span!r}\n0\n\n0101000\n"
        text += f"+{10 - i} 0 -{10 - (i + 1) % 4} 0 *\n"
    text += "Wi\n\n0101100\n+6 0 +5 0 +4 0 +3 0 *\n"
    text += "Fa\n0  1e-07 1 0\n\n0101000\n+2 0 *\n\n+1 0 \n"
    return text


def coons_rows():
    """The Coons patch of cubic Beziers is the bicubic one whose net is the Coons patch of the control polygons."""
    bottom, top, left, right = (0, 4, 4, 0), (0, -3, 5, 0), (0, 3, -3, 0), (0, -2, 4, 0)
    rows = []
    for i in range(4):
        rows.append([])
        for j in range(4):
            u, v = i / 3, j / 3
            z = (1 - v) * bottom[i] + v * top[i] + (1 - u) * left[j] + u * right[j]
            rows[-1].append((10 * u, 10 * v, z))
    return rows


def saddle_rows():
    square = (100.0, -100.0, 100.0)  # x^2 on [-10, 10] by Bernstein's quadratics
    return [[(10.0 * (i - 1), 10.0 * (j - 1), (square[i] - square[j]) / 10) for j in range(3)] for i in range(3)]


def interpolation(values, points):
    """Control values of the cubic spline with knots at averages through values at equal steps (not-a-knot)."""
    n = len(values)
    knots = [0.0] * 4 + [i / (n - 1) for i in range(2, n - 2)] + [1.0] * 4

    def basis(t):
        k = 3
        while k + 1 < n and knots[k + 1] <= t:
            k += 1
        b = [1.0]
        for d in range(1, 4):
            new = [0.0] * (d + 1)
            for r in range(d):
                i = k - d + 1 + r
                width = knots[i + d] - knots[i]
                right = (knots[i + d] - t) / width
                new[r] += right * b[r]
                new[r + 1] += (1 - right) * b[r]
            b = new
        return k - 3, b

    band = [[0.0] * n for _ in range(n)]
    for i in range(n):
        first, b = basis(i / (n - 1))
        for r in range(4):
            band[i][first + r] = b[r]
    right = [list(v) for v in values]
    for c in range(n):  # elimination in the band
        p = max(range(c, min(n, c + 4)), key=lambda r: abs(band[r][c]))
        band[c], band[p], right[c], right[p] = band[p], band[c], right[p], right[c]
        for r in range(c + 1, min(n, c + 4)):
            f = band[r][c] / band[c][c]
            if f:
                for k in range(c, min(n, c + 8)):
                    band[r][k] -= f * band[c][k]
                right[r] = [x - f * y for x, y in zip(right[r], right[c])]
    for c in reversed(range(n)):
        for k in range(c + 1, min(n, c + 8)):
            right[c] = [x - band[c][k] * y for x, y in zip(right[c], right[k])]
        right[c] = [x / band[c][c] for x in right[c]]
    return right, knots


def graph_rows(function, low, high, steps=40):
    axis = [low + (high - low) * i / steps for i in range(steps + 1)]
    heights, knots = interpolation([[function(x, y) for y in axis] for x in axis], axis)
    control, _ = interpolation([[h[j] for h in heights] for j in range(steps + 1)], axis)
    places, _ = interpolation([[x] for x in axis], axis)
    n = steps + 1
    return [[(places[i][0], places[j][0], control[j][i]) for j in range(n)] for i in range(n)], knots


def geometry(name, folder):
    """A .geo of the stand-in, with the files that it needs."""
    factory = 'SetFactory("OpenCASCADE");\n'

    def merged(rows, degree, knots, rest=""):
        path = os.path.join(folder, name + "_patch.brep")
        open(path, "w").write(patch_brep(rows, degree, knots))
        return factory + f'ShapeFromFile("{path}");\n' + rest

    bezier = [0.0] * 4 + [1.0] * 4
    plate = factory + "Rectangle(1) = {0, 0, 0, 10, 10};\n"

    def holes(circles):
        text = "".join(f"Disk({10 + i}) = {{{x}, {y}, 0, {r}}};\n" for i, (x, y, r) in enumerate(circles))
        return text + f"BooleanDifference{{ Surface{{1}}; Delete; }}{{ Surface{{10:{9 + len(circles)}}}; Delete; }}\n"

    sphere = (
        factory + "Circle(1) = {0, 0, 0, 5, -Pi/3, Pi/3};\nRotate {{1, 0, 0}, {0, 0, 0}, Pi/2} { Curve{1}; }\n"
        "Extrude {{0, 0, 1}, {0, 0, 0}, Pi} { Curve{1}; }\n"
    )
    made = {
        "6": lambda: merged(coons_rows(), 3, bezier),
        "7a": lambda: factory + "Circle(1) = {0, 0, 0, 5, 0, Pi/2};\nExtrude {0, 0, 10} { Curve{1}; }\n",
        "7b": lambda: merged(saddle_rows(), 2, [0.0] * 3 + [1.0] * 3),
        "7c": lambda: sphere,
        "7d": lambda: factory + "Circle(1) = {6, 0, 0, 2, 0, 2*Pi};\nRotate {{1, 0, 0}, {6, 0, 0}, Pi/2} { Curve{1}; }\n"
        "Extrude {{0, 0, 1}, {0, 0, 0}, 3*Pi/2} { Curve{1}; }\n",
        "7e": lambda: merged(*with_degree(graph_rows(lambda x, y: 4 * math.exp(-(x * x + y * y) / 8), -10, 10))),
        "7f": lambda: merged(*with_degree(graph_rows(lambda x, y: 1.5 * math.sin(x) * math.cos(y), 0, 10))),
        "8a": lambda: plate + holes([(5, 5, 2)]),
        "8b": lambda: plate + holes([(2.5, 2.5, 1), (7.5, 2.5, 1), (2.5, 7.5, 1), (7.5, 7.5, 1), (5, 5, 1.5)]),
        "8c": lambda: plate + holes([(3, 5, 1.5)])
        + "a = newp; Point(a) = {6, 2, 0}; Point(a + 1) = {8, 8, 0};\nb = newl; Line(b) = {a, a + 1};\nCurve{b} In Surface{1};\n",
        "8d": lambda: factory + "Circle(1) = {0, 0, 0, 5, 0, Pi};\nExtrude {0, 0, 10} { Curve{1}; }\n"
        "Cylinder(1) = {0, 1, 5, 0, 8, 0, 2};\nBooleanDifference{ Surface{1}; Delete; }{ Volume{1}; Delete; }\n",
        "8e": lambda: sphere + "Box(1) = {0, -20, -20, 20, 40, 40};\nRotate {{0, 1, 0}, {0, 0, 0}, -Pi/4} { Volume{1}; }\n"
        "Translate {1.5, 0, 1.5} { Volume{1}; }\nBooleanDifference{ Surface{1}; Delete; }{ Volume{1}; Delete; }\n",
        "8f": lambda: merged(coons_rows(), 3, bezier, "Disk(50) = {5, 5, -20, 3, 2};\n"
                             "Extrude {0, 0, 40} { Surface{50}; }\nBooleanDifference{ Surface{1}; Delete; }{ Volume{1}; Delete; }\n"
                             "Recursive Delete { Surface{50}; }\n"),
    }
    return made[name]()


def with_degree(rows_and_knots):
    rows, knots = rows_and_knots
    return rows, 3, knots


def run_gmsh(name, size, turn, algorithm, folder, most):
    geo, out = os.path.join(folder, name + ".geo"), os.path.join(folder, name + ".msh")
    text = geometry(name, folder)
    text += f"Mesh.MeshSizeMax = {size};\nMesh.MeshSizeFromCurvature = {360 / turn};\nMesh.Algorithm = {algorithm};\n"
    text += "Mesh.MeshSizeFromPoints = 0;\n" if name == "8c" else ""
    open(geo, "w").write(text)
    if os.path.exists(out):
        os.remove(out)
    try:
        log = subprocess.run(["gmsh", geo, "-2", "-nt", "1", "-format", "msh2", "-o", out], capture_output=True, text=True, timeout=most)
    except subprocess.TimeoutExpired:
        return None
    if not os.path.exists(out):
        return None
    found = figures(read_msh2(out))
    spent = re.search(r"Done meshing 2D \(Wall [\d.]+s, CPU ([\d.]+)s\)", log.stdout + log.stderr)
    if found and spent and float(spent.group(1)) > 0:
        found["speed"] = found["NE"] / float(spent.group(1))
    return found


# --- ours


def run_quebra(quebra, file, size, turn, engine, folder):
    out = os.path.join(folder, "ours.msh2")
    command = [quebra, "mesh", file, "--size", str(size), "--turn", str(turn), "--engine", engine, "--out", out, "--json"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        return {"error": done.stderr.strip() or done.stdout.strip(), "code": done.returncode}
    told = json.loads(done.stdout)
    mesh = read_msh2(out)
    found = figures(mesh)
    found["told"] = told
    found["bound"] = mesh.corner_bound()
    found["counts"] = mesh.counts()
    seconds = told["seconds"].get("fill", 0)
    if seconds > 0:
        found["speed"] = found["NE"] / seconds
    return found


def example(name):
    return os.path.join(EXAMPLES, name + ".toml")


def race(quebra, runs):
    """Our front and Gmsh's frontal mesher on one file, the bicubic patch of 7f, run by run one after the other."""
    print("| triangles, ours | Gmsh's | ours, thousand a second | Gmsh's frontal | ratio | mean, least alpha, ours | Gmsh's |")
    print("|---|---|---|---|---|---|---|")
    times, ratio = [], 0
    with tempfile.TemporaryDirectory() as folder:
        for triangles in (1e4, 1e5, 1e6):
            size = math.sqrt(144.457679 * 4 / math.sqrt(3) / triangles)  # the patch's area
            ours, peer = [], []
            for _ in range(runs):
                peer.append(run_gmsh("7f", size, 45, MESHERS["frontal"], folder, 600))
                ours.append(run_quebra(quebra, os.path.join(folder, "7f_patch.brep"), size, 45, "front", folder))
                if not peer[-1] or "speed" not in peer[-1] or "speed" not in ours[-1]:
                    print(f"missed: no mesh or no time at size {size:.4g}: Gmsh {cell(peer[-1])}, ours {cell(ours[-1])}")
                    return 1
            speed, other = (sorted(r["speed"] for r in all)[runs // 2] for all in (ours, peer))
            ratio = speed / other
            print(f"| {ours[0]['NE']} | {peer[0]['NE']} | {speed / 1000:.0f} | {other / 1000:.1f} | {ratio:.1f} | "
                  f"{ours[0]['mean']:.4f} {ours[0]['min']:.3f} | {peer[0]['mean']:.4f} {peer[0]['min']:.3f} |", flush=True)
            times.append((ours[0]["NE"], ours[0]["NE"] / speed))
    (n, t), (m, u) = times[0], times[-1]
    growth = math.log(u / t) / math.log(m / n)
    print(f"\nMedians of {runs} runs. Our time grows with n^{growth:.2f}.")
    missed = [what for what, holds in (("15 times Gmsh's speed at a million triangles", ratio >= 15), ("n^1.1", growth <= 1.1)) if not holds]
    for what in missed:
        print("missed: " + what)
    return 1 if missed else 0


# --- the table


def cell(found):
    if found is None:
        return "none"
    if "error" in found:
        return "refused"
    speed = f" {found['speed'] / 1000:.0f}" if "speed" in found else ""
    return f"{found['NE']} {found['mean']:.3f} {found['a90']:.1f} {found['min']:.3f}{speed}"


def judge(name, ours, paper, peers, missed):
    def ask(what, holds):
        if not holds:
            missed.append(f"{name}: {what}")

    for engine, found in (("front", ours), ("paper", paper)):
        ask(f"engine {engine} gives no mesh: {found.get('error', '')}", "error" not in found)
        if "error" in found:
            continue
        nodes, triangles, border, loops = found["counts"]
        if name not in ("7d",):  # a band: no contour is the outer one
            ask(f"engine {engine}: NE = 2 NN - B - 2 + 2 h does not hold", triangles == 2 * nodes - border - 2 + 2 * (loops - 1))
        told = found["told"]
        ask(f"engine {engine}: area {told['area']} is not within 1 % of {told['area_surface']}",
            abs(told["area"] - told["area_surface"]) <= 0.01 * told["area_surface"])
        ask(f"engine {engine}: the JSON tells another quality",
            abs(told["alpha_mean"] - found["mean"]) < 1e-6 and abs(told["alpha_min"] - found["min"]) < 1e-6)
    if "error" not in ours:
        ask(f"mean alpha {ours['mean']:.4f} < 0.985", ours["mean"] >= 0.985)
        ask(f"alpha90 {ours['a90']:.2f} < 98", ours["a90"] >= 98.0)
        ask(f"least alpha {ours['min']:.3f} < {min(0.6, ours['bound']):.3f}", ours["min"] >= min(0.6, ours["bound"]) - 1e-3)
        frontal = peers.get("frontal")
        if frontal:
            ask(f"mean alpha {ours['mean']:.4f} is below Gmsh's {frontal['mean']:.4f}", ours["mean"] > frontal["mean"])
            ask(f"alpha90 {ours['a90']:.2f} is below Gmsh's {frontal['a90']:.2f}", ours["a90"] > frontal["a90"])
    if "error" not in paper:
        ask(f"engine paper: mean alpha {paper['mean']:.4f} < 0.90", paper["mean"] >= 0.90)
        ask(f"engine paper: alpha90 {paper['a90']:.1f} < 75", paper["a90"] >= 75.0)
        ask(f"engine paper: least alpha {paper['min']:.3f} < 0.15", paper["min"] >= 0.15)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("quebra")
    options.add_argument("names", nargs="*", help="rows: 6a, 7b ...; all by default")
    options.add_argument("--skip-gmsh", action="store_true")
    options.add_argument("--gmsh-most", type=float, default=300, help="seconds that one run of Gmsh may take")
    options.add_argument("--large", type=int, nargs="?", const=5, metavar="RUNS",
                         help="instead of the table: speed against Gmsh on 7f up to a million triangles, median of so many runs")
    asked = options.parse_args()
    if asked.large is not None:
        if asked.large < 1:
            options.error("--large: at least one run")
        return race(asked.quebra, asked.large)
    names = asked.names or list(ROWS)
    missed, least_ahead, ratios, sizes = [], 0, [], {}
    print("Each cell: triangles, mean alpha, alpha90 %, least alpha, thousand triangles a second.\n")
    print("| fig | L | A | paper, published | " + " | ".join("Gmsh " + m for m in MESHERS) + " | paper's mesher | our front |")
    print("|---|---|---|---|" + "---|" * len(MESHERS) + "---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for name in names:
            scenario, size, turn, published = ROWS[name]
            peers = {} if asked.skip_gmsh else {m: run_gmsh(scenario, size, turn, a, folder, asked.gmsh_most) for m, a in MESHERS.items()}
            paper = run_quebra(asked.quebra, example(scenario), size, turn, "paper", folder)
            ours = run_quebra(asked.quebra, example(scenario), size, turn, "front", folder)
            print(f"| {name} | {size} | {turn} | {published[0]} {published[2]:.3f} {published[3]:.1f} {published[4]:.3f} | "
                  + " | ".join(cell(peers.get(m)) for m in MESHERS) + f" | {cell(paper)} | {cell(ours)} |", flush=True)
            judge(name, ours, paper, peers, missed)
            frontal = peers.get("frontal")
            if frontal and "error" not in ours:
                least_ahead += ours["min"] > frontal["min"]
                if "speed" in frontal and "speed" in ours:
                    ratios.append(ours["speed"] / frontal["speed"])
            sizes[name] = {"front": ours.get("NE"), "paper": paper.get("NE")}
        scenario, size, turn = CRITICAL
        for engine in ("front", "paper"):
            found = run_quebra(asked.quebra, example(scenario), size, turn, engine, folder)
            print(f"| critical: {engine} | {size} | {turn} | | | | | | {cell(found)} |")
            if "error" in found:
                missed.append(f"critical case L = 3, A = 3, engine {engine}: {found['error']}")
    for engine in ("front", "paper"):
        series = [sizes[n][engine] for n in ("6a", "6b", "6c") if n in sizes]
        if None not in series and any(a >= b for a, b in zip(series, series[1:])):
            missed.append(f"engine {engine}: finer L and A do not give more elements: {series}")
    print("\npaper, worst of both its tables: mean alpha 0.943, alpha90 80.4 %, least alpha 0.229")
    if ratios:
        ratios.sort()
        print(f"our front against Gmsh's frontal: {ratios[0]:.0f} to {ratios[-1]:.0f} times as many triangles a second, median "
              f"{ratios[len(ratios) // 2]:.0f}; ahead in least alpha on {least_ahead} of {len(names)}")
        if len(names) == len(ROWS) and least_ahead < 12:
            missed.append(f"ahead of Gmsh's frontal in least alpha on {least_ahead} of {len(names)}, 12 are asked")
    for line in missed:
        print("missed: " + line)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
