#!/usr/bin/env python3
"""Makes the sections of listric.toml and thrust.toml: level beds, moved along faults by maps in closed form.

Both are digitised at uneven steps and rounded to 0.1 m, and every bed ends at its faults.
Needs nothing but Python. Run it in this folder; the same files come out each time.
"""
import math


def steps(low, high, step, phase):
    """Places from low to high, both included, at uneven steps."""
    places, x, k = [low], low, 0
    while True:
        x += step * (1 + 0.3 * math.sin(2.3 * k + phase))
        k += 1
        if x > high - 0.4 * step:
            return places + [high]
        places.append(x)


def write(name, lines):
    with open(name, "w") as out:
        out.write("x,z,name,kind\n")
        for k, (line, kind, points) in enumerate(lines):
            out.write("\n" if k > 0 else "")  # parts two pieces of one bed
            out.write("".join(f"{x:.1f},{z:.1f},{line},{kind}\n" for x, z in points))


def root(f, low, high):
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if (f(middle) > 0) == (f(low) > 0) else (low, middle)
    return 0.5 * (low + high)


# Two listric faults dip to the east. West moved first, then East, in the hanging wall of West; both by vertical shear:
# what stood over x stands over x + heave then, as much lower as the fault is there.

BEDS = {"Top": -200.0, "Sandstone": -450.0, "Marl": -750.0, "Limestone": -1100.0, "Shale": -1500.0}
LEFT, RIGHT, SURFACE = 0.0, 12000.0, 0.0
WEST_HEAVE, EAST_HEAVE = 420.0, 260.0


def west(x):
    return SURFACE - 3200 * (1 - math.exp(-(x - 2600) / 2300))


def east(x):
    return SURFACE - 2900 * (1 - math.exp(-(x - 6400) / 2000))


def listric():
    def after_west(x, z):
        return (x + WEST_HEAVE, z + west(x + WEST_HEAVE) - west(x))

    def after_east(x, z):
        return (x + EAST_HEAVE, z + east(x + EAST_HEAVE) - east(x))

    lines = []
    for k, (name, z) in enumerate(BEDS.items()):
        on_west = root(lambda x: west(x) - z, LEFT, RIGHT)
        # Where the bed, already over West, meets East: by its place before West moved.
        on_east = root(lambda x: east(after_west(x, z)[0]) - after_west(x, z)[1], on_west, RIGHT)
        end = RIGHT - WEST_HEAVE - EAST_HEAVE
        lines.append((name, "horizon", [(x, z) for x in steps(LEFT, on_west, 240, k)]))
        lines.append((name, "horizon", [after_west(x, z) for x in steps(on_west, on_east, 130, k + 1)]))
        lines.append((name, "horizon",
                      [after_east(*after_west(x, z)) for x in steps(on_east, end, 130, k + 2)]))
    for name, fault, start in (("West", west, 2600), ("East", east, 6400)):
        lines.append((name, "fault", [(x, fault(x)) for x in steps(start, RIGHT, 110, 0)]))
    write("listric.csv", lines)


# A thrust with one ramp: a fault-bend fold of the first kind, thickness kept. Three domains of constant velocity, parted
# by walls through both bends (Suppe 1983).

RAMP, FLAT, UPPER, SLIP = math.radians(20), -3000.0, -2000.0, 1100.0
FOOT = 5000.0
HEAD = FOOT + (UPPER - FLAT) / math.tan(RAMP)
GAMMA = math.atan((1 + math.sqrt(1 - 3 * math.tan(RAMP) ** 2)) / math.tan(RAMP))
RATIO = math.sin(GAMMA - RAMP) / math.sin(GAMMA)


def fold(x, z):
    """A point of the hanging wall after SLIP."""
    left = SLIP
    velocities = [(1.0, 0.0), (math.cos(RAMP), math.sin(RAMP)), (RATIO, 0.0)]
    # How far a point is beyond a wall: the first leans back by half the ramp, the second stands at GAMMA.
    walls = [(FOOT, FLAT, math.pi / 2 + RAMP / 2), (HEAD, UPPER, GAMMA)]

    def beyond(wall, x, z):
        at_x, at_z, angle = wall
        return (x - at_x) * math.sin(angle) - (z - at_z) * math.cos(angle)

    domain = sum(beyond(wall, x, z) >= 0 for wall in walls)
    while True:
        u, w = velocities[domain]
        if domain == 2:
            return (x + left * u, z + left * w)
        rate = beyond(walls[domain], x + u, z + w) - beyond(walls[domain], x, z)
        time = -beyond(walls[domain], x, z) / rate
        if time >= left:
            return (x + left * u, z + left * w)
        x, z, left, domain = x + time * u, z + time * w, left - time, domain + 1


def thrust():
    beds = {"Grey Shale": -800.0, "Sandstone": -1300.0, "Limestone": -1700.0, "Red Marl": -2250.0, "Dolomite": -2700.0}
    lines = []
    for k, (name, z) in enumerate(beds.items()):
        if z >= UPPER:
            lines.append((name, "horizon", [fold(x, z) for x in steps(0.0, 12000.0, 90, k)]))
            continue
        cut = FOOT + (z - FLAT) / math.tan(RAMP)
        lines.append((name, "horizon", [fold(x, z) for x in steps(0.0, cut, 90, k)]))
        lines.append((name, "horizon", [(x, z) for x in steps(cut, 13000.0, 240, k)]))
    lines.append(("Thrust", "fault", [(0.0, FLAT), (FOOT, FLAT), (HEAD, UPPER), (14000.0, UPPER)]))
    write("thrust.csv", lines)


listric()
thrust()
