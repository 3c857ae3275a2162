/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The program is that of shares c >= 0 of forces, and of a share t from 0 to 1 of the second load:
 * of all a = C (w1 + t (w2 - w1) + sum of c f) that satisfy the rows, the greatest w . a, w the one
 * load and then the other. A row that w1 alone does not satisfy has a slack at a great price, so
 * that modes that contradict each other are excluded by the same proof. */

#include "solid_contacts/solid_exclusion.h"

#include "contact_modes/dense_program.h"
#include "solid_contacts/mode_claim.h"

#include <math.h>
#include <stdlib.h>

enum { PRICE_BITS = 20 };

typedef enum doing { DOES_ANY, DOES_OPEN, DOES_STICK, DOES_SLIP } doing;

/* Of a slip: its sector, of the 4 << level. */
typedef struct contact_doing {
  doing kind;
  int level, sector;
} contact_doing;

/* A row of a program: a contact's, turned round or not; zero or above. */
typedef struct program_row {
  const tp_mode_vector *vector;
  int sign;      /* of the row as it is asked to be above zero */
  bool is_equal; /* it is to be zero */
  int turned;    /* by which it was multiplied for a right-hand side that is not below zero */
  bool is_priced;
  long surplus; /* its column; or -1 */
} program_row;

typedef struct exclusion {
  tp_mode_cones modes;
  contact_doing doing[TP_MODE_CONTACTS];
  bool is_stretch; /* of two loads */
  int target;      /* which of them is to gain */
  long most, tried;
  bool failed; /* memory is exhausted */
  long force_count, row_count;
  const tp_mode_vector *forces[TP_MODE_CONTACTS * TP_MODE_POLYGON];
  program_row rows[TP_MODE_CLAIM_ROWS];
} exclusion;

/* ---- modes as forces and rows ------------------------------------------------------------------
 */

static void add_force(exclusion *x, long contact, int which) {
  x->forces[x->force_count++] = tp_mode_cones_force(&x->modes, contact, which);
}

static void add_row(exclusion *x, long contact, int which, int sign, bool is_equal) {
  x->rows[x->row_count++] = (program_row){.vector = tp_mode_cones_row(&x->modes, contact, which),
                                          .sign = sign,
                                          .is_equal = is_equal,
                                          .surplus = -1};
}

static void add_slip(exclusion *x, long contact, const contact_doing *d) {
  const int span = TP_MODE_RAYS / (TP_MODE_QUARTERS << d->level);
  const int from = d->sector * span, to = (d->sector + 1) * span % TP_MODE_RAYS;
  const int ends[2] = {from, to};
  for (int k = 0; k < 2; k++) {
    add_force(x, contact, TP_MODE_INNER + ends[k]);
    add_force(x, contact, TP_MODE_OUTER + ends[k]);
    add_row(x, contact, TP_MODE_ROW_RAYS + ends[k], k == 0 ? 1 : -1, false);
  }
  add_force(x, contact, tp_mode_tip(d->level, d->sector));
}

static void add_contact(exclusion *x, long contact) {
  const contact_doing *d = x->doing + contact;
  const bool smooth = x->modes.contacts[contact].is_smooth;
  add_row(x, contact, 0, 1, d->kind != DOES_ANY && d->kind != DOES_OPEN);
  if (d->kind == DOES_OPEN) return;
  if (d->kind == DOES_SLIP) {
    add_slip(x, contact, d);
    return;
  }
  for (int k = 0; k < (smooth ? 1 : TP_MODE_POLYGON); k++) add_force(x, contact, TP_MODE_CONE + k);
  for (int k = 0; k < 2 && d->kind == DOES_STICK && !smooth; k++) {
    add_row(x, contact, TP_MODE_ROW_ACROSS + k, 1, true);
  }
}

/* ---- the program -------------------------------------------------------------------------------
 */

static double product(const double a[TP_WRENCH], const double b[TP_WRENCH]) {
  double sum = 0;
  for (int k = 0; k < TP_WRENCH; k++) sum += a[k] * b[k];
  return sum;
}

