/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One plane h . w = 0 that bounds the loads of a mode (motion/bounds.h), through two of its
 * generators. */

#ifndef TP_MOTION_BOUND_PLANE_H
#define TP_MOTION_BOUND_PLANE_H

#include "motion/mode_filter.h"

typedef struct tp_bound {
  tp_vector h;
  tp_source source;
  bool ray_and_edge; /* the pair is */
  bool lower;        /* where doubles chose it: it ends the tilts from below */
  unsigned rays;     /* bit k: M times the k-th ray of the mode lies in the plane */
  arb_t held;        /* h . w >= held, below zero or above by cohesion and bonds */
} tp_bound;

/* All but h, for the i-th and the j-th generator. */
void tp_bound_describe(tp_bound *own, const tp_generators *generators, long i, long j);

/* The bit of a generator in `rays`; none where it is no ray. */
unsigned tp_bound_bit(const tp_generators *generators, long k);

/* The sign of h . g; `size` is log2 of that of h, where the judge may ask for it. */
int tp_bound_sign(const tp_generators *generators, const tp_vector *h, const tp_source *plane,
                  double size, const tp_generator *other);

/* The same plane by its point or its direction alone, without the roundings of friction: forces
 * through a point have no moment about it, forces of one direction none across it, and what
 * accelerates along a normal line none along that. False: it stays as it is. */
bool tp_bound_sharpen(tp_bound *bound, const tp_generators *generators, const tp_generator *a,
                      const tp_generator *b);

/* Where the loads have no moment, the plane of a slide and a force meets them along the slide,
 * whatever the force: M r x -e is its moment times (v_y, -v_x), beside a part that does no work. */
TP_MUST_USE tp_motion_outcome tp_bound_sharpen_slide(tp_bound *bound,
                                                     const tp_generators *generators,
                                                     const tp_generator *ray,
                                                     const tp_generator *force, bool below);

/* h of a plane that doubles have chosen, towards the others. */
TP_MUST_USE tp_motion_outcome tp_bound_evaluate(tp_bound *bound, tp_generators *generators,
                                                const tp_twists *twists,
                                                const tp_chosen_planes *chosen, int k);

#endif
