/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Velocities of one block are three numbers, and rows of its contacts a cone of them: r . a >= 0,
 * or r . a = 0. Where rows span all three directions a cone that is more than nothing has an edge,
 * and that is at right angles to two rows: so there is none but nothing where no cross product of
 * two rows, nor its opposite, is allowed by all of them. In doubles first, as mostly one is; then
 * in whole numbers, steps of the lattice. */

#include "contact_modes/held_fast.h"

#include "contact_modes/corner_modes.h"

#include <math.h>

/* Of very many the first: fewer rows allow no less. */
enum { MOST_ROWS = 24 };

/* n at an end of a contact, or its t, one way or the other. */
typedef struct bound_row {
  long contact;
  int end, side;
  bool along, back, is_equal;
  double entry[3];
} bound_row;

typedef struct bound_rows {
  int count;
  bound_row all[MOST_ROWS];
} bound_rows;

static void add(bound_rows *b, const tp_resting *r, bound_row own) {
  if (b->count == MOST_ROWS) return;
  const tp_resting_contact *c = r->contacts + own.contact;
  const tp_force_column *column = own.along ? &c->along : c->normal + own.end;
  for (int e = 0; e < 3; e++) {
    own.entry[e] = (own.back ? -1 : 1) * column->entry[own.side][e].value;
  }
  b->all[b->count++] = own;
}

/* What its set says, once it is told. */
static void add_contact(bound_rows *b, const tp_modes_node *n, const tp_resting *r, long k,
                        int side) {
  const tp_mode_set set = n->sets[k];
  for (int e = 0; e < r->contacts[k].ends; e++) {
    const bool is_closed = (set & ~tp_modes_closed(e)) == 0;
    add(b, r, (bound_row){.contact = k, .end = e, .side = side, .is_equal = is_closed});
  }
  const bool forward = (set & (TP_MODES_FORWARD | TP_MODES_OPEN)) != 0;
  const bool back = (set & (TP_MODES_BACK | TP_MODES_OPEN)) != 0;
  if (forward && back) return;
  add(b, r,
      (bound_row){
          .contact = k, .side = side, .along = true, .back = back, .is_equal = !forward && !back});
}

/* With blocks at rest. */
static void find_rows(bound_rows *b, const tp_modes_node *n, const tp_resting *r, long block) {
  b->count = 0;
  for (long k = 0; k < r->contact_count; k++) {
    const long *row = r->contacts[k].along.row;
    const int side = row[0] == 3 * block ? 0 : 1;
    if (row[side] != 3 * block || !tp_modes_rests(n, row[1 - side])) continue;
    if (n->sets[k] != 0 && tp_modes_is_told(n->sets, r, k)) add_contact(b, n, r, k, side);
  }
}

/* ---- in doubles --------------------------------------------------------------------------------
 */

static void cross(double own[3], const double a[3], const double b[3]) {
  for (int e = 0; e < 3; e++) {
    own[e] = a[(e + 1) % 3] * b[(e + 2) % 3] - a[(e + 2) % 3] * b[(e + 1) % 3];
  }
}

static double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Which of a direction, 1, and its opposite, 2, do all rows seem to allow? */
static int seem_to_allow(const bound_rows *b, const double direction[3]) {
  static const double little = 1e-9;
  int ways = 1 + 2;
  const double size = sqrt(dot(direction, direction));
  for (int k = 0; k < b->count && ways != 0; k++) {
    const double *row = b->all[k].entry;
    const double own = dot(row, direction), within = little * size * sqrt(dot(row, row));
    if (own < -within) ways &= b->all[k].is_equal ? 0 : ~1;
    if (own > within) ways &= b->all[k].is_equal ? 0 : ~2;
  }
  return ways;
}

static bool seems_free(const bound_rows *b) {
  static const double little = 1e-9;
  bool spans = false;
  for (int i = 0; i < b->count; i++) {
    for (int j = i + 1; j < b->count; j++) {
      double own[3];
      const double *one = b->all[i].entry, *other = b->all[j].entry;
      cross(own, one, other);
      if (dot(own, own) <= little * little * dot(one, one) * dot(other, other)) continue;
      if (seem_to_allow(b, own) != 0) return true;
      spans = true;
    }
  }
  return !spans;
}

