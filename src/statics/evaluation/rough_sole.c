/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Compares sliding on the given sole with sliding on one whose short asperity sides are levelled
 * into the mean plane, and cautions where roughness raises the factor or the angle by more than 0.5
 * per cent. */

#include "evaluation/rough_sole.h"

#include "common/notes.h"
#include "evaluation/friction.h"
#include "evaluation/loaded.h"

#include <math.h>
#include <stdio.h>

/* A side of an asperity, that is all facets between one crest or valley and the next, is short
 * below half of the contact's length along the mean plane: a wave of such sides fits into the
 * contact. */
enum { SHORT_PART = 2 };

/* Fewer facets than three waves have are a shape that someone drew. */
enum { FEWEST = 6 };

/* What the factor, or the angle, has to gain to be told: less is in the last digit printed. */
static const double least_gain = 1.005;

/* A sole as it would be with its short sides in the mean plane. */
typedef struct levelled {
  long count;       /* of their facets */
  double length;    /* below which a side is short: in scene lengths */
  fmpz_t run, rise; /* down-dip on the other side that climbs most; level where none climbs */
  bool blocked;     /* one of those stands upright in the way */
} levelled;

/* Sign of the rise of a facet from left to right. */
static int slope_of(const tp_lattice *l, const tp_facet *f) {
  return fmpz_cmp(l->y + f->q1, l->y + f->q0);
}

/* The side that begins with facet k goes on to the one before the facet that is returned. */
static long end_of_side(const tp_contact *contact, const tp_lattice *l, long k) {
  int slope = 0;
  for (; k < contact->facet_count; k++) {
    const int own = slope_of(l, contact->facets + k);
    if (slope != 0 && own != 0 && (own > 0) != (slope > 0)) return k;
    if (own != 0) slope = own;
  }
  return k;
}

/* Takes a side between two points as a whole: a short one is counted, any other may be the one that
 * climbs most. */
static void take_side(levelled *s, const tp_contact *contact, const tp_lattice *l, long first,
                      long end, const fmpz_t whole, tp_direction towards) {
  const long from = contact->facets[first].q0, to = contact->facets[end - 1].q1;
  fmpz_t run, rise, part;
  fmpz_init(run);
  fmpz_init(rise);
  fmpz_init(part);
  fmpz_sub(run, l->x + to, l->x + from);
  fmpz_sub(rise, l->y + to, l->y + from);
  fmpz_fdiv_q_ui(part, whole, SHORT_PART);
  if (fmpz_cmpabs(run, part) < 0 && fmpz_cmpabs(rise, part) < 0) {
    for (long k = first; k < end; k++) {
      s->count += contact->facets[k].q0 != contact->facets[k].q1;
    }
  } else {
    if (towards == TP_TOWARDS_LEFT) fmpz_neg(rise, rise);
    s->blocked = s->blocked || (fmpz_sgn(run) <= 0 && fmpz_sgn(rise) > 0);
    fmpz_mul(part, rise, s->run);
    fmpz_submul(part, s->rise, run);
    if (fmpz_sgn(run) > 0 && fmpz_sgn(part) > 0) {
      fmpz_swap(s->run, run);
      fmpz_swap(s->rise, rise);
    }
  }
  fmpz_clear(run);
  fmpz_clear(rise);
  fmpz_clear(part);
}

static void level(levelled *s, const tp_problem *problem, tp_direction towards) {
  const tp_contact *contact = &problem->contact;
  const tp_lattice *l = &problem->lattice;
  fmpz_t whole;
  fmpq_t length;
  fmpz_init(whole);
  fmpq_init(length);
  fmpz_sub(whole, l->x + tp_contact_extreme(contact, false).point,
           l->x + tp_contact_extreme(contact, true).point);
  *s = (levelled){0};
  fmpz_init_set_ui(s->run, 1);
  fmpz_init(s->rise);
  for (long k = 0, end = 0; k < contact->facet_count; k = end) {
    end = end_of_side(contact, l, k);
    take_side(s, contact, l, k, end, whole, towards);
  }
  fmpq_set_fmpz_frac(length, whole, (const fmpz[]){SHORT_PART});
  fmpq_mul(length, length, l->step_m);
  fmpq_div(length, length, problem->scene->metres_per_unit);
  s->length = fmpq_get_d(length);
  fmpz_clear(whole);
  fmpq_clear(length);
}

/* What sliding comes to on the levelled sole, and what the scene comes to: factors at its tilt, or
 * angles. */
typedef struct gain {
  bool known, unbounded; /* the scene: nothing moves it */
  bool of_angle;
  double level, drawn;
} gain;

/* Level sliding: a factor at the scene's tilt, and the angle at which it starts, in degrees. */
typedef struct sliding {
  bool has_factor, starts;
  double factor, angle_deg;
} sliding;

/* By the weight alone tan(phi) / tan(tilt - i), and phi + i. */
static sliding by_weight(const levelled *s, const tp_quantity *tilt, const arb_t friction) {
  const double degree = acos(-1) / 180;
  const double phi = degree * arf_get_d(arb_midref(friction), ARF_RND_NEAR);
  const double i = atan2(fmpz_get_d(s->rise), fmpz_get_d(s->run));
  const double steeper = degree * fmpq_get_d(tilt->value) - i;
  return (sliding){.has_factor = tilt->given && steeper > 0,
                   .starts = true,
                   .factor = tan(phi) / tan(steeper),
                   .angle_deg = (phi + i) / degree};
}

