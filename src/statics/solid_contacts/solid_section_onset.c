/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Three generators g_i of a mode balance a load w where w = sum c_i g_i with c_i >= 0, and by
 * Cramer's rule c_i = det_i / det. Along R + x D the determinants are linear in x; along a divisor,
 * by u = 1 / divisor, which multiplies tan(phi), they are polynomials of degree two at most, as one
 * generator at least is M r. Coefficients are rational, and so are signs. Two generators, with the
 * vector across both as the third, are enough for loads that stay in their plane. */

#include "solid_contacts/solid_section_onset.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEGREES = 3, GENERATORS = 2 + 2 * TP_SOLID_SECTION_CONTACTS };

/* A vector, or a number, as a polynomial in u. */
typedef struct vector {
  fmpq at[DEGREES][3];
} vector;

typedef struct number {
  fmpq at[DEGREES];
} number;

/* An interval of x, and the ray that moves within. */
typedef struct interval {
  double from, to;
  double twist[3];
} interval;

typedef struct onsets {
  const tp_solid_section *s;
  vector generators[GENERATORS];
  int count, ray_count; /* generators of the mode at hand; rays are the first */
  const int *rays;
  vector load[2];           /* R and D */
  vector product, across;   /* room */
  number dets[4], parts[4]; /* det and det_i; of D */
  bool failed;
  long interval_count, interval_room;
  interval *intervals;
} onsets;

/* ---- polynomials -------------------------------------------------------------------------------
 */

static void vector_init(vector *v) {
  for (int k = 0; k < DEGREES; k++) tp_rational3_init(v->at[k]);
}

static void vector_clear(vector *v) {
  for (int k = 0; k < DEGREES; k++) tp_rational3_clear(v->at[k]);
}

static void vector_zero(vector *v) {
  for (int k = 0; k < DEGREES; k++) {
    for (int i = 0; i < 3; i++) fmpq_zero(v->at[k] + i);
  }
}

static void number_init(number *n) {
  for (int k = 0; k < DEGREES; k++) fmpq_init(n->at + k);
}

static void number_clear(number *n) {
  for (int k = 0; k < DEGREES; k++) fmpq_clear(n->at + k);
}

static bool number_is_zero(const number *n) {
  return fmpq_is_zero(n->at) && fmpq_is_zero(n->at + 1) && fmpq_is_zero(n->at + 2);
}

/* Powers above the second vanish where one of the factors has none. */
static void cross(vector *product, const vector *a, const vector *b) {
  vector_zero(product);
  for (int i = 0; i < DEGREES; i++) {
    if (tp_rational3_is_zero(a->at[i])) continue;
    for (int j = 0; i + j < DEGREES; j++) {
      for (int k = 0; k < 3; k++) {
        const int m = (k + 1) % 3, n = (k + 2) % 3;
        fmpq_addmul(product->at[i + j] + k, a->at[i] + m, b->at[j] + n);
        fmpq_submul(product->at[i + j] + k, a->at[i] + n, b->at[j] + m);
      }
    }
  }
}

static void dot(number *product, const vector *a, const vector *b) {
  for (int i = 0; i < DEGREES; i++) fmpq_zero(product->at + i);
  for (int i = 0; i < DEGREES; i++) {
    if (tp_rational3_is_zero(a->at[i])) continue;
    for (int j = 0; i + j < DEGREES; j++) {
      for (int k = 0; k < 3; k++) fmpq_addmul(product->at + i + j, a->at[i] + k, b->at[j] + k);
    }
  }
}

static void evaluate(fmpq_t value, const number *n, const fmpq_t u) {
  fmpq_mul(value, n->at + 2, u);
  fmpq_add(value, value, n->at + 1);
  fmpq_mul(value, value, u);
  fmpq_add(value, value, n->at);
}

/* ---- generators --------------------------------------------------------------------------------
 */

/* -(n + slip u tan(phi) t); with u = 1 where it stays. */
static void set_force(vector *g, const tp_solid_section *s, const tp_solid_section_force *force,
                      bool stays) {
  const tp_solid_section_contact *c = s->contacts + force->contact;
  fmpq_t part;
  fmpq_init(part);
  vector_zero(g);
  for (int k = 0; k < 3; k++) {
    fmpq_mul(part, &c->friction, c->slip + k);
    if (force->slip > 0) fmpq_neg(part, part);
    if (force->slip == 0) fmpq_zero(part);
    fmpq_neg(g->at[0] + k, c->normal + k);
    fmpq_add(g->at[stays ? 0 : 1] + k, g->at[stays ? 0 : 1] + k, part);
  }
  fmpq_clear(part);
}

