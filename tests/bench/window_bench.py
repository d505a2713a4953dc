#!/usr/bin/env python3
"""How long the window's thread is deaf, how much memory it takes, and how many frames a second it shows.

    python3 tests/bench/window_bench.py build/release/bin [HORIZONSxPOINTS | fold | TRIANGLESt ...]

Each document is opened in the window under xvfb-run (1280 x 800), edited there once, and run on the command line. Printed
are seconds and resident memory at most of both, the longest time in which the window answered nothing, until the document
was opened (the first picture, for which OpenGL starts, among it) and after the edit, whatever it was busy with, and

- full frame: how long the longest frame in full detail took from its beginning to its end, and in brackets for how much
  of that the window was deaf at once: one of many points is drawn in parts, between which the window hears,
- frames: how many a second reach the screen while a mouse pans the picture for two seconds at 120 Hz,
- states: how many different restored sections a second reach the screen while a mouse drags a vertex of fold.toml so,
- same: whether the report.json of the window and of the command line are the same bytes.

    10x1000    ten horizons of 1000 points that ripple, restored by shear; the edit changes the restoration
    fold       resources/examples/recon/fold.toml; the edit changes the restoration
    1000000t   a square of so many triangles, nearly; the edit changes how they are smoothed
"""

import math
import os
import re
import subprocess
import sys
import tempfile
import time

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..')


def write_section(folder, horizons, points):
    lines = ['dobra = 1', 'program = "recon"', '[input]']
    for k in range(horizons):
        name = f'h{k}.csv'
        with open(os.path.join(folder, name), 'w') as out:
            out.write('x,z\n')
            for i in range(points):
                x = 10000.0 * i / (points - 1)
                fold = 200.0 * math.sin(x / 900.0)
                ripple = 3.0 * math.sin(40.0 * x / (10000.0 / points * 100.0) + k)
                out.write(f'{x:.6f},{fold + ripple - 2000.0 * k / horizons:.6f}\n')
        lines += ['[[input.horizon]]', f'name = "h{k}"', f'file = "{name}"']
    lines += ['[[step]]', 'operation = "grid"', 'top = "h0"', '[[step]]', 'operation = "target"', 'shape = "flat"',
              'pin = 0.0', '[[step]]', 'operation = "restore"', 'method = "shear"']
    scenario = os.path.join(folder, f'section_{horizons}x{points}.toml')
    with open(scenario, 'w') as out:
        out.write('\n'.join(lines) + '\n')
    return scenario


def write_square(folder, triangles):
    size = math.sqrt(4.0 / (math.sqrt(3.0) * triangles))  # equilateral triangles of that side on 1 m2
    scenario = os.path.join(folder, f'square_{triangles}.toml')
    with open(scenario, 'w') as out:
        out.write('dobra = 1\nprogram = "quebra"\n[input]\n[[input.curve]]\nname = "outline"\nkind = "polygon"\n'
                  'points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]\n'
                  f'[[step]]\noperation = "mesh"\nsize = {size:.6g}\nmax_elements = {2 * triangles}\nsmoothing = 1\n')
    return scenario


def measured(command, settings):
    """Seconds, and megabytes of the largest process below it. The window begins as new: its settings go to a folder."""
    begin = time.time()
    process = subprocess.Popen(['/usr/bin/time', '-f', 'peak %M', *command], stderr=subprocess.PIPE, text=True,
                               env={**os.environ, 'XDG_CONFIG_HOME': settings})
    _, said = process.communicate()
    if process.returncode not in (0, 1):
        sys.exit(said)
    return time.time() - begin, float(re.findall(r'peak (\d+)', said)[-1]) / 1024.0


def measure(bin_folder, what, folder):
    program, edit, states = 'recon', 'select 3\nset percent 99', ''
    if what == 'fold':
        scenario = os.path.join(ROOT, 'resources', 'examples', 'recon', 'fold.toml')
        place = first_point_inside(os.path.join(os.path.dirname(scenario), 'fold_upper_sandstone.csv'))
        # Near enough that 40 m are some 35 pixels: a shorter way would snap to the vertex that is dragged.
        states = (f'fit\nwait\ntool select\nzoom 12 0.364 0.21\nwait\nclick {place[0]} {place[1]}\nwait\n'
                  f'states {place[0]} {place[1]} {place[0]} {place[1] + 40.0} {folder}/states\nwait\n')
        edit = 'select 3\nset tolerance 3'
    elif what.endswith('t'):
        program, edit = 'quebra', 'select 1\nset smoothing 2'
        scenario = write_square(folder, int(what[:-1]))
    else:
        scenario = write_section(folder, *map(int, what.split('x')))
    binary = os.path.join(bin_folder, program)
    script = os.path.join(folder, 'script.txt')
    with open(script, 'w') as out:
        out.write(f'wait\nlongest-gap {folder}/open\nfull-frame {folder}/full_open\nreport {folder}/report.json\n'
                  f'{edit}\nwait\nlongest-gap {folder}/edit\nfull-frame {folder}/full_edit\n'
                  f'frames {folder}/frames\nwait\n{states}screenshot {folder}/shot.png\nquit\n')
    line, line_mb = measured([binary, 'run', scenario, '--quiet', '--out', os.path.join(folder, 'out')], folder)
    window, window_mb = measured(['xvfb-run', '-a', '-s', '-screen 0 1280x800x24', binary, scenario, '--script', script], folder)

    def said(name):
        path = os.path.join(folder, name)
        return open(path).read().strip() if os.path.exists(path) else '-'

    def frame(name):
        return '{} ({})'.format(*said(name).split())

    same = 'yes' if said('report.json') == said('out/report.json') else 'NO'
    print(f'| {what} | {line:.1f} | {line_mb:.0f} | {window:.1f} | {window_mb:.0f} | {said("open")} | {said("edit")} | '
          f'{frame("full_open")} | {frame("full_edit")} | {said("frames")} | {said("states")} | {same} |', flush=True)


def first_point_inside(file):
    """A vertex of the line in the file, some way from its ends."""
    rows = [line.split(',') for line in open(file).read().split('\n')[1:] if line]
    return tuple(float(number) for number in rows[len(rows) // 3][:2])


def main():
    bin_folder = os.path.abspath(sys.argv[1])
    print(f'Load of the machine at the start: {os.getloadavg()[0]:.1f}, {os.cpu_count()} cores.\n')
    print('| document | command line s | MB | window s | MB | deaf ms on opening | on an edit | full frame ms on opening | '
          'on an edit | frames | states | same |')
    print('|' + 12 * '---|')
    for what in sys.argv[2:] or ['fold', '10x1000', '1000000t', '100x10000']:
        with tempfile.TemporaryDirectory() as folder:
            measure(bin_folder, what, folder)


if __name__ == '__main__':
    main()
