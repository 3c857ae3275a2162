/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* With F and T of a wrench about the first contact and g from there to the centroid: the moment
 * about that is T - g x F, w = I^-1 of it, and v = F - w x g. */

#include "solid_contacts/mode_cones.h"

#include "number/ball.h"

#include <math.h>
#include <stdlib.h>

enum { RAY_BITS = 40, MARGIN_BITS = 28 };

/* ---- vectors -----------------------------------------------------------------------------------
 */

static void init3(fmpz v[3]) {
  for (int k = 0; k < 3; k++) fmpz_init(v + k);
}

static void clear3(fmpz v[3]) {
  for (int k = 0; k < 3; k++) fmpz_clear(v + k);
}

static void cross3(fmpz product[3], const fmpz a[3], const fmpz b[3]) {
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    fmpz_mul(product + k, a + i, b + j);
    fmpz_submul(product + k, a + j, b + i);
  }
}

static double length3(const fmpz v[3]) {
  double square = 0;
  for (int k = 0; k < 3; k++) square += fmpz_get_d(v + k) * fmpz_get_d(v + k);
  return sqrt(square);
}

/* By how many binary places a number is below one. */
static slong below_one(double number) {
  return number > 0 && number < 1 ? -ilogb(number) : 0;
}

/* False: beyond the range of doubles; the number is zero then. */
static bool set_rounded(fmpz_t number, double value, int bits) {
  const double whole = nearbyint(ldexp(value, bits));
  if (isfinite(whole)) fmpz_set_d(number, whole);
  return isfinite(whole);
}

void tp_mode_add_product(arb_t sum, const arb_struct a[TP_WRENCH], const arb_struct b[TP_WRENCH]) {
  for (int k = 0; k < TP_WRENCH; k++) arb_addmul(sum, a + k, b + k, TP_MODE_BITS);
}

static void balls_init(arb_struct *balls, int count) {
  for (int k = 0; k < count; k++) arb_init(balls + k);
}

static void balls_clear(arb_struct *balls, int count) {
  for (int k = 0; k < count; k++) arb_clear(balls + k);
}

static void vector_init(tp_mode_vector *v) {
  v->is_known = true;
  balls_init(v->at, TP_WRENCH);
  balls_init(v->turned, TP_WRENCH);
}

static void vector_clear(tp_mode_vector *v) {
  if (!v->is_known) return;
  balls_clear(v->at, TP_WRENCH);
  balls_clear(v->turned, TP_WRENCH);
  v->is_known = false;
}

/* to += a x b, or less */
static void add_cross(arb_struct to[3], const arb_struct a[3], const arb_struct b[3], bool less) {
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    arb_addmul(to + k, a + (less ? j : i), b + (less ? i : j), TP_MODE_BITS);
    arb_submul(to + k, a + (less ? i : j), b + (less ? j : i), TP_MODE_BITS);
  }
}

void tp_mode_cones_turn(arb_struct turned[TP_WRENCH], const tp_mode_cones *m,
                        const arb_struct wrench[TP_WRENCH]) {
  arb_struct moment[3];
  balls_init(moment, 3);
  for (int k = 0; k < 3; k++) arb_set(moment + k, wrench + 3 + k);
  add_cross(moment, m->centroid, wrench, true);
  for (int k = 0; k < 3; k++) {
    arb_set(turned + k, wrench + k);
    arb_zero(turned + 3 + k);
    for (int i = 0; i < 3; i++) {
      arb_addmul(turned + 3 + k, m->inverse + 3 * k + i, moment + i, TP_MODE_BITS);
    }
  }
  add_cross(turned, turned + 3, m->centroid, true);
  balls_clear(moment, 3);
}

static void set_near(tp_mode_vector *v) {
  for (int k = 0; k < TP_WRENCH; k++) {
    v->near[k] = tp_ball_nearest(arb_midref(v->at + k));
    v->near_turned[k] = tp_ball_nearest(arb_midref(v->turned + k));
  }
}

