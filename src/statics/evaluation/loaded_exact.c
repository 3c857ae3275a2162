/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Fills in centroid, heel, toe and pivot as rationals for the exact test of load/vanish.h; without
 * it where corners are rounded. */

#include "evaluation/loaded_exact.h"

/* What lattice sums are, where they are whole numbers and no balls: the centroid in metres. */
static bool set_centroid(tp_exact_setting *s, const tp_evaluation *e) {
  const arb_struct *sums = e->moments.weighted;
  const tp_lattice *l = &e->problem->lattice;
  if (!arb_is_int(sums + TP_A2) || !arb_is_int(sums + TP_X6) || !arb_is_int(sums + TP_Y6)) {
    return false;
  }
  fmpz_t size;
  fmpz_init(size);
  arf_get_fmpz(size, arb_midref(sums + TP_A2), ARF_RND_NEAR);
  fmpz_mul_ui(size, size, 3);
  arf_get_fmpz(fmpq_numref(s->x), arb_midref(sums + TP_X6), ARF_RND_NEAR);
  arf_get_fmpz(fmpq_numref(s->y), arb_midref(sums + TP_Y6), ARF_RND_NEAR);
  fmpq_div_fmpz(s->x, s->x, size);
  fmpq_div_fmpz(s->y, s->y, size);
  fmpq_add_fmpz(s->x, s->x, l->origin_x);
  fmpq_add_fmpz(s->y, s->y, l->origin_y);
  fmpq_mul(s->x, s->x, l->step_m);
  fmpq_mul(s->y, s->y, l->step_m);
  if (s->mirrored) fmpq_neg(s->x, s->x);
  fmpz_clear(size);
  return true;
}

static void set_joint(tp_exact_setting *s, const tp_base_joint *joint) {
  const int heel = s->mirrored ? 0 : 1;
  fmpq_set(s->heel_x, joint->x + heel);
  fmpq_set(s->heel_y, joint->y + heel);
  fmpq_set(s->toe_x, joint->x + 1 - heel);
  fmpq_set(s->toe_y, joint->y + 1 - heel);
  if (!s->mirrored) return;
  fmpq_neg(s->heel_x, s->heel_x);
  fmpq_neg(s->toe_x, s->toe_x);
}

/* All but the pivot. */
static void set_setting(tp_exact_setting *s, const tp_loaded *loaded, const tp_evaluation *e) {
  const tp_problem *problem = e->problem;
  tp_exact_setting_init(s, problem->scene, loaded->mirrored);
  if (tp_problem_has_wetted(problem)) s->wetted = problem->wetted + (loaded->mirrored ? 1 : 0);
  s->has_centroid = set_centroid(s, e);
  if (problem->scene->loads.water.given) set_joint(s, &problem->joint);
}

bool tp_loaded_vanishes(const tp_load *load, tp_load_part part, const tp_loaded *loaded,
                        const tp_evaluation *e, long k) {
  const tp_problem *problem = e->problem;
  const tp_lattice *l = &problem->lattice;
  const tp_outline_point pivot = tp_contact_on_outline(problem->contact.points + k);
  if (pivot.cut != NULL) return false;
  tp_exact_setting s;
  set_setting(&s, loaded, e);
  tp_lattice_metres_x(s.pivot_x, l, l->x + pivot.point);
  tp_lattice_metres_y(s.pivot_y, l, l->y + pivot.point);
  if (s.mirrored) fmpq_neg(s.pivot_x, s.pivot_x);
  const bool vanishes = tp_load_vanishes(load, part, &s, problem->scene->tilt_angle_deg.value);
  tp_exact_setting_clear(&s);
  return vanishes;
}

bool tp_loaded_is_central(const tp_load *load, const tp_loaded *loaded, const tp_evaluation *e) {
  tp_exact_setting s;
  set_setting(&s, loaded, e);
  fmpq_set(s.pivot_x, s.x);
  fmpq_set(s.pivot_y, s.y);
  const bool central = s.has_centroid && tp_load_vanishes(load, TP_LOAD_WHOLE, &s, NULL);
  tp_exact_setting_clear(&s);
  return central;
}