/* By the forces along and across the mean plane, or the facet that is left. */
static sliding by_forces(const levelled *s, const tp_evaluation *e, const arb_t friction) {
  tp_certainty certainty = {0};
  tp_fos fos;
  arb_t degrees;
  arb_init(degrees);
  sliding own = {.starts = tp_loaded_sliding(degrees, &fos, NULL, e->loaded, e, s->run, s->rise,
                                             friction, &certainty)};
  own.angle_deg = arf_get_d(arb_midref(degrees), ARF_RND_NEAR);
  own.has_factor = fos.state == TP_FOS_NUMBER;
  own.factor = fos.value.value;
  arb_clear(degrees);
  return own;
}

static gain gain_of(const tp_case *c, const tp_scene *scene, sliding level) {
  if (scene->tilt_angle_deg.given) {
    const tp_fos own = c->governing_fos.fos;
    const bool unbounded = own.state == TP_FOS_NO_OVERTURNING;
    return (gain){.known = level.has_factor && (unbounded || own.state == TP_FOS_NUMBER),
                  .unbounded = unbounded,
                  .level = level.factor,
                  .drawn = own.value.value};
  }
  const bool unbounded = c->limit.kind == TP_LIMIT_INTERLOCKED;
  return (gain){.known = level.starts && (unbounded || c->limit.kind == TP_LIMIT_AT_ANGLE),
                .unbounded = unbounded,
                .of_angle = true,
                .level = level.angle_deg,
                .drawn = c->limit.critical_angle_deg.value};
}

/* Under the loads of the evaluation. */
static gain find_gain(const levelled *s, const tp_evaluation *e, const tp_case *c) {
  const tp_scene *scene = e->problem->scene;
  arb_t tilt, friction;
  arb_init(tilt);
  arb_init(friction);
  arb_set_fmpq(tilt, scene->tilt_angle_deg.value, e->rung.bits);
  tp_friction_at(friction, e, tilt);
  const sliding level = e->loaded == NULL ? by_weight(s, &scene->tilt_angle_deg, friction)
                                          : by_forces(s, e, friction);
  arb_clear(tilt);
  arb_clear(friction);
  return gain_of(c, scene, level);
}

static tp_status tell(tp_notes *notes, const levelled *s, gain g, const tp_problem *problem,
                      tp_direction towards, tp_message *message) {
  const tp_scene *scene = problem->scene;
  const bool decides = !g.of_angle && g.level < 1 && (g.unbounded || g.drawn >= 1);
  char drawn[64];
  if (g.unbounded) {
    snprintf(drawn, sizeof drawn, "nothing moves it");
  } else {
    snprintf(drawn, sizeof drawn, g.of_angle ? "it holds up to %.3f°" : "%.3f governs", g.drawn);
  }
  return tp_notes_add(
      notes, message, TP_CAUTION, tp_polyline_place(problem->section.rings, -1),
      "towards the %s %s with the sole as it is drawn; with %ld of its facets, on asperities whose "
      "sides are shorter than %.3g %s, half of the contact, levelled into the mean plane it "
      "slides %s %.3f%s: %sthe difference is not real strength if these facets come from "
      "digitising%s%s%s; 'base: {smooth: …}' levels short facets",
      towards == TP_TOWARDS_LEFT ? "left" : "right", drawn, s->count, s->length, scene->length_unit,
      g.of_angle ? "at" : "with a factor of", g.level, g.of_angle ? "°" : "",
      decides ? "roughness decides that it stands; " : "",
      scene->friction_is_basic ? "" : ", or if ",
      scene->friction_is_basic         ? ""
      : scene->friction.load_dependent ? "Barton's law"
                                       : "'friction_angle_deg'",
      scene->friction_is_basic ? "" : " is that of the rough joint ('friction_is: apparent')");
}

static tp_status look(tp_notes *notes, tp_evaluation *e, const tp_case *c, tp_message *message) {
  tp_status status = TP_OK;
  levelled s;
  tp_loaded loaded;
  level(&s, e->problem, c->towards);
  if (s.count >= FEWEST && !s.blocked) {
    if (e->problem->loaded) {
      if (!tp_loaded_init(&loaded, e, c->towards)) status = tp_fail_memory(message, "the loads");
      if (status == TP_OK) e->loaded = &loaded;
    }
    const gain g = status == TP_OK ? find_gain(&s, e, c) : (gain){0};
    if (g.known && (g.unbounded || g.drawn > least_gain * g.level)) {
      status = tell(notes, &s, g, e->problem, c->towards, message);
    }
    if (e->loaded != NULL) tp_loaded_clear(&loaded);
    e->loaded = NULL;
  }
  fmpz_clear(s.run);
  fmpz_clear(s.rise);
  return status;
}

tp_status tp_rough_sole_cautions(tp_notes *notes, const tp_solution *solution,
                                 const tp_problem *problem, tp_message *message) {
  const tp_scene *scene = problem->scene;
  if (!scene->base.mated || scene->block.form != TP_OUTLINE_VERTICES ||
      !scene->friction_angle_deg.given || problem->contact.facet_count < FEWEST) {
    return TP_OK;
  }
  const tp_solve_options options = {.size = sizeof options, .digits = 9};
  tp_status status = TP_OK;
  tp_evaluation e;
  tp_evaluation_init(&e, problem, (tp_rung){TP_LEVEL_DOUBLE, TP_BALL_BITS}, &options);
  tp_friction_stress_when_level(e.weight_per_area_pa, &e);
  tp_friction_tangent_given(e.friction_tangent, &e);
  for (size_t k = 0; k < solution->case_count && status == TP_OK; k++) {
    status = look(notes, &e, solution->cases + k, message);
  }
  tp_evaluation_clear(&e);
  return status;
}