/* Along a force at a contact: of a size between one half and one. */
static void set_vector(tp_mode_vector *v, const tp_mode_cones *m, const tp_mode_contact *c,
                       const fmpz along[3], bool turns) {
  fmpz whole[TP_WRENCH];
  for (int k = 0; k < TP_WRENCH; k++) fmpz_init(whole + k);
  for (int k = 0; k < 3; k++) fmpz_mul(whole + k, along + k, &m->unit);
  cross3(whole + 3, c->at, along);
  vector_init(v);
  for (int k = 0; k < TP_WRENCH; k++) {
    const slong bits = (slong)fmpz_bits(whole + k);
    if (bits > v->exponent) v->exponent = bits;
  }
  for (int k = 0; k < TP_WRENCH; k++) {
    arb_set_fmpz(v->at + k, whole + k);
    arb_mul_2exp_si(v->at + k, v->at + k, -v->exponent);
    fmpz_clear(whole + k);
  }
  if (turns) tp_mode_cones_turn(v->turned, m, v->at);
  set_near(v);
}

/* ---- forces and rows ---------------------------------------------------------------------------
 */

int tp_mode_tip(int level, int sector) {
  return TP_MODE_TIPS + TP_MODE_QUARTERS * ((1 << level) - 1) + sector;
}

/* n and so much of d in 2^-MARGIN_BITS; the ray in 2^-bits. */
static void add_ray(fmpz force[3], const tp_mode_contact *c, int ray, slong share) {
  for (int k = 0; k < 3; k++) {
    fmpz_t part;
    fmpz_init(part);
    fmpz_mul_si(part, c->rays[ray] + k, share);
    fmpz_add(force + k, force + k, part);
    fmpz_clear(part);
  }
}

/* In 2^-MARGIN_BITS, rounded up. */
static slong share_above(double share) {
  return (slong)ceil(ldexp(share, MARGIN_BITS)) + 2;
}

static void set_force(fmpz force[3], const tp_mode_contact *c, int which, double divisor) {
  static const slong one = (slong)1 << MARGIN_BITS;
  const double turn_angle = 2 * M_PI;
  for (int k = 0; k < 3; k++) {
    fmpz_mul_2exp(force + k, c->normal + k, (ulong)(c->bits + MARGIN_BITS));
  }
  if (c->is_smooth) return;
  if (which < TP_MODE_OUTER) {
    add_ray(force, c, which, -(slong)floor((double)(one - 1) / divisor));
  } else if (which < TP_MODE_CONE) {
    add_ray(force, c, which - TP_MODE_OUTER, -(one + 1));
  } else if (which < TP_MODE_TIPS) {
    add_ray(force, c, (which - TP_MODE_CONE) * (TP_MODE_RAYS / TP_MODE_POLYGON),
            share_above(1 / cos(turn_angle / (2 * TP_MODE_POLYGON))));
  } else {
    int level = 0, sector = which - TP_MODE_TIPS;
    for (; sector >= TP_MODE_QUARTERS << level; level++) sector -= TP_MODE_QUARTERS << level;
    const int sectors = TP_MODE_QUARTERS << level, span = TP_MODE_RAYS / sectors;
    const double half = cos(turn_angle / (2 * sectors));
    const slong share = share_above(1 / (2 * half * half));
    add_ray(force, c, sector * span, -share);
    add_ray(force, c, (sector + 1) * span % TP_MODE_RAYS, -share);
  }
}

const tp_mode_vector *tp_mode_cones_force(tp_mode_cones *m, long contact, int which) {
  tp_mode_contact *c = m->contacts + contact;
  tp_mode_vector *v = c->forces + which;
  if (v->is_known) return v;
  fmpz force[3];
  init3(force);
  set_force(force, c, which, m->divisor);
  set_vector(v, m, c, force, false);
  clear3(force);
  return v;
}

