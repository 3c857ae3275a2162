/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sorts facets by direction in lowest terms and offset, exactly, and gives each the first facet of
 * its straight line. */

#include "stability/limit_lines.h"

#include <stdlib.h>

/* A facet's direction in lowest terms, and direction x position: the same for all on one line. */
typedef struct entry {
  fmpz dx, dy, offset;
  long facet;
} entry;

static void entry_init(entry *e, const tp_lattice *l, const tp_facet *f, long facet) {
  fmpz_t divisor;
  fmpz_init(divisor);
  fmpz_init(&e->dx);
  fmpz_init(&e->dy);
  fmpz_init(&e->offset);
  fmpz_sub(&e->dx, l->x + f->t1, l->x + f->t0);
  fmpz_sub(&e->dy, l->y + f->t1, l->y + f->t0);
  fmpz_gcd(divisor, &e->dx, &e->dy);
  fmpz_divexact(&e->dx, &e->dx, divisor);
  fmpz_divexact(&e->dy, &e->dy, divisor);
  fmpz_mul(&e->offset, &e->dx, l->y + f->t0);
  fmpz_submul(&e->offset, &e->dy, l->x + f->t0);
  e->facet = facet;
  fmpz_clear(divisor);
}

static void entry_clear(entry *e) {
  fmpz_clear(&e->dx);
  fmpz_clear(&e->dy);
  fmpz_clear(&e->offset);
}

static int compare_lines(const entry *a, const entry *b) {
  int order = fmpz_cmp(&a->dx, &b->dx);
  if (order == 0) order = fmpz_cmp(&a->dy, &b->dy);
  return order != 0 ? order : fmpz_cmp(&a->offset, &b->offset);
}

static int compare(const void *first, const void *second) {
  const entry *a = first, *b = second;
  const int order = compare_lines(a, b);
  return order != 0 ? order : (a->facet > b->facet) - (a->facet < b->facet);
}

bool tp_limit_lines_find(long *first, const tp_problem *problem) {
  const tp_contact *contact = &problem->contact;
  entry *entries = calloc((size_t)contact->facet_count + 1, sizeof *entries);
  if (entries == NULL) return false;
  long count = 0;
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *f = contact->facets + k;
    first[k] = k;
    if (f->q0 != f->q1) entry_init(entries + count++, &problem->lattice, f, k);
  }
  qsort(entries, (size_t)count, sizeof *entries, compare);
  for (long k = 1; k < count; k++) {
    if (compare_lines(entries + k - 1, entries + k) != 0) continue;
    first[entries[k].facet] = first[entries[k - 1].facet];
  }
  for (long k = 0; k < count; k++) entry_clear(entries + k);
  free(entries);
  return true;
}
