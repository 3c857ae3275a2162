/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contacts by block; those on one edge by the signs of exact products, and sorted along it. */

#include "block_system/edge_pieces.h"

#include <stdlib.h>
#include <string.h>

void tp_edge_pieces_clear(tp_edge_pieces *pieces) {
  for (long k = 0; k < pieces->room && pieces->items != NULL; k++) {
    fmpq_clear(pieces->items[k].from);
    fmpq_clear(pieces->items[k].to);
  }
  free(pieces->items);
  free(pieces->first);
  free(pieces->touch);
  memset(pieces, 0, sizeof *pieces);
}

bool tp_edge_pieces_init(tp_edge_pieces *pieces, const tp_assemblage *a) {
  memset(pieces, 0, sizeof *pieces);
  pieces->assemblage = a;
  pieces->first = calloc((size_t)a->count + 2, sizeof *pieces->first);
  pieces->touch = calloc(2 * (size_t)a->contact_count + 1, sizeof *pieces->touch);
  if (pieces->first == NULL || pieces->touch == NULL) return false;
  for (int fills = 0; fills < 2; fills++) {
    for (long k = 0; k < a->contact_count; k++) {
      for (int side = 0; side < 2; side++) {
        const long block = a->contacts[k].block[side];
        if (fills == 0) {
          pieces->first[block + 2]++;
        } else {
          pieces->touch[pieces->first[block + 1]++] = k;
        }
      }
    }
    for (long b = 0; b < a->count && fills == 0; b++) pieces->first[b + 2] += pieces->first[b + 1];
  }
  for (long b = 0; b < a->count; b++) {
    const long own = pieces->first[b + 1] - pieces->first[b];
    if (own > pieces->room) pieces->room = own;
  }
  pieces->items = calloc((size_t)pieces->room + 1, sizeof *pieces->items);
  for (long k = 0; k < pieces->room && pieces->items != NULL; k++) {
    fmpq_init(pieces->items[k].from);
    fmpq_init(pieces->items[k].to);
  }
  return pieces->items != NULL;
}

/* Which share of the edge from p to q a point on its line has. */
static void share_of(fmpq_t share, const tp_lattice *l, long p, long q, long at) {
  fmpz_t dx, dy, own;
  fmpz_init(dx);
  fmpz_init(dy);
  fmpz_init(own);
  fmpz_sub(dx, l->x + q, l->x + p);
  fmpz_sub(dy, l->y + q, l->y + p);
  fmpz_sub(own, l->x + at, l->x + p);
  fmpz_mul(fmpq_numref(share), own, dx);
  fmpz_sub(own, l->y + at, l->y + p);
  fmpz_addmul(fmpq_numref(share), own, dy);
  fmpz_mul(fmpq_denref(share), dx, dx);
  fmpz_addmul(fmpq_denref(share), dy, dy);
  fmpq_canonicalise(share);
  fmpz_clear(dx);
  fmpz_clear(dy);
  fmpz_clear(own);
}

bool tp_edge_piece_set(tp_edge_piece *own, const tp_lattice *l, const tp_block_contact *c, long p,
                       long q) {
  if (c->ends[0] == c->ends[1]) return false;
  for (int e = 0; e < 2; e++) {
    if (tp_lattice_cross(l, p, q, p, c->ends[e]) != 0) return false;
  }
  share_of(own->from, l, p, q, c->ends[0]);
  share_of(own->to, l, p, q, c->ends[1]);
  if (fmpq_cmp(own->from, own->to) > 0) fmpq_swap(own->from, own->to);
  return fmpq_sgn(own->from) >= 0 && fmpq_cmp_si(own->to, 1) <= 0;
}

static void swap(tp_edge_piece *a, tp_edge_piece *b) {
  fmpq_swap(a->from, b->from);
  fmpq_swap(a->to, b->to);
}

long tp_edge_pieces_find(tp_edge_pieces *pieces, long block, long p, long q) {
  const tp_assemblage *a = pieces->assemblage;
  long count = 0;
  for (long k = pieces->first[block]; k < pieces->first[block + 1]; k++) {
    if (!tp_edge_piece_set(pieces->items + count, &a->lattice, a->contacts + pieces->touch[k], p,
                           q))
      continue;
    for (long n = count++; n > 0 && fmpq_cmp(pieces->items[n].from, pieces->items[n - 1].from) < 0;
         n--) {
      swap(pieces->items + n, pieces->items + n - 1);
    }
  }
  return count;
}
