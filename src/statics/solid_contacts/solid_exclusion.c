/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The program is that of shares c >= 0 of forces, and of a share t from 0 to 1 of the second load:
 * of all a = C (w1 + t (w2 - w1) + sum of c f) that satisfy the rows, the greatest w . a, w the one
 * load and then the other. A row that w1 alone does not satisfy has a slack at a great price, so
 * that modes that contradict each other are excluded by the same proof. */

#include "solid_contacts/solid_exclusion.h"

#include "contact_modes/dense_program.h"
#include "solid_contacts/mode_cones.h"

#include <flint/fmpz_mat.h>
#include <math.h>
#include <stdlib.h>

enum { MOST_CONTACTS = 16, PRICE_BITS = 20 };

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
  contact_doing doing[MOST_CONTACTS];
  bool is_stretch;       /* of two loads */
  int target;            /* which of them is to gain */
  tp_mode_vector change; /* w2 - w1 */
  long most, tried;
  bool failed; /* memory is exhausted */
  long force_count, row_count;
  const tp_mode_vector *forces[MOST_CONTACTS * TP_MODE_POLYGON];
  program_row rows[3 * MOST_CONTACTS];
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
  double rights[3 * MOST_CONTACTS];
  long surpluses;
  settle_rows(x, rights, &surpluses);
  const long share = x->force_count + surpluses; /* the column of t; its row is the last */
  if (!tp_dense_program_init(p, x->row_count + 1, share + 1)) return false;
  const double price = ldexp(1, PRICE_BITS);
  double *aim = tp_dense_program_entry(p, p->rows, 0);
  const double *target = x->modes.loads[x->target].near_turned;
  for (long g = 0; g < x->force_count; g++) aim[g] = product(target, x->forces[g]->near);
  if (x->is_stretch) aim[share] = product(target, x->change.near);
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
      entries[share] = own->turned * own->sign * product(own->vector->near_turned, x->change.near);
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

typedef struct proof {
  long unknown_count, force_count;
  long unknown[3 * MOST_CONTACTS];                    /* rows */
  const tp_mode_vector *basic[3 * MOST_CONTACTS + 1]; /* forces that y does no work on */
  slong raised;                                       /* y is 2^raised of what it is */
  fmpz y[TP_WRENCH];
  fmpz_t sum;
} proof;

/* Of the price of a row in the size of w, as a power of two. */
static slong price_exponent(const exclusion *x, const program_row *row) {
  return PRICE_BITS + x->modes.loads[x->target].exponent - row->vector->exponent;
}

/* Which rows have a z, by what is basic; what is dear has its price. */
static void read_basis(proof *f, const exclusion *x, const tp_dense_program *p) {
  bool is_slack[3 * MOST_CONTACTS + 1] = {false}, has_share = false;
  f->unknown_count = f->force_count = 0;
  for (long k = 0; k < p->rows; k++) {
    const long variable = p->basic[k];
    has_share = has_share || variable == p->columns - 1;
    if (variable >= p->columns) {
      const long row = variable - p->columns;
      is_slack[row] = true;
      if (row == x->row_count || !x->rows[row].is_priced) continue;
      /* z = price, as the row is multiplied, in the size of w */
      const program_row *own = x->rows + row;
      const slong shift = f->raised + price_exponent(x, own);
      for (int i = 0; i < TP_WRENCH; i++) {
        fmpz_mul_2exp(f->sum, own->vector->turned + i, (ulong)shift);
        fmpz_mul_si(f->sum, f->sum, own->turned * own->sign);
        fmpz_add(f->y + i, f->y + i, f->sum);
      }
    } else if (variable < x->force_count) {
      f->basic[f->force_count++] = x->forces[variable];
    }
  }
  /* a share between 0 and 1 */
  if (x->is_stretch && has_share && is_slack[x->row_count]) {
    f->basic[f->force_count++] = &x->change;
  }
  for (long r = 0; r < x->row_count; r++) {
    bool surplus_is_basic = false;
    for (long k = 0; k < p->rows; k++) {
      surplus_is_basic =
          surplus_is_basic || (x->rows[r].surplus >= 0 && p->basic[k] == x->rows[r].surplus);
    }
    if (!is_slack[r] && !surplus_is_basic) f->unknown[f->unknown_count++] = r;
  }
}

