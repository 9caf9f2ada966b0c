#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Added mass on the wall of a shaken basin by linear theory, fitted as the case fits it, over the basin's length.

Prints length, mass under a level surface, mass with waves on it; with a file name draws them beside OpenFOAM's.
Usage: linear_waves.py [basin_length.png]
"""
import math
import subprocess
import sys

RHO, G, DEPTH, AMPLITUDE, OMEGA = 1000.0, 9.81, 10.0, 0.5, 4 * math.pi
OPENFOAM = [(10, 35650), (20, 48482), (30, 51532)]  # at 40 cells in the depth


def force(length, time, waves):
    """On the right wall, from rest: a L H/2 less what each mode of the surface answers."""
    total = AMPLITUDE * math.sin(OMEGA * time) * length / 2 * DEPTH
    for n in range(1, 300):
        k = (2 * n - 1) * math.pi / length
        share = 4 / (length * k**3) * math.tanh(k * DEPTH)
        own = math.sqrt(G * k * math.tanh(k * DEPTH)) if waves else 0.0
        answer = OMEGA * math.sin(OMEGA * time) - own * math.sin(own * time)
        total -= AMPLITUDE * share * OMEGA * answer / (OMEGA**2 - own**2)
    return -RHO * total


def fitted(length, waves, rows=100):
    """m of F = F0 - m a over all but the first tenth of a second."""
    times = [i / rows for i in range(rows // 10 + 1, rows)]
    a = [AMPLITUDE * math.sin(OMEGA * t) for t in times]
    f = [force(length, t, waves) for t in times]
    n, sa, sf = len(a), sum(a), sum(f)
    return -(n * sum(x * y for x, y in zip(a, f)) - sa * sf) / (n * sum(x * x for x in a) - sa * sa)


def main():
    lengths = range(4, 42, 2)
    table = [(length, fitted(length, False), fitted(length, True)) for length in lengths]
    for row in table:
        print("%g %.0f %.0f" % row)
    if len(sys.argv) < 2:
        return
    rows = "".join("%g %g %g\n" % row for row in table)
    points = "".join("%g %g\n" % row for row in OPENFOAM)
    script = f"""set terminal pngcairo size 900,520 font ',11'
set output '{sys.argv[1]}'
set xlabel 'length of the basin [m], 10 m deep'
set ylabel 'added mass on a wall [kg/m]'
set key right bottom
set grid
$theory << E
{rows}E
$openfoam << E
{points}E
plot $theory using 1:2 with lines dashtype 2 lc rgb '#444444' title 'level surface', \\
  $theory using 1:3 with lines lw 2 lc rgb '#1f6fb4' title 'with linear waves', \\
  $openfoam with points pt 7 ps 1.3 lc rgb '#c00000' title 'OpenFOAM, 40 cells in the depth'
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


if __name__ == "__main__":
    main()