static void set_generators(onsets *o, const tp_solid_section_mode *mode, bool stays) {
  o->count = 0;
  o->ray_count = mode->ray_count;
  o->rays = mode->rays;
  for (int k = 0; k < mode->ray_count; k++) {
    vector *entry = o->generators + o->count++;
    vector_zero(entry);
    tp_rational3_set(entry->at[0], o->s->rays[mode->rays[k]].wrench);
  }
  for (int k = 0; k < mode->force_count; k++) {
    set_force(o->generators + o->count++, o->s, mode->forces + k, stays);
  }
}

static void set_load(vector *v, const tp_solid_section *s, const tp_hold_load *load) {
  vector_zero(v);
  if (load == NULL) return;
  for (int k = 0; k < 2; k++) tp_rational3_dot(v->at[0] + k, s->along[k], load->exact);
}

/* ---- intervals ---------------------------------------------------------------------------------
 */

static void add_interval(onsets *o, double from, double to, const double twist[3]) {
  if (o->interval_count == o->interval_room) {
    const long room = o->interval_room > 0 ? 2 * o->interval_room : 64;
    interval *entry = realloc(o->intervals, (size_t)room * sizeof *entry);
    o->failed = o->failed || entry == NULL;
    if (entry == NULL) return;
    o->intervals = entry;
    o->interval_room = room;
  }
  interval *entry = o->intervals + o->interval_count++;
  *entry = (interval){.from = from, .to = to};
  memcpy(entry->twist, twist, sizeof entry->twist);
}

/* x between two rationals: from zero on, and perhaps without an upper end. */
typedef struct stretch {
  fmpq_t from, to;
  bool has_to, is_empty;
} stretch;

static void stretch_init(stretch *t) {
  fmpq_init(t->from);
  fmpq_init(t->to);
  t->has_to = t->is_empty = false;
}

static void stretch_clear(stretch *t) {
  fmpq_clear(t->from);
  fmpq_clear(t->to);
}

/* Where constant + x slope >= 0. */
static void cut(stretch *t, const fmpq_t constant, const fmpq_t slope) {
  if (t->is_empty) return;
  if (fmpq_is_zero(slope)) {
    t->is_empty = fmpq_sgn(constant) < 0;
    return;
  }
  fmpq_t root;
  fmpq_init(root);
  fmpq_div(root, constant, slope);
  fmpq_neg(root, root);
  if (fmpq_sgn(slope) > 0) {
    if (fmpq_cmp(root, t->from) > 0) fmpq_set(t->from, root);
  } else if (!t->has_to || fmpq_cmp(root, t->to) < 0) {
    fmpq_set(t->to, root);
    t->has_to = true;
  }
  t->is_empty = t->has_to && fmpq_cmp(t->from, t->to) > 0;
  fmpq_clear(root);
}

static void negate_if(fmpq_t number, bool negative) {
  if (negative) fmpq_neg(number, number);
}

/* Some x within, near the lower end, at which the motion is taken. */
static void middle_of(fmpq_t middle, const stretch *t) {
  fmpq_set(middle, t->from);
  if (t->has_to) {
    fmpq_add(middle, t->from, t->to);
    fmpq_div_2exp(middle, middle, 1);
  } else {
    fmpq_add_si(middle, middle, 1);
  }
}

/* The acceleration at x: sum of c_i r_i, of any length; false where it is none. */
static bool set_twist(double twist[3], onsets *o, const int chosen[3], int chosen_count,
                      const fmpq_t x, const fmpq_t u) {
  fmpq_t entry, det;
  bool moves = false;
  fmpq_init(entry);
  fmpq_init(det);
  evaluate(det, o->dets, u);
  const int sign = fmpq_sgn(det);
  memset(twist, 0, 3 * sizeof *twist);
  for (int i = 0; i < chosen_count; i++) {
    if (chosen[i] >= o->ray_count) continue;
    evaluate(entry, o->parts + 1 + i, u);
    fmpq_mul(entry, entry, x);
    evaluate(det, o->dets + 1 + i, u);
    fmpq_add(entry, entry, det);
    negate_if(entry, sign < 0);
    const double share = fmpq_get_d(entry);
    moves = moves || fmpq_sgn(entry) > 0;
    for (int k = 0; k < 3; k++) {
      twist[k] += share * fmpq_get_d(o->s->rays[o->rays[chosen[i]]].twist + k);
    }
  }
  fmpq_clear(entry);
  fmpq_clear(det);
  return moves;
}

