/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Evaluations of one angle at a given precision: about the governing pivot by boundary sums,
 * triangles or either model of rounding, the static limit, and the onset. */

#include "accuracy/ways.h"

#include "block/check.h"
#include "block/triangle_sums.h"
#include "stability/limit_price.h"
#include "stability/loaded.h"
#include "stability/onset_price.h"
#include "stability/stages.h"

/* What a way computes with: moments of its own, and the loads where the scene calls for some. */
typedef struct way {
  tp_evaluation e;
  tp_loaded loaded;
} way;

static void way_init(way *w, const tp_accuracy_subject *s, tp_rung rung) {
  w->e =
      (tp_evaluation){.problem = &s->problem, .rung = rung, .digits = 1}; /* its bound is shown */
  tp_moments_init(&w->e.moments);
}

/* The moments being known. */
static tp_status way_load(way *w, const tp_accuracy_subject *s) {
  if (!s->problem.loaded) return TP_OK;
  if (!tp_loaded_init(&w->loaded, &w->e, s->towards)) return TP_OUT_OF_MEMORY;
  w->e.loaded = &w->loaded;
  return TP_OK;
}

/* With the moments that a solve takes at the rung, and the loads. */
static tp_status way_init_whole(way *w, const tp_accuracy_subject *s, tp_rung rung) {
  way_init(w, s, rung);
  tp_evaluate_moments(&w->e.moments, &s->problem, rung);
  return way_load(w, s);
}

static void way_clear(way *w) {
  if (w->e.loaded != NULL) tp_loaded_clear(&w->loaded);
  tp_moments_clear(&w->e.moments);
}

/* The critical angle about the governing pivot, the moments being known. */
static tp_status turn(arb_t degrees, bool *found, const tp_accuracy_subject *s, way *w) {
  const tp_status status = way_load(w, s);
  if (status != TP_OK) return status;
  tp_certainty certainty = {0};
  tp_direction_ball angle;
  tp_direction_ball_init(&angle);
  tp_evaluate_turning(&w->e, s->towards, s->point, &angle, &certainty);
  arb_set(degrees, angle.degrees);
  *found = arb_is_finite(degrees) && arf_cmpabs_ui(arb_midref(degrees), 180) < 0;
  tp_direction_ball_clear(&angle);
  return TP_OK;
}

/* Sums at the rung's own level, never at a cheaper one. */
tp_status tp_accuracy_by_boundary(arb_t degrees, bool *found, const void *subject, tp_rung rung) {
  const tp_accuracy_subject *s = subject;
  const tp_problem *p = &s->problem;
  way w;
  way_init(&w, s, rung);
  tp_moments_evaluate(&w.e.moments, &p->section, &p->lattice, s->scene.metres_per_unit, rung,
                      TP_AREA_SUM_COUNT);
  if (p->section.arc_tips.count > 0) {
    tp_arcs_take_off(&w.e.moments, &p->section, &p->lattice, s->scene.metres_per_unit, rung.bits);
  }
  const tp_status status = turn(degrees, found, s, &w);
  way_clear(&w);
  return status;
}

tp_status tp_accuracy_by_triangles(arb_t degrees, bool *found, const void *subject, tp_rung rung) {
  const tp_accuracy_subject *s = subject;
  const tp_problem *p = &s->problem;
  tp_geom_triangulation t = {0};
  tp_message message;
  way w;
  way_init(&w, s, rung);
  tp_status status = tp_check_triangulate(&t, &p->section, &p->lattice, &message);
  if (status == TP_OK && !tp_triangle_sums(&w.e.moments, &t, &p->section, &p->lattice, rung)) {
    status = TP_OUT_OF_MEMORY;
  }
  if (status == TP_OK) status = turn(degrees, found, s, &w);
  tp_geom_triangulation_clear(&t);
  way_clear(&w);
  return status;
}

tp_status tp_accuracy_by_rounding(arb_t degrees, bool *found, const void *subject, tp_rung rung) {
  const tp_accuracy_subject *s = subject;
  way w;
  way_init(&w, s, rung);
  tp_evaluate_moments(&w.e.moments, &s->problem, rung);
  const tp_status status = turn(degrees, found, s, &w);
  way_clear(&w);
  return status;
}

tp_status tp_accuracy_by_limit(arb_t degrees, bool *found, const void *subject, tp_rung rung) {
  const tp_accuracy_subject *s = subject;
  const tp_limit_price price = rung.level == TP_LEVEL_DOUBLE  ? TP_LIMIT_IN_DOUBLES
                               : rung.level == TP_LEVEL_EXACT ? TP_LIMIT_EXACTLY
                                                              : TP_LIMIT_CERTIFIED;
  way w;
  tp_status status = way_init_whole(&w, s, rung);
  if (status == TP_OK) {
    status = tp_evaluate_limit_at_price(degrees, found, &w.e, s->towards, price);
  }
  way_clear(&w);
  return status;
}

tp_status tp_accuracy_by_onset(arb_t degrees, bool *found, const void *subject, tp_rung rung) {
  const tp_accuracy_subject *s = subject;
  way w;
  tp_status status = way_init_whole(&w, s, rung);
  if (status == TP_OK) status = tp_evaluate_onset_at_price(degrees, found, &w.e, s->towards);
  way_clear(&w);
  return status;
}
