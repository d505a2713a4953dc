#!/usr/bin/env python3
"""How long the window's thread is deaf, and how much memory it takes, on restored sections that ripple.

    python3 tests/bench/window_bench.py build/release/bin/recon [HORIZONSxPOINTS ...]

Each section is opened and restored in the window under xvfb-run (1280 x 800), there once more after an edit of the
restoration, and on the command line. Printed: seconds and resident memory at most of both, and the longest time in which
the window answered nothing, until the section was opened (the first picture, for which OpenGL starts, among it) and after
the edit; and the pictures a second that are drawn while the section is panned.
"""

import math
import os
import re
import subprocess
import sys
import tempfile
import time


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


def measured(command):
    """Seconds, and megabytes of the largest process below it."""
    begin = time.time()
    process = subprocess.Popen(['/usr/bin/time', '-f', 'peak %M', *command], stderr=subprocess.PIPE, text=True)
    _, said = process.communicate()
    if process.returncode not in (0, 1):
        sys.exit(said)
    return time.time() - begin, float(re.findall(r'peak (\d+)', said)[-1]) / 1024.0


def main():
    recon = os.path.abspath(sys.argv[1])
    sizes = [tuple(map(int, size.split('x'))) for size in sys.argv[2:] or ['10x1000', '100x10000']]
    print('| section | command line s | MB | window s | MB | deaf ms on opening | on an edit | frames a second |')
    print('|---|---|---|---|---|---|---|---|')
    for horizons, points in sizes:
        with tempfile.TemporaryDirectory() as folder:
            scenario = write_section(folder, horizons, points)
            script = os.path.join(folder, 'script.txt')
            gaps = os.path.join(folder, 'gaps.txt')
            with open(script, 'w') as out:
                out.write(f'wait\nlongest-gap {gaps}.open\nselect 3\nset percent 99\nwait\nlongest-gap {gaps}.edit\n'
                          f'frames {gaps}.frames\nscreenshot {folder}/shot.png\nquit\n')
            line, line_mb = measured([recon, 'run', scenario, '--quiet', '--out', os.path.join(folder, 'out')])
            window, window_mb = measured(['xvfb-run', '-a', '-s', '-screen 0 1280x800x24', recon, scenario, '--script',
                                          script])
            opened, edited, frames = (open(f'{gaps}.{what}').read().strip() for what in ('open', 'edit', 'frames'))
            print(f'| {horizons} x {points} | {line:.1f} | {line_mb:.0f} | {window:.1f} | {window_mb:.0f} | {opened} | '
                  f'{edited} | {frames} |', flush=True)


if __name__ == '__main__':
    main()
