/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A contact whose strength is divided by a factor: tan(phi), cohesion and bond alike. Its margin at
 * the scene's tilt by the simplex method in doubles, which only proposes; its limit as
 * limit/limit.h proves it; and on which side of the tilt it lies, by forces that hold or a twist
 * that fails, both proven. */

#ifndef TP_STRENGTH_REDUCTION_REDUCED_H
#define TP_STRENGTH_REDUCTION_REDUCED_H

#include "limit/limit.h"
#include "linear_program/scaled.h"
#include "plane/vector.h"

/* The strength as given, to be divided. */
typedef struct tp_reduced {
  const tp_limit_question *question;
  tp_cones *cones;
  arb_t friction; /* as given, and those of their own */
  arb_ptr own_friction;
  arb_ptr bounds; /* shear and pull of each capacity, as given */
  const tp_scaled *given;
  tp_scaled reduced; /* the caller's copy */
  arb_srcptr degrees;
  tp_vector load;   /* at the tilt */
  double target[3]; /* turned round, in the scaled program's units */
  tp_near level[3]; /* that on level ground in these units, where loads turn with the tilt */
} tp_reduced;

/* Keeps the strength of the cones; `clear` gives it back to them. */
void tp_reduced_init(tp_reduced *reduced);
void tp_reduced_clear(tp_reduced *reduced);

/* How much more than the loads the base bears at the tilt, in doubles, by the logarithm of the
 * factor: it falls, and is below zero where they are more. */
double tp_reduced_margin(tp_reduced *reduced, double log_factor);

/* The limit at a factor, in degrees. */
typedef struct tp_reduced_limit {
  tp_limit_kind kind;
  arb_t degrees; /* where there is one */
  bool has_motion;
  tp_face_motion motion; /* at that limit */
} tp_reduced_limit;

tp_limit_outcome tp_reduced_find(tp_reduced_limit *limit, tp_reduced *reduced, const arf_t factor);

/* Does that limit, which is at the strength at hand, prove that the block is held at the tilt? It
 * does where the tilt lies below it, and not below level ground, on which doubles prove that it is
 * held: the loads between two that are borne are a sum of these. */
bool tp_reduced_holds_below(const tp_reduced_limit *limit, tp_reduced *reduced);

/* How a block moves that is lost at the tilt: the motion of the twist that proves it, up-dip as
 * well as down-dip. */
typedef struct tp_reduced_loss {
  bool known; /* false: it was proven otherwise */
  tp_face_motion motion;
} tp_reduced_loss;

/* With the strength divided by the factor, is the block proven to be held at the tilt, 1, or not,
 * -1? 0 where that is open. What is expected is tried first. `loss` NULL: not asked. */
tp_limit_outcome tp_reduced_side(int *side, tp_reduced_loss *loss, tp_reduced *reduced,
                                 const arf_t factor, int expected);

#endif
