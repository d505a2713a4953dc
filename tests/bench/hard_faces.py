#!/usr/bin/env python3
"""Faces of boundary models that are hard to mesh, given to the program one by one, and its meshes checked by rules that
share nothing with it.

    tests/bench/hard_faces.py build/release/bin/quebra build/release/bin/hard_faces_writer [--first N] [--faces N]
        [--kinds K,K...] [--parts 0,10,30,100] [--seconds S] [--memory MB] [--show] [--keep FOLDER] [--strict]

The writer makes the faces of tests/support/hard_faces.h. Each is meshed with the program's own size (part 0) and with
the diagonal of its box over each part. Every answer is one of
  clean    exit 0; the mesh is closed but for the outline, has the Euler characteristic of the face, lies with its border
           on the outline, has its area, no two neighbours that look against each other, and no flat triangle
  told     exit 0 and a finding with its place says what is wrong: the area, or a flat triangle
  refused  exit 3 or 4; JSON names the reason, in words and with the place
  BAD      all else: a crash, too much time or memory, a bad mesh without a finding, a broken face without one
Ends with 1 where one is BAD or more than a twentieth of the sound ones are refused; with --strict also where one is told.

    tests/bench/hard_faces.py build/release/bin/quebra --folder FOLDER [--every K] [--first N] [--files TEXT] [--parts ...]

takes the faces of boundary models in OCCT's text format (*.brep) instead, each alone, or each K-th. What such a face should
be nobody says: the mesh must have its border on the named curves alone, the area that the program integrates over the
face, no folds, no flat triangle without a finding. It also lists what is refused, by code, and what takes longer than 10 s.
"""
import argparse, glob, json, math, os, resource, subprocess, sys, tempfile
import brep_faces

FLAT = 0.1
AREA_OFF = 0.01


def minus(p, q):
    return (p[0] - q[0], p[1] - q[1], p[2] - q[2])


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def cross(p, q):
    return (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])


def size(p):
    return math.sqrt(dot(p, p))


def read_off(path):
    words = open(path).read().split()
    assert words[0] == "OFF"
    points, count, at = int(words[1]), int(words[2]), 4
    nodes = [tuple(map(float, words[at + 3 * i:at + 3 * i + 3])) for i in range(points)]
    at += 3 * points
    triangles = []
    for _ in range(count):
        corners = int(words[at])
        assert corners == 3
        triangles.append(tuple(map(int, words[at + 1:at + 4])))
        at += 4
    return nodes, triangles


def diagonal(points):
    lows, highs = [min(p[i] for p in points) for i in range(3)], [max(p[i] for p in points) for i in range(3)]
    return math.sqrt(sum((b - a) ** 2 for a, b in zip(lows, highs)))


def from_segment(p, a, b):
    way, to = minus(b, a), minus(p, a)
    length = dot(way, way)
    t = max(0.0, min(1.0, dot(way, to) / length)) if length > 0 else 0.0
    return size(minus(to, (t * way[0], t * way[1], t * way[2])))


class Chains:
    """Segments in a grid, to be asked how far a point is from them, up to a reach."""

    def __init__(self, segments, reach):
        longest = max((size(minus(a, b)) for a, b in segments), default=0.0)
        self.step, self.cells = max(longest, 2.0 * reach, 1e-12), {}
        for a, b in segments:
            spans = [range(self.cell(min(a[i], b[i]) - reach), self.cell(max(a[i], b[i]) + reach) + 1) for i in range(3)]
            for i in spans[0]:
                for j in spans[1]:
                    for k in spans[2]:
                        self.cells.setdefault((i, j, k), []).append((a, b))

    def cell(self, x):
        return math.floor(x / self.step)

    def distance(self, p):
        near = self.cells.get((self.cell(p[0]), self.cell(p[1]), self.cell(p[2])), [])
        return min((from_segment(p, a, b) for a, b in near), default=math.inf)


def circles_of(edges):
    """Closed curves that bound the face: components of the outline's edges."""
    parent = {}

    def root(v):
        while parent.setdefault(v, v) != v:
            v = parent[v]
        return v

    for edge in edges:
        parent[root(edge["a"])] = root(edge["b"])
    return len({root(v) for v in list(parent)})


def angle(p, q):
    return math.atan2(size(cross(p, q)), dot(p, q))


def best_alpha(corner):
    return 1.0 if corner >= math.pi / 3 else math.sqrt(3) * math.sin(corner) / (2 - math.cos(corner))


