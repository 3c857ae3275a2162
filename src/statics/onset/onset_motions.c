/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Every mode possible at the scene's tilt with its accelerations, centre, contact states and
 * forces, converted to the scene's units (docs/mechanics.md section 6a). */

#include "onset/onset_motions.h"

#include "evaluation/loaded.h"
#include "motion/accelerations.h"
#include "motion/closed.h"
#include "motion/newton.h"
#include "number/ball.h"

#include <math.h>
#include <stdlib.h>

/* The weight under loads, N. */
static void set_weight(arb_t weight, const tp_onset_telling *t) {
  arb_neg(weight, t->e->loaded->items[0].wrench.y.of + TP_COS);
}

/* The loads at the tilt, over the weight. */
static void set_loads(tp_vector *loads, const tp_onset_telling *t, const arb_t tilt) {
  const long bits = t->e->rung.bits;
  const tp_wrench *load = &t->question->load;
  arb_t sine, cosine;
  arb_init(sine);
  arb_init(cosine);
  tp_ball_sin_cos(sine, cosine, tilt, bits);
  tp_trig_evaluate(loads->of, &load->x, sine, cosine, bits);
  tp_trig_evaluate(loads->of + 1, &load->y, sine, cosine, bits);
  tp_trig_evaluate(loads->of + 2, &load->moment, sine, cosine, bits);
  if (t->e->loaded != NULL) {
    arb_t weight;
    arb_init(weight);
    set_weight(weight, t);
    for (int k = 0; k < 3; k++) arb_div(loads->of + k, loads->of + k, weight, bits);
    arb_clear(weight);
  }
  arb_clear(sine);
  arb_clear(cosine);
}

/* What goes along x and y, to the scene's x. */
static void set_components(tp_bounded *x, tp_bounded *y, const tp_onset_telling *t,
                           const tp_vector *of) {
  arb_t own;
  arb_init(own);
  arb_set(own, of->of);
  tp_ball_mirror(own, t->result->towards);
  *x = tp_result_within(t->e, own, 0, t->certainty);
  *y = tp_result_within(t->e, of->of + 1, 0, t->certainty);
  arb_clear(own);
}

/* What turns, over or times the question's unit of length, to metres and the scene's sense. */
static tp_bounded turning(const tp_onset_telling *t, const arb_t of, bool over_length) {
  const tp_evaluation *e = t->e;
  const tp_lattice *l = &e->problem->lattice;
  const double log2_size = e->log2_extent;
  arb_t own, unit;
  arb_init(own);
  arb_init(unit);
  arb_set_fmpq(unit, l->step_m, e->rung.bits);
  if (over_length) {
    arb_mul(own, of, t->question->scale, e->rung.bits);
    arb_div(own, own, unit, e->rung.bits);
  } else {
    arb_mul(own, of, unit, e->rung.bits);
    arb_div(own, own, t->question->scale, e->rung.bits);
  }
  tp_ball_mirror(own, t->result->towards);
  const tp_bounded result =
      tp_result_within(e, own, over_length ? -log2_size : log2_size, t->certainty);
  arb_clear(own);
  arb_clear(unit);
  return result;
}

static void set_accelerations(tp_motion *motion, const tp_onset_telling *t, const tp_start *start) {
  set_components(&motion->acceleration_x_g, &motion->acceleration_y_g, t, &start->acceleration);
  motion->angular_g_per_m = turning(t, start->acceleration.of + 2, true);
  motion->has_centre = !arb_contains_zero(start->twist.of + 2);
  if (motion->has_centre) {
    tp_onset_centre(&motion->centre_x_m, &motion->centre_y_m, t, &start->twist);
  }
}

/* Does the point stay closed in all of the mode? 1, 0, or 2 where open. */
static int is_closed(const tp_motions *m, const tp_motion_mode *mode, long point) {
  const tp_normal *line = m->normals.items + m->normals.normal_of[point];
  for (int k = 0; k < mode->ray_count; k++) {
    const tp_ray *ray = m->twists.rays + mode->rays[k];
    const int sign = tp_normal_sign(&m->normals, line, &ray->twist, ray->near, ray->site);
    if (sign != 0) return sign == TP_OPEN_SIGN ? TP_OPEN_SIGN : 0;
  }
  return mode->ray_count > 0;
}

static int slip_of(const tp_motions *m, const tp_motion_mode *mode, long point) {
  int slip = 0;
  for (int k = 0; k < mode->ray_count && slip == 0; k++) {
    slip = tp_closed_slip(&m->normals, point, m->twists.rays + mode->rays[k]);
  }
  return slip;
}

