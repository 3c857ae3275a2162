/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "motion/strength_change.h"

#include "motion/mode_shares.h"
#include "motion/newton.h"
#include "motion/strength.h"
#include "motion/windows.h"
#include "number/ball.h"

#include <math.h>

void tp_strength_change_init(tp_strength_change *change) {
  change->found = change->raised = false;
  change->mechanism = TP_MECHANISM_UNDECIDED;
  arb_init(change->share);
}

void tp_strength_change_clear(tp_strength_change *change) {
  arb_clear(change->share);
}

/* ---- modes in doubles --------------------------------------------------------------------------
 */

/* A linear function of the share in balls, at + share rise. */
typedef struct ball_line {
  tp_vector at, rise;
} ball_line;

/* The modes of a question at its tilt, one after another. */
typedef struct reading {
  const tp_strength_asked *asked;
  tp_vector loads;
  slong length; /* 2^length: about a length of the question, moments over forces */
  ball_line line;
  tp_strength strength;
  tp_motion_outcome outcome;
} reading;

static void set_loads(tp_vector *loads, const tp_strength_asked *a) {
  const tp_wrench *load = &a->question->load;
  const tp_trig *rows[3] = {&load->x, &load->y, &load->moment};
  const long bits = a->question->judge.bits;
  arb_t sine, cosine;
  arb_init(sine);
  arb_init(cosine);
  tp_ball_sin_cos(sine, cosine, a->degrees, bits);
  for (int row = 0; row < 3; row++) {
    tp_trig_evaluate(loads->of + row, rows[row], sine, cosine, bits);
  }
  arb_clear(sine);
  arb_clear(cosine);
}

static void reading_init(reading *r, const tp_strength_asked *a) {
  const double log2_gyration = tp_ball_log2_above(a->question->gyration);
  r->asked = a;
  r->outcome = TP_MOTION_PROVEN;
  r->length = isfinite(log2_gyration) ? (slong)(log2_gyration / 2) : 0;
  tp_vector_init(&r->loads);
  tp_vector_init(&r->line.at);
  tp_vector_init(&r->line.rise);
  tp_strength_init(&r->strength);
  set_loads(&r->loads, a);
}

static void reading_clear(reading *r) {
  tp_vector_clear(&r->loads);
  tp_vector_clear(&r->line.at);
  tp_vector_clear(&r->line.rise);
  tp_strength_clear(&r->strength);
}