def corner_bound(edges, nodes, triangles):
    """The best least alpha that the corners of the outline leave: two edges that leave one vertex at the angle g, or sides
    of the border there, which are chords."""
    ends = [p for e in edges for p in (e["points"][0], e["points"][-1])]
    at = {min(range(len(nodes)), key=lambda n: size(minus(nodes[n], p))) for p in ends}
    turned = {}
    for t in triangles:
        for i in range(3):
            if t[i] in at:
                here = nodes[t[i]]
                turned[t[i]] = turned.get(t[i], 0.0) + angle(minus(nodes[t[(i + 1) % 3]], here),
                                                             minus(nodes[t[(i + 2) % 3]], here))
    least = min(turned.values(), default=math.pi)
    leaving = {}
    for edge in edges:
        points = edge["points"]
        leaving.setdefault(edge["a"], []).append(minus(points[1], points[0]))
        leaving.setdefault(edge["b"], []).append(minus(points[-2], points[-1]))
    for ways in leaving.values():
        for i, p in enumerate(ways):
            for q in ways[:i]:
                least = min(least, angle(p, q))
    return best_alpha(least)


def measures(nodes, triangles):
    """Area, least alpha, sides with their triangles, border; what is open or folded, by name."""
    flaws = {}
    whole = 0.0
    least = 1.0
    sides, normals = {}, []
    for t, (a, b, c) in enumerate(triangles):
        u, v, w = minus(nodes[b], nodes[a]), minus(nodes[c], nodes[a]), minus(nodes[c], nodes[b])
        normal = cross(u, v)
        double = size(normal)
        squares = dot(u, u) + dot(v, v) + dot(w, w)
        whole += 0.5 * double
        least = min(least, 2 * math.sqrt(3) * double / squares if squares > 0 else 0.0)
        normals.append(normal)
        for side in ((a, b), (b, c), (c, a)):
            if side in sides or side[0] == side[1]:
                flaws["open"] = "a side is used twice in one direction"
            sides[side] = t
    against, border = {}, []
    for (a, b), t in sides.items():
        other = sides.get((b, a))
        if other is None:
            border.append((a, b))
        else:
            cosine = dot(normals[t], normals[other])
            if cosine < 0.0:  # across a kink of the surface two may turn so far, if both agree with all their others
                opposite = cosine < -0.9 * size(normals[t]) * size(normals[other])
                against[t] = against.get(t, 0) + (2 if opposite else 1)
    folds = sum(1 for count in against.values() if count > 1)
    if folds:
        flaws["fold"] = f"{folds} triangles look against their neighbours"
    ends, starts = sorted(b for _, b in border), sorted(a for a, _ in border)
    if ends != starts or len(set(starts)) != len(starts):
        flaws["open"] = "the border is no set of closed curves"
    return whole, least, sides, border, flaws


def flaws_of(face, said, nodes, triangles, wanted):
    """Each flaw by name, with a text."""
    whole, least, sides, border, flaws = measures(nodes, triangles)
    used = {n for t in triangles for n in t}
    euler = len(used) - (len(sides) + len(border)) // 2 + len(triangles)
    meant = 2 - 2 * face["handles"] - circles_of(face["edges"])
    if euler != meant:
        flaws["euler"] = f"Euler characteristic {euler}, that of the face is {meant}"
    box = diagonal(nodes)
    outline = [(tuple(p), tuple(q)) for e in face["edges"] for p, q in zip(e["points"], e["points"][1:])]
    bent = max((from_segment(e["points"][i], e["points"][i - 1], e["points"][i + 1])
                for e in face["edges"] for i in range(1, len(e["points"]) - 1)), default=0.0)
    near = bent + 10.0 * face["tolerance"] + 1e-3 * box
    if outline:
        chains = Chains(outline, near)
        far = [n for n, _ in border if not chains.distance(nodes[n]) <= near]
        if far:
            flaws["outline"] = f"{len(far)} nodes of the border are not on the outline"
        # A side of the turn A bulges by tan(A / 4) / 2 of its length.
        longest = max((size(minus(nodes[a], nodes[b])) for a, b in border), default=0.0)
        reach = near + 0.1 * longest
        drawn = Chains([(nodes[a], nodes[b]) for a, b in border], reach)
        missed = sum(1 for e in face["edges"] for p in e["points"] if not drawn.distance(p) <= reach)
        if missed:
            flaws["outline"] = f"{missed} places of the outline have no side of the border"
    area = face["area"]
    length = sum(size(minus(p, q)) for p, q in outline)
    if face["sound"]:
        off = AREA_OFF * area + face["unsure"] * area
        off = max(off, face["tolerance"] * length)
        if abs(whole - area) > off:
            flaws["area"] = f"area {whole:.6g}, meant is {area:.6g}"
        if abs(said["area_surface"] - area) > (1e-4 + face["unsure"]) * area + face["tolerance"] * length:
            flaws["area_surface"] = f"area_surface {said['area_surface']:.6g}, meant is {area:.6g}"
        if least < FLAT and least < 0.98 * (bound := min(FLAT, corner_bound(face["edges"], nodes, triangles))):
            flaws["alpha"] = f"alpha {least:.4f} below {bound:.4f}"
    if abs(said["area"] - whole) > 1e-6 * whole or abs(said["alpha_min"] - least) > 1e-4:
        flaws["figures"] = f"says area {said['area']:.8g} and alpha {said['alpha_min']:.4f}; {whole:.8g}, {least:.4f}"
    if said["elements"] != len(triangles):
        flaws["figures"] = "says another number of elements"
    if wanted > 0:
        most = max(size(minus(nodes[a], nodes[b])) for a, b in sides)
        if most > 2.5 * wanted:
            flaws["long"] = f"a side is {most / wanted:.2f} sizes long"
    return flaws


