/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Cones rounded to doubles with a bound of the rounding: moments about a point of the contact,
 * lengths in a power of two, each column of size one. Exact coordinates that fit a double are used
 * without balls. */

#include "linear_program/scaled.h"

#include "number/ball.h"
#include "number/binary.h"
#include "number/word.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ball * 2^-exponent; beyond the range of a double, its end. */
static double in_units(const arb_t ball, long exponent) {
  arf_t middle;
  arf_init(middle);
  arf_mul_2exp_si(middle, arb_midref(ball), -exponent);
  const double value = tp_ball_nearest(middle);
  arf_clear(middle);
  return value;
}

/* A bound of |truth - in_units(ball, exponent)|: the radius, the rounding, and what underflows. */
static double error_of(const arb_t ball, long exponent) {
  mag_t radius;
  mag_init(radius);
  mag_mul_2exp_si(radius, arb_radref(ball), -exponent);
  const double error = mag_get_d(radius); /* an upper bound */
  mag_clear(radius);
  return error + fabs(in_units(ball, exponent)) * DBL_EPSILON + DBL_MIN;
}

static long exponent_of(double log2_size) {
  return isfinite(log2_size) ? (long)ceil(log2_size) : 0;
}

/* moment - (x f_y - y f_x) */
static void set_moment(arb_t moment, const tp_scaled *s, const tp_vector *of) {
  arb_t product;
  arb_init(product);
  arb_mul(product, s->x, of->of + 1, s->bits);
  arb_submul(product, s->y, of->of, s->bits);
  arb_sub(moment, of->of + 2, product, s->bits);
  arb_clear(product);
}

/* Exact doubles: where a scaled program's moments are about, and the friction rounded, that of
 * points of one `own`. With them the edges of cones at exact points take no balls. */
typedef struct doubles {
  bool known, friction_known;
  long own;
  double x, y, friction;
  double log2_friction;
  double length; /* 2^-length_exponent */
} doubles;

/* Log2 of tan(phi). */
static double friction_above(arb_srcptr tangent) {
  mag_t friction;
  mag_init(friction);
  arb_get_mag(friction, tangent);
  const double log2_above = tp_mag_log2_above(friction);
  mag_clear(friction);
  return log2_above;
}

/* Friction known to half a unit in its last place and a little more. */
static void set_friction(doubles *d, arb_srcptr tangent, long own) {
  enum { BITS_OF_FRICTION = 60 }; /* the 53 of a double and some */
  d->own = own;
  d->friction = arf_get_d(arb_midref(tangent), ARF_RND_NEAR);
  d->friction_known =
      (arb_is_zero(tangent) || arb_rel_accuracy_bits(tangent) >= BITS_OF_FRICTION) &&
      isfinite(d->friction);
  d->log2_friction = friction_above(tangent);
}

static doubles doubles_of(const tp_scaled *s, const tp_cones *cones) {
  doubles d = {.known = false};
  set_friction(&d, cones->friction, 0);
  d.known = tp_cones_to_double(&d.x, s->x) && tp_cones_to_double(&d.y, s->y) && d.friction_known;
  return d;
}

/* From where moments are about to a point: each rounded once. */
static bool away_in_double(double *dx, double *dy, const doubles *d, const tp_cones *cones,
                           long point) {
  if (!d->known || !tp_cones_in_double(dx, dy, cones, point)) return false;
  *dx -= d->x;
  *dy -= d->y;
  return true;
}

/* Largest distance of a contact point, or arm of the loads, from where moments are about. */
static long length_exponent(const tp_scaled *s, const tp_cones *cones, const doubles *d,
                            double arm) {
  double farthest = 0, dx = 0, dy = 0;
  mag_t most, own;
  arb_t away;
  arb_init(away);
  mag_init(most);
  mag_init(own);
  for (long k = 0; k < cones->count; k++) {
    if (away_in_double(&dx, &dy, d, cones, k)) {
      farthest = tp_larger(tp_larger(farthest, fabs(dx)), fabs(dy));
      continue;
    }
    const arb_struct x = tp_cones_x(cones, k), y = tp_cones_y(cones, k);
    arb_sub(away, &x, s->x, s->bits);
    arb_get_mag(own, away);
    mag_max(most, most, own);
    arb_sub(away, &y, s->y, s->bits);
    arb_get_mag(own, away);
    mag_max(most, most, own);
  }
  mag_set_d(own, farthest); /* an upper bound */
  mag_max(most, most, own);
  const long exponent = exponent_of(fmax(tp_mag_log2_above(most), arm));
  mag_clear(most);
  mag_clear(own);
  arb_clear(away);
  return exponent;
}