/* Above zero each: row . C f c >= -row . C w, or with the other sign. */
static void settle_rows(exclusion *x, double *rights, long *surpluses) {
  *surpluses = 0;
  for (long r = 0; r < x->row_count; r++) {
    program_row *own = x->rows + r;
    const double right = -own->sign * product(own->vector->near_turned, x->modes.loads[0].near);
    own->is_priced = own->is_equal || right > 0;
    own->turned = own->is_equal ? (right < 0 ? -1 : 1) : right > 0 ? 1 : -1;
    if (!own->is_equal && own->is_priced) own->surplus = x->force_count + (*surpluses)++;
    rights[r] = fabs(right);
  }
}

static bool init_program(tp_dense_program *p, exclusion *x) {
  double rights[TP_MODE_CLAIM_ROWS];
  long surpluses;
  settle_rows(x, rights, &surpluses);
  const long share = x->force_count + surpluses; /* the column of t; its row is the last */
  if (!tp_dense_program_init(p, x->row_count + 1, share + 1)) return false;
  const double price = ldexp(1, PRICE_BITS);
  double *aim = tp_dense_program_entry(p, p->rows, 0);
  const double *target = x->modes.loads[x->target].near_turned;
  for (long g = 0; g < x->force_count; g++) aim[g] = product(target, x->forces[g]->near);
  if (x->is_stretch) aim[share] = product(target, x->modes.change.near);
  *tp_dense_program_entry(p, x->row_count, share) = 1;
  *tp_dense_program_right(p, x->row_count) = 1;
  for (long r = 0; r < x->row_count; r++) {
    const program_row *own = x->rows + r;
    double *entries = tp_dense_program_entry(p, r, 0);
    for (long g = 0; g < x->force_count; g++) {
      entries[g] = own->turned * own->sign * product(own->vector->near_turned, x->forces[g]->near);
      if (own->is_priced) aim[g] += price * entries[g];
    }
    if (x->is_stretch) {
      entries[share] =
          own->turned * own->sign * product(own->vector->near_turned, x->modes.change.near);
      if (own->is_priced) aim[share] += price * entries[share];
    }
    if (own->surplus >= 0) {
      entries[own->surplus] = -1;
      aim[own->surplus] = -price;
    }
    *tp_dense_program_right(p, r) = rights[r];
    p->exact[r] = own->is_priced;
  }
  return true;
}

/* ---- the proof ---------------------------------------------------------------------------------
 */

/* Which rows have a z, by what is basic; what is dear has its price. */
static void set_claim(tp_mode_claim *c, const exclusion *x, const tp_dense_program *p) {
  bool is_slack[TP_MODE_CLAIM_ROWS + 1] = {false}, has_share = false;
  *c = (tp_mode_claim){.modes = &x->modes,
                       .target = x->target,
                       .price_bits = PRICE_BITS,
                       .force_count = x->force_count,
                       .forces = x->forces};
  for (long k = 0; k < p->rows; k++) {
    const long variable = p->basic[k];
    has_share = has_share || variable == p->columns - 1;
    if (variable >= p->columns) {
      const long row = variable - p->columns;
      is_slack[row] = true;
      if (row == x->row_count || !x->rows[row].is_priced) continue;
      /* z = price, as the row is multiplied */
      c->priced[c->priced_count++] =
          (tp_mode_claim_row){x->rows[row].vector, x->rows[row].turned * x->rows[row].sign};
    } else if (variable < x->force_count) {
      c->basic[c->basic_count++] = x->forces[variable];
    }
  }
  /* a share between 0 and 1 */
  if (x->is_stretch && has_share && is_slack[x->row_count]) {
    c->basic[c->basic_count++] = c->change = &x->modes.change;
  }
  for (long r = 0; r < x->row_count; r++) {
    bool surplus_is_basic = false;
    for (long k = 0; k < p->rows; k++) {
      surplus_is_basic =
          surplus_is_basic || (x->rows[r].surplus >= 0 && p->basic[k] == x->rows[r].surplus);
    }
    if (is_slack[r] || surplus_is_basic) continue;
    c->unknown[c->unknown_count++] =
        (tp_mode_claim_row){x->rows[r].vector, x->rows[r].is_equal ? 0 : x->rows[r].sign};
  }
}

