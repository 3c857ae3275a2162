/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contacts of one normal in one plane, and the corners of their convex hull there: by the monotone
 * chain of Andrew (1979) over both coordinates that the plane is not steepest in. */

#include "ground/ground_contacts.h"

#include <stdlib.h>
#include <string.h>

typedef struct spot {
  tp_ground_contact *contact;
  fmpq offset; /* normal . at: of its plane */
  int axes[2]; /* that the plane is seen by */
} spot;

/* ---- the order ---------------------------------------------------------------------------------
 */

static void set_spot(spot *s, tp_ground_contact *contact) {
  fmpq_t own;
  fmpq_init(own);
  fmpq_init(&s->offset);
  s->contact = contact;
  int steepest = 0;
  for (int k = 0; k < 3; k++) {
    const fmpz *normal = contact->normal.at;
    fmpq_mul_fmpz(own, contact->at + k, normal + k);
    fmpq_add(&s->offset, &s->offset, own);
    if (fmpz_cmpabs(normal + k, normal + steepest) > 0) steepest = k;
  }
  s->axes[0] = (steepest + 1) % 3;
  s->axes[1] = (steepest + 2) % 3;
  fmpq_clear(own);
}

static int compare_planes(const spot *a, const spot *b) {
  for (int k = 0; k < 3; k++) {
    const int order = fmpz_cmp(a->contact->normal.at + k, b->contact->normal.at + k);
    if (order != 0) return order;
  }
  return fmpq_cmp(&a->offset, &b->offset);
}

static int compare(const void *one, const void *other) {
  const spot *a = one, *b = other;
  const int order = compare_planes(a, b);
  if (order != 0) return order;
  for (int k = 0; k < 2; k++) {
    const int along = fmpq_cmp(a->contact->at + a->axes[k], b->contact->at + a->axes[k]);
    if (along != 0) return along;
  }
  return 0;
}

/* ---- hulls -------------------------------------------------------------------------------------
 */

/* Does the way from p by q to r turn left, in the plane? */
static bool turns_left(const spot *p, const spot *q, const spot *r) {
  fmpq way[4], one, other;
  const int *axes = p->axes;
  fmpq_init(&one);
  fmpq_init(&other);
  for (int k = 0; k < 4; k++) fmpq_init(way + k);
  for (int k = 0; k < 2; k++) {
    fmpq_sub(way + k, q->contact->at + axes[k], p->contact->at + axes[k]);
    fmpq_sub(way + 2 + k, r->contact->at + axes[k], p->contact->at + axes[k]);
  }
  fmpq_mul(&one, way, way + 3);
  fmpq_mul(&other, way + 1, way + 2);
  const bool left = fmpq_cmp(&one, &other) > 0;
  for (int k = 0; k < 4; k++) fmpq_clear(way + k);
  fmpq_clear(&one);
  fmpq_clear(&other);
  return left;
}

static long push(long *chain, long count, long least, const spot *spots, long next) {
  while (count >= least + 2 &&
         !turns_left(spots + chain[count - 2], spots + chain[count - 1], spots + next)) {
    count--;
  }
  chain[count] = next;
  return count + 1;
}

/* Marks corners of the hull of spots low … high - 1, which are in order and all different. */
static void mark_hull(bool *kept, long *chain, const spot *spots, long low, long high) {
  long count = 0;
  for (long k = low; k < high; k++) count = push(chain, count, 0, spots, k);
  const long upper = count - 1;
  for (long k = high - 2; k >= low; k--) count = push(chain, count, upper, spots, k);
  for (long k = 0; k < count; k++) kept[chain[k]] = true;
}

static long drop_equal(spot *spots, long count) {
  long left = 0;
  for (long k = 0; k < count; k++) {
    if (left > 0 && compare(spots + left - 1, spots + k) == 0) {
      fmpq_clear(&spots[k].offset);
    } else {
      spots[left++] = spots[k];
    }
  }
  return left;
}

static void mark_all(bool *kept, long *chain, const spot *spots, long count) {
  for (long low = 0, high = 0; low < count; low = high) {
    while (high < count && compare_planes(spots + low, spots + high) == 0) high++;
    mark_hull(kept, chain, spots, low, high);
  }
}

/* ---- all ---------------------------------------------------------------------------------------
 */

/* Those that are kept, in the order of the spots; all others are cleared. */
static void keep(tp_ground_contacts *c, tp_ground_contact *room, const spot *spots, long count,
                 const bool *kept) {
  long left = 0;
  for (long k = 0; k < count; k++) {
    if (!kept[k]) continue;
    room[left++] = *spots[k].contact;
    memset(spots[k].contact, 0, sizeof *spots[k].contact);
  }
  for (long k = 0; k < c->count; k++) {
    tp_whole_clear(&c->items[k].normal);
    for (int axis = 0; axis < 3; axis++) fmpq_clear(c->items[k].at + axis); /* zeros: nothing */
  }
  memcpy(c->items, room, (size_t)left * sizeof *room);
  c->count = left;
}

bool tp_ground_contacts_reduce(tp_ground_contacts *c) {
  const size_t count = (size_t)c->count;
  if (count == 0) return true;
  spot *spots = malloc(count * sizeof *spots);
  long *chain = malloc((2 * count + 1) * sizeof *chain);
  bool *kept = calloc(count, sizeof *kept);
  tp_ground_contact *room = malloc(count * sizeof *room);
  const bool done = spots != NULL && chain != NULL && kept != NULL && room != NULL;
  if (done) {
    for (long k = 0; k < c->count; k++) set_spot(spots + k, c->items + k);
    qsort(spots, count, sizeof *spots, compare);
    const long left = drop_equal(spots, c->count);
    mark_all(kept, chain, spots, left);
    keep(c, room, spots, left, kept);
    for (long k = 0; k < left; k++) fmpq_clear(&spots[k].offset);
  }
  free(spots);
  free(chain);
  free(kept);
  free(room);
  return done;
}
