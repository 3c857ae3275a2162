/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Area, centroid, second moments about the centroid and weight of the block from the sums of
 * docs/mechanics.md section 2, each as a number with its bound relative to the size of the
 * block. */

#include "evaluation/stages.h"

#include "number/ball.h"

/* Of the least that the ball's size may be. */
static double log2_of(const arb_t ball) {
  mag_t size;
  mag_init(size);
  arb_get_mag_lower(size, ball);
  const double log2_value = tp_mag_log2(size);
  mag_clear(size);
  return log2_value;
}

/* Of the block's size in metres, the root of its area: on symmetric blocks a coordinate of the
 * centroid is zero, which is not known to any share of itself but exactly. */
static double log2_size(const tp_evaluation *e) {
  arb_t area;
  arb_init(area);
  arb_mul_2exp_si(area, e->moments.area2, -1);
  tp_evaluation_to_metres(area, e, 2);
  const double size = log2_of(area) / 2;
  arb_clear(area);
  return size;
}

/* Coordinate of the centroid in metres: S6 / (3 A2), moved back by the local origin. */
static void centroid(arb_t value, const tp_evaluation *e, const arb_t first_moment,
                     const fmpz_t origin) {
  const long bits = e->rung.bits, exact = tp_evaluation_bits(e);
  /* (S6 + 3 A2 origin) / (3 A2): exact zeros stay exact */
  arb_mul_fmpz(value, e->moments.weighted + TP_A2, origin, exact);
  arb_mul_ui(value, value, 3, exact);
  arb_add(value, value, first_moment, exact);
  arb_div(value, value, e->moments.weighted + TP_A2, bits);
  arb_div_ui(value, value, 3, bits);
  tp_evaluation_to_metres(value, e, 1);
}

static void set_centroid(const tp_evaluation *e, tp_block_result *block, tp_certainty *certainty) {
  const tp_lattice *l = &e->problem->lattice;
  const arb_struct *sums = e->moments.weighted;
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  centroid(x, e, sums + TP_X6, l->origin_x);
  centroid(y, e, sums + TP_Y6, l->origin_y);
  tp_result_place(&block->centroid_x_m, &block->centroid_y_m, e, x, y, log2_size(e), certainty);
  arb_clear(x);
  arb_clear(y);
}

/* (M / m - f g / (18 A2)) area2 / A2, the moment about the centroid weighted by the relative
 * density; M / m the second moment about the origin, f and g first moments times six. As a single
 * fraction over 72 A2^2 it cancels exactly on exact rungs. */
static void second_moment(arb_t value, const tp_evaluation *e, const arb_t second, unsigned long m,
                          const arb_t first, const arb_t other) {
  const long bits = e->rung.bits, exact = tp_evaluation_bits(e);
  const arb_struct *area2 = e->moments.weighted + TP_A2;
  arb_t product;
  arb_init(product);
  arb_mul(value, second, area2, exact);
  arb_mul_ui(value, value, 72 / m, exact);
  arb_mul(product, first, other, exact);
  arb_mul_2exp_si(product, product, 2);
  arb_sub(value, value, product, exact);
  arb_mul(value, value, e->moments.area2, exact);
  arb_mul(product, area2, area2, exact);
  arb_mul_ui(product, product, 72, exact);
  arb_div(value, value, product, bits);
  tp_evaluation_to_metres(value, e, 4);
  arb_clear(product);
}

/* The mixed one is zero on symmetric blocks, which is not known to any share of itself but exactly:
 * it counts against the root of the others' product, which it cannot exceed (Cauchy, Schwarz). */
static void second_moments(const tp_evaluation *e, tp_block_result *block,
                           tp_certainty *certainty) {
  const arb_struct *sums = e->moments.weighted;
  arb_t xx, yy, xy;
  arb_init(xx);
  arb_init(yy);
  arb_init(xy);
  second_moment(xx, e, sums + TP_XX12, 12, sums + TP_X6, sums + TP_X6);
  second_moment(yy, e, sums + TP_YY12, 12, sums + TP_Y6, sums + TP_Y6);
  second_moment(xy, e, sums + TP_XY24, 24, sums + TP_X6, sums + TP_Y6);
  block->second_moment_xx_m4 = tp_result(e, xx, certainty);
  block->second_moment_yy_m4 = tp_result(e, yy, certainty);
  block->second_moment_xy_m4 = tp_result_within(e, xy, (log2_of(xx) + log2_of(yy)) / 2, certainty);
  arb_clear(xx);
  arb_clear(yy);
  arb_clear(xy);
}

void tp_evaluate_block(const tp_evaluation *e, tp_block_result *block, tp_certainty *certainty) {
  const tp_problem *problem = e->problem;
  arb_t value;
  fmpq_t thickness;
  arb_init(value);
  fmpq_init(thickness);
  arb_mul_2exp_si(value, e->moments.area2, -1);
  block->area_m2 = tp_result_metres(e, value, 2, certainty);
  set_centroid(e, block, certainty);
  second_moments(e, block, certainty);
  tp_problem_thickness(thickness, problem);
  block->thickness_m = tp_result_rational(thickness);
  block->has_weight = problem->scene->block.unit_weight_kn_m3.given;
  if (block->has_weight) {
    tp_evaluation_weight(value, e);
    block->weight_n = tp_result(e, value, certainty);
  }
  const bool curved = problem->section.ellipse != NULL;
  block->vertices = curved ? 0 : (size_t)tp_problem_vertex_count(problem);
  block->holes = (size_t)problem->section.hole_count;
  block->parts = (size_t)problem->section.part_count;
  block->triangles = curved ? 0 : problem->triangle_count;
  arb_clear(value);
  fmpq_clear(thickness);
}