/* Determinants of generators i, j and k, the last of which may be the vector across both. */
static bool set_dets(onsets *o, const int chosen[3], int chosen_count) {
  const vector *g[3];
  for (int i = 0; i < chosen_count; i++) g[i] = o->generators + chosen[i];
  if (chosen_count == 2) {
    cross(&o->across, g[0], g[1]);
    g[2] = &o->across;
  }
  for (int i = 0; i < 3; i++) {
    cross(&o->product, g[(i + 1) % 3], g[(i + 2) % 3]);
    if (i == 0) dot(o->dets, &o->product, g[0]);
    dot(o->dets + 1 + i, &o->product, o->load);
    dot(o->parts + 1 + i, &o->product, o->load + 1);
  }
  return !number_is_zero(o->dets);
}

/* ---- along R + x D -----------------------------------------------------------------------------
 */

static void take_driving(onsets *o, const int chosen[3], int chosen_count) {
  if (!set_dets(o, chosen, chosen_count)) return;
  stretch t;
  fmpq_t constant, slope, one;
  double twist[3];
  stretch_init(&t);
  fmpq_init(constant);
  fmpq_init(slope);
  fmpq_init(one);
  fmpq_one(one);
  const bool negative = fmpq_sgn(o->dets->at) < 0;
  for (int i = 0; i < 3; i++) {
    fmpq_set(constant, o->dets[1 + i].at);
    fmpq_set(slope, o->parts[1 + i].at);
    negate_if(constant, negative);
    negate_if(slope, negative);
    cut(&t, constant, slope);
    if (i < chosen_count) continue;
    fmpq_neg(constant, constant); /* nothing across both */
    fmpq_neg(slope, slope);
    cut(&t, constant, slope);
  }
  if (!t.is_empty) {
    middle_of(slope, &t);
    if (set_twist(twist, o, chosen, chosen_count, slope, one)) {
      add_interval(o, fmpq_get_d(t.from), t.has_to ? fmpq_get_d(t.to) : INFINITY, twist);
    }
  }
  stretch_clear(&t);
  fmpq_clear(constant);
  fmpq_clear(slope);
  fmpq_clear(one);
}

/* ---- along a divisor of strength ---------------------------------------------------------------
 */

/* Roots above zero of a quadratic. */
static int add_roots(double *roots, const number *n) {
  const double a = fmpq_get_d(n->at + 2), b = fmpq_get_d(n->at + 1), c = fmpq_get_d(n->at);
  double found[2];
  int count = 0, kept = 0;
  if (a == 0) {
    if (b != 0) found[count++] = -c / b;
  } else {
    const double square = b * b - 4 * a * c, noise = 64 * DBL_EPSILON * (b * b + fabs(4 * a * c));
    if (square < -noise) return 0;
    const double half = -(b + copysign(sqrt(fmax(0, square)), b)) / 2;
    found[count++] = half / a;
    if (half != 0) found[count++] = c / half;
  }
  for (int k = 0; k < count; k++) {
    if (found[k] > 0 && isfinite(found[k])) roots[kept++] = found[k];
  }
  return kept;
}

