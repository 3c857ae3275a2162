/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* At one end, with u = u_0 + D f for the other forces as they are and D = (n, t)^T M^-1 (n, t): no
 * force where u_0 opens; the one that stops it, where that is within the cone; else the edge of
 * the cone that stops u_n, by the side on which that force lies. A side of a pair of corners bears
 * nothing where the other one opens. The end of a contact that bears at both of its ends has no
 * friction from the part of its force that its bond asks for: it need not pull there. */

#include "contact_modes/letting_go.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double still = 1e-7; /* of gravity, or of the largest velocity */

/* What a unit of n or t at an end does to both blocks, and D. What every round reads of each end
 * comes first, and in one place, for speed. */
typedef struct end {
  long row[2];          /* of ground the one behind all others, which stays at rest */
  double along_n[2][3]; /* the entries of both rows */
  double along_t[2][3];
  double nn, nt, tt, per_volume; /* 1 / (nn tt - nt^2) */
  double n[2][3], t[2][3];
  const tp_force_column *normal, *along;
  double twin_n, twin_t; /* u_n of the twin by a unit of n, of t */
  long twin;             /* of a pair of corners: the other side's end; -1 */
  long corner; /* else: the first side's end of a pair in its point, of one of its blocks; -1 */
} end;

tp_status tp_letting_go_init(tp_letting_go *s, const tp_resting *r, tp_message *message) {
  *s = (tp_letting_go){.resting = r};
  s->accelerations = calloc((size_t)r->rows + 3, sizeof *s->accelerations);
  s->normals = calloc(2 * (size_t)r->contact_count + 1, sizeof *s->normals);
  s->shears = calloc(2 * (size_t)r->contact_count + 1, sizeof *s->shears);
  if (s->accelerations != NULL && s->normals != NULL && s->shears != NULL) return TP_OK;
  tp_letting_go_clear(s);
  return tp_fail_memory(message, "the motions");
}

void tp_letting_go_clear(tp_letting_go *s) {
  free(s->accelerations);
  free(s->normals);
  free(s->shears);
  memset(s, 0, sizeof *s);
}

void tp_letting_go_release(tp_letting_go *s) {
  const size_t ends = 2 * (size_t)s->resting->contact_count;
  memset(s->normals, 0, ends * sizeof *s->normals);
  memset(s->shears, 0, ends * sizeof *s->shears);
}

void tp_letting_go_copy(tp_letting_go *own, const tp_letting_go *from) {
  const size_t ends = 2 * (size_t)own->resting->contact_count;
  memcpy(own->normals, from->normals, ends * sizeof *own->normals);
  memcpy(own->shears, from->shears, ends * sizeof *own->shears);
}

static void push(double own[3], const tp_resting *r, const tp_force_column *c, int side) {
  double wrench[3];
  for (int e = 0; e < 3; e++) wrench[e] = c->entry[side][e].value;
  tp_resting_accelerate_double(own, r->assemblage->blocks + r->block[c->row[side] / 3], wrench);
}

static double power(const tp_force_column *c, double y[2][3]) {
  double sum = 0;
  for (int side = 0; side < 2; side++) {
    for (int e = 0; e < 3 && c->row[side] >= 0; e++) sum += c->entry[side][e].value * y[side][e];
  }
  return sum;
}

static long corner_at(const tp_resting *r, const tp_resting_contact *c, long point) {
  for (long k = r->pair_first; k < r->contact_count; k += 2) {
    const tp_block_contact *own = &r->contacts[k].of;
    const bool shares = own->block[0] == c->of.block[0] || own->block[1] == c->of.block[1] ||
                        own->block[0] == c->of.block[1] || own->block[1] == c->of.block[0];
    if (shares && tp_lattice_same_point(&r->assemblage->lattice, own->ends[0], point)) return 2 * k;
  }
  return -1;
}

