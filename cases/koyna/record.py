#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""An artificial earthquake, written to record_x.csv and record_y.csv (s, m/s2).

It is no record of a real earthquake. Sines of random phase (seed 1967) from 0.5 to 15 Hz, each with the amplitude of a
broad spectrum around 2 to 6 Hz, under an envelope that rises for 1.5 s, is strong for 4 s and fades. A parabola is
taken out of the acceleration, so that the ground comes to rest where it began. The peaks are 0.47 g along x and 0.31 g
along y, those that were measured at Koyna in 1967 along the stream and upright (Chopra and Chakrabarti 1973).
"""
import math
import random

STEP_S, LENGTH_S, GRAVITY = 0.01, 10.0, 9.81


def envelope(t):
    if t < 1.5:
        return (t / 1.5) ** 2
    return 1.0 if t < 5.5 else math.exp(-0.9 * (t - 5.5))


def at_rest_again(a):
    """Takes c1 t + c2 t^2 + c3 t^3 times the window out, so that velocity and displacement end at zero and the last value is zero."""
    n = len(a)
    times = [i * STEP_S for i in range(n)]

    def ends(f):
        v = u = 0.0
        for i in range(1, n):  # accelerations are linear between rows
            u += STEP_S * v + STEP_S**2 * (2 * f[i - 1] + f[i]) / 6
            v += STEP_S * (f[i - 1] + f[i]) / 2
        return v, u

    shapes = [[t * (LENGTH_S - t) / LENGTH_S**2 for t in times], [t * (LENGTH_S - t) * t / LENGTH_S**3 for t in times]]
    (v1, u1), (v2, u2) = ends(shapes[0]), ends(shapes[1])
    v, u = ends(a)
    det = v1 * u2 - v2 * u1
    c1, c2 = (v * u2 - v2 * u) / det, (v1 * u - v * u1) / det
    return [x - c1 * s1 - c2 * s2 for x, s1, s2 in zip(a, *shapes)]


def record(seed, peak):
    random.seed(seed)
    sines = []
    for k in range(60):
        f = 0.5 * 30 ** (k / 59)
        amplitude = 1 / (1 + (math.log(f / 3.5) / math.log(2.2)) ** 4)
        sines.append((f, amplitude, random.uniform(0, 2 * math.pi)))
    a = []
    for i in range(round(LENGTH_S / STEP_S) + 1):
        t = i * STEP_S
        a.append(envelope(t) * sum(A * math.sin(2 * math.pi * f * t + p) for f, A, p in sines))
    a[0] = a[-1] = 0.0
    for _ in range(3):
        scale = peak / max(abs(x) for x in a)
        a = at_rest_again([scale * x for x in a])
    return a


for name, seed, peak in (("record_x", 1967, 0.47 * GRAVITY), ("record_y", 1968, 0.31 * GRAVITY)):
    with open(f"{name}.csv", "w", encoding="ascii") as file:
        file.write("time_s,acceleration_m_per_s2\n")
        for i, x in enumerate(record(seed, peak)):
            file.write(f"{i * STEP_S:.2f},{x:.5f}\n")
