/* SPDX-License-Identifier: GPL-3.0-or-later
 * Still water that rises before the upper cracked dam (cases/cracked-dam-upper): a whole fluid on the kit.
 * The level is that of the case: 21.702 m at the start, 22.302 m at 6 s. It presses on the face at x = 0. */
#include <math.h>
#include <stdio.h>

#include "blockweir_fluid.h"

#define WEIGHT (1000 * 9.81) /* of water [N/m3] */
#define MOST 16              /* panels, and vertices of a block */

static double level_m(double time_s) {
  return 21.702 + (22.302 - 21.702) * fmin(time_s / 6, 1);
}

int main(void) {
  uint32_t block[MOST], edge[MOST];
  double s_from[MOST], s_to[MOST], from_pa[MOST], to_pa[MOST], now[2 * MOST];
  blockweir_motion motion;
  blockweir_load load = blockweir_dry();
  blockweir_fluid* fluid = blockweir_open("rising water in C", NULL);
  load.block = block, load.edge = edge, load.s_from = s_from, load.s_to = s_to;
  load.pressure_from_pa = from_pa, load.pressure_to_pa = to_pa;

  while (blockweir_receive(fluid, &motion) == BLOCKWEIR_MOTION) {
    const double level = level_m(motion.time_s);
    size_t n = 0;
    for (size_t b = 0; b < blockweir_blocks(fluid); ++b) {
      const size_t vertices = blockweir_vertices(fluid, b);
      const double* drawn = blockweir_outline(fluid, b);
      if (vertices > MOST || blockweir_place(fluid, b, now) != BLOCKWEIR_OK) continue;
      for (size_t e = 0; e < vertices && n < MOST; ++e) {
        const size_t next = (e + 1) % vertices;
        if (drawn[2 * e] != 0 || drawn[2 * next] != 0) continue;
        /* downwards, as outlines run counter-clockwise */
        const double y_from = now[2 * e + 1], y_to = now[2 * next + 1];
        block[n] = (uint32_t)b, edge[n] = (uint32_t)e;
        s_from[n] = level >= y_from ? 0 : fmin((y_from - level) / (y_from - y_to), 1);
        s_to[n] = 1;
        from_pa[n] = WEIGHT * fmax(level - y_from, 0);
        to_pa[n++] = WEIGHT * fmax(level - y_to, 0);
      }
    }
    load.panels = load.cracks_from = n;
    load.upstream_level_m = level;
    blockweir_send(fluid, &load);
  }
  if (*blockweir_error(fluid) != '\0') fprintf(stderr, "upper_dam: %s\n", blockweir_error(fluid));
  return blockweir_close(fluid);
}
