/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Angle of the first new contact: of the pairs that doubles leave, the exact roots (top + sqrt(D))
 * / bottom are compared by signs of surds (number/surd.h), and the least is kept. */

#include "rest/turning.h"

#include "common/message.h"
#include "number/surd.h"

#include <arb.h>
#include <math.h>
#include <string.h>

void tp_turning_init(tp_turning *turning, const tp_bodies *bodies, const tp_touch *about,
                     int turn) {
  memset(turning, 0, sizeof *turning);
  tp_exact_point_init(&turning->pivot);
  tp_exact_point_init(&turning->own);
  fmpq_init(turning->top);
  fmpq_init(turning->radicand);
  fmpq_init(turning->bottom);
  turning->about = *about;
  turning->turn = turn;
  const tp_exact_point pivot = tp_touch_point(bodies, about);
  fmpq_set(&turning->pivot.x, &pivot.x);
  fmpq_set(&turning->pivot.y, &pivot.y);
  if (about->on_block_edge) {
    tp_pose_undo(&turning->own.x, &turning->own.y, &bodies->pose, &pivot.x, &pivot.y);
  } else {
    fmpq_set(&turning->own.x, bodies->own.x + about->block);
    fmpq_set(&turning->own.y, bodies->own.y + about->block);
  }
}

void tp_turning_clear(tp_turning *turning) {
  tp_exact_point_clear(&turning->pivot);
  tp_exact_point_clear(&turning->own);
  fmpq_clear(turning->top);
  fmpq_clear(turning->radicand);
  fmpq_clear(turning->bottom);
  tp_candidates_clear(&turning->pairs);
}

/* Sign of rational + factor sqrt(radicand). */
static int surd_sign(const fmpq_t rational, const fmpq_t factor, const fmpq_t radicand) {
  tp_surd surd;
  fmpq_t share;
  fmpz_t product;
  tp_surd_init(&surd);
  fmpq_init(share);
  fmpz_init(product);
  fmpq_set(surd.c, rational);
  fmpz_mul(product, fmpq_numref(radicand), fmpq_denref(radicand));
  fmpq_div_fmpz(share, factor, fmpq_denref(radicand));
  if (!fmpz_is_zero(product) && !fmpq_is_zero(share)) tp_surd_add_root(&surd, share, product);
  const int sign = tp_surd_sign(&surd);
  tp_surd_clear(&surd);
  fmpq_clear(share);
  fmpz_clear(product);
  return sign;
}

/* Sign of p t^2 + q t + w at t = (top + sqrt(D)) / bottom, by that of
 *     p (top^2 + D) + q top bottom + w bottom^2 + (2 p top + q bottom) sqrt(D). */
static int sign_at(const fmpq_t p, const fmpq_t q, const fmpq_t w, const fmpq_t top,
                   const fmpq_t radicand, const fmpq_t bottom) {
  fmpq_t rational, factor, part;
  fmpq_init(rational);
  fmpq_init(factor);
  fmpq_init(part);
  fmpq_mul(rational, top, top);
  fmpq_add(rational, rational, radicand);
  fmpq_mul(rational, rational, p);
  fmpq_mul(part, q, bottom);
  fmpq_addmul(rational, part, top);
  fmpq_mul(factor, p, top);
  fmpq_mul_si(factor, factor, 2);
  fmpq_add(factor, factor, part);
  fmpq_mul(part, bottom, bottom);
  fmpq_addmul(rational, part, w);
  const int sign = surd_sign(rational, factor, radicand);
  fmpq_clear(rational);
  fmpq_clear(factor);
  fmpq_clear(part);
  return sign;
}

/* The root at which the pair goes in. False: there is none, or not after the start. */
static bool root_of(fmpq_t top, fmpq_t radicand, fmpq_t bottom, const tp_turning_numbers *n) {
  fmpq_mul(radicand, n->a, n->a);
  fmpq_submul(radicand, n->d, n->d);
  fmpq_add(bottom, n->a, n->d);
  fmpq_set(top, n->b);
  const int past = fmpq_sgn(radicand); /* of A^2 - d^2 */
  fmpq_addmul(radicand, n->b, n->b);
  if (fmpq_sgn(radicand) <= 0) return false;
  if (fmpq_is_zero(bottom)) { /* one root, -A / B, where it falls */
    fmpq_neg(top, n->a);
    fmpq_set(bottom, n->b);
    fmpq_zero(radicand);
    return fmpq_sgn(n->b) < 0 && fmpq_sgn(n->a) > 0;
  }
  const int sign = fmpq_sgn(n->b) > 0 ? 1 : past; /* of B + sqrt(B^2 + A^2 - d^2) */
  return sign * fmpq_sgn(bottom) > 0;
}

static bool lies_on_edge(const tp_turning_numbers *n, const fmpq_t top, const fmpq_t radicand,
                         const fmpq_t bottom) {
  fmpq_t p, q, w;
  fmpq_init(p);
  fmpq_init(q);
  fmpq_init(w);
  fmpq_add(p, n->c, n->g);
  fmpq_neg(p, p);
  fmpq_mul_si(q, n->s, 2);
  fmpq_sub(w, n->c, n->g);
  bool lies = sign_at(p, q, w, top, radicand, bottom) >= 0;
  fmpq_sub(p, n->square, p);
  fmpq_neg(q, q);
  fmpq_sub(w, n->square, w);
  lies = lies && sign_at(p, q, w, top, radicand, bottom) >= 0;
  fmpq_clear(p);
  fmpq_clear(q);
  fmpq_clear(w);
  return lies;
}