static int compare_doubles(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Are all three not negative at u, with a motion? */
static bool holds_at(double twist[3], onsets *o, const int chosen[3], double u) {
  fmpq_t at, entry, none;
  bool holds = true;
  fmpq_init(at);
  fmpq_init(entry);
  fmpq_init(none);
  tp_hold_double(at, u);
  evaluate(entry, o->dets, at);
  const int sign = fmpq_sgn(entry);
  holds = sign != 0;
  for (int i = 0; i < 3 && holds; i++) {
    evaluate(entry, o->dets + 1 + i, at);
    holds = fmpq_sgn(entry) * sign >= 0;
  }
  holds = holds && set_twist(twist, o, chosen, 3, none, at);
  fmpq_clear(at);
  fmpq_clear(entry);
  fmpq_clear(none);
  return holds;
}

/* As a divisor, the inverse of u. */
static void take_strength(onsets *o, const int chosen[3]) {
  enum { ROOTS = 8 };
  double roots[ROOTS + 2] = {0}, twist[3];
  if (!set_dets(o, chosen, 3)) return;
  int count = 1; /* from zero on */
  for (int i = 0; i < 4; i++) count += add_roots(roots + count, o->dets + i);
  qsort(roots, (size_t)count, sizeof *roots, compare_doubles);
  for (int k = 0; k < count; k++) {
    const double to = k + 1 < count ? roots[k + 1] : INFINITY;
    const double middle = isfinite(to) ? roots[k] + (to - roots[k]) / 2 : 2 * roots[k] + 1;
    if (!(middle > roots[k] && middle < to)) continue;
    if (holds_at(twist, o, chosen, middle)) add_interval(o, 1 / to, 1 / roots[k], twist);
  }
}

/* ---- all modes ---------------------------------------------------------------------------------
 */

static void take_mode(onsets *o, bool by_strength) {
  for (int a = 0; a < o->ray_count; a++) {
    for (int b = a + 1; b < o->count; b++) {
      const int pair[3] = {a, b, -1};
      if (!by_strength) take_driving(o, pair, 2);
      for (int c = b + 1; c < o->count; c++) {
        const int chosen[3] = {a, b, c};
        if (by_strength) {
          take_strength(o, chosen);
        } else {
          take_driving(o, chosen, 3);
        }
      }
    }
  }
}

/* It leaves all contacts: a = w / M. */
static void take_open(onsets *o, bool by_strength) {
  stretch t;
  fmpq entry[2][3];
  fmpq_t part[2], middle;
  double twist[3] = {0};
  stretch_init(&t);
  fmpq_init(middle);
  for (int i = 0; i < 2; i++) {
    fmpq_init(part[i]);
    tp_rational3_init(entry[i]);
    for (int k = 0; k < 3; k++) fmpq_div(entry[i] + k, o->load[i].at[0] + k, o->s->mass + k);
  }
  for (int n = 0; n < o->s->count; n++) {
    for (int i = 0; i < 2; i++) tp_rational3_dot(part[i], o->s->contacts[n].normal, entry[i]);
    cut(&t, part[0], part[1]);
  }
  if (!t.is_empty) {
    middle_of(middle, &t);
    for (int k = 0; k < 3; k++) {
      twist[k] = fmpq_get_d(entry[0] + k) + fmpq_get_d(middle) * fmpq_get_d(entry[1] + k);
    }
    if (by_strength) {
      add_interval(o, 0, INFINITY, twist);
    } else {
      add_interval(o, fmpq_get_d(t.from), t.has_to ? fmpq_get_d(t.to) : INFINITY, twist);
    }
  }
  stretch_clear(&t);
  fmpq_clear(middle);
  for (int i = 0; i < 2; i++) {
    fmpq_clear(part[i]);
    tp_rational3_clear(entry[i]);
  }
}

static void onsets_init(onsets *o, const tp_solid_section *s) {
  memset(o, 0, sizeof *o);
  o->s = s;
  for (int k = 0; k < GENERATORS; k++) vector_init(o->generators + k);
  for (int k = 0; k < 2; k++) vector_init(o->load + k);
  vector_init(&o->product);
  vector_init(&o->across);
  for (int k = 0; k < 4; k++) {
    number_init(o->dets + k);
    number_init(o->parts + k);
  }
}

static void onsets_clear(onsets *o) {
  for (int k = 0; k < GENERATORS; k++) vector_clear(o->generators + k);
  for (int k = 0; k < 2; k++) vector_clear(o->load + k);
  vector_clear(&o->product);
  vector_clear(&o->across);
  for (int k = 0; k < 4; k++) {
    number_clear(o->dets + k);
    number_clear(o->parts + k);
  }
  free(o->intervals);
}

/* ---- the onset ---------------------------------------------------------------------------------
 */

/* Ends of intervals are rounded from rationals, or roots. */
static const double near_enough = 1e-12;

static bool reaches(double end, double x) {
  return end >= x - near_enough * (1 + fabs(x));
}

static void set_motion(tp_solid_section_onset *onset, const tp_solid_section *s,
                       const double twist[3]) {
  for (int k = 0; k < 3; k++) {
    onset->twist[k] = 0;
    for (int i = 0; i < 2; i++) {
      onset->twist[k] += twist[i] * fmpq_get_d(s->along[i] + k);
    }
    onset->twist[3 + k] = twist[2] * fmpq_get_d(s->axis + k);
  }
}

/* The interval around `from`, down to its end, by all that reach it. */
static void follow_down(tp_solid_section_onset *onset, const onsets *o, double from, double limit) {
  onset->x = fmin(from, limit);
  for (bool changed = true; changed;) {
    changed = false;
    for (long k = 0; k < o->interval_count; k++) {
      const interval *entry = o->intervals + k;
      if (entry->from >= onset->x || !reaches(entry->to, onset->x)) continue;
      onset->x = entry->from;
      set_motion(onset, o->s, entry->twist);
      changed = true;
    }
  }
}

static void find_above(tp_solid_section_onset *onset, const onsets *o, double from, double limit) {
  onset->x = limit;
  for (long k = 0; k < o->interval_count; k++) {
    const interval *entry = o->intervals + k;
    const double at = fmax(entry->from, from);
    if (entry->to < from || at >= onset->x) continue;
    onset->x = at;
    set_motion(onset, o->s, entry->twist);
  }
  onset->is_endless = isinf(onset->x);
}

static void find_onset(tp_solid_section_onset *onset, const onsets *o, double from, double limit) {
  *onset = (tp_solid_section_onset){.moves_at_from = limit < from};
  for (long k = 0; k < o->interval_count && !onset->moves_at_from; k++) {
    const interval *entry = o->intervals + k;
    onset->moves_at_from =
        entry->to > from && (entry->from < from || from == 0) && entry->from <= from;
    if (onset->moves_at_from) set_motion(onset, o->s, entry->twist);
  }
  if (onset->moves_at_from) {
    follow_down(onset, o, from, limit);
  } else {
    find_above(onset, o, from, limit);
  }
}

static bool find(tp_solid_section_onset *onset, const tp_solid_section *s, const tp_hold_load *rest,
                 const tp_hold_load *way, double from, double limit, bool by_strength) {
  onsets *o = malloc(sizeof *o);
  if (o == NULL) return false;
  onsets_init(o, s);
  set_load(o->load, s, rest);
  set_load(o->load + 1, s, way);
  take_open(o, by_strength);
  for (long k = 0; k < s->mode_count; k++) {
    set_generators(o, s->modes + k, !by_strength);
    take_mode(o, by_strength);
  }
  const bool done = !o->failed;
  if (done) find_onset(onset, o, from, limit);
  onsets_clear(o);
  free(o);
  return done;
}

/* All edges of all forces as one mode without a ray. */
static void set_all_forces(tp_solid_section_mode *mode, const tp_solid_section *s) {
  memset(mode, 0, sizeof *mode);
  for (int k = 0; k < s->count; k++) {
    for (int slip = -1; slip <= 1; slip += 2) {
      mode->forces[mode->force_count++] = (tp_solid_section_force){k, slip};
    }
  }
}

static bool balances(onsets *o, const int chosen[3]) {
  bool holds = set_dets(o, chosen, 3);
  const int sign = fmpq_sgn(o->dets->at);
  for (int i = 0; i < 3 && holds; i++) holds = fmpq_sgn(o->dets[1 + i].at) * sign >= 0;
  return holds;
}

bool tp_solid_section_holds(bool *holds, const tp_solid_section *section,
                            const tp_hold_load *load) {
  onsets *o = malloc(sizeof *o);
  tp_solid_section_mode *mode = malloc(sizeof *mode);
  *holds = false;
  if (o != NULL && mode != NULL) {
    onsets_init(o, section);
    set_load(o->load, section, load);
    set_all_forces(mode, section);
    set_generators(o, mode, true);
    for (int a = 0; a < o->count && !*holds; a++) {
      for (int b = a + 1; b < o->count && !*holds; b++) {
        for (int c = b + 1; c < o->count && !*holds; c++) {
          const int chosen[3] = {a, b, c};
          *holds = balances(o, chosen);
        }
      }
    }
    onsets_clear(o);
  }
  const bool done = o != NULL && mode != NULL;
  free(o);
  free(mode);
  return done;
}

bool tp_solid_section_driving(tp_solid_section_onset *onset, const tp_solid_section *section,
                              const tp_hold_load *rest, const tp_hold_load *way, double from,
                              double limit) {
  return find(onset, section, rest, way, from, limit, false);
}

bool tp_solid_section_strength(tp_solid_section_onset *onset, const tp_solid_section *section,
                               const tp_hold_load *load, double limit) {
  return find(onset, section, load, NULL, 1, limit, true);
}
