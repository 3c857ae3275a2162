/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Stability under the loads of a scene (docs/mechanics.md section 5). */

#ifndef TP_EVALUATION_LOADED_H
#define TP_EVALUATION_LOADED_H

#include "evaluation/certainty.h"
#include "evaluation/loaded_bond.h"
#include "load/loads.h"
#include "load/roots.h"

/* The loads for one direction of tilt at one rung, in SI units and the frame of load/wrench.h. */
typedef struct tp_loaded tp_loaded;
struct tp_loaded {
  bool mirrored;
  long count;
  tp_load *items;
  tp_wrench sum;
  tp_bond *bond;    /* NULL: there is none */
  double range_deg; /* up to which a static limit is looked for; exact */
  double evaluated; /* when the items were, by tp_clock_now */
};

/* False when memory is exhausted. */
TP_MUST_USE bool tp_loaded_init(tp_loaded *loaded, const tp_evaluation *evaluation,
                                tp_direction towards);
void tp_loaded_clear(tp_loaded *loaded);

/* The axis about the k-th contact point, in metres and in the frame of the loads. */
void tp_loaded_axis(arb_t x, arb_t y, const tp_loaded *loaded, const tp_evaluation *evaluation,
                    long k);

/* A point of the lattice in metres of the scene, and in metres from the lattice's origin. */
void tp_loaded_metres(arb_t x, arb_t y, const tp_evaluation *evaluation);
void tp_loaded_local_metres(arb_t x, arb_t y, const tp_evaluation *evaluation);

/* All loads, their moment about the lattice's origin: a block far from the scene's origin has
 * moments about that that cancel, and friction is known only to so many bits. */
void tp_loaded_local_sum(tp_wrench *sum, const tp_loaded *loaded, const tp_evaluation *evaluation);

/* The same of loads that are given, about the origin of the scene. */
void tp_loaded_local(tp_wrench *local, const tp_wrench *loads, const tp_loaded *loaded,
                     const tp_evaluation *evaluation);

/* The moment of the contact's tensile bond about the axis at a contact point, positive, in N m:
 * against overturning, or against turning `back`. */
void tp_loaded_bond(arb_t moment, long k, bool back, const tp_loaded *loaded,
                    const tp_evaluation *evaluation);

/* The moment of all loads about the axis at a contact point, the bond of the contact included. */
void tp_loaded_moment(tp_trig *moment, const tp_loaded *loaded, const tp_evaluation *evaluation,
                      long k);

/* Its zeros, and the critical angle in degrees: 180 where it never topples, -180 where it never
 * stands. */
void tp_loaded_critical(arb_t degrees, tp_roots *roots, const tp_loaded *loaded,
                        const tp_evaluation *evaluation, long k, tp_certainty *certainty);

/* The factor of safety about a contact point at the scene's tilt, where the state says that it is a
 * number. */
tp_fos_state tp_loaded_factor(arb_t factor, const tp_loaded *loaded,
                              const tp_evaluation *evaluation, long k, tp_certainty *certainty);

/* Fill in a pivot's limits and its factor of safety at the scene's tilt. */
void tp_loaded_pivot(tp_pivot *pivot, const tp_loaded *loaded, const tp_evaluation *evaluation,
                     long k, const arb_t degrees, const tp_roots *roots, tp_certainty *certainty);

/* The tilt beyond which water that stays level would stand above the top of its face. */
void tp_loaded_overtops(tp_case *result, const tp_evaluation *evaluation, tp_certainty *certainty);

/* The account of loads about the governing pivot; room for tp_loaded_account_count. False when
 * memory is exhausted. */
long tp_loaded_account_count(const tp_scene *scene);
TP_MUST_USE bool tp_loaded_account(tp_case *result, const tp_loaded *loaded,
                                   const tp_evaluation *evaluation, tp_certainty *certainty);
void tp_loaded_account_clear(tp_case *result);

/* Does it turn up-dip at the scene's tilt? `*open` where that is not known. */
bool tp_loaded_falls_backwards(bool *open, const tp_loaded *loaded, const tp_evaluation *evaluation,
                               const bool *admissible, tp_certainty *certainty);

/* Sliding down along a facet, (run, rise) as in evaluation/sliding.c, with a friction angle in
 * degrees and the cohesion of the contact: the critical angle in degrees, -180 where it slides at
 * every tilt, or false where it never does; the factor of safety is with the friction at the
 * scene's tilt, and `forces` gets those that it is made of (NULL: nobody asks). */
bool tp_loaded_sliding(arb_t degrees, tp_fos *fos, tp_sliding *forces, const tp_loaded *loaded,
                       const tp_evaluation *evaluation, const fmpz_t run, const fmpz_t rise,
                       const arb_t friction, tp_certainty *certainty);

/* The same where friction depends on the load: the tilt from level at which it begins to slide with
 * the friction of the stress there. */
typedef enum tp_loaded_start {
  TP_START_AT_ANGLE,
  TP_START_NEVER,
  TP_START_ALWAYS,
  TP_START_OPEN /* more bits are needed */
} tp_loaded_start;
tp_loaded_start tp_loaded_sliding_start(arb_t degrees, const tp_loaded *loaded,
                                        const tp_evaluation *evaluation, const fmpz_t run,
                                        const fmpz_t rise);

#endif
