#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The monolith of scene.toml, turned about its toe: at which level does it stand so, and at which does its anchor
yield? Moments of weight, anchor, reservoir and joint water (cubic law in the wedge) on the turned block, by quadrature."""
import math

B, H, WATER = 3.0, 10.0, 9810.0
WEIGHT = 2400 * 9.81 * B * H
APERTURE, STIFFNESS, PRESTRESS, YIELD = 5e-4, 5e7, 200e3, 380e3


def anchor(angle):
    """Tension, and its moment about the toe that holds."""
    c, s = math.cos(angle), math.sin(angle)
    top, foot = (-2.5 * c + 9.5 * s, 9.5 * c + 2.5 * s), (-2.5, -3.0)
    dx, dy = foot[0] - top[0], foot[1] - top[1]
    length = math.hypot(dx, dy)
    tension = PRESTRESS + STIFFNESS * (length - 12.5)
    return tension, (top[0] * dy - top[1] * dx) / length * tension


def excess(level, angle, parts=4000):
    """Overturning less holding moment [N]."""
    c, s = math.cos(angle), math.sin(angle)
    wet = (level - B * s) / c
    moment = WATER * c * wet**3 / 6
    w1, w2 = APERTURE + 2 * B * math.sin(angle / 2), APERTURE
    for i in range(parts):
        u = (i + 0.5) / parts * B
        w = w1 + (w2 - w1) * u / B
        left = (w**-2 - w2**-2) / (w1**-2 - w2**-2) if angle > 0 else 1 - u / B
        moment += WATER * (level * left - (B - u) * s / 2) * (B - u) * B / parts
    return moment - WEIGHT * (B / 2 * c - H / 2 * s) - anchor(angle)[1]


def bisect(function, low, high):
    for _ in range(50):
        middle = (low + high) / 2
        low, high = (low, middle) if function(middle) > 0 else (middle, high)
    return (low + high) / 2


last = bisect(lambda angle: anchor(angle)[0] - YIELD, 0, 3e-3)


def level_at(angle):
    return bisect(lambda z: excess(z, angle), 1, 12)


def heel_mm(angle):
    return 2e3 * B * math.sin(angle / 2)


first = level_at(0)
lowest = min((level_at(k * 5e-6), k * 5e-6) for k in range(40))
regained = bisect(lambda angle: level_at(angle) - first, lowest[1], 1e-3)
print(f"heel opens at {first:.4f} m; the level that would hold it falls to {lowest[0]:.4f} m, and is as high again when open by {heel_mm(regained):.2f} mm")
for k in range(6):
    print(f"heel open by {heel_mm(k / 5 * last):.3f} mm: level {level_at(k / 5 * last):.9f} m")
