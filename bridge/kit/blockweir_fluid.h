/* SPDX-License-Identifier: GPL-3.0-or-later
 * A fluid of one's own as the partner of blockweir's solid, in C: bridge/wire/README.md says what goes over the line.
 *
 *   blockweir_fluid* fluid = blockweir_open("mine", NULL);
 *   while (blockweir_receive(fluid, &motion) == BLOCKWEIR_MOTION) { ...; blockweir_send(fluid, &load); }
 *   status = blockweir_close(fluid);
 *
 * Lengths are in m, times in s, pressures in Pa (compression positive), all per metre of thickness. A handle belongs to
 * one thread at a time. After an error all calls but blockweir_error and blockweir_close do nothing and return
 * BLOCKWEIR_ERROR: errors may be looked at once, at the end.
 */
#ifndef BLOCKWEIR_FLUID_H
#define BLOCKWEIR_FLUID_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct blockweir_fluid blockweir_fluid;

enum { BLOCKWEIR_END = 0, BLOCKWEIR_MOTION = 1, BLOCKWEIR_SAVE = 2, BLOCKWEIR_OK = 0, BLOCKWEIR_ERROR = -1 };

/* Where the blocks are, or will be, at time_s, to which the fluid is to step. Six numbers a block, in the scene's
 * order: u, v [m], turn [rad], ex, ey, gxy of its centroid since the scene's outline, and their rates. */
typedef struct blockweir_motion {
  uint64_t window;
  double time_s;
  const double* displacement; /* 6 * blockweir_blocks; good until the next call */
  const double* velocity;     /* the same */
} blockweir_motion;

/* Pressures at the motion's time. Panel i is the part s_from[i]..s_to[i] (0..1) of edge edge[i] of block block[i],
 * which runs from vertex edge[i] to the next one; its pressure is linear. Panels in cracks stand last. */
typedef struct blockweir_load {
  size_t panels;
  const uint32_t* block;
  const uint32_t* edge;
  const double* s_from;
  const double* s_to;
  const double* pressure_from_pa;
  const double* pressure_to_pa;
  size_t cracks_from;        /* first panel in a crack; `panels`: none is */
  double upstream_level_m;   /* NaN: no pool */
  double downstream_level_m; /* NaN: no pool */
  double holds_until_s;      /* the pressures stay until then while no block moves; NaN: not known */
  int breached;              /* other than 0: open water has found a way past the structure */
  const double* added_mass;  /* 6 * blockweir_blocks (xx, xy, xr, yy, yr, rr), or NULL */
} blockweir_load;

/* A load without panels, without pools. */
blockweir_load blockweir_dry(void);

/* Connects to `endpoint` (NULL: that of BLOCKWEIR_ENDPOINT) under the name `role`, waits for the solid and agrees with
 * it. Never NULL but where memory is short; blockweir_error says whether it went well. */
blockweir_fluid* blockweir_open(const char* role, const char* endpoint);

/* "" where all is well, else one line for the user. Good until blockweir_close. */
const char* blockweir_error(const blockweir_fluid* fluid);

/* What the solid said at the handshake. Texts and arrays are good until blockweir_close; where `block` is none they are
 * "" and NULL. */
size_t blockweir_blocks(const blockweir_fluid* fluid);
const char* blockweir_block_name(const blockweir_fluid* fluid, size_t block);
size_t blockweir_vertices(const blockweir_fluid* fluid, size_t block);
const double* blockweir_outline(const blockweir_fluid* fluid,
                                size_t block); /* x0, y0, x1, y1, ..., counter-clockwise */
double blockweir_window_s(const blockweir_fluid* fluid);
double blockweir_duration_s(const blockweir_fluid* fluid);
/* 0, or the number of the motion with which a run is resumed: restore the state from blockweir_checkpoint of it. */
uint64_t blockweir_first_window(const blockweir_fluid* fluid);
/* File for the state before `window`; its folder is there. Good until the next call. */
const char* blockweir_checkpoint(blockweir_fluid* fluid, uint64_t window);

/* This fluid remembers what has been, and keeps checkpoints: blockweir_receive then tells it when to save. */
int blockweir_remembers(blockweir_fluid* fluid);

/* Waits for the next motion: BLOCKWEIR_MOTION, to be answered; BLOCKWEIR_SAVE, where the state before motion->window is
 * to be saved to blockweir_checkpoint of it, and nothing to be answered; BLOCKWEIR_END where the run is complete;
 * BLOCKWEIR_ERROR. */
int blockweir_receive(blockweir_fluid* fluid, blockweir_motion* motion);

/* Where the vertices of a block are now: 2 * blockweir_vertices numbers into `xy`. */
int blockweir_place(const blockweir_fluid* fluid, size_t block, double* xy);

/* Answers the last motion. What cannot be (NaN, a block that is not there, s_to before s_from) is refused here. */
int blockweir_send(blockweir_fluid* fluid, const blockweir_load* load);
/* To be called while a step takes long, whenever it has come further: the solid then waits on. */
int blockweir_progress(blockweir_fluid* fluid, const char* text);
/* Tells the solid, and the user, why this fluid cannot go on. */
int blockweir_fail(blockweir_fluid* fluid, const char* text);

/* Ends the line. 0 where the run was complete, 1 where not: the status that a program should exit with, after having
 * printed blockweir_error. */
int blockweir_close(blockweir_fluid* fluid);

#ifdef __cplusplus
}
#endif

#endif