const tp_mode_vector *tp_mode_cones_row(tp_mode_cones *m, long contact, int row) {
  tp_mode_contact *c = m->contacts + contact;
  tp_mode_vector *v = c->rows + row;
  if (v->is_known) return v;
  fmpz along[3];
  init3(along);
  if (row >= TP_MODE_ROW_RAYS) cross3(along, c->normal, c->rays[row - TP_MODE_ROW_RAYS]);
  set_vector(v, m, c,
             row == 0                 ? c->normal
             : row < TP_MODE_ROW_RAYS ? c->across[row - TP_MODE_ROW_ACROSS]
                                      : along,
             true);
  clear3(along);
  return v;
}

/* ---- contacts ----------------------------------------------------------------------------------
 */

/* Whole numbers along a rational vector, without a common factor. */
static void set_whole(fmpz whole[3], const fmpq v[3]) {
  fmpz_t common;
  fmpz_init(common);
  fmpz_one(common);
  for (int k = 0; k < 3; k++) fmpz_lcm(common, common, fmpq_denref(v + k));
  for (int k = 0; k < 3; k++) {
    fmpz_divexact(whole + k, common, fmpq_denref(v + k));
    fmpz_mul(whole + k, whole + k, fmpq_numref(v + k));
  }
  fmpz_gcd(common, whole, whole + 1);
  fmpz_gcd(common, common, whole + 2);
  for (int k = 0; k < 3; k++) fmpz_divexact(whole + k, whole + k, common);
  fmpz_clear(common);
}

static void set_across(tp_mode_contact *c) {
  fmpz axis[3];
  int least = 0;
  init3(axis);
  for (int k = 1; k < 3; k++) {
    if (fmpz_cmpabs(c->normal + k, c->normal + least) < 0) least = k;
  }
  fmpz_one(axis + least);
  cross3(c->across[0], c->normal, axis);
  cross3(c->across[1], c->normal, c->across[0]);
  clear3(axis);
}

/* Counter-clockwise about n, as n x t1 = t2. The first is turned by a part of the angle between
 * two, so that slips along axes of symmetry are within sectors, not on the border of two of them.
 */
static bool set_rays(tp_mode_contact *c, double mu) {
  static const double turned_by = 0.382;
  const double reach = mu * length3(c->normal);
  double share[2], finest = INFINITY;
  for (int k = 0; k < 2; k++) {
    share[k] = reach / length3(c->across[k]);
    finest = fmin(finest, share[k]);
  }
  if (!(finest > 0) || !isfinite(reach)) return false;
  c->bits = RAY_BITS + below_one(finest);
  bool done = true;
  fmpz_t part;
  fmpz_init(part);
  for (int j = 0; j < TP_MODE_RAYS; j++) {
    const double angle = 2 * M_PI * (j + turned_by) / TP_MODE_RAYS,
                 parts[2] = {cos(angle), sin(angle)};
    for (int i = 0; i < 2; i++) {
      done = set_rounded(part, share[i] * parts[i], (int)c->bits) && done;
      for (int k = 0; k < 3; k++) fmpz_addmul(c->rays[j] + k, c->across[i] + k, part);
    }
  }
  fmpz_clear(part);
  return done;
}

static void contact_init(tp_mode_contact *c) {
  init3(c->at);
  init3(c->normal);
  for (int k = 0; k < 2; k++) init3(c->across[k]);
  for (int k = 0; k < TP_MODE_RAYS; k++) init3(c->rays[k]);
}

static void contact_clear(tp_mode_contact *c) {
  clear3(c->at);
  clear3(c->normal);
  for (int k = 0; k < 2; k++) clear3(c->across[k]);
  for (int k = 0; k < TP_MODE_RAYS; k++) clear3(c->rays[k]);
  for (int k = 0; k < TP_MODE_FORCES; k++) vector_clear(c->forces + k);
  for (int k = 0; k < TP_MODE_ROWS; k++) vector_clear(c->rows + k);
}