static void set_end(end *own, const tp_resting *r, const tp_resting_contact *c, int which) {
  own->twin = c->twin < 0 ? -1 : 2 * c->twin;
  own->corner = c->twin < 0 ? corner_at(r, c, c->of.ends[which]) : -1;
  own->normal = c->normal + which;
  own->along = &c->along;
  for (int side = 0; side < 2; side++) {
    const bool is_ground = c->along.row[side] < 0;
    own->row[side] = is_ground ? r->rows : c->along.row[side];
    for (int e = 0; e < 3 && !is_ground; e++) {
      own->along_n[side][e] = own->normal->entry[side][e].value;
      own->along_t[side][e] = own->along->entry[side][e].value;
    }
    if (is_ground) continue;
    push(own->n[side], r, own->normal, side);
    push(own->t[side], r, own->along, side);
  }
  own->nn = power(own->normal, own->n);
  own->nt = power(own->normal, own->t);
  own->tt = power(own->along, own->t);
  own->per_volume = 1 / (own->nn * own->tt - own->nt * own->nt);
}

/* Both sides of a pair are of the same blocks, in one order or the other. */
static void set_twin(end *ends, long at) {
  end *own = ends + at;
  const end *twin = ends + own->twin;
  own->twin_n = own->twin_t = 0;
  for (int side = 0; side < 2; side++) {
    const int other = twin->row[side] == own->row[side] ? side : 1 - side;
    for (int e = 0; e < 3; e++) {
      own->twin_n += twin->along_n[other][e] * own->n[side][e];
      own->twin_t += twin->along_n[other][e] * own->t[side][e];
    }
  }
}

static void accelerate(tp_letting_go *s, const end *own, double normal, double shear) {
  for (int side = 0; side < 2; side++) {
    double *a = s->accelerations + own->row[side];
    for (int e = 0; e < 3; e++) a[e] += normal * own->n[side][e] + shear * own->t[side][e];
  }
}

/* u_n, or u_t, as it is. */
static double velocity(const tp_letting_go *s, const end *own, const double along[2][3]) {
  const double *a = s->accelerations + own->row[0], *b = s->accelerations + own->row[1];
  return (along[0][0] * a[0] + along[0][1] * a[1] + along[0][2] * a[2]) +
         (along[1][0] * b[0] + along[1][1] * b[1] + along[1][2] * b[2]);
}

/* Does the other side of a pair of corners bear, or is it to, as asked for? Else does that open
 * without the force of this one, or more than it? `opens` is u_n of this one without its force. */
static bool is_kept_apart(const tp_letting_go *s, const end *ends, long at, double opens) {
  const end *own = ends + at;
  if (own->twin < 0) return false;
  if (s->corners == TP_CORNERS_FIRST_SIDE) return own->twin < at;
  if (s->corners == TP_CORNERS_SECOND_SIDE) return own->twin > at;
  if (s->normals[own->twin] > 0) return true;
  const end *twin = ends + own->twin;
  const double twin_opens =
      velocity(s, twin, twin->along_n) - own->twin_n * s->normals[at] - own->twin_t * s->shears[at];
  return twin_opens >= 0 || twin_opens > opens;
}

/* What an end has for shear: as much as `friction` of its normal force above `pull`, and
 * `cohesion`.
 */
typedef struct shear_law {
  double friction, cohesion, pull;
} shear_law;

static double most_shear(const shear_law *law, double normal) {
  return law->friction * (normal > law->pull ? normal - law->pull : 0) + law->cohesion;
}

/* The force that stops u_n and is all of the shear to one side, 1 or -1. */
static void slip(double *normal, double *shear, const end *at, const shear_law *law, double un,
                 int sign) {
  const double edge = sign * law->friction, bound = sign * law->cohesion - edge * law->pull;
  const double stiff = at->nn + edge * at->nt, rest = -un - bound * at->nt;
  *normal = stiff > 0 && rest > 0 ? rest / stiff : 0;
  *shear = edge * *normal + (*normal > 0 ? bound : 0);
  if (*normal >= law->pull) return;
  const double free = -un - sign * law->cohesion * at->nt;
  *normal = free > 0 ? fmin(free / at->nn, law->pull) : 0;
  *shear = *normal > 0 ? sign * law->cohesion : 0;
}

/* The force of an end by its law; how far that is from the one it had, as a velocity. An end that
 * bears nothing and opens stays so. */
