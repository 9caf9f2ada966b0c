#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Still water that rises before the upper cracked dam (cases/cracked-dam-upper): a whole fluid on the kit.

The level is that of the case: 21.702 m at the start, 22.302 m at 6 s. It presses on every edge that faces upstream.
"""

from blockweir_fluid import Fluid, place

WEIGHT = 1000 * 9.81  # of water [N/m3]


def level_m(time_s):
    return 21.702 + (22.302 - 21.702) * min(time_s / 6, 1)


def panels_of(blocks, motion, level):
    """Pressures on the part under water of each edge on the dam's upstream face, x = 0 in the scene."""
    panels = []
    for index, block in enumerate(blocks):
        now = place(block.vertices, motion.displacement[index])
        for edge, (x, _) in enumerate(block.vertices):
            if x != 0 or block.vertices[(edge + 1) % len(now)][0] != 0:
                continue
            y_from, y_to = now[edge][1], now[(edge + 1) % len(now)][1]  # downwards, as outlines run counter-clockwise
            s_from = 0.0 if level >= y_from else min((y_from - level) / (y_from - y_to), 1.0)
            head = min(level, y_from)
            panels.append((index, edge, s_from, 1.0, WEIGHT * (level - head), WEIGHT * max(level - y_to, 0)))
    return panels


with Fluid("rising water", remembers=False) as fluid:
    while motion := fluid.receive():
        level = level_m(motion.time_s)
        fluid.send(panels_of(fluid.blocks, motion, level), upstream_level_m=level)