/* ---- in whole numbers --------------------------------------------------------------------------
 */

typedef struct whole_rows {
  int count;
  fmpz entry[MOST_ROWS][3];
} whole_rows;

/* n = (-dy, dx) or t = (dx, dy), and its moment about the block's own point. */
static void set_whole(fmpz own[3], const tp_resting *r, const bound_row *row) {
  const tp_lattice *l = &r->assemblage->lattice;
  const tp_block_contact *c = &r->contacts[row->contact].of;
  const tp_rigid_block *block = r->assemblage->blocks + c->block[row->side];
  fmpz_t x, y;
  fmpz_init(x);
  fmpz_init(y);
  fmpz_sub(own + 0, l->x + c->along[1], l->x + c->along[0]);
  fmpz_sub(own + 1, l->y + c->along[1], l->y + c->along[0]);
  if (!row->along) {
    fmpz_swap(own + 0, own + 1);
    fmpz_neg(own + 0, own + 0);
  }
  fmpz_sub(x, l->x + c->ends[row->end], block->x);
  fmpz_sub(y, l->y + c->ends[row->end], block->y);
  fmpz_mul(own + 2, x, own + 1);
  fmpz_submul(own + 2, y, own + 0);
  const bool runs_back = row->along && r->slips_run_back;
  const bool turns = (row->back != runs_back) != (row->side == 1);
  for (int e = 0; e < 3 && turns; e++) fmpz_neg(own + e, own + e);
  fmpz_clear(x);
  fmpz_clear(y);
}

static void cross_whole(fmpz own[3], const fmpz a[3], const fmpz b[3]) {
  for (int e = 0; e < 3; e++) {
    fmpz_mul(own + e, a + (e + 1) % 3, b + (e + 2) % 3);
    fmpz_submul(own + e, a + (e + 2) % 3, b + (e + 1) % 3);
  }
}

static int sign_of_dot(const fmpz a[3], const fmpz b[3]) {
  fmpz_t sum;
  fmpz_init(sum);
  for (int e = 0; e < 3; e++) fmpz_addmul(sum, a + e, b + e);
  const int own = fmpz_sgn(sum);
  fmpz_clear(sum);
  return own;
}

static bool allow(const bound_rows *b, const whole_rows *w, const fmpz direction[3]) {
  int ways = 1 + 2;
  for (int k = 0; k < w->count && ways != 0; k++) {
    const int own = sign_of_dot(w->entry[k], direction);
    if (own < 0) ways &= b->all[k].is_equal ? 0 : ~1;
    if (own > 0) ways &= b->all[k].is_equal ? 0 : ~2;
  }
  return ways != 0;
}

/* Rows that span less than all allow a direction at right angles to them all: the product of two
 * that are not parallel, of which none is crossed by a third. */
static bool is_free(const bound_rows *b, const whole_rows *w) {
  fmpz own[3];
  bool spans = false, allowed = false;
  for (int e = 0; e < 3; e++) fmpz_init(own + e);
  for (int i = 0; i < w->count && !allowed; i++) {
    for (int j = i + 1; j < w->count && !allowed; j++) {
      cross_whole(own, w->entry[i], w->entry[j]);
      if (fmpz_is_zero(own) && fmpz_is_zero(own + 1) && fmpz_is_zero(own + 2)) continue;
      spans = true;
      allowed = allow(b, w, own);
    }
  }
  for (int e = 0; e < 3; e++) fmpz_clear(own + e);
  return allowed || !spans;
}

bool tp_modes_is_held_fast(const tp_modes_node *n, const tp_resting *r, long block) {
  bound_rows b;
  find_rows(&b, n, r, block);
  if (b.count < 3 || seems_free(&b)) return false;
  whole_rows w = {.count = b.count};
  for (int k = 0; k < 3 * w.count; k++) fmpz_init(w.entry[k / 3] + k % 3);
  for (int k = 0; k < w.count; k++) set_whole(w.entry[k], r, b.all + k);
  const bool held = !is_free(&b, &w);
  for (int k = 0; k < 3 * w.count; k++) fmpz_clear(w.entry[k / 3] + k % 3);
  return held;
}