static void set_points(tp_mode_cones *m, const tp_friction_cones *cones) {
  fmpq_t way;
  fmpq_init(way);
  fmpz_one(&m->unit);
  for (int pass = 0; pass < 2; pass++) {
    for (long n = 0; n < m->count; n++) {
      for (int k = 0; k < 3; k++) {
        fmpq_sub(way, cones->cones[n].at + k, cones->cones[0].at + k);
        if (pass == 0) {
          fmpz_lcm(&m->unit, &m->unit, fmpq_denref(way));
        } else {
          fmpq_mul_fmpz(way, way, &m->unit);
          fmpz_set(m->contacts[n].at + k, fmpq_numref(way));
        }
      }
    }
  }
  fmpq_clear(way);
}

/* ---- body --------------------------------------------------------------------------------------
 */

/* I = trace - S of the second moments S; its inverse by cofactors. */
static bool set_inverse(arb_struct inverse[9], const fmpq second[6]) {
  static const int place[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}}; /* of each product in S */
  arb_struct own[9];
  arb_t determinant;
  fmpq_t trace;
  balls_init(own, 9);
  arb_init(determinant);
  fmpq_init(trace);
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      arb_set_fmpq(own + 3 * i + j, second + place[i][j], TP_MODE_BITS);
      arb_neg(own + 3 * i + j, own + 3 * i + j);
    }
    fmpq_add(trace, second + (i + 1) % 3, second + (i + 2) % 3);
    arb_set_fmpq(own + 3 * i + i, trace, TP_MODE_BITS);
  }
  for (int i = 0; i < 3; i++) {
    add_cross(inverse + 3 * i, own + 3 * ((i + 1) % 3), own + 3 * ((i + 2) % 3), false);
  }
  for (int k = 0; k < 3; k++) arb_addmul(determinant, own + k, inverse + k, TP_MODE_BITS);
  const bool is_regular = arb_is_positive(determinant) != 0;
  for (int k = 0; k < 9; k++) arb_div(inverse + k, inverse + k, determinant, TP_MODE_BITS);
  balls_clear(own, 9);
  arb_clear(determinant);
  fmpq_clear(trace);
  return is_regular;
}

static bool set_body(tp_mode_cones *m, const tp_friction_cones *cones, const fmpq inertia[6]) {
  for (int k = 0; k < 3; k++) {
    fmpq_neg(m->exact_centroid + k, cones->cones[0].at + k);
    arb_set_fmpq(m->centroid + k, m->exact_centroid + k, TP_MODE_BITS);
  }
  for (int k = 0; k < 6; k++) fmpq_set(m->exact_inertia + k, inertia + k);
  return set_inverse(m->inverse, inertia);
}

/* times 2^-exponent */
static void set_scaled(fmpq_t number, const fmpq_t from, slong exponent) {
  if (exponent >= 0) {
    fmpq_div_2exp(number, from, (ulong)exponent);
  } else {
    fmpq_mul_2exp(number, from, (ulong)-exponent);
  }
}

/* At the centroid, where C turns nothing: of the size of 2^exponent. */
static void set_load(tp_mode_cones *m, tp_mode_vector *v, int which, const tp_hold_load *load,
                     slong exponent) {
  mag_t radius;
  fmpq_t error;
  mag_init(radius);
  fmpq_init(error);
  v->exponent = exponent;
  for (int k = 0; k < 3; k++) {
    fmpq *own = m->exact_loads[which] + k;
    tp_hold_double(error, load->error[k]);
    set_scaled(m->load_errors[which] + k, error, exponent);
    set_scaled(own, load->exact + k, exponent);
    arb_set_fmpq(v->at + k, own, TP_MODE_BITS);
    mag_set_d(radius, ldexp(load->error[k], (int)-exponent));
    arb_add_error_mag(v->at + k, radius);
    arb_set(v->turned + k, v->at + k);
  }
  mag_clear(radius);
  fmpq_clear(error);
  add_cross(v->at + 3, m->centroid, v->at, false);
  set_near(v);
}