def bound_at_border(nodes, triangles, border):
    """The best least alpha that the corners of the border leave."""
    at = {n for side in border for n in side}
    turned = {}
    for t in triangles:
        for i in range(3):
            if t[i] in at:
                here = nodes[t[i]]
                turned[t[i]] = turned.get(t[i], 0.0) + angle(minus(nodes[t[(i + 1) % 3]], here),
                                                             minus(nodes[t[(i + 2) % 3]], here))
    return best_alpha(min(turned.values(), default=math.pi))


def flaws_alone(tolerance, said, nodes, triangles, named):
    """Of a mesh that only the program's own area and the names of its sides are there to be compared with."""
    whole, least, _, border, flaws = measures(nodes, triangles)
    unnamed = sum(1 for side in border if side not in named)
    if unnamed:
        flaws["open"] = f"{unnamed} sides of the border are on no curve"
    area = said["area_surface"]
    length = sum(size(minus(nodes[a], nodes[b])) for a, b in border)
    if not abs(whole - area) <= max(AREA_OFF * area, tolerance * length):
        flaws["area"] = f"area {whole:.6g}, the face has {area:.6g}"
    if least < FLAT and least < 0.98 * (bound := min(FLAT, bound_at_border(nodes, triangles, border))):
        flaws["alpha"] = f"alpha {least:.4f} below {bound:.4f}"
    if abs(said["area"] - whole) > 1e-6 * whole or abs(said["alpha_min"] - least) > 1e-4:
        flaws["figures"] = f"says area {said['area']:.8g} and alpha {said['alpha_min']:.4f}; {whole:.8g}, {least:.4f}"
    if said["elements"] != len(triangles):
        flaws["figures"] = "says another number of elements"
    return flaws


TOLD_BY = {"area": "area_off", "alpha": "flat_triangle"}


def findings_without(findings):
    """What each finding must have and one has not."""
    for finding in findings:
        if not finding.get("code") or not finding.get("message"):
            return "a finding without code or message"
        if not finding.get("place"):
            return f"{finding['code']} without a place"
    return None


def run(program, arguments, limits):
    """Ends itself after thrice the time; limits["sharp"]: at once."""
    def limited():
        if limits["memory"]:
            resource.setrlimit(resource.RLIMIT_AS, (limits["memory"] << 20, limits["memory"] << 20))
        cpu = (1 if limits.get("sharp") else 3) * limits["seconds"]
        resource.setrlimit(resource.RLIMIT_CPU, (cpu, cpu))

    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([program] + arguments, capture_output=True, text=True, preexec_fn=limited,
                          timeout=60 * limits["seconds"])
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return done, seconds