static tp_contact_state state_of(const tp_motions *m, const tp_motion_mode *mode, long point) {
  const int slip = slip_of(m, mode, point);
  return slip == 0  ? TP_CONTACT_STICKS
         : slip > 0 ? TP_CONTACT_SLIPS_UP_DIP
                    : TP_CONTACT_SLIPS_DOWN_DIP;
}

/* A mode at the scene's tilt. */
typedef struct telling {
  const tp_onset_telling *t;
  const tp_motion_mode *mode;
  const tp_strength *strength; /* or NULL */
  const tp_start *start;
} telling;

/* The sum of the mode's forces at a contact, where these are fixed. */
static void set_share(tp_motion_contact *own, const telling *m, long point) {
  const tp_onset_telling *t = m->t;
  const tp_motion_mode *mode = m->mode;
  const tp_start *start = m->start;
  const long bits = t->e->rung.bits;
  tp_vector edge, sum;
  tp_vector_init(&edge);
  tp_vector_init(&sum);
  for (int row = 0; row < 2 && start->one_point; row++) {
    arb_set(sum.of + row, start->sum.of + row);
  }
  const long pulls = m->strength != NULL ? m->strength->pull_count : 0;
  for (long k = 0; k < pulls; k++) {
    if (m->strength->pulled[k] != point) continue;
    const arb_struct *factor = start->forces + mode->edge_count + k;
    for (int row = 0; row < 2; row++) {
      arb_submul(sum.of + row, m->strength->pulls[k].of + row, factor, bits);
    }
  }
  for (long k = 0; k < mode->edge_count; k++) {
    if (mode->edges[k].point != point) continue;
    tp_newton_force(&edge, t->question, &t->motions->normals, mode->edges + k);
    for (int row = 0; row < 2; row++) {
      arb_submul(sum.of + row, edge.of + row, start->forces + k, bits);
    }
  }
  tp_ball_mirror(sum.of, t->result->towards);
  own->share_x = tp_result_within(t->e, sum.of, 0, t->certainty);
  own->share_y = tp_result_within(t->e, sum.of + 1, 0, t->certainty);
  tp_vector_clear(&edge);
  tp_vector_clear(&sum);
}

/* Is every contact that stays closed one whose forces the mode is made of? */
static bool has_all(const telling *t, const tp_motion *motion, const long *points) {
  const tp_motion_mode *mode = t->mode;
  if (t->start->one_point) return motion->contact_count == 1;
  if (!t->start->forces_fixed) return false;
  for (size_t k = 0; k < motion->contact_count; k++) {
    bool found = false;
    for (long e = 0; e < mode->edge_count && !found; e++) {
      found = mode->edges[e].point == points[k];
    }
    if (!found) return false;
  }
  return true;
}

static tp_motion_outcome set_contacts(tp_motion *motion, const telling *told) {
  const tp_onset_telling *t = told->t;
  const tp_motion_mode *mode = told->mode;
  const tp_cones *cones = t->question->cones;
  long *points = calloc((size_t)cones->count + 1, sizeof *points);
  tp_motion_outcome done = points != NULL ? TP_MOTION_PROVEN : TP_MOTION_OUT_OF_MEMORY;
  for (long k = 0; k < cones->count && done == TP_MOTION_PROVEN; k++) {
    const int closed = is_closed(t->motions, mode, k);
    if (closed == TP_OPEN_SIGN) done = TP_MOTION_OPEN;
    if (closed != 1) continue;
    const bool bears = tp_cones_bears(cones, k, slip_of(t->motions, mode, k));
    if (bears) points[motion->contact_count++] = k;
  }
  if (done == TP_MOTION_PROVEN) {
    motion->contacts = calloc(motion->contact_count + 1, sizeof *motion->contacts);
    if (motion->contacts == NULL) done = TP_MOTION_OUT_OF_MEMORY;
  }
  const bool has_forces = done == TP_MOTION_PROVEN && has_all(told, motion, points);
  for (size_t k = 0; k < motion->contact_count && done == TP_MOTION_PROVEN; k++) {
    const long point = points[k], facet = cones->points[point].facet;
    tp_motion_contact *own = motion->contacts + k;
    own->of_facet = facet >= 0;
    own->facet = facet >= 0 ? (size_t)facet : 0;
    own->at_right_end = facet >= 0 && point > 0 && cones->points[point - 1].facet == facet;
    own->has_pivot = cones->points[point].site < t->e->problem->contact.point_count;
    own->pivot = own->has_pivot ? (size_t)cones->points[point].site : 0;
    own->state = state_of(t->motions, mode, point);
    own->has_force = has_forces;
    if (has_forces) set_share(own, told, point);
  }
  free(points);
  return done;
}

