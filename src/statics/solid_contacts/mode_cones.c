/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* With F and T of a wrench about the first contact and g from there to the centroid: the moment
 * about that is T - g x F, w = I^-1 of it, and v = F - w x g. */

#include "solid_contacts/mode_cones.h"

#include "solid_contacts/solid_section_parts.h"

#include <math.h>
#include <stdlib.h>

enum { BITS = 50, RAY_BITS = 40, MARGIN_BITS = 28 };

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

void tp_mode_add_product(fmpz_t sum, const fmpz a[TP_WRENCH], const fmpz b[TP_WRENCH]) {
  for (int k = 0; k < TP_WRENCH; k++) fmpz_addmul(sum, a + k, b + k);
}

static void vector_init(tp_mode_vector *v) {
  v->is_known = false;
  for (int k = 0; k < TP_WRENCH; k++) {
    fmpz_init(v->whole + k);
    fmpz_init(v->turned + k);
  }
}

static void vector_clear(tp_mode_vector *v) {
  for (int k = 0; k < TP_WRENCH; k++) {
    fmpz_clear(v->whole + k);
    fmpz_clear(v->turned + k);
  }
}

static slong turned_bits(const tp_mode_cones *m) {
  return 2 * m->centroid_bits + m->inverse_bits;
}

/* C times 2^turned_bits. */
static void turn(fmpz turned[TP_WRENCH], const tp_mode_cones *m, const fmpz wrench[TP_WRENCH]) {
  fmpz moment[3], arm[3], turning[3];
  init3(moment);
  init3(arm);
  init3(turning);
  cross3(arm, m->centroid, wrench);
  for (int k = 0; k < 3; k++) {
    fmpz_mul_2exp(moment + k, wrench + 3 + k, (ulong)m->centroid_bits);
    fmpz_sub(moment + k, moment + k, arm + k);
  }
  for (int k = 0; k < 3; k++) {
    for (int i = 0; i < 3; i++) fmpz_addmul(turning + k, m->inverse + 3 * k + i, moment + i);
  }
  cross3(arm, turning, m->centroid);
  for (int k = 0; k < 3; k++) {
    fmpz_mul_2exp(turned + k, wrench + k, (ulong)turned_bits(m));
    fmpz_sub(turned + k, turned + k, arm + k);
    fmpz_mul_2exp(turned + 3 + k, turning + k, (ulong)m->centroid_bits);
  }
  clear3(moment);
  clear3(arm);
  clear3(turning);
}

static double shifted(const fmpz_t number, slong exponent) {
  slong own;
  const double mantissa = fmpz_get_d_2exp(&own, number);
  return ldexp(mantissa, (int)(own - exponent));
}

static void set_near(tp_mode_vector *v, const tp_mode_cones *m, slong exponent) {
  v->exponent = exponent;
  for (int k = 0; k < TP_WRENCH; k++) {
    v->near[k] = shifted(v->whole + k, exponent);
    v->near_turned[k] = shifted(v->turned + k, exponent + turned_bits(m));
  }
}

static void settle(tp_mode_vector *v, const tp_mode_cones *m) {
  slong exponent = 0;
  v->is_known = true;
  for (int k = 0; k < TP_WRENCH; k++) {
    const slong bits = (slong)fmpz_bits(v->whole + k);
    if (bits > exponent) exponent = bits;
  }
  turn(v->turned, m, v->whole);
  set_near(v, m, exponent);
}

/* Along a force at a contact. */
static void set_vector(tp_mode_vector *v, const tp_mode_cones *m, const tp_mode_contact *c,
                       const fmpz along[3]) {
  for (int k = 0; k < 3; k++) fmpz_mul(v->whole + k, along + k, &m->unit);
  cross3(v->whole + 3, c->at, along);
  settle(v, m);
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
  set_vector(v, m, c, force);
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
                                      : along);
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

