/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Generators and loads of each mode at one tilt as linear functions of the strength share, scaled
 * by powers of two to size one. */

#include "motion/mode_reading.h"

#include "motion/newton.h"
#include "number/ball.h"

#include <math.h>
#include <stdlib.h>

enum { BALLS = TP_SHARE_LINES + TP_SHARE_FREE + 2 }; /* the last two: of loads, and their sum */

static void set_loads(tp_vector *loads, const tp_motion_question *q, const arb_t degrees) {
  const tp_wrench *load = &q->load;
  const tp_trig *rows[3] = {&load->x, &load->y, &load->moment};
  const long bits = q->judge.bits;
  arb_t sine, cosine;
  arb_init(sine);
  arb_init(cosine);
  tp_ball_sin_cos(sine, cosine, degrees, bits);
  for (int row = 0; row < 3; row++) {
    tp_trig_evaluate(loads->of + row, rows[row], sine, cosine, bits);
  }
  arb_clear(sine);
  arb_clear(cosine);
}

void tp_mode_reading_init(tp_mode_reading *r, const tp_motion_question *q, const tp_motions *m,
                          const arb_t degrees) {
  const double log2_gyration = tp_ball_log2_above(q->gyration);
  r->question = q;
  r->motions = m;
  r->outcome = TP_MOTION_PROVEN;
  r->length = isfinite(log2_gyration) ? (slong)(log2_gyration / 2) : 0;
  tp_vector_init(&r->loads);
  r->keeps_balls = false;
  r->planes = NULL;
  tp_vector_init(&r->line.at);
  tp_vector_init(&r->line.rise);
  for (int k = 0; k < BALLS; k++) {
    tp_vector_init(&r->balls[k].at);
    tp_vector_init(&r->balls[k].rise);
  }
  tp_strength_init(&r->strength);
  set_loads(&r->loads, q, degrees);
}

void tp_mode_reading_clear(tp_mode_reading *r) {
  free(r->planes);
  tp_vector_clear(&r->loads);
  tp_vector_clear(&r->line.at);
  tp_vector_clear(&r->line.rise);
  for (int k = 0; k < BALLS; k++) {
    tp_vector_clear(&r->balls[k].at);
    tp_vector_clear(&r->balls[k].rise);
  }
  tp_strength_clear(&r->strength);
}

/* The least power of two above all entries, moments over the length. */
static double log2_of(const tp_ball_line *line, slong length) {
  double most = -INFINITY;
  for (int e = 0; e < 3; e++) {
    const double less = e == 2 ? (double)length : 0;
    most = fmax(most, tp_ball_log2_above(line->at.of + e) - less);
    if (!arb_is_zero(line->rise.of + e)) {
      most = fmax(most, tp_ball_log2_above(line->rise.of + e) - less);
    }
  }
  return most;
}

static void scale_vector(tp_vector *own, const tp_vector *of, slong power, slong length) {
  for (int e = 0; e < 3; e++) {
    arb_mul_2exp_si(own->of + e, of->of + e, e == 2 ? power - length : power);
  }
}

static void set_near(tp_near own[3], const tp_vector *of) {
  for (int e = 0; e < 3; e++) {
    own[e] = arb_is_zero(of->of + e) ? (tp_near){0, 0} : tp_ball_near(of->of + e);
  }
}

/* Moments and forces of one size, by powers of two, which round nothing; the place of its balls. */
static void set_line(tp_share_line *own, tp_mode_reading *r, int place, slong power, slong length) {
  tp_ball_line *balls = r->balls + place;
  *own = (tp_share_line){.balls = r->keeps_balls ? balls : NULL};
  scale_vector(&balls->at, &r->line.at, power, length);
  scale_vector(&balls->rise, &r->line.rise, power, length);
  set_near(own->at, &balls->at);
  set_near(own->rise, &balls->rise);
}

/* With its largest entry about 1, as generators and planes may be. */
static void set_scaled(tp_share_line *own, tp_mode_reading *r, int place, slong length) {
  const double log2_size = log2_of(&r->line, length);
  set_line(own, r, place, isfinite(log2_size) ? -(slong)log2_size : 0, length);
}

/* The next of the mode. */
static tp_share_line *add_generator(tp_share_mode *to, tp_mode_reading *r) {
  tp_share_line *own = to->own + to->count;
  to->of[to->count] = own;
  set_scaled(own, r, to->count++, r->length);
  return own;
}

static void clear_line(tp_ball_line *line) {
  for (int e = 0; e < 3; e++) {
    arb_zero(line->at.of + e);
    arb_zero(line->rise.of + e);
  }
}

static void add_ray(tp_share_mode *to, tp_mode_reading *r, long ray) {
  clear_line(&r->line);
  tp_newton_inertia(&r->line.at, r->question, r->motions->twists.rays + ray);
  (void)add_generator(to, r);
}