def answer_of(program, face, file, out, wanted, limits):
    """(verdict, text, seconds, elements, nodes)"""
    arguments = ["mesh", file, "--json", "--out", out] + (["--size", repr(wanted)] if wanted else [])
    if os.path.exists(out):
        os.remove(out)
    done, seconds = run(program, arguments, limits)
    if done.returncode not in (0, 3, 4):
        return "BAD", f"exit code {done.returncode}: {done.stderr.strip()[:200]}", seconds, 0, []
    try:
        said = json.loads(done.stdout)
    except ValueError:
        return "BAD", f"no JSON at exit code {done.returncode}: {done.stdout[:80]!r}", seconds, 0, []
    findings = said.get("findings") or []
    late = seconds > limits["seconds"]
    fault = findings_without(findings)
    if done.returncode != 0:
        text = "; ".join(f"{f['code']}: {f['message']}" for f in findings[-1:])
        if fault or not findings or late:
            return "BAD", f"refused: {fault or ('no finding' if not findings else 'too late')}: {text}", seconds, 0, []
        return "refused", text, seconds, 0, []
    nodes, triangles = read_off(out)
    if not triangles:
        return "BAD", "an empty mesh", seconds, 0, []
    flaws = flaws_of(face, said, nodes, triangles, wanted)
    if fault:
        flaws["finding"] = fault
    if late:
        flaws["late"] = f"{seconds:.1f} s"
    if not face["sound"] and not findings:
        flaws["broken"] = f"meshed without a finding: {face['wrong']}"
    codes = {f["code"] for f in findings}
    text = "; ".join(f"{name}: {said_of}" for name, said_of in flaws.items())
    count = len(triangles)
    if any(TOLD_BY.get(name) not in codes for name in flaws):
        return "BAD", text, seconds, count, nodes
    if flaws or not face["sound"]:
        return "told", text or "; ".join(sorted(codes)), seconds, count, nodes
    return "clean", "", seconds, count, nodes


def answer_alone(options, tolerance, file, out, wanted):
    """(verdict, text, seconds, elements, nodes) for a face of a folder."""
    arguments = ["mesh", file, "--json", "--out", out] + (["--size", repr(wanted)] if wanted else [])
    if os.path.exists(out):
        os.remove(out)
    done, seconds = run(options.program, arguments, {"seconds": options.seconds, "memory": options.memory, "sharp": True})
    if seconds >= options.seconds - 0.5 and done.returncode < 0:
        return "late", f"{seconds:.1f} s, exit {done.returncode}", seconds, 0, []
    if done.returncode not in (0, 3, 4):
        return "BAD", f"exit code {done.returncode}: {done.stderr.strip()[:200]}", seconds, 0, []
    try:
        said = json.loads(done.stdout)
    except ValueError:
        return "BAD", f"no JSON at exit code {done.returncode}: {done.stdout[:80]!r}", seconds, 0, []
    findings = said.get("findings") or []
    fault = findings_without(findings)
    if done.returncode != 0:
        if fault or not findings:
            return "BAD", f"refused: {fault or 'no finding'}: {done.stderr.strip()[-200:]}", seconds, 0, []
        return "refused " + findings[-1]["code"], findings[-1]["message"], seconds, 0, []
    nodes, triangles, named = brep_faces.read_vtu(out)
    if not triangles:
        return "BAD", "an empty mesh", seconds, 0, []
    flaws = flaws_alone(tolerance, said, nodes, triangles, named)
    if fault:
        flaws["finding"] = fault
    codes = {f["code"] for f in findings}
    text = "; ".join(f"{name}: {said_of}" for name, said_of in flaws.items())
    verdict = "BAD" if any(TOLD_BY.get(name) not in codes for name in flaws) else "told" if flaws else "clean"
    return verdict, text, seconds, len(triangles), nodes


