/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Twist as the cross product of two columns, and its admissibility v . e_k >= 0 column by column:
 * by doubles with bounds first, by balls where these do not decide (docs/mechanics.md section
 * 6). */

#include "certificate/face.h"

#include "certificate/filter.h"
#include "number/ball.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool tp_face_init(tp_face *face, const tp_cones *cones) {
  memset(face, 0, sizeof *face);
  if (cones->capacity_count > 0) {
    face->full = calloc((size_t)(TP_CAPACITY_COLUMNS * cones->capacity_count), sizeof(bool));
    if (face->full == NULL) return false;
  }
  tp_vector_init(face->edges);
  tp_vector_init(face->edges + 1);
  tp_vector_init(&face->normal);
  tp_vector_init(&face->twist);
  arb_init(face->resistance);
  return true;
}

void tp_face_clear(tp_face *face) {
  tp_vector_clear(face->edges);
  tp_vector_clear(face->edges + 1);
  tp_vector_clear(&face->normal);
  tp_vector_clear(&face->twist);
  arb_clear(face->resistance);
  free(face->full);
  memset(face, 0, sizeof *face);
}

/* The same twist from the point alone, without the roundings of the friction: (y, -x, 1) omega. */
static void turn_about_site(tp_face *face, const tp_cones *cones) {
  arb_struct *v = face->twist.of;
  long point = 0;
  while (cones->points[point].site != face->site) point++;
  const bool back = arf_sgn(arb_midref(v + 2)) < 0;
  const arb_struct x = tp_cones_x(cones, point), y = tp_cones_y(cones, point);
  arb_set(v, &y);
  arb_neg(v + 1, &x);
  arb_one(v + 2);
  if (back) tp_vector_neg(&face->twist);
}

tp_answer tp_face_span(tp_face *face, const tp_cones *cones, long first, long second,
                       const tp_vector *drive, const tp_judge *judge) {
  face->columns[0] = first;
  face->columns[1] = second;
  tp_vector *twist = &face->twist;
  arb_t power;
  arb_init(power);
  tp_cones_column(face->edges[0].of, cones, first, judge->precision);
  tp_cones_column(face->edges[1].of, cones, second, judge->precision);
  tp_vector_cross(&face->normal, face->edges, face->edges + 1, judge->precision);
  for (int k = 0; k < 3; k++) arb_set(twist->of + k, face->normal.of + k);
  if (tp_cones_are_parallel(cones, first, second)) arb_zero(twist->of + 2);
  tp_vector_dot(power, twist, drive, judge->precision);
  const int sign = tp_vector_judge(judge, power, twist, drive);
  if (sign < 0) tp_vector_neg(twist);
  const int turns = tp_vector_judge(judge, twist->of + 2, face->edges, face->edges + 1);
  if (turns == 0) arb_zero(twist->of + 2);
  face->motion = turns == 0 ? TP_MOTION_SLIDE : TP_MOTION_TURN;
  if (tp_cones_meet(&face->site, cones, first, second)) face->motion = TP_MOTION_TURN_AT_SITE;
  arb_clear(power);
  return sign == 0 ? TP_NO : sign == TP_OPEN_SIGN || turns == TP_OPEN_SIGN ? TP_OPEN : TP_YES;
}

/* Scratch for the power of the two edges of the cone at a point, once it is needed. */
typedef struct powers {
  long point; /* -1: none as yet */
  arb_t vx, vy, normal, along, edge;
} powers;

/* The velocity of the point is (v_x - omega y, v_y + omega x); its share along n is `normal`, along
 * t `along`; the edges' powers are normal +- along tan(phi). */
static void point_powers(powers *p, const tp_face *face, const tp_cones *cones, long point,
                         long bits) {
  const arb_struct *v = face->twist.of;
  const arb_struct x = tp_cones_x(cones, point), y = tp_cones_y(cones, point);
  p->point = point;
  arb_mul(p->vx, v + 2, &y, bits);
  arb_sub(p->vx, v, p->vx, bits);
  arb_mul(p->vy, v + 2, &x, bits);
  arb_add(p->vy, v + 1, p->vy, bits);
  arb_mul_fmpz(p->normal, p->vy, cones->tx + point, bits);
  arb_submul_fmpz(p->normal, p->vx, cones->ty + point, bits);
  arb_mul_fmpz(p->along, p->vx, cones->tx + point, bits);
  arb_addmul_fmpz(p->along, p->vy, cones->ty + point, bits);
  arb_mul(p->along, p->along, tp_cones_friction(cones, point), bits);
}

/* Does the column do no work by its point alone? */
static bool is_idle(const tp_face *face, const tp_cones *cones, long column) {
  if (face->motion == TP_MOTION_TURN_AT_SITE && cones->points[column / 2].site == face->site) {
    return true;
  }
  for (int k = 0; k < 2; k++) {
    if (face->columns[k] < 0) continue;
    const bool parallel = tp_cones_are_parallel(cones, face->columns[k], column);
    if (face->motion == TP_MOTION_SLIDE && parallel) return true;
    if (parallel && tp_cones_share_site(cones, face->columns[k], column)) return true;
  }
  return false;
}

/* What the velocity of a point is made of: v and omega (-y, x), which may cancel. */
static double log2_of_velocity(const tp_face *face, const tp_cones *cones, long point) {
  const arb_struct *v = face->twist.of;
  const arb_struct x = tp_cones_x(cones, point), y = tp_cones_y(cones, point);
  const double arm = fmax(tp_ball_log2_above(&x), tp_ball_log2_above(&y));
  return fmax(fmax(tp_ball_log2_above(v), tp_ball_log2_above(v + 1)),
              tp_ball_log2_above(v + 2) + arm);
}