/* Log2 of the size of the first edge of a cone, for both; from that of tan(phi). */
static long edge_exponent(const tp_cones *cones, long point, double log2_friction) {
  const slong x = (slong)fmpz_bits(cones->tx + point), y = (slong)fmpz_bits(cones->ty + point);
  return exponent_of((double)(x > y ? x : y) + tp_larger(0, log2_friction));
}

/* Log2 of the size of a force. */
static long column_exponent(const tp_cones *cones, long k, const tp_vector *entries) {
  if (tp_cones_is_edge(cones, k))
    return edge_exponent(cones, k / 2, friction_above(tp_cones_friction(cones, k / 2)));
  mag_t size;
  mag_init(size);
  arb_get_mag(size, entries->of);
  const double along = tp_mag_log2_above(size);
  arb_get_mag(size, entries->of + 1);
  const long exponent = exponent_of(fmax(along, tp_mag_log2_above(size)));
  mag_clear(size);
  return exponent;
}

static void set_column(tp_scaled *s, const tp_cones *cones, long k, tp_vector *entries, long bits) {
  tp_cones_column(entries->of, cones, k, bits);
  set_moment(entries->of + 2, s, entries);
  double *own = s->columns[k];
  const long exponent = column_exponent(cones, k, entries);
  for (int row = 0; row < 3; row++) {
    const long unit = row < 2 ? exponent : exponent + s->length_exponent;
    own[row] = in_units(entries->of + row, unit);
    s->error = fmax(s->error, error_of(entries->of + row, unit));
    s->largest[row] = fmax(s->largest[row], fabs(own[row]));
  }
  if (s->most == NULL) return;
  s->most[k] = INFINITY;
  if (tp_cones_is_edge(cones, k)) return;
  tp_cones_bound(entries->of, cones, k);
  s->most[k] = in_units(entries->of, s->force_exponent - exponent);
}

/* Both edges of a cone, where its point and its facet are small whole numbers. In units of the
 * force, which is at least |t| max(1, tan(phi)), and with w = 2^-53: tan(phi) t errs by 2 w, that
 * and n together, at most 2, by 5 w with the rounding of the friction; a moment, of arms at most 1
 * that err by w, by 2 (5 + 2 + 2) + 4 = 22 w. */
static bool set_edges_in_double(tp_scaled *s, const tp_cones *cones, long point, doubles *d) {
  static const double error = 22 * (DBL_EPSILON / 2);
  static const int64_t most = INT64_C(1) << DBL_MANT_DIG;
  const fmpz *x = cones->tx + point, *y = cones->ty + point;
  double dx = 0, dy = 0;
  const long kind = tp_cones_own(cones, point);
  if (!away_in_double(&dx, &dy, d, cones, point)) return false;
  if (d->own != kind) set_friction(d, tp_cones_friction(cones, point), kind);
  if (!d->friction_known) return false;
  if (!tp_word_is_small(x) || llabs(tp_word_get(x)) > most) return false;
  if (!tp_word_is_small(y) || llabs(tp_word_get(y)) > most) return false;
  const long exponent = -edge_exponent(cones, point, d->log2_friction);
  const double unit = exponent > -1000 ? tp_two_to(exponent) : ldexp(1, (int)exponent);
  const double tx = (double)tp_word_get(x) * unit, ty = (double)tp_word_get(y) * unit;
  for (int against = 0; against < 2; against++) {
    const double friction = against ? -d->friction : d->friction;
    double *own = s->columns[2 * point + against];
    own[0] = friction * tx - ty;
    own[1] = friction * ty + tx;
    own[2] = dx * d->length * own[1] - dy * d->length * own[0];
    for (int row = 0; row < 3; row++) s->largest[row] = tp_larger(s->largest[row], fabs(own[row]));
    if (s->most != NULL) s->most[2 * point + against] = INFINITY;
  }
  s->error = tp_larger(s->error, error + DBL_MIN);
  return true;
}

