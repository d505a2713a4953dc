"""The faces of boundary models in OCCT's text format, each as a file of its own: the same tables with another root."""
import math, re

ENTRY = re.compile(r"^(Ve|Ed|Wi|Fa|Sh|So|CS|Co)\s*$", re.M)
FLAGS = re.compile(r"^[01]{7}\s*$", re.M)
ROOT = re.compile(r"\s*[+-]\d+\s+\d+[ \t]*(?=\n|$)")


class Shapes:
    """The table of shapes. Numbers in the file count from its end."""

    def __init__(self, text):
        self.text, self.kinds, self.below, self.tolerances, self.points = text, {}, {}, {}, {}
        table = re.search(r"^TShapes\s+(\d+)\s*$", text, re.M)
        if not table:
            raise ValueError("no table of shapes")
        count, at = int(table.group(1)), table.end()
        for number in range(count, 0, -1):
            head = ENTRY.search(text, at)
            flags = FLAGS.search(text, head.end())
            end = text.index("*", flags.end())
            self.kinds[number] = head.group(1)
            words = text[flags.end():end].split()
            self.below[number] = [abs(int(w)) for w in words[::2]]
            said = text[head.end():flags.start()].split()
            if head.group(1) == "Ed":
                self.tolerances[number] = float(said[0])
            if head.group(1) == "Ve":
                self.points[number] = tuple(map(float, said[1:4]))
            at = end + 1
        self.end = at
        self.rest = ROOT.match(text, at).end()

    def faces(self):
        return sorted((n for n, kind in self.kinds.items() if kind == "Fa"), reverse=True)

    def alone(self, face):
        return f"{self.text[:self.end]}\n\n+{face} 0 {self.text[self.rest:]}"

    def edges_of(self, face):
        return [e for w in self.below[face] if self.kinds[w] == "Wi" for e in self.below[w] if self.kinds[e] == "Ed"]

    def tolerance_of(self, face):
        return max((self.tolerances[e] for e in self.edges_of(face)), default=0.0)

    def diagonal_of(self, face):
        """Of the box of its vertices, as they stand in the file."""
        points = [self.points[v] for e in self.edges_of(face) for v in self.below[e] if v in self.points]
        return math.sqrt(sum((max(c) - min(c)) ** 2 for c in zip(*points))) if points else 0.0


def array_of(text, name):
    """The words of one ASCII array of a VTK file."""
    found = re.search(r'<DataArray [^>]*Name="' + re.escape(name) + r'"[^>]*format="ascii"[^>]*>([^<]*)<', text)
    return found.group(1).split() if found else []


def read_vtu(path):
    """Nodes, triangles, and the sides that lie on a named curve, as pairs of nodes."""
    text = open(path).read()
    places = re.search(r"<Points>.*?<DataArray [^>]*>([^<]*)<", text, re.S)
    numbers = list(map(float, places.group(1).split())) if places else []
    nodes = [tuple(numbers[i:i + 3]) for i in range(0, len(numbers), 3)]
    corners = list(map(int, array_of(text, "connectivity")))
    if any(kind != "5" for kind in array_of(text, "types")):
        raise ValueError("cells that are no triangles")
    triangles = [tuple(corners[i:i + 3]) for i in range(0, len(corners), 3)]
    named = set()
    for words in re.findall(r'Name="side_set [^"]*"[^>]*>([^<]*)<', text):
        numbers = list(map(int, words.split()))
        for cell, side in zip(numbers[::2], numbers[1::2]):
            named.add((triangles[cell][side], triangles[cell][(side + 1) % 3]))
    return nodes, triangles, named