/* Both in one size, as mixes of them count. */
static bool set_loads(tp_mode_cones *m, const tp_hold_load loads[2], const tp_hold_load *way) {
  double most = 0;
  for (int k = 0; k < 6; k++) {
    const double own = fabs(loads[k / 3].nearest[k % 3]);
    if (!isfinite(own) || !isfinite(loads[k / 3].error[k % 3])) return false;
    most = fmax(most, own);
  }
  const slong exponent = most > 0 ? ilogb(most) + 1 : 0;
  for (int k = 0; k < 2; k++) set_load(m, m->loads + k, k, loads + k, exponent);
  if (way == NULL) return true;
  for (int k = 0; k < 3; k++) {
    if (!isfinite(way->error[k])) return false;
  }
  set_load(m, &m->change, 2, way, exponent);
  for (int k = 0; k < TP_WRENCH; k++) {
    m->change.near[k] = m->loads[1].near[k] - m->loads[0].near[k];
  }
  return true;
}

bool tp_mode_cones_init(tp_mode_cones *m, const tp_friction_cones *cones, const fmpq inertia[6],
                        double divisor, const tp_hold_load loads[2], const tp_hold_load *way) {
  *m = (tp_mode_cones){.contacts = calloc((size_t)cones->count + 1, sizeof *m->contacts),
                       .divisor = divisor,
                       .is_in_range = true};
  if (m->contacts == NULL) return false;
  m->count = cones->count;
  fmpz_init(&m->unit);
  balls_init(m->centroid, 3);
  balls_init(m->inverse, 9);
  for (int k = 0; k < 3; k++) fmpq_init(m->exact_centroid + k);
  for (int k = 0; k < 6; k++) fmpq_init(m->exact_inertia + k);
  for (int k = 0; k < 9; k++) {
    fmpq_init(m->exact_loads[k / 3] + k % 3);
    fmpq_init(m->load_errors[k / 3] + k % 3);
  }
  vector_init(&m->change);
  for (int k = 0; k < 2; k++) vector_init(m->loads + k);
  for (long n = 0; n < m->count; n++) contact_init(m->contacts + n);
  set_points(m, cones);
  for (long n = 0; n < m->count; n++) {
    tp_mode_contact *c = m->contacts + n;
    set_whole(c->normal, cones->cones[n].normal);
    set_across(c);
    c->is_smooth = tp_near_is_zero(cones->cones[n].friction);
    if (!c->is_smooth && !set_rays(c, cones->cones[n].friction.value)) m->is_in_range = false;
  }
  if (!set_body(m, cones, inertia)) m->is_in_range = false;
  if (!set_loads(m, loads, way)) m->is_in_range = false;
  return true;
}

void tp_mode_cones_clear(tp_mode_cones *m) {
  if (m->contacts == NULL) return;
  for (long n = 0; n < m->count; n++) contact_clear(m->contacts + n);
  free(m->contacts);
  fmpz_clear(&m->unit);
  balls_clear(m->centroid, 3);
  balls_clear(m->inverse, 9);
  for (int k = 0; k < 3; k++) fmpq_clear(m->exact_centroid + k);
  for (int k = 0; k < 6; k++) fmpq_clear(m->exact_inertia + k);
  for (int k = 0; k < 9; k++) {
    fmpq_clear(m->exact_loads[k / 3] + k % 3);
    fmpq_clear(m->load_errors[k / 3] + k % 3);
  }
  vector_clear(&m->change);
  for (int k = 0; k < 2; k++) vector_clear(m->loads + k);
  *m = (tp_mode_cones){.contacts = NULL};
}