/* The least power of two above all entries, moments over the length. */
static double log2_of(const ball_line *line, slong length) {
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

static void set_near(tp_near own[3], const tp_vector *of, slong power, slong length) {
  arb_t scaled;
  arb_init(scaled);
  for (int e = 0; e < 3; e++) {
    arb_mul_2exp_si(scaled, of->of + e, e == 2 ? power - length : power);
    own[e] = arb_is_zero(scaled) ? (tp_near){0, 0} : tp_ball_near(scaled);
  }
  arb_clear(scaled);
}

/* Moments and forces of one size, by powers of two, which round nothing. */
static void set_line(tp_share_line *own, const ball_line *line, slong power, slong length) {
  *own = (tp_share_line){.site = 0};
  set_near(own->at, &line->at, power, length);
  set_near(own->rise, &line->rise, power, length);
}

/* The same with the largest entry about 1, as generators may be. */
static void set_generator(tp_share_line *own, const reading *r, slong length) {
  const double log2_size = log2_of(&r->line, length);
  set_line(own, &r->line, isfinite(log2_size) ? -(slong)log2_size : 0, length);
}

static void clear_line(ball_line *line) {
  for (int e = 0; e < 3; e++) {
    arb_zero(line->at.of + e);
    arb_zero(line->rise.of + e);
  }
}

static void add_ray(tp_share_mode *to, reading *r, long ray) {
  clear_line(&r->line);
  tp_newton_inertia(&r->line.at, r->asked->question, r->asked->motions->twists.rays + ray);
  set_generator(to->of + to->count++, r, r->length);
}

/* Of a force x, y at a point. */
static void set_moment(tp_vector *force, const tp_motion_question *q, long point) {
  const long bits = q->judge.precision;
  arb_t arm;
  arb_init(arm);
  arb_mul(arm, q->cones->x + point, q->scale, bits);
  arb_sub(arm, arm, q->x, bits);
  arb_mul(force->of + 2, arm, force->of + 1, bits);
  arb_mul(arm, q->cones->y + point, q->scale, bits);
  arb_sub(arm, arm, q->y, bits);
  arb_submul(force->of + 2, arm, force->of, bits);
  arb_clear(arm);
}

/* The force n +- t tan(phi) turned round, as tp_newton_force has it. */
static void add_edge(tp_share_mode *to, reading *r, const tp_mode_edge *edge) {
  const tp_motion_question *q = r->asked->question;
  const tp_normals *n = &r->asked->motions->normals;
  const tp_cone_point *point = q->cones->points + edge->point;
  const fmpz *tx = n->tx + edge->point, *ty = n->ty + edge->point;
  arb_srcptr friction = tp_cones_friction(q->cones, edge->point);
  ball_line *line = &r->line;
  clear_line(line);
  arb_set_fmpz(line->at.of, ty);
  arb_set_fmpz(line->at.of + 1, tx);
  arb_neg(line->at.of + 1, line->at.of + 1);
  arb_mul_fmpz(line->rise.of, friction, tx, q->judge.precision);
  arb_mul_fmpz(line->rise.of + 1, friction, ty, q->judge.precision);
  set_moment(&line->at, q, edge->point);
  set_moment(&line->rise, q, edge->point);
  if (!edge->against) tp_vector_neg(&line->rise);
  tp_share_line *own = to->of + to->count++;
  set_generator(own, r, r->length);
  own->site = point->site + 1;
  const long family = n->families[n->family_of[edge->point]].axis;
  own->parallel = 1 + 2 * (family * (q->cones->own_count + 1) + point->own) + edge->against;
}

static void add_vector(tp_share_line *own, reading *r, const tp_vector *of) {
  clear_line(&r->line);
  for (int e = 0; e < 3; e++) arb_set(r->line.at.of + e, of->of + e);
  set_generator(own, r, r->length);
}

/* The loads, and what is free beside them, in one scale. */
static void set_loads_of(tp_share_mode *to, reading *r, bool strong) {
  const tp_strength *s = &r->strength;
  clear_line(&r->line);
  for (int e = 0; e < 3; e++) {
    arb_set(r->line.at.of + e, r->loads.of + e);
    if (strong) arb_set(r->line.rise.of + e, s->fixed.of + e);
  }
  const double log2_size = log2_of(&r->line, r->length);
  const slong power = isfinite(log2_size) ? -(slong)log2_size : 0;
  set_line(&to->loads, &r->line, power, r->length);
  for (long k = 0; strong && !to->interior && k < s->free_count; k++) {
    clear_line(&r->line);
    for (int e = 0; e < 3; e++) arb_set(r->line.rise.of + e, s->free[k].of + e);
    set_line(to->of + to->count + to->free_count++, &r->line, power, r->length);
  }
}

/* What cohesion and bonds do in the mode: false where there is no room for it. */
static bool find_strength(const tp_share_mode *to, reading *r, const tp_motion_mode *mode) {
  const tp_strength_asked *a = r->asked;
  const tp_mode own = {.ray_count = mode->ray_count,
                       .rays = {mode->rays[0], mode->rays[1]},
                       .edge_count = mode->edge_count,
                       .edges = mode->edges};
  tp_strength *s = &r->strength;
  r->outcome = tp_strength_find(s, a->question, &a->motions->normals, &a->motions->twists, &own);
  return r->outcome == TP_MOTION_PROVEN && s->free_count <= TP_SHARE_FREE &&
         to->count + s->pull_count <= TP_SHARE_LINES;
}

static bool add_planes(tp_share_mode *to, reading *r) {
  const tp_motions *m = r->asked->motions;
  for (long k = 0; k < m->twists.face_count; k++) {
    const long normal = m->twists.faces[k].normal;
    if (k > 0 && normal == m->twists.faces[k - 1].normal) continue;
    if (to->count == TP_SHARE_LINES) return false;
    clear_line(&r->line);
    tp_newton_normal(&r->line.at, r->asked->question, &m->normals, normal);
    set_generator(to->of + to->count++, r, -r->length);
  }
  return true;
}

/* A mode at the tilt; false where there is no room for it. */
static bool read_mode(tp_share_mode *to, reading *r, const tp_motion_mode *mode) {
  const bool strong = r->asked->question->strong != NULL;
  to->mechanism = mode->mechanism;
  to->interior = mode->ray_count == 0;
  to->ray_count = mode->ray_count;
  to->count = to->free_count = 0;
  if (to->interior && !add_planes(to, r)) return false;
  if (mode->ray_count + mode->edge_count > TP_SHARE_LINES) return false;
  for (int k = 0; k < mode->ray_count; k++) add_ray(to, r, mode->rays[k]);
  for (long k = 0; k < mode->edge_count; k++) add_edge(to, r, mode->edges + k);
  if (strong && !find_strength(to, r, mode)) return false;
  for (long k = 0; strong && !to->interior && k < r->strength.pull_count; k++) {
    add_vector(to->of + to->count++, r, r->strength.pulls + k);
  }
  set_loads_of(to, r, strong);
  return true;
}

/* ---- search ------------------------------------------------------------------------------------
 */

/* Below the share with which some forces just hold it, none do. */
static bool add_lost(tp_share_spans *spans, const tp_strength_asked *a) {
  if (a->is_held) return true;
  const double share = arf_get_d(arb_midref(a->held), ARF_RND_NEAR);
  return tp_share_spans_put(spans, (tp_share_span){TP_LEAST_SHARE, share, a->lost});
}

/* The spans of all modes; false where one is too large. */
static bool search(tp_share_spans *spans, reading *r) {
  const tp_motions *m = r->asked->motions;
  tp_share_mode mode;
  bool done = add_lost(spans, r->asked), all = true;
  for (long k = 0; k < m->mode_count && done && r->outcome == TP_MOTION_PROVEN; k++) {
    if (read_mode(&mode, r, m->modes + k)) {
      done = tp_share_spans_add(spans, &mode);
    } else {
      all = false;
    }
  }
  if (!done) r->outcome = TP_MOTION_OUT_OF_MEMORY;
  return done && all;
}

/* ---- proofs ------------------------------------------------------------------------------------
 */

/* Can a motion begin with the share? 1, or -1: no; 0 where doubles do not tell. */
static int side_by_doubles(reading *r, const arf_t share) {
  const tp_motions *m = r->asked->motions;
  const double s = arf_get_d(share, ARF_RND_NEAR);
  tp_share_mode mode;
  int any = arf_cmp_d(share, s) == 0 ? -1 : 0;
  if (any == 0) return 0;
  for (long k = 0; k < m->mode_count; k++) {
    const int side = read_mode(&mode, r, m->modes + k) ? tp_share_mode_side(&mode, s) : 0;
    if (side > 0) return 1;
    if (side == 0) any = 0;
  }
  return any;
}

static void scale_cones(tp_cones *cones, const arf_t share, long bits) {
  if (cones == NULL) return;
  arb_mul_arf(cones->friction, cones->friction, share, bits);
  for (long k = 0; k < cones->own_count; k++) {
    arb_mul_arf(cones->own_friction + k, cones->own_friction + k, share, bits);
  }
  for (long k = 0; k < cones->capacity_count; k++) {
    arb_mul_arf(cones->capacities[k].shear, cones->capacities[k].shear, share, bits);
    arb_mul_arf(cones->capacities[k].pull, cones->capacities[k].pull, share, bits);
  }
}

/* The strength of cones as given. */
typedef struct given {
  tp_cones *cones;
  arb_t friction;
  arb_ptr own, bounds;
} given;

static void keep(given *g, tp_cones *cones) {
  g->cones = cones;
  if (cones == NULL) return;
  arb_init(g->friction);
  arb_set(g->friction, cones->friction);
  g->own = _arb_vec_init(cones->own_count);
  _arb_vec_set(g->own, cones->own_friction, cones->own_count);
  g->bounds = _arb_vec_init(2 * cones->capacity_count);
  for (long k = 0; k < cones->capacity_count; k++) {
    arb_set(g->bounds + 2 * k, cones->capacities[k].shear);
    arb_set(g->bounds + 2 * k + 1, cones->capacities[k].pull);
  }
}

static void give_back(given *g) {
  tp_cones *cones = g->cones;
  if (cones == NULL) return;
  arb_swap(cones->friction, g->friction);
  _arb_vec_swap(cones->own_friction, g->own, cones->own_count);
  for (long k = 0; k < cones->capacity_count; k++) {
    arb_swap(cones->capacities[k].shear, g->bounds + 2 * k);
    arb_swap(cones->capacities[k].pull, g->bounds + 2 * k + 1);
  }
  _arb_vec_clear(g->own, cones->own_count);
  _arb_vec_clear(g->bounds, 2 * cones->capacity_count);
  arb_clear(g->friction);
}

static int side_of_spans(const tp_motions *m, const arb_t degrees) {
  int any = -1;
  for (long k = 0; k < m->spans.count; k++) {
    const tp_answer here = tp_tilt_span_holds(m->spans.items + k, degrees);
    if (here == TP_YES) return 1;
    if (here == TP_OPEN) any = 0;
  }
  return any;
}

/* The same by balls, of all modes with the strength so scaled. */
static tp_motion_outcome side_by_balls(int *side, const tp_strength_asked *a, const arf_t share) {
  given own, strong;
  tp_motions motions;
  tp_motion_question q = *a->question;
  q.keeps_all = false;
  q.judge.settled = false; /* a proof takes nothing for zero that only is so to so many bits */
  keep(&own, a->cones);
  keep(&strong, a->strong);
  scale_cones(a->cones, share, q.judge.bits);
  scale_cones(a->strong, share, q.judge.bits);
  const tp_motion_outcome done = tp_motions_init(&motions, &q);
  *side = done == TP_MOTION_PROVEN ? side_of_spans(&motions, a->degrees) : 0;
  if (done == TP_MOTION_PROVEN) tp_motions_clear(&motions);
  give_back(&strong);
  give_back(&own);
  return done;
}

/* Where forces just do not hold it something moves, by a mode or not. */
static bool is_lost(const tp_strength_asked *a, const arf_t share) {
  arb_t own;
  if (a->is_held) return false;
  arb_init(own);
  arb_set_arf(own, share);
  const bool lost = arb_lt(own, a->held) != 0;
  arb_clear(own);
  return lost;
}

static tp_motion_outcome side_of(int *side, reading *r, const arf_t share) {
  *side = is_lost(r->asked, share) ? 1 : side_by_doubles(r, share);
  if (*side != 0 || r->outcome == TP_MOTION_OUT_OF_MEMORY) return r->outcome;
  return side_by_balls(side, r->asked, share);
}

/* The sides of a share within 2^-wanted of it: do they differ? */
static tp_motion_outcome try_about(bool *proven, reading *r, arb_t share, const arf_t about,
                                   slong wanted) {
  const long bits = r->asked->question->judge.bits;
  arf_t width, end;
  int below = 0, above = 0;
  arf_init(width);
  arf_init(end);
  arf_mul_2exp_si(width, about, -wanted);
  arf_sub(end, about, width, bits, ARF_RND_DOWN);
  tp_motion_outcome done = side_of(&below, r, end);
  if (done == TP_MOTION_PROVEN && below != 0) {
    arf_add(end, about, width, bits, ARF_RND_UP);
    done = side_of(&above, r, end);
  }
  *proven = done == TP_MOTION_PROVEN && below * above < 0;
  if (*proven) {
    arb_set_arf(share, about);
    arf_mul_2exp_si(width, width, 1); /* the rounded ends lie within */
    arf_get_mag(arb_radref(share), width);
  }
  arf_clear(width);
  arf_clear(end);
  return done;
}

/* Halve between shares on different sides, 2^-bracket about it, to 2^-wanted. */
static tp_motion_outcome refine(arf_t about, reading *r, slong bracket, slong wanted) {
  const long bits = r->asked->question->judge.bits;
  arf_t low, high, width;
  int below = 0, side = 1;
  arf_init(low);
  arf_init(high);
  arf_init(width);
  arf_mul_2exp_si(width, about, -bracket);
  arf_sub(low, about, width, bits, ARF_RND_DOWN);
  arf_add(high, about, width, bits, ARF_RND_UP);
  tp_motion_outcome done = side_of(&below, r, low);
  for (; bracket < wanted && done == TP_MOTION_PROVEN && side != 0; bracket++) {
    arf_add(about, low, high, bits, ARF_RND_NEAR);
    arf_mul_2exp_si(about, about, -1);
    done = side_of(&side, r, about);
    if (side != 0) arf_set(side == below ? low : high, about);
  }
  arf_add(about, low, high, bits, ARF_RND_NEAR);
  arf_mul_2exp_si(about, about, -1);
  arf_clear(low);
  arf_clear(high);
  arf_clear(width);
  return done;
}

/* From what doubles tell apart to what is asked for; what that lacks is halved. */
static tp_motion_outcome enclose(bool *proven, reading *r, arb_t share, double estimate) {
  enum { NARROWEST = 43, STEP = 4, SPARE = 4 }; /* 2^-43 is about 10^-13 */
  const slong asked = (slong)tp_digits_bits(r->asked->digits + 1) + 1;
  tp_motion_outcome done = TP_MOTION_PROVEN;
  arf_t about;
  arf_init(about);
  arf_set_d(about, estimate);
  slong wanted = NARROWEST;
  *proven = false;
  for (; wanted > STEP && done == TP_MOTION_PROVEN && !*proven; wanted -= STEP) {
    done = try_about(proven, r, share, about, wanted);
  }
  wanted += STEP;
  if (done == TP_MOTION_PROVEN && *proven && wanted < asked) {
    done = refine(about, r, wanted, asked + SPARE);
    if (done == TP_MOTION_PROVEN) done = try_about(proven, r, share, about, asked);
  }
  arf_clear(about);
  return done;
}

/* What does not change stays so at the ends of what is tried, unless these prove otherwise. */
static bool is_throughout(reading *r) {
  static const double ends[] = {TP_LEAST_SHARE, TP_MOST_SHARE};
  const int other = r->asked->can_begin ? -1 : 1;
  bool same = true;
  arf_t share;
  arf_init(share);
  for (int k = 0; k < 2 && same; k++) {
    arf_set_d(share, ends[k]);
    same = side_by_doubles(r, share) != other;
  }
  arf_clear(share);
  return same;
}

tp_motion_outcome tp_strength_change_find(tp_strength_change *change,
                                          const tp_strength_asked *asked) {
  reading r;
  tp_share_spans spans = {.count = 0};
  change->found = false;
  if (asked->all_is_lost) return TP_MOTION_PROVEN;
  reading_init(&r, asked);
  bool proven = search(&spans, &r);
  const tp_share_change found = tp_share_spans_change(&spans, asked->can_begin);
  tp_motion_outcome done = r.outcome;
  if (done == TP_MOTION_PROVEN && proven && !found.found) proven = is_throughout(&r);
  if (done == TP_MOTION_PROVEN && found.found) {
    done = enclose(&proven, &r, change->share, found.share);
    change->found = proven;
    change->raised = found.share > 1;
    change->mechanism = found.mechanism;
  }
  tp_share_spans_clear(&spans);
  reading_clear(&r);
  return done == TP_MOTION_PROVEN && !proven ? TP_MOTION_OPEN : done;
}
