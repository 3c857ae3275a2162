/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "accuracy/ways.h"

#include "block/check.h"
#include "block/triangle_sums.h"
#include "stability/limit_price.h"
#include "stability/loaded.h"
#include "stability/onset_price.h"

static tp_evaluation evaluation_of(const tp_accuracy_subject *s, tp_rung rung) {
  return (tp_evaluation){.problem = &s->problem, .rung = rung, .digits = 1, .certain = true};
}

/* Under its loads, where the scene calls for some. */
static tp_status with_loads(const tp_accuracy_subject *s, tp_evaluation *e, tp_loaded *loaded) {
  e->loaded = NULL;
  if (!s->problem.loaded) return TP_OK;
  if (!tp_loaded_init(loaded, e, s->towards, s->noted)) return TP_OUT_OF_MEMORY;
  e->loaded = loaded;
  return TP_OK;
}

/* The critical angle about the governing pivot, the moments being known. */
static tp_status turn(arb_t degrees, bool *found, const tp_accuracy_subject *s, tp_evaluation *e) {
  tp_loaded loaded;
  const tp_status status = with_loads(s, e, &loaded);
  if (status != TP_OK) return status;
  tp_direction_ball angle;
  tp_direction_ball_init(&angle);
  tp_evaluate_turning(e, s->towards, s->point, &angle);
  arb_set(degrees, angle.degrees);
  *found = arb_is_finite(degrees) && arf_cmpabs_ui(arb_midref(degrees), 180) < 0;
  tp_direction_ball_clear(&angle);
  if (e->loaded != NULL) tp_loaded_clear(&loaded);
  return TP_OK;
}

/* Sums at the rung's own level, never at a cheaper one. */
tp_status tp_accuracy_by_boundary(arb_t degrees, bool *found, const void *subject, tp_rung rung) {
  const tp_accuracy_subject *s = subject;
  tp_evaluation e = evaluation_of(s, rung);
  const tp_problem *p = &s->problem;
  tp_moments_init(&e.moments);
  tp_moments_evaluate(&e.moments, &p->section, &p->lattice, s->scene.metres_per_unit, rung,
                      TP_AREA_SUM_COUNT);
  if (p->section.arc_tips.count > 0) {
    tp_arcs_take_off(&e.moments, &p->section, &p->lattice, s->scene.metres_per_unit, rung.bits);
  }
  const tp_status status = turn(degrees, found, s, &e);
  tp_moments_clear(&e.moments);
  return status;
}

tp_status tp_accuracy_by_triangles(arb_t degrees, bool *found, const void *subject, tp_rung rung) {
  const tp_accuracy_subject *s = subject;
  tp_evaluation e = evaluation_of(s, rung);
  const tp_problem *p = &s->problem;
  tp_geom_triangulation t = {0};
  tp_message message;
  tp_moments_init(&e.moments);
  tp_status status = tp_check_triangulate(&t, &p->section, &p->lattice, &message);
  if (status == TP_OK && !tp_triangle_sums(&e.moments, &t, &p->section, &p->lattice, rung)) {
    status = TP_OUT_OF_MEMORY;
  }
  if (status == TP_OK) status = turn(degrees, found, s, &e);
  tp_geom_triangulation_clear(&t);
  tp_moments_clear(&e.moments);
  return status;
}

tp_status tp_accuracy_by_rounding(arb_t degrees, bool *found, const void *subject, tp_rung rung) {
  const tp_accuracy_subject *s = subject;
  tp_evaluation e = evaluation_of(s, rung);
  tp_moments_init(&e.moments);
  tp_evaluate_moments(&e);
  const tp_status status = turn(degrees, found, s, &e);
  tp_moments_clear(&e.moments);
  return status;
}

tp_status tp_accuracy_by_limit(arb_t degrees, bool *found, const void *subject, tp_rung rung) {
  const tp_accuracy_subject *s = subject;
  const tp_limit_price price = rung.level == TP_LEVEL_DOUBLE  ? TP_LIMIT_IN_DOUBLES
                               : rung.level == TP_LEVEL_EXACT ? TP_LIMIT_EXACTLY
                                                              : TP_LIMIT_CERTIFIED;
  tp_evaluation e = evaluation_of(s, rung);
  tp_loaded loaded;
  tp_moments_init(&e.moments);
  tp_evaluate_moments(&e);
  tp_status status = with_loads(s, &e, &loaded);
  if (status == TP_OK) {
    status = tp_evaluate_limit_at_price(degrees, found, &e, s->towards, price);
    if (e.loaded != NULL) tp_loaded_clear(&loaded);
  }
  tp_moments_clear(&e.moments);
  return status;
}

tp_status tp_accuracy_by_onset(arb_t degrees, bool *found, const void *subject, tp_rung rung) {
  const tp_accuracy_subject *s = subject;
  tp_evaluation e = evaluation_of(s, rung);
  tp_loaded loaded;
  tp_moments_init(&e.moments);
  tp_evaluate_moments(&e);
  tp_status status = with_loads(s, &e, &loaded);
  if (status == TP_OK) {
    status = tp_evaluate_onset_at_price(degrees, found, &e, s->towards);
    if (e.loaded != NULL) tp_loaded_clear(&loaded);
  }
  tp_moments_clear(&e.moments);
  return status;
}