def folder_main(options, parts, folder):
    counts, seconds, number = {}, {p: [] for p in parts}, -1
    for path in sorted(glob.glob(os.path.join(options.folder, "*.brep"))):
        name = os.path.splitext(os.path.basename(path))[0]
        try:
            shapes = brep_faces.Shapes(open(path, encoding="latin-1").read())
        except (ValueError, AttributeError) as error:
            print(f"{name}: no boundary model in text: {error}")
            continue
        for k, face in enumerate(shapes.faces()):
            number += 1
            if number < options.first or number % options.every or options.files not in name:
                continue
            file = os.path.join(folder, f"{name}_{k:03}.brep" if options.keep else "face.brep")
            with open(file, "w", encoding="latin-1") as out:
                out.write(shapes.alone(face))
            box = shapes.diagonal_of(face)
            for part in parts:
                wanted = box / part if part else 0.0
                if part and not wanted:
                    continue
                verdict, text, took, triangles, nodes = answer_alone(
                    options, shapes.tolerance_of(face), file, os.path.join(folder, "mesh.vtu"), wanted)
                if nodes and not part:
                    box = diagonal(nodes)
                if verdict != "late" and took > 10.0:
                    verdict, text = "late", f"{took:.1f} s, {verdict}"
                counts.setdefault(verdict, {}).setdefault(part, []).append(f"{name}_{k:03}")
                seconds[part].append(took)
                if options.show and verdict != "clean" or verdict in ("BAD", "late"):
                    print(f"{number} {name}_{k:03} 1/{part}: {verdict}, {triangles} triangles, {took:.2f} s: {text}",
                          flush=True)
    print(f"{'verdict':<24}" + "".join(f"{'1/' + str(p) if p else 'own size':>10}" for p in parts))
    for verdict, by_part in sorted(counts.items()):
        print(f"{verdict:<24}" + "".join(f"{len(by_part.get(p, [])):>10}" for p in parts))
    print(f"{'most s':<24}" + "".join(f"{max(seconds[p], default=0.0):>10.2f}" for p in parts))
    return 1 if "BAD" in counts or "late" in counts else 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("writer", nargs="?")
    parser.add_argument("--folder", help="boundary models whose faces are taken, instead of the writer's")
    parser.add_argument("--every", type=int, default=1, help="of a folder, each so many-th face")
    parser.add_argument("--files", default="", help="of a folder, the files with this in their names")
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--faces", type=int, default=510)
    parser.add_argument("--kinds", default="")
    parser.add_argument("--parts", help="default 0,10,30,100; of a folder 0,30,100")
    parser.add_argument("--seconds", type=int, help="default 10; of a folder 20")
    parser.add_argument("--memory", type=int, default=6000, help="MB of address space; 0: as much as there is")
    parser.add_argument("--show", action="store_true", help="a line for each answer that is not clean")
    parser.add_argument("--keep", help="the files stay in this folder")
    parser.add_argument("--strict", action="store_true")
    options = parser.parse_args()
    if bool(options.writer) == bool(options.folder):
        parser.error("give the writer of faces or --folder")
    options.seconds = options.seconds or (20 if options.folder else 10)
    limits = {"seconds": options.seconds, "memory": options.memory}
    parts = sorted(int(p) for p in (options.parts or ("0,30,100" if options.folder else "0,10,30,100")).split(","))
    temporary = tempfile.TemporaryDirectory()
    folder = options.keep or temporary.name
    os.makedirs(folder, exist_ok=True)
    if options.folder:
        return folder_main(options, parts, folder)
    subprocess.run([options.writer, folder, str(options.first), str(options.faces)]
                   + [k for k in options.kinds.split(",") if k], check=True)
    with open(os.path.join(folder, "faces.json")) as lines:
        faces = [json.loads(line) for line in lines]
    table = {}
    for face in faces:
        file = os.path.join(folder, f"face_{face['seed']}.brep")
        reference = [p for e in face["edges"] for p in e["points"]]
        kind = table.setdefault((not face["sound"], face["kind"]),
                                {"faces": 0, "clean": 0, "told": 0, "refused": 0, "BAD": 0, "seconds": []})
        kind["faces"] += 1
        for part in parts:
            wanted = diagonal(reference) / part if part and reference else 0.0
            if part and not wanted:
                continue
            verdict, text, seconds, count, nodes = answer_of(options.program, face, file, os.path.join(folder, "mesh.off"),
                                                             wanted, limits)
            if nodes and not part:
                reference = nodes  # the box of the face itself, not of its border alone
            kind[verdict] += 1
            kind["seconds"].append(seconds)
            if options.show and verdict != "clean" and (face["sound"] or verdict == "BAD"):
                print(f"seed {face['seed']} ({face['kind']}) 1/{part}: {verdict}, {count} triangles, {seconds:.2f} s: {text}",
                      flush=True)
    print(f"{'kind':<22} {'faces':>5} {'runs':>5} {'clean':>6} {'told':>5} {'refused':>7} {'BAD':>4} {'median':>7} {'most':>7}")
    total = {"faces": 0, "clean": 0, "told": 0, "refused": 0, "BAD": 0, "seconds": []}
    of_sound = dict(total, seconds=[])

    def row(name, counts):
        seconds = sorted(counts["seconds"]) or [0.0]
        print(f"{name:<22} {counts['faces']:>5} {len(counts['seconds']):>5} {counts['clean']:>6} {counts['told']:>5} "
              f"{counts['refused']:>7} {counts['BAD']:>4} {seconds[len(seconds) // 2]:>6.2f}s {seconds[-1]:>6.2f}s")

    for (broken, name), counts in sorted(table.items()):
        row(name + (" (broken)" if broken else ""), counts)
        for key in total:
            total[key] += counts[key]
            if not broken:
                of_sound[key] += counts[key]
    row("sound ones", of_sound)
    row("all", total)
    refused_too_often = of_sound["refused"] > 0.05 * len(of_sound["seconds"])
    return 1 if total["BAD"] or refused_too_often or (options.strict and of_sound["told"]) else 0


if __name__ == "__main__":
    sys.exit(main())
