/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Moments of random polygons of any scale, place and number of digits, on their lattice at every
 * rung of the ladder: every price holds the exact value, which triangles give in 128 bits before
 * the polygon is scaled and moved. */

#include "block/moments.h"
#include "random_sums.h"
#include "suite.h"

enum { POLYGONS_A_SCENE = 32 };

static uint64_t seed; /* of the polygon in hand */

/* Check writes to a file for each assertion that holds. */
static void claim(bool condition, const char *what, int sum) {
  if (!condition) ck_abort_msg("%s, sum %d: TOPPLE_RANDOM_SEED=%lu", what, sum, (ulong)seed);
}

/* A polygon's axis in scene lengths: scale times the integer, and a move. */
typedef struct axis {
  fmpq_t scale, move;
} axis;

/* Up to 10^30 times, or one of so many, and as many digits. */
static void draw_number(fmpq_t number, random_numbers *state) {
  fmpz_ui_pow_ui(fmpq_numref(number), 10, (ulong)draw_below(state, 31));
  fmpz_ui_pow_ui(fmpq_denref(number), 10, (ulong)draw_below(state, 31));
  fmpz_mul_ui(fmpq_numref(number), fmpq_numref(number), 1 + draw(state) % 1000000);
  fmpz_mul_ui(fmpq_denref(number), fmpq_denref(number), 1 + draw(state) % 100);
  fmpq_canonicalise(number);
}

static void axis_init(axis *a, random_numbers *state) {
  fmpq_init(a->scale);
  fmpq_init(a->move);
  fmpq_one(a->scale);
  if (draw_once_in(state, 2)) draw_number(a->scale, state);
  if (draw_once_in(state, 2)) draw_number(a->move, state);
  if (draw_once_in(state, 2)) fmpq_neg(a->move, a->move);
}

static void axis_clear(axis *a) {
  fmpq_clear(a->scale);
  fmpq_clear(a->move);
}

static void make_line(tp_polyline *line, const polygon *p, const axis *of_x, const axis *of_y) {
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  for (long k = 0; k < p->count; k++) {
    fmpq_mul_si(x, of_x->scale, p->x[k]);
    fmpq_add(x, x, of_x->move);
    fmpq_mul_si(y, of_y->scale, p->y[k]);
    fmpq_add(y, y, of_y->move);
    claim(tp_polyline_append(line, x, y, (tp_mark){0}), "memory", 0);
  }
  fmpq_clear(x);
  fmpq_clear(y);
}

/* x' = a x + p, y' = d y + q: what becomes of the integer polygon on the lattice. */
typedef struct change {
  fmpq_t a, p, d, q;
} change;

static void change_init(change *t, const tp_lattice *l, const axis *of_x, const axis *of_y) {
  fmpq_init(t->a);
  fmpq_init(t->p);
  fmpq_init(t->d);
  fmpq_init(t->q);
  fmpq_div(t->a, of_x->scale, l->step_m);
  fmpq_div(t->p, of_x->move, l->step_m);
  fmpq_sub_fmpz(t->p, t->p, l->origin_x);
  fmpq_div(t->d, of_y->scale, l->step_m);
  fmpq_div(t->q, of_y->move, l->step_m);
  fmpq_sub_fmpz(t->q, t->q, l->origin_y);
}

static void change_clear(change *t) {
  fmpq_clear(t->a);
  fmpq_clear(t->p);
  fmpq_clear(t->d);
  fmpq_clear(t->q);
}

/* result += factor n f g */
static void add_term(fmpq_t result, long factor, const fmpz_t n, const fmpq *f, const fmpq *g) {
  fmpq_t term;
  fmpq_init(term);
  fmpq_mul(term, f, g);
  fmpq_mul_fmpz(term, term, n);
  fmpq_mul_si(term, term, factor);
  fmpq_add(result, result, term);
  fmpq_clear(term);
}