/* The force n +- t tan(phi) turned round, as tp_newton_force has it. */
static void add_edge(tp_share_mode *to, tp_mode_reading *r, const tp_cone_edge *edge) {
  const tp_motion_question *q = r->question;
  const tp_normals *n = &r->motions->normals;
  const tp_cone_point *point = q->cones->points + edge->point;
  const fmpz *tx = tp_normals_tx(n, edge->point), *ty = tp_normals_ty(n, edge->point);
  arb_srcptr friction = tp_cones_friction(q->cones, edge->point);
  tp_ball_line *line = &r->line;
  clear_line(line);
  arb_set_fmpz(line->at.of, ty);
  arb_set_fmpz(line->at.of + 1, tx);
  arb_neg(line->at.of + 1, line->at.of + 1);
  arb_mul_fmpz(line->rise.of, friction, tx, q->judge.precision);
  arb_mul_fmpz(line->rise.of + 1, friction, ty, q->judge.precision);
  const arb_struct x = tp_cones_x(q->cones, edge->point), y = tp_cones_y(q->cones, edge->point);
  tp_newton_moment(&line->at, q, &x, &y, q->judge.precision);
  tp_newton_moment(&line->rise, q, &x, &y, q->judge.precision);
  if (!edge->against) tp_vector_neg(&line->rise);
  tp_share_line *own = add_generator(to, r);
  own->site = point->site + 1;
  const long family = n->families[n->family_of[edge->point]].axis;
  const long kind = tp_cones_own(q->cones, edge->point);
  own->parallel = 1 + 2 * (family * (q->cones->own_count + 1) + kind) + edge->against;
}

static void add_vector(tp_share_mode *to, tp_mode_reading *r, const tp_vector *of) {
  clear_line(&r->line);
  for (int e = 0; e < 3; e++) arb_set(r->line.at.of + e, of->of + e);
  (void)add_generator(to, r);
}

/* The loads, and what is free beside them, in one scale. */
static void set_loads_of(tp_share_mode *to, tp_mode_reading *r, bool strong) {
  const tp_strength *s = &r->strength;
  clear_line(&r->line);
  for (int e = 0; e < 3; e++) {
    arb_set(r->line.at.of + e, r->loads.of + e);
    if (strong) arb_set(r->line.rise.of + e, s->fixed.of + e);
  }
  const double log2_size = log2_of(&r->line, r->length);
  const slong power = isfinite(log2_size) ? -(slong)log2_size : 0;
  set_line(&to->loads, r, BALLS - 2, power, r->length);
  for (long k = 0; strong && !to->interior && k < s->free_count; k++) {
    clear_line(&r->line);
    for (int e = 0; e < 3; e++) arb_set(r->line.rise.of + e, s->free[k].of + e);
    const int place = to->count + to->free_count++;
    to->of[place] = to->own + place;
    set_line(to->own + place, r, place, power, r->length);
  }
}

/* What cohesion and bonds do in the mode: false where there is no room for it. */
static bool find_strength(const tp_share_mode *to, tp_mode_reading *r, const tp_motion_mode *mode) {
  const tp_mode own = {.ray_count = mode->ray_count,
                       .rays = {mode->rays[0], mode->rays[1]},
                       .edge_count = mode->edge_count,
                       .edges = mode->edges};
  tp_strength *s = &r->strength;
  r->outcome = tp_strength_find(s, r->question, &r->motions->normals, &r->motions->twists, &own);
  return r->outcome == TP_MOTION_PROVEN && s->free_count <= TP_SHARE_FREE &&
         to->count + s->pull_count <= TP_SHARE_LINES;
}

/* A rough base has dozens of planes, a vault as many as facets. */
static bool add_planes(tp_share_mode *to, tp_mode_reading *r) {
  const tp_motions *m = r->motions;
  if (r->planes == NULL) r->planes = malloc((size_t)(m->twists.face_count + 1) * sizeof *r->planes);
  if (r->planes == NULL) {
    r->outcome = TP_MOTION_OUT_OF_MEMORY;
    return false;
  }
  to->planes = r->planes;
  for (long k = 0; k < m->twists.face_count; k++) {
    const long normal = m->twists.faces[k].normal;
    if (k > 0 && normal == m->twists.faces[k - 1].normal) continue;
    clear_line(&r->line);
    tp_newton_normal(&r->line.at, r->question, &m->normals, normal);
    set_scaled(r->planes + to->plane_count++, r, 0, -r->length);
  }
  return true;
}

bool tp_mode_read(tp_share_mode *to, tp_mode_reading *r, const tp_motion_mode *mode) {
  const bool strong = r->question->strong != NULL;
  to->mechanism = mode->mechanism;
  to->interior = mode->ray_count == 0;
  to->ray_count = mode->ray_count;
  to->count = to->free_count = 0;
  to->plane_count = 0;
  to->sum = r->keeps_balls ? r->balls + BALLS - 1 : NULL;
  to->bits = r->question->judge.precision;
  if (to->interior && !add_planes(to, r)) return false;
  if (mode->ray_count + mode->edge_count > TP_SHARE_LINES) return false;
  for (int k = 0; k < mode->ray_count; k++) add_ray(to, r, mode->rays[k]);
  for (long k = 0; k < mode->edge_count; k++) add_edge(to, r, mode->edges + k);
  if (strong && !find_strength(to, r, mode)) return false;
  for (long k = 0; strong && !to->interior && k < r->strength.pull_count; k++) {
    add_vector(to, r, r->strength.pulls + k);
  }
  set_loads_of(to, r, strong);
  return true;
}