bool tp_scaled_init(tp_scaled *scaled, const tp_cones *cones, const tp_vector *size, long bits) {
  memset(scaled, 0, sizeof *scaled);
  const long count = tp_cones_column_count(cones);
  const bool bounded = cones->capacity_count > 0;
  scaled->count = count;
  scaled->columns = calloc((size_t)count + 1, sizeof *scaled->columns);
  if (bounded) {
    scaled->most = calloc((size_t)count, sizeof *scaled->most);
    scaled->at_most = calloc((size_t)count, sizeof *scaled->at_most);
  }
  if (scaled->columns == NULL || (bounded && (scaled->most == NULL || scaled->at_most == NULL))) {
    tp_scaled_clear(scaled);
    return false;
  }
  tp_vector entries;
  tp_vector_init(&entries);
  arb_set(entries.of, size->of);
  arb_set(entries.of + 1, size->of + 1);
  const double force = tp_vector_log2_size(&entries); /* its moment is zero as yet */
  arb_init(scaled->x);
  arb_init(scaled->y);
  scaled->bits = bits;
  if (cones->count > 0) {
    const arb_struct x = tp_cones_x(cones, 0), y = tp_cones_y(cones, 0);
    arb_get_mid_arb(scaled->x, &x);
    arb_get_mid_arb(scaled->y, &y);
  }
  mag_t moment;
  mag_init(moment);
  set_moment(entries.of + 2, scaled, size);
  arb_get_mag(moment, entries.of + 2);
  scaled->force_exponent = exponent_of(force);
  doubles d = doubles_of(scaled, cones);
  scaled->length_exponent = length_exponent(scaled, cones, &d, tp_mag_log2_above(moment) - force);
  d.length = ldexp(1, (int)-scaled->length_exponent);
  mag_clear(moment);
  for (long point = 0; point < cones->count; point++) {
    if (set_edges_in_double(scaled, cones, point, &d)) continue;
    for (int edge = 0; edge < 2; edge++)
      set_column(scaled, cones, 2 * point + edge, &entries, bits);
  }
  for (long k = 2 * cones->count; k < count; k++) set_column(scaled, cones, k, &entries, bits);
  tp_vector_clear(&entries);
  return true;
}

void tp_scaled_clear(tp_scaled *scaled) {
  if (scaled->bits > 0) {
    arb_clear(scaled->x);
    arb_clear(scaled->y);
  }
  free(scaled->columns);
  free(scaled->most);
  free(scaled->at_most);
  memset(scaled, 0, sizeof *scaled);
}

void tp_scaled_wrench(double wrench[3], const tp_scaled *scaled, const tp_vector *of) {
  wrench[0] = in_units(of->of, scaled->force_exponent);
  wrench[1] = in_units(of->of + 1, scaled->force_exponent);
  arb_t moment;
  arb_init(moment);
  set_moment(moment, scaled, of);
  wrench[2] = in_units(moment, scaled->force_exponent + scaled->length_exponent);
  arb_clear(moment);
}

void tp_scaled_wrench_near(tp_near wrench[3], const tp_scaled *scaled, const tp_vector *of) {
  arb_t own;
  arb_init(own);
  for (int row = 0; row < 3; row++) {
    const bool force = row < 2;
    if (!force) set_moment(own, scaled, of);
    const long unit = scaled->force_exponent + (force ? 0 : scaled->length_exponent);
    arb_mul_2exp_si(own, force ? of->of + row : own, -unit);
    wrench[row] = tp_ball_near(own);
  }
  arb_clear(own);
}

void tp_scaled_twist(tp_vector *own, const tp_scaled *s, const tp_vector *twist) {
  const arb_struct *v = twist->of;
  arb_mul(own->of, v + 2, s->y, s->bits);
  arb_sub(own->of, v, own->of, s->bits);
  arb_mul(own->of + 1, v + 2, s->x, s->bits);
  arb_add(own->of + 1, v + 1, own->of + 1, s->bits);
  arb_mul_2exp_si(own->of + 2, v + 2, s->length_exponent);
}

void tp_scaled_untwist(tp_vector *twist, const tp_scaled *s, const tp_vector *own) {
  arb_struct *v = twist->of;
  arb_mul_2exp_si(v + 2, own->of + 2, -s->length_exponent);
  arb_mul(v, v + 2, s->y, s->bits);
  arb_add(v, v, own->of, s->bits);
  arb_mul(v + 1, v + 2, s->x, s->bits);
  arb_sub(v + 1, own->of + 1, v + 1, s->bits);
}

tp_simplex_answer tp_scaled_solve(tp_scaled *scaled, const double direction[3],
                                  const double target[3]) {
  tp_simplex_program program = {
      .count = scaled->count, .columns = (const double(*)[3])scaled->columns, .most = scaled->most};
  memcpy(program.direction, direction, sizeof program.direction);
  memcpy(program.target, target, sizeof program.target);
  return tp_simplex_solve(&program, scaled->at_most);
}
