#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Uplift and seepage of scene.toml's joints, all of them full, by a calculation of its own: crossings of the lines,
the cubic law between them, conjugate gradients. Prints kN/m and m2/s with and without drains and curtain."""
import math

WEIGHT = 9810.0
VISCOSITY = 1.3e-3
APERTURE = 3e-4
LEFT, RIGHT, BOTTOM = -60.0, 90.0, -40.0
BASE = ((0.0, 0.0), (24.0, 0.0))
DRAIN = ((4.0, 0.5), (4.0, -20.0))
CURTAIN = (0.5, 2.5, -25.0)
CURTAIN_SIDES = [((0.5, 0.5), (2.5, 0.5)), ((2.5, 0.5), (2.5, -25.0)), ((2.5, -25.0), (0.5, -25.0)), ((0.5, -25.0), (0.5, 0.5))]


def lines_of_set(dip_deg, spacing, offset):
    """Lines n.x = offset + k spacing, cut to the rock."""
    dip = math.radians(dip_deg)
    nx, ny = math.sin(dip), math.cos(dip)
    lines = []
    for k in range(-100, 101):
        d = offset + k * spacing
        ends = [(x, (d - nx * x) / ny) for x in (LEFT, RIGHT)]
        ends += [((d - ny * y) / nx, y) for y in (BOTTOM, 0.0)]
        inside = {(round(x, 9), round(y, 9)) for x, y in ends if LEFT - 1e-9 <= x <= RIGHT + 1e-9 and BOTTOM - 1e-9 <= y <= 1e-9}
        if len(inside) > 1:
            lines.append((min(inside), max(inside)))
    return lines


def crossing(a, b):
    """Share of line a at which line b crosses it, or None."""
    (ax, ay), (bx, by) = a
    (cx, cy), (dx, dy) = b
    det = (bx - ax) * (dy - cy) - (by - ay) * (dx - cx)
    if abs(det) < 1e-12:
        return None
    t = ((cx - ax) * (dy - cy) - (cy - ay) * (dx - cx)) / det
    u = ((cx - ax) * (by - ay) - (cy - ay) * (bx - ax)) / det
    return t if -1e-9 <= t <= 1 + 1e-9 and -1e-9 <= u <= 1 + 1e-9 else None


def network(drains, curtain):
    lines = lines_of_set(3, 5, -2.5) + lines_of_set(-80, 5, 1) + [BASE]
    number, places, channels, drained = {}, [], [], set()

    def node(p):
        key = (round(p[0], 6), round(p[1], 6))
        if key not in number:
            number[key] = len(places)
            places.append(p)
        return number[key]

    for i, line in enumerate(lines):
        (ax, ay), (bx, by) = line

        def at(t):
            return ax + t * (bx - ax), ay + t * (by - ay)

        cuts = {0.0, 1.0}
        cuts |= {min(1.0, max(0.0, t)) for k, other in enumerate(lines) if k != i and (t := crossing(line, other)) is not None}
        cuts |= {t for side in CURTAIN_SIDES if (t := crossing(line, side)) is not None}
        t = crossing(line, DRAIN) if drains else None
        if t is not None:
            cuts.add(t)
            drained.add(node(at(t)))
        shares = []
        for share in sorted(cuts):
            if not shares or share - shares[-1] > 1e-9:
                shares.append(share)
        for s, e in zip(shares, shares[1:]):
            mx, my = at((s + e) / 2)
            grouted = curtain and CURTAIN[0] < mx < CURTAIN[1] and my > CURTAIN[2]
            w = APERTURE * (0.2 if grouted else 1)
            channels.append((node(at(s)), node(at(e)), w**3 / (12 * VISCOSITY * math.dist(at(s), at(e)))))
    return places, channels, drained


def seepage(drains, curtain):
    places, channels, drained = network(drains, curtain)
    known = {i: WEIGHT * max(3.0, places[i][1]) for i in drained}
    for i, (x, y) in enumerate(places):
        if abs(y) < 1e-7 and i not in known:
            if LEFT + 1e-6 < x <= 1e-9:
                known[i] = WEIGHT * 28
            elif 24 - 1e-9 <= x < RIGHT - 1e-6:
                known[i] = WEIGHT * 2
    beside = [[] for _ in places]
    for a, b, g in channels:
        beside[a].append((b, g))
        beside[b].append((a, g))
    free = [i for i in range(len(places)) if i not in known]
    potential = [known.get(i, WEIGHT * 15) for i in range(len(places))]

    def outflow(x):
        return [sum(g * (x[i] - x[k]) for k, g in beside[i]) if i not in known else 0.0 for i in range(len(x))]

    scale = [1 / sum(g for _, g in links) for links in beside]
    r = [-q for q in outflow(potential)]
    z = [a * b for a, b in zip(r, scale)]
    p, rz = z[:], sum(a * b for a, b in zip(r, z))
    first = rz
    while rz > 1e-28 * first:
        q = outflow(p)
        step = rz / sum(a * b for a, b in zip(p, q))
        for i in free:
            potential[i] += step * p[i]
            r[i] -= step * q[i]
        z = [a * b for a, b in zip(r, scale)]
        rz, last = sum(a * b for a, b in zip(r, z)), rz
        p = [a + rz / last * b for a, b in zip(z, p)]
    base = sorted((places[i][0], potential[i]) for i in range(len(places)) if abs(places[i][1]) < 1e-7 and -1e-9 <= places[i][0] <= 24 + 1e-9)
    uplift = sum((b[0] - a[0]) * (a[1] + b[1]) / 2 for a, b in zip(base, base[1:]))
    supply = sum(g * (potential[i] - potential[k]) for i, h in known.items() if h == WEIGHT * 28 for k, g in beside[i])
    return uplift, supply


for with_drains in (True, False):
    for with_curtain in (True, False):
        uplift, supply = seepage(with_drains, with_curtain)
        print(f"drains {with_drains!s:5} curtain {with_curtain!s:5} uplift {uplift / 1e3:.4f} kN/m, from the reservoir {supply:.10e} m2/s")