/* Order of (top + sqrt(radicand)) / bottom and the turning's own root. */
static int compare_roots(const fmpq_t top, const fmpq_t radicand, const fmpq_t bottom,
                         const tp_turning *turning) {
  tp_surd surd;
  fmpq_t share;
  fmpz_t product;
  tp_surd_init(&surd);
  fmpq_init(share);
  fmpz_init(product);
  fmpq_div(surd.c, top, bottom);
  fmpq_div(share, turning->top, turning->bottom);
  fmpq_sub(surd.c, surd.c, share);
  for (int k = 0; k < 2; k++) {
    const fmpq *own = k == 0 ? radicand : turning->radicand;
    if (fmpq_is_zero(own)) continue;
    fmpz_mul(product, fmpq_numref(own), fmpq_denref(own));
    fmpq_mul_fmpz(share, k == 0 ? bottom : turning->bottom, fmpq_denref(own));
    fmpq_inv(share, share);
    if (k == 1) fmpq_neg(share, share);
    tp_surd_add_root(&surd, share, product);
  }
  const int sign = tp_surd_sign(&surd);
  tp_surd_clear(&surd);
  fmpq_clear(share);
  fmpz_clear(product);
  return sign;
}

/* Is the centroid still on its side of P when they touch? */
static bool centroid_is_over(const tp_turning *turning, const tp_bodies *bodies) {
  fmpq_t p, q, w;
  fmpq_init(p);
  fmpq_init(q);
  fmpq_init(w);
  fmpq_sub(w, &bodies->centroid.x, &turning->pivot.x);
  fmpq_neg(p, w);
  fmpq_sub(q, &bodies->centroid.y, &turning->pivot.y);
  fmpq_mul_si(q, q, -2 * turning->turn);
  const int side = sign_at(p, q, w, turning->top, turning->radicand, turning->bottom);
  fmpq_clear(p);
  fmpq_clear(q);
  fmpq_clear(w);
  return side == -turning->turn;
}

/* What lies in P stays there. */
static bool stays(const tp_turning *turning, const tp_candidate *pair) {
  const tp_touch *about = &turning->about;
  return pair->of_base ? !about->on_base_edge && pair->vertex == about->base
                       : !about->on_block_edge && pair->vertex == about->block;
}

/* The exact stage: of the candidates those that touch first. Doubles with bounds tell most orders,
 * and that most vertices meet their edges. */
static void keep_first(tp_turning *turning, const tp_bodies *bodies) {
  tp_turning_numbers n;
  fmpq_t top, radicand, bottom;
  tp_turning_numbers_init(&n);
  fmpq_init(top);
  fmpq_init(radicand);
  fmpq_init(bottom);
  long kept = 0;
  for (long k = 0; k < turning->pairs.count; k++) {
    const tp_candidate pair = turning->pairs.items[k];
    const tp_candidate *first = turning->pairs.items;
    if (stays(turning, &pair) || (kept > 0 && pair.low > first->high)) continue;
    tp_turning_numbers_of(&n, bodies, turning, &pair);
    if (!root_of(top, radicand, bottom, &n)) continue;
    const int order =
        kept == 0 || pair.high < first->low ? -1 : compare_roots(top, radicand, bottom, turning);
    if (order > 0 || !(pair.certain || lies_on_edge(&n, top, radicand, bottom))) continue;
    if (order < 0) {
      kept = 0;
      fmpq_swap(turning->top, top);
      fmpq_swap(turning->radicand, radicand);
      fmpq_swap(turning->bottom, bottom);
    }
    turning->pairs.items[kept] = pair;
    if (fmpq_is_zero(n.d)) { /* an edge on an edge: taken as the exact one first */
      turning->pairs.items[kept] = turning->pairs.items[0];
      turning->pairs.items[0] = pair;
    }
    kept++;
  }
  turning->pairs.count = kept;
  tp_turning_numbers_clear(&n);
  fmpq_clear(top);
  fmpq_clear(radicand);
  fmpq_clear(bottom);
}

/* Do the pairs that touch first do so by tan(phi / 2) = limit? */
static bool is_within(const tp_turning *turning, double limit) {
  if (turning->pairs.items[0].high <= limit) return true;
  fmpq_t p, q, w;
  arf_t exact;
  fmpq_init(p);
  fmpq_init(q);
  fmpq_init(w);
  arf_init(exact);
  arf_set_d(exact, -limit);
  arf_get_fmpq(w, exact);
  fmpq_one(q);
  const bool within = sign_at(p, q, w, turning->top, turning->radicand, turning->bottom) <= 0;
  fmpq_clear(p);
  fmpq_clear(q);
  fmpq_clear(w);
  arf_clear(exact);
  return within;
}

/* Small turns first, since what can touch within one lies close to it. */
tp_status tp_turning_find(tp_turning *turning, const tp_bodies *bodies, tp_message *message) {
  static const double first_limit = 0x1p-10, growth = 4, last_limit = 0x1p4;
  double passes, latest; /* under P: not before the one, by the other */
  tp_turning_latest(&passes, &latest, turning, bodies);
  bool found = false;
  for (double limit = first_limit; !found; limit *= growth) {
    const bool is_last = !(limit < fmin(latest, last_limit));
    if (is_last) limit = latest;
    if (!tp_turning_candidates(turning, bodies, limit)) {
      return tp_fail_memory(message, "the points of contact");
    }
    if (!is_last && turning->pairs.best >= limit && !turning->is_close) continue;
    keep_first(turning, bodies);
    found = is_last || (turning->pairs.count > 0 && is_within(turning, limit));
  }
  if (turning->pairs.count > 0 && turning->pairs.items[0].high >= passes &&
      !centroid_is_over(turning, bodies)) {
    turning->pairs.count = 0;
  }
  return TP_OK;
}