/* Any claim of this form will do, whatever the program was. */
static bool prove(const exclusion *x, const tp_dense_program *p) {
  tp_mode_claim claim;
  bool is_close;
  set_claim(&claim, x, p);
  return tp_mode_claim_holds(&is_close, &claim) ||
         (is_close && tp_mode_claim_holds_exactly(&claim));
}

/* Rows that are zero and of rank six leave no motion. */
static bool is_still(const exclusion *x) {
  const tp_mode_vector *equal[TP_MODE_CLAIM_ROWS];
  long count = 0;
  for (long r = 0; r < x->row_count; r++) {
    if (x->rows[r].is_equal) equal[count++] = x->rows[r].vector;
  }
  return count >= TP_WRENCH && tp_mode_rank(equal, count) == TP_WRENCH;
}

static bool does_not_gain(exclusion *x, int target) {
  tp_dense_program p;
  x->target = target;
  if (!init_program(&p, x)) {
    x->failed = true;
    return false;
  }
  const bool proven = tp_dense_program_climb(&p, 0) && prove(x, &p);
  tp_dense_program_clear(&p);
  return proven;
}

static bool is_refuted(exclusion *x) {
  x->force_count = x->row_count = 0;
  for (long n = 0; n < x->modes.count; n++) add_contact(x, n);
  return is_still(x) || (does_not_gain(x, 0) && (!x->is_stretch || does_not_gain(x, 1)));
}

/* ---- all modes ---------------------------------------------------------------------------------
 */

/* The contact that is to be decided next: without a mode, else of the widest slip; below 0: none.
 */
static long next_contact(const exclusion *x) {
  long widest = -1;
  for (long n = 0; n < x->modes.count; n++) {
    const contact_doing *d = x->doing + n;
    if (d->kind == DOES_ANY) return n;
    if (d->kind != DOES_SLIP || d->level + 1 >= TP_MODE_LEVELS) continue;
    if (widest < 0 || d->level < x->doing[widest].level) widest = n;
  }
  return widest;
}

static bool is_excluded(exclusion *x); /* calls itself by way of the modes below */

static bool is_excluded_with(exclusion *x, long contact, contact_doing doing) {
  const contact_doing before = x->doing[contact];
  x->doing[contact] = doing;
  const bool excluded = is_excluded(x);
  x->doing[contact] = before;
  return excluded;
}

static bool is_excluded(exclusion *x) {
  if (x->failed || x->tried++ >= x->most) return false;
  if (is_refuted(x)) return true;
  const long n = next_contact(x);
  if (n < 0) return false;
  const contact_doing own = x->doing[n];
  bool excluded = true;
  if (own.kind == DOES_SLIP) {
    for (int k = 0; k < 2 && excluded; k++) {
      excluded =
          is_excluded_with(x, n, (contact_doing){DOES_SLIP, own.level + 1, 2 * own.sector + k});
    }
    return excluded;
  }
  /* without friction it does not stick: it is closed, and moves along as it may */
  const int sectors = x->modes.contacts[n].is_smooth ? 0 : TP_MODE_QUARTERS;
  for (int k = 0; k < sectors && excluded; k++) {
    excluded = is_excluded_with(x, n, (contact_doing){DOES_SLIP, 0, k});
  }
  excluded = excluded && is_excluded_with(x, n, (contact_doing){.kind = DOES_STICK});
  return excluded && is_excluded_with(x, n, (contact_doing){.kind = DOES_OPEN});
}

static bool find(tp_solid_exclusion *of, exclusion *x) {
  if (!tp_mode_cones_init(&x->modes, of->cones, of->inertia, of->divisor, of->loads, of->way))
    return false;
  x->is_stretch = of->way != NULL;
  of->is_excluded = x->modes.is_in_range && is_excluded(x);
  of->most -= x->tried;
  tp_mode_cones_clear(&x->modes);
  return !x->failed;
}

bool tp_solid_exclusion_find(tp_solid_exclusion *of) {
  of->is_excluded = false;
  if (of->cones->count == 0 || of->cones->count > TP_MODE_CONTACTS) return true;
  exclusion *x = calloc(1, sizeof *x);
  if (x == NULL) return false;
  x->most = of->most;
  const bool done = find(of, x);
  free(x);
  return done;
}