static double give(tp_letting_go *s, const end *ends, long at, const shear_law *law) {
  const end *own = ends + at;
  const double n = s->normals[at], t = s->shears[at];
  double un = velocity(s, own, own->along_n);
  if (n == 0 && t == 0 && un >= 0) return 0;
  double normal = 0, shear = 0;
  un -= own->nn * n + own->nt * t;
  if (un < 0 && !is_kept_apart(s, ends, at, un)) {
    const double ut = velocity(s, own, own->along_t) - (own->nt * n + own->tt * t);
    normal = (own->nt * ut - own->tt * un) * own->per_volume;
    shear = (own->nt * un - own->nn * ut) * own->per_volume;
    if (!(fabs(shear) <= most_shear(law, normal))) {
      slip(&normal, &shear, own, law, un, shear > 0 ? 1 : -1);
    }
  }
  if (normal == n && shear == t) return 0;
  accelerate(s, own, normal - n, shear - t);
  s->normals[at] = normal;
  s->shears[at] = shear;
  return fabs(normal - n) * own->nn + fabs(shear - t) * own->tt;
}

static void begin(tp_letting_go *s, const end *ends, const tp_near *loads) {
  const tp_resting *r = s->resting;
  for (long b = 0; b < r->rows / 3; b++) {
    double wrench[3];
    for (int e = 0; e < 3; e++) wrench[e] = loads[3 * b + e].value;
    tp_resting_accelerate_double(s->accelerations + 3 * b, r->assemblage->blocks + r->block[b],
                                 wrench);
  }
  for (long k = 0; k < 2 * r->contact_count; k++) {
    if (ends[k].normal != NULL) accelerate(s, ends + k, s->normals[k], s->shears[k]);
  }
}

static void find_most(tp_letting_go *s, const end *ends) {
  s->most = 0;
  for (long k = 0; k < 2 * s->resting->contact_count; k++) {
    if (ends[k].normal == NULL) continue;
    const double n = tp_resting_along_double(ends[k].normal, s->accelerations);
    const double t = tp_resting_along_double(ends[k].along, s->accelerations);
    s->most = fmax(s->most, hypot(n, t));
  }
}

/* Its share of the cohesion: all of it where the other end is open. */
static double cohesion_at(const tp_letting_go *s, const tp_shear_strength *strength, long at) {
  if (strength == NULL || strength->cohesion[at / 2].value == 0) return 0;
  return strength->cohesion[at / 2].value * (s->normals[at ^ 1] > 0 ? 0.5 : 1);
}

/* The part of its force that a bond may do without, where both ends bear. */
static double pull_at(const tp_letting_go *s, const tp_shear_strength *strength, long at) {
  if (strength->bond == NULL || !(s->normals[at ^ 1] > 0)) return 0;
  return strength->bond[at].value;
}

static shear_law law_at(const tp_letting_go *s, const tp_shear_strength *strength, long at) {
  if (strength == NULL) return (shear_law){0, 0, 0};
  return (shear_law){strength->friction[at / 2].value, cohesion_at(s, strength, at),
                     pull_at(s, strength, at)};
}

/* One round over all ends; how far forces were from their laws, as a velocity. */
static double go_round(tp_letting_go *s, const end *ends, const tp_shear_strength *strength) {
  const long count = 2 * s->resting->contact_count;
  double change = 0;
  for (long k = 0; k < count; k++) {
    const long at = s->backwards ? count - 1 - k : k;
    if (ends[at].normal == NULL) continue;
    const long corner = s->corners != TP_CORNERS_AS_THEY_OPEN ? ends[at].corner : -1;
    for (int side = 0; side < 2 && corner >= 0; side++) {
      const long other = side == 0 ? corner : ends[corner].twin;
      const shear_law of = {strength == NULL ? 0 : strength->friction[other / 2].value, 0, 0};
      give(s, ends, other, &of);
    }
    const shear_law law = law_at(s, strength, at);
    const double moved = give(s, ends, at, &law);
    if (moved > change) change = moved; /* fmax is a call, in the innermost loop of all */
  }
  return change;
}

/* Forces a little farther along the way that the last round took, and what they were before that.
 */
static void lead(tp_letting_go *s, const end *ends, double *before, double share) {
  const long count = 2 * s->resting->contact_count;
  for (long k = 0; k < count; k++) {
    const double n = s->normals[k], t = s->shears[k];
    const double normal = share * (n - before[k]), shear = share * (t - before[count + k]);
    before[k] = n;
    before[count + k] = t;
    if (normal == 0 && shear == 0) continue;
    accelerate(s, ends + k, normal, shear);
    s->normals[k] += normal;
    s->shears[k] += shear;
  }
}