/* Counter-clockwise about n, as n x t1 = t2. */
static bool set_rays(tp_mode_contact *c, double mu) {
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
    const double angle = 2 * M_PI * j / TP_MODE_RAYS, parts[2] = {cos(angle), sin(angle)};
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
  for (int k = 0; k < TP_MODE_FORCES; k++) vector_init(c->forces + k);
  for (int k = 0; k < TP_MODE_ROWS; k++) vector_init(c->rows + k);
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
static bool set_body(tp_mode_cones *m, const tp_friction_cones *cones,
                     const tp_solid_section_inertia *inertia) {
  const double *s = inertia->second, trace = s[0] + s[1] + s[2];
  const double own[3][3] = {
      {trace - s[0], -s[5], -s[4]}, {-s[5], trace - s[1], -s[3]}, {-s[4], -s[3], trace - s[2]}};
  double cofactor[3][3], determinant = 0, most = 0, far = 0;
  bool done = true;
  for (int i = 0; i < 3; i++) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = 0; j < 3; j++) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      cofactor[i][j] = own[i1][j1] * own[i2][j2] - own[i1][j2] * own[i2][j1];
    }
    determinant += i == 0 ? own[0][0] * cofactor[0][0] + own[0][1] * cofactor[0][1] +
                                own[0][2] * cofactor[0][2]
                          : 0;
  }
  for (int i = 0; i < 3; i++) {
    most = fmax(most, fabs(cofactor[i][i] / determinant));
    far = fmax(far, fabs(fmpq_get_d(cones->cones[0].at + i)));
  }
  if (!isfinite(most) || !isfinite(far)) return false;
  m->inverse_bits = BITS + below_one(most);
  m->centroid_bits = BITS + below_one(far);
  for (int i = 0; i < 3; i++) {
    for (int j = i; j < 3; j++) {
      done =
          set_rounded(m->inverse + 3 * i + j, cofactor[i][j] / determinant, (int)m->inverse_bits) &&
          done;
      fmpz_set(m->inverse + 3 * j + i, m->inverse + 3 * i + j);
    }
    done =
        set_rounded(m->centroid + i, -fmpq_get_d(cones->cones[0].at + i), (int)m->centroid_bits) &&
        done;
  }
  return done;
}

/* At the centroid. */
static bool set_load(tp_mode_vector *v, const tp_mode_cones *m, const tp_hold_load *load,
                     double most) {
  fmpz force[3];
  bool done = true;
  init3(force);
  for (int k = 0; k < 3; k++) {
    done = set_rounded(force + k, load->nearest[k], BITS + (most > 0 ? -ilogb(most) : 0)) && done;
    fmpz_mul_2exp(v->whole + k, force + k, (ulong)m->centroid_bits);
  }
  cross3(v->whole + 3, m->centroid, force);
  settle(v, m);
  clear3(force);
  return done;
}

/* Both in one size, as mixes of them count. */
static bool set_loads(tp_mode_cones *m, const tp_hold_load loads[2]) {
  double most = 0;
  bool done = true;
  for (int k = 0; k < 6; k++) most = fmax(most, fabs(loads[k / 3].nearest[k % 3]));
  for (int k = 0; k < 2; k++) done = set_load(m->loads + k, m, loads + k, most) && done;
  const slong first = m->loads[0].exponent, second = m->loads[1].exponent;
  for (int k = 0; k < 2; k++) set_near(m->loads + k, m, first > second ? first : second);
  return done;
}

bool tp_mode_cones_init(tp_mode_cones *m, const tp_friction_cones *cones,
                        const tp_solid_section_inertia *inertia, double divisor,
                        const tp_hold_load loads[2]) {
  *m = (tp_mode_cones){.contacts = calloc((size_t)cones->count + 1, sizeof *m->contacts),
                       .divisor = divisor,
                       .is_in_range = true,
                       .centroid_bits = BITS,
                       .inverse_bits = BITS};
  if (m->contacts == NULL) return false;
  m->count = cones->count;
  fmpz_init(&m->unit);
  init3(m->centroid);
  for (int k = 0; k < 9; k++) fmpz_init(m->inverse + k);
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
  if (!set_loads(m, loads)) m->is_in_range = false;
  return true;
}

void tp_mode_cones_clear(tp_mode_cones *m) {
  if (m->contacts == NULL) return;
  for (long n = 0; n < m->count; n++) contact_clear(m->contacts + n);
  free(m->contacts);
  fmpz_clear(&m->unit);
  clear3(m->centroid);
  for (int k = 0; k < 9; k++) fmpz_clear(m->inverse + k);
  for (int k = 0; k < 2; k++) vector_clear(m->loads + k);
  *m = (tp_mode_cones){.contacts = NULL};
}