/* A force over the weight with its moment about the centroid. */
static tp_motion_resistance resistance(const tp_onset_telling *t, const tp_vector *force) {
  tp_motion_resistance r;
  set_components(&r.share_x, &r.share_y, t, force);
  r.moment_m = turning(t, force->of + 2, false);
  return r;
}

static void set_resistance(tp_motion *motion, const telling *m) {
  motion->has_strength = m->strength != NULL;
  if (!motion->has_strength) return;
  motion->cohesion = resistance(m->t, &m->strength->cohesion);
  motion->bond = resistance(m->t, &m->strength->bond);
}

/* What cohesion and bonds do in the mode, over the weight. */
static tp_motion_outcome find_strength(tp_strength *strength, const tp_onset_telling *t,
                                       const tp_motion_mode *mode) {
  const tp_mode own = {.ray_count = mode->ray_count,
                       .rays = {mode->rays[0], mode->rays[1]},
                       .edge_count = mode->edge_count,
                       .edges = mode->edges};
  const tp_motion_outcome done =
      tp_strength_find(strength, t->question, &t->motions->normals, &t->motions->twists, &own);
  arb_t weight;
  arb_init(weight);
  set_weight(weight, t);
  tp_strength_divide(strength, weight, t->e->rung.bits);
  arb_clear(weight);
  return done;
}

static tp_motion_outcome add_motion(const tp_onset_telling *t, const tp_motion_mode *mode,
                                    const tp_vector *loads) {
  tp_onset *onset = &t->result->onset;
  const bool strong = t->question->strong != NULL;
  tp_start start;
  tp_strength strength;
  tp_start_init(&start, mode);
  tp_strength_init(&strength);
  const telling told = {t, mode, strong ? &strength : NULL, &start};
  tp_motion_outcome done = strong ? find_strength(&strength, t, mode) : TP_MOTION_PROVEN;
  if (done == TP_MOTION_PROVEN) {
    done = tp_start_find(&start, t->question, t->motions, mode, loads, told.strength);
  }
  if (done == TP_MOTION_PROVEN && start.moves) {
    tp_motion *own = onset->motions + onset->motion_count++;
    own->mechanism = mode->mechanism;
    own->accelerations_fixed = start.fixed;
    own->greatest = start.greatest;
    set_accelerations(own, t, &start);
    set_resistance(own, &told);
    onset->paradox = onset->paradox || start.paradox;
    done = set_contacts(own, &told);
  }
  tp_strength_clear(&strength);
  tp_start_clear(&start);
  return done;
}

/* Is the tilt in one of the mode's spans? Those of a mode stand together, in the order of modes;
 * `next` is where they begin, and then where those of the next mode do. */
static tp_answer holds(const tp_motions *m, long mode, long *next, const arb_t tilt) {
  tp_answer answer = TP_NO;
  for (; *next < m->spans.count && m->spans.items[*next].mode == mode; (*next)++) {
    if (answer == TP_YES) continue;
    const tp_answer here = tp_tilt_span_holds(m->spans.items + *next, tilt);
    if (here != TP_NO) answer = here;
  }
  return answer;
}

/* Each mechanism once. */
static void set_beginnings(tp_onset *onset) {
  onset->beginning_count = 0;
  for (int m = TP_SLIDES; m <= TP_LEAVES_BASE; m++) {
    bool found = false;
    for (size_t k = 0; k < onset->motion_count; k++) {
      found = found || (int)onset->motions[k].mechanism == m;
    }
    if (found) onset->beginnings[onset->beginning_count++] = (tp_mechanism)m;
  }
}

tp_motion_outcome tp_onset_motions(const tp_onset_telling *t, const arb_t tilt, bool may_move) {
  tp_onset *onset = &t->result->onset;
  const tp_motions *m = t->motions;
  onset->motions = calloc((size_t)m->mode_count + 1, sizeof *onset->motions);
  if (onset->motions == NULL) return TP_MOTION_OUT_OF_MEMORY;
  onset->has_motions = !may_move;
  if (!may_move) return TP_MOTION_PROVEN;
  tp_vector loads;
  tp_vector_init(&loads);
  set_loads(&loads, t, tilt);
  tp_motion_outcome done = TP_MOTION_PROVEN;
  long span = 0;
  for (long k = 0; k < m->mode_count && done == TP_MOTION_PROVEN; k++) {
    const tp_answer here = holds(m, k, &span, tilt);
    if (here == TP_OPEN) done = TP_MOTION_OPEN;
    if (here == TP_YES) done = add_motion(t, m->modes + k, &loads);
  }
  onset->has_motions = done == TP_MOTION_PROVEN;
  if (onset->has_motions) set_beginnings(onset);
  tp_vector_clear(&loads);
  return done;
}