/* With y . f = 0 for all basic forces; y times what all are divided by. False: they do not tell. */
static bool solve(proof *f, const exclusion *x) {
  const long count = f->unknown_count;
  if (count != f->force_count) return false;
  if (count == 0) return true;
  fmpz_mat_t left, right, z;
  fmpz_t divisor;
  fmpz_mat_init(left, count, count);
  fmpz_mat_init(right, count, 1);
  fmpz_mat_init(z, count, 1);
  fmpz_init(divisor);
  for (long i = 0; i < count; i++) {
    const tp_mode_vector *force = f->basic[i];
    fmpz *entry = fmpz_mat_entry(right, i, 0);
    tp_mode_add_product(entry, f->y, force->whole);
    fmpz_neg(entry, entry);
    for (long k = 0; k < count; k++) {
      tp_mode_add_product(fmpz_mat_entry(left, i, k), x->rows[f->unknown[k]].vector->turned,
                          force->whole);
    }
  }
  bool solved = fmpz_mat_solve(z, divisor, left, right) != 0 && !fmpz_is_zero(divisor);
  if (solved && fmpz_sgn(divisor) < 0) {
    fmpz_neg(divisor, divisor);
    fmpz_mat_neg(z, z);
  }
  for (int i = 0; i < TP_WRENCH; i++) fmpz_mul(f->y + i, f->y + i, divisor);
  for (long k = 0; k < count && solved; k++) {
    const program_row *own = x->rows + f->unknown[k];
    const fmpz *share = fmpz_mat_entry(z, k, 0);
    solved = own->is_equal || fmpz_sgn(share) * own->sign >= 0;
    for (int i = 0; i < TP_WRENCH; i++) fmpz_addmul(f->y + i, own->vector->turned + i, share);
  }
  fmpz_clear(divisor);
  fmpz_mat_clear(left);
  fmpz_mat_clear(right);
  fmpz_mat_clear(z);
  return solved;
}

static bool is_resisted(proof *f, const fmpz wrench[TP_WRENCH]) {
  fmpz_zero(f->sum);
  tp_mode_add_product(f->sum, f->y, wrench);
  return fmpz_sgn(f->sum) <= 0;
}

/* Any y of this form will do, whatever the program was. */
static bool prove(const exclusion *x, const tp_dense_program *p) {
  proof f = {.unknown_count = 0};
  fmpz_init(f.sum);
  for (long r = 0; r < x->row_count; r++) {
    const slong own = -price_exponent(x, x->rows + r);
    if (own > f.raised) f.raised = own;
  }
  for (int k = 0; k < TP_WRENCH; k++) {
    fmpz_init(f.y + k);
    fmpz_mul_2exp(f.y + k, x->modes.loads[x->target].turned + k, (ulong)f.raised);
  }
  read_basis(&f, x, p);
  bool proven = solve(&f, x) && is_resisted(&f, x->modes.loads[0].whole) &&
                is_resisted(&f, x->modes.loads[1].whole);
  for (long g = 0; g < x->force_count && proven; g++) {
    proven = is_resisted(&f, x->forces[g]->whole);
  }
  for (int k = 0; k < TP_WRENCH; k++) fmpz_clear(f.y + k);
  fmpz_clear(f.sum);
  return proven;
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
  return does_not_gain(x, 0) && (!x->is_stretch || does_not_gain(x, 1));
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

/* w2 - w1, of the size of both; false: they are the same. */
static bool set_change(exclusion *x) {
  const tp_mode_vector *from = x->modes.loads, *to = x->modes.loads + 1;
  bool any = false;
  for (int k = 0; k < TP_WRENCH; k++) {
    fmpz_init(x->change.whole + k);
    fmpz_sub(x->change.whole + k, to->whole + k, from->whole + k);
    x->change.near[k] = to->near[k] - from->near[k];
    any = any || !fmpz_is_zero(x->change.whole + k);
  }
  return any;
}

static bool find(tp_solid_exclusion *of, exclusion *x) {
  if (!tp_mode_cones_init(&x->modes, of->cones, of->inertia, of->divisor, of->loads)) return false;
  x->is_stretch = set_change(x);
  of->is_excluded = x->modes.is_in_range && is_excluded(x);
  of->most -= x->tried;
  for (int k = 0; k < TP_WRENCH; k++) fmpz_clear(x->change.whole + k);
  tp_mode_cones_clear(&x->modes);
  return !x->failed;
}

bool tp_solid_exclusion_find(tp_solid_exclusion *of) {
  of->is_excluded = false;
  if (of->cones->count == 0 || of->cones->count > MOST_CONTACTS) return true;
  exclusion *x = calloc(1, sizeof *x);
  if (x == NULL) return false;
  x->most = of->most;
  const bool done = find(of, x);
  free(x);
  return done;
}
