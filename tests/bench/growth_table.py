#!/usr/bin/env python3
"""How good triangles can be where sizes grow: the table of docs/algorithms/triangulate.md, "Where sizes grow".

1. A hexagonal lattice bent so that sizes grow evenly along it, without any node left out: alpha by growth.
2. gmsh's frontal mesher (Mesh.Algorithm = 6) on the plates of TriangulateUnseen, with the same sizes as a field:
   fine + (growth - 1) * distance from the holes, at most 1.
"""
import cmath, math, os, subprocess, tempfile


def alpha(a, b, c):
    area = abs(((b - a).conjugate() * (c - a)).imag)
    return 2 * math.sqrt(3) * area / (abs(b - a) ** 2 + abs(c - b) ** 2 + abs(a - c) ** 2)


def bent_lattice(growth):
    """Sizes h = (growth - 1) |z|: the image of a lattice of that side under exp, all orientations alike."""
    s = growth - 1
    return alpha(1, cmath.exp(s), cmath.exp(s * cmath.exp(1j * math.pi / 3)))


def geo(holes, fine, growth):
    text = "".join(f"Point({i + 1}) = {{{x}, {y}, 0}};\n" for i, (x, y) in enumerate([(0, 0), (10, 0), (10, 10), (0, 10)]))
    text += "Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1}; Line Loop(1) = {1:4};\n"
    point, line = 5, 5
    for k, ((x, y), r) in enumerate(holes):
        text += f"Point({point}) = {{{x}, {y}, 0}};\n"
        for i, (u, v) in enumerate([(r, 0), (0, r), (-r, 0), (0, -r)]):
            text += f"Point({point + 1 + i}) = {{{x + u}, {y + v}, 0}};\n"
        for i in range(4):
            text += f"Circle({line + i}) = {{{point + 1 + i}, {point}, {point + 1 + (i + 1) % 4}}};\n"
        text += f"Line Loop({k + 2}) = {{{line}:{line + 3}}};\n"
        text += f'Field[{k + 1}] = MathEval; Field[{k + 1}].F = "{fine} + {growth - 1} * (Sqrt((x - {x})^2 + (y - {y})^2) - {r})";\n'
        point, line = point + 5, line + 4
    n = len(holes)
    text += f"Plane Surface(1) = {{1:{n + 1}}};\n"
    text += f'Field[{n + 1}] = MathEval; Field[{n + 1}].F = "1";\nField[{n + 2}] = Min; Field[{n + 2}].FieldsList = {{1:{n + 1}}};\n'
    text += f"Background Field = {n + 2};\nMesh.CharacteristicLengthExtendFromBoundary = 0;\nMesh.CharacteristicLengthFromPoints = 0;\nMesh.Algorithm = 6;\n"
    return text


def alphas(msh):
    lines = open(msh).read().split("\n")
    first = lines.index("$Nodes")
    points = {}
    for line in lines[first + 2 : first + 2 + int(lines[first + 1])]:
        number, x, y, _ = line.split()
        points[number] = complex(float(x), float(y))
    first = lines.index("$Elements")
    elements = [line.split() for line in lines[first + 2 : first + 2 + int(lines[first + 1])]]
    return [alpha(*(points[n] for n in e[-3:])) for e in elements if e[1] == "2"]


one = [((3.7, 6.1), 1.3)]
four = [((2.2, 2.9), 0.7), ((7.1, 2.4), 1.1), ((6.4, 7.3), 0.4), ((2.8, 7.9), 0.9)]
print("| growth | bent lattice, alpha |\n|---|---|")
for growth in (1.1, 1.2, 1.3, 1.5):
    print(f"| {growth} | {bent_lattice(growth):.4f} |")
print("\n| domain | gmsh frontal, triangles | alpha mean | alpha90 | alpha min |\n|---|---|---|---|---|")
with tempfile.TemporaryDirectory() as folder:
    for growth in (1.1, 1.2, 1.3, 1.5):
        for name, holes, fine in (("four holes 1:20", four, 0.05), ("one hole 1:200", one, 0.005)):
            path = os.path.join(folder, "plate.geo")
            with open(path, "w") as out:
                out.write(geo(holes, fine, growth))
            subprocess.run(["gmsh", "-2", "-format", "msh2", "-o", path + ".msh", "-v", "1", path], check=True)
            a = alphas(path + ".msh")
            print(f"| {name}, growth {growth} | {len(a)} | {sum(a) / len(a):.4f} | {100 * sum(x >= 0.9 for x in a) / len(a):.2f} % | {min(a):.3f} |")