/* The six sums on the lattice, by expansion of the integrals; each times a d. */
static void expected_sums(fmpz expected[TP_SUM_COUNT], const sums *truth, const change *t) {
  fmpz n[TP_SUM_COUNT] = {0};
  fmpq results[TP_SUM_COUNT], one = {1, 1};
  for (int k = 0; k < TP_SUM_COUNT; k++) {
    fmpz_set_wide(n + k, truth->of[k]);
    fmpq_init(results + k);
  }
  add_term(results + TP_A2, 1, n + TP_A2, &one, &one);
  add_term(results + TP_X6, 1, n + TP_X6, t->a, &one);
  add_term(results + TP_X6, 3, n + TP_A2, t->p, &one);
  add_term(results + TP_Y6, 1, n + TP_Y6, t->d, &one);
  add_term(results + TP_Y6, 3, n + TP_A2, t->q, &one);
  add_term(results + TP_XX12, 1, n + TP_XX12, t->a, t->a);
  add_term(results + TP_XX12, 4, n + TP_X6, t->a, t->p);
  add_term(results + TP_XX12, 6, n + TP_A2, t->p, t->p);
  add_term(results + TP_YY12, 1, n + TP_YY12, t->d, t->d);
  add_term(results + TP_YY12, 4, n + TP_Y6, t->d, t->q);
  add_term(results + TP_YY12, 6, n + TP_A2, t->q, t->q);
  add_term(results + TP_XY24, 1, n + TP_XY24, t->a, t->d);
  add_term(results + TP_XY24, 4, n + TP_Y6, t->p, t->d);
  add_term(results + TP_XY24, 4, n + TP_X6, t->a, t->q);
  add_term(results + TP_XY24, 12, n + TP_A2, t->p, t->q);
  for (int k = 0; k < TP_SUM_COUNT; k++) {
    fmpq_mul(results + k, results + k, t->a);
    fmpq_mul(results + k, results + k, t->d);
    claim(fmpz_is_one(fmpq_denref(results + k)), "whole on the lattice", k);
    fmpz_set(expected + k, fmpq_numref(results + k));
    fmpq_clear(results + k);
    fmpz_clear(n + k);
  }
}

/* At every rung the ball holds the truth; balls proper do not grow with their bits, and exact sums
 * have no radius. */
static void claim_rungs(const fmpz expected[TP_SUM_COUNT], const tp_section *section,
                        const tp_lattice *lattice) {
  static const tp_rung rungs[] = {{TP_LEVEL_DOUBLE, 64}, {TP_LEVEL_COMPENSATED, 128},
                                  {TP_LEVEL_BALL, 53},   {TP_LEVEL_BALL, 64},
                                  {TP_LEVEL_BALL, 128},  {TP_LEVEL_BALL, 256},
                                  {TP_LEVEL_BALL, 1024}, {TP_LEVEL_EXACT, 320}};
  const fmpq metre = {1, 1};
  tp_moments now, before;
  tp_moments_init(&now);
  tp_moments_init(&before);
  for (size_t r = 0; r < sizeof rungs / sizeof *rungs; r++) {
    tp_moments_evaluate(&now, section, lattice, &metre, rungs[r], TP_SUM_COUNT);
    const bool nested = r > 0 && rungs[r - 1].level == TP_LEVEL_BALL;
    claim(arb_contains_fmpz(now.area2, expected + TP_A2), "twice the area", 0);
    for (int k = 0; k < TP_SUM_COUNT; k++) {
      const arb_struct *own = now.weighted + k;
      claim(arb_contains_fmpz(own, expected + k), tp_level_name(rungs[r].level), k);
      claim(!nested || mag_cmp(arb_radref(own), arb_radref(before.weighted + k)) <= 0,
            "balls do not grow with their bits", k);
      claim(rungs[r].level != TP_LEVEL_EXACT || arb_is_exact(own), "exact", k);
      arb_set(before.weighted + k, own);
    }
  }
  tp_moments_clear(&now);
  tp_moments_clear(&before);
}

static void claim_polygon(random_numbers *state) {
  const fmpq metre = {1, 1};
  polygon p;
  axis x, y;
  change t;
  tp_lattice lattice;
  tp_polyline line = {0};
  fmpz expected[TP_SUM_COUNT] = {0}, weight = 1;
  const tp_polyline *const chain = &line;
  draw_polygon(&p, state);
  axis_init(&x, state);
  axis_init(&y, state);
  make_line(&line, &p, &x, &y);
  claim(tp_lattice_init(&lattice, &chain, 1, &metre, NULL) == TP_OK, "lattice", 0);
  const tp_section section = {.ring_count = 1, .rings = &line, .ring_weights = &weight};
  const sums truth = polygon_sums(&p);
  change_init(&t, &lattice, &x, &y);
  expected_sums(expected, &truth, &t);
  claim_rungs(expected, &section, &lattice);
  for (int k = 0; k < TP_SUM_COUNT; k++) fmpz_clear(expected + k);
  change_clear(&t);
  tp_lattice_clear(&lattice);
  tp_polyline_clear(&line);
  axis_clear(&x);
  axis_clear(&y);
}

START_TEST(test_moments_of_random_polygons) {
  const uint64_t first = random_seed();
  const long count = random_scenes() * POLYGONS_A_SCENE;
  for (long k = 0; k < count; k++) {
    seed = first + (uint64_t)k;
    random_numbers state = random_numbers_from(seed);
    claim_polygon(&state);
  }
}
END_TEST

SUITE(random_moments) {
  Suite *suite = suite_create("random moments");
  TCase *cases = tcase_create("random moments");
  tcase_set_timeout(cases, 0);
  tcase_add_test(cases, test_moments_of_random_polygons);
  suite_add_tcase(suite, cases);
  return suite;
}