/* What the powers at a point are made of: its velocity times t. */
static double log2_of_terms(const tp_face *face, const tp_cones *cones, long point) {
  const slong along = (slong)fmpz_bits(cones->tx + point), up = (slong)fmpz_bits(cones->ty + point);
  return log2_of_velocity(face, cones, point) + (double)(along > up ? along : up);
}

/* Is the point at rest, where neither edge of its cone does work? Where there is friction the two
 * edges span the plane; otherwise the point may still slip along its facet. */
static tp_answer is_at_rest(const tp_face *face, const tp_cones *cones, long point, const powers *p,
                            const tp_judge *judge) {
  if (!arb_is_zero(tp_cones_friction(cones, point))) return TP_YES;
  const double scale = log2_of_velocity(face, cones, point);
  const int along = tp_judge_sign(judge, p->vx, scale), up = tp_judge_sign(judge, p->vy, scale);
  if (along == TP_OPEN_SIGN || up == TP_OPEN_SIGN) return TP_OPEN;
  return along == 0 && up == 0 ? TP_YES : TP_NO;
}

/* The sign of an edge's power. */
static int sign_of_edge(const tp_face *face, const tp_cones *cones, long column, powers *p,
                        const tp_judge *judge) {
  const long point = column / 2;
  if (p->point != point) point_powers(p, face, cones, point, judge->precision);
  if (column % 2 == 0) {
    arb_add(p->edge, p->normal, p->along, judge->precision);
  } else {
    arb_sub(p->edge, p->normal, p->along, judge->precision);
  }
  const bool asks = tp_judge_asks_scale(judge, p->edge);
  return tp_judge_sign(judge, p->edge, asks ? log2_of_terms(face, cones, point) : 0);
}

/* The signs of both edges' powers at a point, but those `above` zero: idle ones count as zero
 * without arithmetic. */
static tp_answer admit_point(tp_face *face, const tp_cones *cones, long point, const bool above[2],
                             powers *p, const tp_judge *judge, long *violated) {
  int zeros = 0;
  for (int side = 0; side < 2; side++) {
    if (above[side]) continue;
    const long column = 2 * point + side;
    const int sign = is_idle(face, cones, column) ? 0 : sign_of_edge(face, cones, column, p, judge);
    if (sign == 0) zeros++;
    if (sign == -1 || sign == TP_OPEN_SIGN) {
      *violated = column;
      return sign == -1 ? TP_NO : TP_OPEN;
    }
  }
  if (zeros < 2 || face->motion != TP_MOTION_TURN) return TP_YES;
  if (p->point != point) point_powers(p, face, cones, point, judge->precision);
  const tp_answer rests = is_at_rest(face, cones, point, p, judge);
  if (rests == TP_YES) { /* the centre lies in this point */
    face->motion = TP_MOTION_TURN_AT_SITE;
    face->site = cones->points[point].site;
  }
  return rests == TP_OPEN ? TP_OPEN : TP_YES;
}

tp_face_motion tp_face_told_motion(const tp_face *face, const tp_cones *cones) {
  const bool spans = face->columns[0] >= 0 && face->columns[1] >= 0;
  const bool slips = spans && face->motion == TP_MOTION_TURN &&
                     tp_cones_slip_unevenly(cones, face->columns[0], face->columns[1]);
  return slips ? TP_MOTION_SLIDE : face->motion;
}

static void powers_init(powers *p) {
  p->point = -1;
  arb_init(p->vx);
  arb_init(p->vy);
  arb_init(p->normal);
  arb_init(p->along);
  arb_init(p->edge);
}

static void powers_clear(powers *p) {
  arb_clear(p->vx);
  arb_clear(p->vy);
  arb_clear(p->normal);
  arb_clear(p->along);
  arb_clear(p->edge);
}

tp_answer tp_face_admit_points(tp_face *face, const tp_cones *cones, long from,
                               const tp_judge *judge) {
  powers p;
  long violated = -1;
  tp_answer answer = TP_YES;
  powers_init(&p);
  for (long k = from; k < cones->count && answer == TP_YES; k++) {
    answer = admit_point(face, cones, k, (bool[2]){false, false}, &p, judge, &violated);
  }
  powers_clear(&p);
  return answer;
}

tp_answer tp_face_admit(tp_face *face, const tp_cones *cones, const tp_scaled *scaled,
                        const tp_judge *judge, long *violated) {
  const tp_filter filter = tp_filter_of(&face->twist, scaled);
  powers p;
  powers_init(&p);
  tp_answer answer = TP_YES;
  for (long k = 0; k < cones->count && answer == TP_YES; k++) {
    const bool above[2] = {tp_filter_is_above_zero(&filter, scaled->columns[2 * k]),
                           tp_filter_is_above_zero(&filter, scaled->columns[2 * k + 1])};
    if (above[0] && above[1]) continue;
    answer = admit_point(face, cones, k, above, &p, judge, violated);
  }
  powers_clear(&p);
  if (answer == TP_YES && face->motion == TP_MOTION_TURN_AT_SITE) turn_about_site(face, cones);
  if (answer == TP_YES) tp_face_find_resistance(face, cones, judge);
  return answer;
}