/* Rounds with momentum (Nesterov's), which begins anew where they do not come nearer. Where what is
 * left, over so many of them, is not half of what it was before, they go in circles. */
static void settle(tp_letting_go *s, const end *ends, double *before,
                   const tp_shear_strength *strength, long rounds) {
  static const double enough = 1e-13;
  enum { CIRCLE = 600 };
  double change = INFINITY, pace = 1, sum = 0, mark = INFINITY;
  lead(s, ends, before, 0);
  for (long round = 0; round < rounds && change > enough; round++) {
    const double own = go_round(s, ends, strength);
    const bool alone = own > change || round < rounds / 8;
    const double next = alone ? 1 : (1 + sqrt(1 + 4 * pace * pace)) / 2;
    lead(s, ends, before, alone ? 0 : (pace - 1) / next);
    pace = next;
    change = own;
    sum += own;
    if ((round + 1) % CIRCLE != 0) continue;
    if (sum > mark / 2) break;
    mark = sum;
    sum = 0;
  }
}

/* Ends beside a corner that bears leave all to it: which of both bears how much is undetermined. */
static void leave_to_corners(tp_letting_go *s, const end *ends) {
  for (long k = 0; k < 2 * s->resting->contact_count; k++) {
    if (s->corners == TP_CORNERS_AS_THEY_OPEN || ends[k].normal == NULL || ends[k].corner < 0) {
      continue;
    }
    const double first = s->normals[ends[k].corner], second = s->normals[ends[ends[k].corner].twin];
    if (s->normals[k] < fmax(first, second)) s->normals[k] = s->shears[k] = 0;
  }
}

bool tp_letting_go_find(tp_letting_go *s, const tp_shear_strength *strength, const tp_near *loads,
                        long rounds) {
  const tp_resting *r = s->resting;
  end *ends = calloc(2 * (size_t)r->contact_count + 1, sizeof *ends);
  double *before = calloc(4 * (size_t)r->contact_count + 1, sizeof *before);
  if (ends == NULL || before == NULL) {
    free(ends);
    free(before);
    return false;
  }
  for (long k = 0; k < r->contact_count; k++) {
    for (int e = 0; e < r->contacts[k].ends; e++) set_end(ends + 2 * k + e, r, r->contacts + k, e);
  }
  for (long k = r->pair_first; k < r->contact_count; k++) set_twin(ends, 2 * k);
  begin(s, ends, loads);
  settle(s, ends, before, strength, rounds);
  begin(s, ends, loads); /* once more, without the roundings of so many steps */
  find_most(s, ends);
  leave_to_corners(s, ends);
  free(ends);
  free(before);
  return true;
}

bool tp_letting_go_moves(const tp_letting_go *s) {
  return s->most > still;
}

void tp_letting_go_modes(tp_mode_set *modes, const tp_letting_go *s,
                         const tp_shear_strength *strength) {
  static const double within = 1e-6;
  const tp_resting *r = s->resting;
  const double nothing = 100 * still * s->most;
  for (long k = 0; k < r->contact_count; k++) {
    const tp_resting_contact *c = r->contacts + k;
    bool closed[2] = {false, false}, grips = false;
    for (int e = 0; e < c->ends; e++) {
      const double n = s->normals[2 * k + e];
      const shear_law law = law_at(s, strength, 2 * k + e);
      const double most = most_shear(&law, n);
      closed[e] = tp_resting_along_double(c->normal + e, s->accelerations) <= nothing &&
                  (c->twin < 0 || n > 0);
      grips = grips || (closed[e] && fabs(s->shears[2 * k + e]) < (1 - within) * most);
    }
    const double slip = tp_resting_along_double(&c->along, s->accelerations);
    const bool sticks = fabs(slip) <= nothing || (grips && fabs(slip) <= 1000 * nothing);
    modes[k] = !closed[0] && !closed[1] ? TP_MODES_OPEN
                                        : tp_mode_of(closed[0], closed[1],
                                                     sticks     ? TP_MODE_STICKS
                                                     : slip > 0 ? TP_MODE_FORWARD
                                                                : TP_MODE_BACK);
  }
}
