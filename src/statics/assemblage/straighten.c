/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A joint that crosses others is cut into pieces. Where their corners are rounded these pieces bend
 * by some 1e-19, and joints of one set no longer are parallel: a block between them could not slide
 * at all. Two directions whose ends are off by e each are parallel where
 *
 *     |d x d'| <= e (|d| + |d'|);
 *
 * they are sorted by their angle, and of those within that of the longest, all take its direction:
 * the one that roundings turn least. What they mean is then blocks whose corners are off by no more
 * than they were. */

#include "assemblage/assemblage.h"

#include "common/message.h"

#include <math.h>
#include <stdlib.h>

enum { ROUNDED_BITS = 62 }; /* corners are off by less than 2^-62 of the largest coordinate */

typedef struct direction {
  tp_block_contact *contact;
  long order;
  double x, y, length; /* lattice steps */
  double angle;        /* of its line, from about 0 to pi */
} direction;

static const double apart = 1e-12; /* of angles: far beyond what roundings make */

static double steps(const fmpz *from, const fmpz *to) {
  fmpz_t difference;
  fmpz_init(difference);
  fmpz_sub(difference, to, from);
  const double own = fmpz_get_d(difference);
  fmpz_clear(difference);
  return own;
}

/* Contacts first, then both sides of each pair of corners. */
static tp_block_contact *contact_of(const tp_assemblage *a, long order) {
  const long pair = order - a->contact_count;
  return pair < 0 ? a->contacts + order : a->pairs[pair / 2].side + pair % 2;
}

static direction direction_of(const tp_assemblage *a, long order) {
  const double pi = acos(-1);
  tp_block_contact *c = contact_of(a, order);
  direction own = {.contact = c,
                   .order = order,
                   .x = steps(a->lattice.x + c->from, a->lattice.x + c->to),
                   .y = steps(a->lattice.y + c->from, a->lattice.y + c->to)};
  own.length = hypot(own.x, own.y);
  own.angle = atan2(own.y, own.x);
  if (own.angle < 0) own.angle += pi;
  if (own.angle > pi - apart / 2) own.angle -= pi;
  return own;
}

static int compare(const void *first, const void *second) {
  const direction *a = first, *b = second;
  if (a->angle != b->angle) return a->angle < b->angle ? -1 : 1;
  return (a->order > b->order) - (a->order < b->order);
}

static bool is_parallel(const tp_assemblage *a, const direction *p, const direction *q) {
  const tp_lattice *l = &a->lattice;
  const tp_block_contact *c = p->contact, *d = q->contact;
  fmpz_t x, y, cross;
  fmpz_init(x);
  fmpz_init(y);
  fmpz_init(cross);
  fmpz_sub(x, l->x + c->to, l->x + c->from);
  fmpz_sub(y, l->y + d->to, l->y + d->from);
  fmpz_mul(cross, x, y);
  fmpz_sub(x, l->x + d->to, l->x + d->from);
  fmpz_sub(y, l->y + c->to, l->y + c->from);
  fmpz_submul(cross, x, y);
  const double rounded = ldexp(1, (int)(l->bits - ROUNDED_BITS));
  const bool own = fabs(fmpz_get_d(cross)) <= rounded * (p->length + q->length);
  fmpz_clear(x);
  fmpz_clear(y);
  fmpz_clear(cross);
  return own;
}

/* Each keeps its own side to the left. */
static void take(const direction *own, const direction *longest) {
  const tp_block_contact *from = longest->contact;
  const bool same = own->x * longest->x + own->y * longest->y > 0;
  tp_block_contact *c = own->contact;
  c->along[0] = same ? from->from : from->to;
  c->along[1] = same ? from->to : from->from;
}

static void straighten(const tp_assemblage *a, const direction *first, const direction *end) {
  const direction *longest = first;
  for (const direction *d = first; d < end; d++) {
    if (d->length > longest->length) longest = d;
  }
  for (const direction *d = first; d < end; d++) {
    if (d != longest && is_parallel(a, d, longest)) take(d, longest);
  }
}

tp_status tp_assemblage_straighten(tp_assemblage *a, tp_message *message) {
  const long count = a->contact_count + 2 * a->pair_count;
  direction *all = calloc((size_t)count + 1, sizeof *all);
  if (all == NULL) return tp_fail_memory(message, "the contacts");
  for (long k = 0; k < count; k++) all[k] = direction_of(a, k);
  qsort(all, (size_t)count, sizeof *all, compare);
  for (long k = 0; k < count;) {
    long end = k + 1;
    while (end < count && all[end].angle - all[end - 1].angle <= apart) end++;
    straighten(a, all + k, all + end);
    k = end;
  }
  free(all);
  return TP_OK;
}
