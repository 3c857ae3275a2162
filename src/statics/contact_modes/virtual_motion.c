/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Inequalities that hold with no margin, whatever the unknowns, hold as equations in every
 * solution. Where unknowns that may be 0 are 0, such a one is 0 = 0, and all others keep a margin
 * that roundings do not take up. */

#include "contact_modes/virtual_motion.h"

#include "contact_modes/enclosed_solve.h"
#include "contact_modes/virtual_program.h"
#include "linear_program/margins.h"
#include "number/ball.h"

#include <stdlib.h>
#include <string.h>

/* ---- the program -------------------------------------------------------------------------------
 */

/* Behind the unknowns two parts, both at least 0, of each entry off the diagonal. */
typedef struct solving {
  tp_virtual_program *p;
  long columns, rows;
  bool *out;   /* by unknown: is 0 */
  bool *wants; /* by row */
  double *x, *margin;
  long *first, *column, *first_equation, *column_of_equation;
  double *entry, *constant, *entry_of_equation, *constant_of_equation;
} solving;

static void clear(solving *s) {
  free(s->out);
  free(s->wants);
  free(s->x);
  free(s->margin);
  free(s->first);
  free(s->column);
  free(s->first_equation);
  free(s->column_of_equation);
  free(s->entry);
  free(s->constant);
  free(s->entry_of_equation);
  free(s->constant_of_equation);
}

static bool is_diagonal(const tp_virtual_program *p, long entry) {
  return p->entries[entry].row == p->entries[entry].column;
}

static bool init(solving *s, tp_virtual_program *p) {
  *s = (solving){.p = p};
  const size_t entries = (size_t)p->mass.count, parts = 2 * entries;
  const size_t columns = (size_t)p->unknown_count + parts + 1;
  const size_t rows = (size_t)p->signs.count + entries + parts + 2;
  const size_t equations = (size_t)p->powers.count + entries + 2;
  const size_t terms = (size_t)p->signs.term_count + (size_t)p->mass.term_count + 4 * parts + 1;
  const size_t others = (size_t)p->powers.term_count + (size_t)p->mass.term_count + parts + 1;
  s->out = calloc(columns, sizeof *s->out);
  s->wants = calloc(rows, sizeof *s->wants);
  s->x = calloc(columns, sizeof *s->x);
  s->margin = calloc(rows, sizeof *s->margin);
  s->first = calloc(rows, sizeof *s->first);
  s->constant = calloc(rows, sizeof *s->constant);
  s->column = calloc(terms, sizeof *s->column);
  s->entry = calloc(terms, sizeof *s->entry);
  s->first_equation = calloc(equations, sizeof *s->first_equation);
  s->constant_of_equation = calloc(equations, sizeof *s->constant_of_equation);
  s->column_of_equation = calloc(others, sizeof *s->column_of_equation);
  s->entry_of_equation = calloc(others, sizeof *s->entry_of_equation);
  return s->out != NULL && s->wants != NULL && s->x != NULL && s->margin != NULL &&
         s->first != NULL && s->constant != NULL && s->column != NULL && s->entry != NULL &&
         s->first_equation != NULL && s->constant_of_equation != NULL &&
         s->column_of_equation != NULL && s->entry_of_equation != NULL;
}

/* A form of what is not left out, times a sign, behind the terms that there are. */
static long put(const solving *s, long *column, double *entry, long at,
                const tp_linear_forms *forms, long form, double sign) {
  for (long k = forms->forms[form].first; k < forms->forms[form].end; k++) {
    if (s->out[forms->unknown[k]]) continue;
    column[at] = forms->unknown[k];
    entry[at++] = sign * forms->factor[k].value;
  }
  return at;
}

/* The parts of entry k. */
static long part_of(const solving *s, long entry, int part) {
  return s->p->unknown_count + 2 * entry + part;
}

static long set_rows(solving *s) {
  const tp_virtual_program *p = s->p;
  static const double least = 0.04; /* of twice a diagonal entry over those beside it */
  long at = 0, row = 0;
  for (long k = 0; k < p->signs.count; k++, row++) {
    s->first[row] = at;
    s->wants[row] = true;
    s->constant[row] = p->signs.forms[k].constant.value;
    at = put(s, s->column, s->entry, at, &p->signs, k, 1);
    if (at == s->first[row]) s->wants[row] = false; /* 0 = 0, or it cannot hold */
  }
  for (long k = 0; k < p->mass.count; k++) {
    if (!is_diagonal(p, k)) continue;
    s->first[row] = at;
    s->constant[row] = least - p->mass.forms[k].constant.value;
    s->wants[row++] = false;
    at = put(s, s->column, s->entry, at, &p->mass, k, -1);
    for (long other = 0; other < p->mass.count; other++) {
      if (!tp_virtual_is_beside(p, k, other)) continue;
      for (int part = 0; part < 2; part++) {
        s->column[at] = part_of(s, other, part);
        s->entry[at++] = 1;
      }
    }
  }
  for (long k = 0; k < p->mass.count; k++) {
    for (int part = 0; part < 2 && !is_diagonal(p, k); part++) {
      s->first[row] = at;
      s->constant[row] = 0;
      s->wants[row++] = false;
      s->column[at] = part_of(s, k, part);
      s->entry[at++] = -1;
    }
  }
  s->first[row] = at;
  return row;
}

static long set_equations(solving *s) {
  const tp_virtual_program *p = s->p;
  long at = 0, row = 0;
  for (long k = 0; k < p->powers.count; k++, row++) {
    s->first_equation[row] = at;
    s->constant_of_equation[row] = p->powers.forms[k].constant.value;
    at = put(s, s->column_of_equation, s->entry_of_equation, at, &p->powers, k, 1);
  }
  for (long k = 0; k < p->mass.count; k++) {
    if (is_diagonal(p, k)) continue;
    s->first_equation[row] = at;
    s->constant_of_equation[row++] = p->mass.forms[k].constant.value;
    at = put(s, s->column_of_equation, s->entry_of_equation, at, &p->mass, k, 1);
    for (int part = 0; part < 2; part++) {
      s->column_of_equation[at] = part_of(s, k, part);
      s->entry_of_equation[at++] = part == 0 ? -1 : 1;
    }
  }
  s->first_equation[row] = at;
  return row;
}

static const double most_margin = 1e-3;

static tp_status solve(bool *found, solving *s, tp_message *message) {
  enum { MOST_WORK = 400000000 };
  s->rows = set_rows(s);
  const long equations = set_equations(s);
  const tp_margin_program program = {.columns = s->p->unknown_count + 2 * s->p->mass.count,
                                     .rows = {s->rows, s->first, s->column, s->entry, s->constant},
                                     .equations = {equations, s->first_equation,
                                                   s->column_of_equation, s->entry_of_equation,
                                                   s->constant_of_equation},
                                     .wants_margin = s->wants,
                                     .most = most_margin,
                                     .most_work = MOST_WORK};
  if (!tp_margins_find(found, s->x, s->margin, &program)) return tp_fail_memory(message, "a proof");
  for (long k = 0; k < s->p->unknown_count; k++) {
    if (s->out[k]) s->x[k] = 0;
  }
  return TP_OK;
}

/* Unknowns in rows without a margin are left out from then on. */
static bool leave_out(solving *s) {
  static const double none = 1e-2;
  const tp_virtual_program *p = s->p;
  bool changed = false;
  for (long k = 0; k < p->signs.count; k++) {
    if (!s->wants[k] || s->margin[k] > none * most_margin) continue;
    bool transforms = false;
    for (long t = p->signs.forms[k].first; t < p->signs.forms[k].end; t++) {
      transforms = transforms || tp_virtual_is_of_transform(p->signs.unknown[t]);
    }
    for (long t = p->signs.forms[k].first; t < p->signs.forms[k].end; t++) {
      const long unknown = p->signs.unknown[t];
      if (s->out[unknown] || tp_virtual_is_of_transform(unknown)) continue;
      if (transforms && p->is_traded[unknown]) continue;
      s->out[unknown] = changed = true;
      s->x[unknown] = 0;
    }
  }
  return changed;
}

/* ---- the proof ---------------------------------------------------------------------------------
 */

static bool is_at_most_zero(tp_near number) {
  return number.value + number.error <= 0;
}

static bool dominates(const solving *s) {
  const tp_virtual_program *p = s->p;
  bool proven = true;
  for (long k = 0; k < p->mass.count && proven; k++) {
    if (!is_diagonal(p, k)) continue;
    tp_near rest = tp_linear_forms_value(&p->mass, k, s->x);
    for (long other = 0; other < p->mass.count; other++) {
      if (!tp_virtual_is_beside(p, k, other)) continue;
      const tp_near entry = tp_linear_forms_value(&p->mass, other, s->x);
      rest = tp_near_minus(rest, (tp_near){fabs(entry.value), entry.error});
    }
    proven = tp_near_sign(rest) > 0;
  }
  return proven;
}

static bool forces_do_no_work(const solving *s) {
  const long end = tp_virtual_first_of_load(s->p, 0);
  bool proven = true;
  for (long k = 0; k < end && proven; k++) {
    proven = is_at_most_zero(tp_linear_forms_value(&s->p->signs, k, s->x));
  }
  return proven;
}

/* The work of a load on T a is to be a sum of gaps exactly: what `reach` leaves is made up for by
 * gaps that count, as many as there are independent ones. Blocks that these do not keep from a
 * slide along D go together; on such a slide both are zero, exactly. */
typedef struct balancing {
  const solving *s;
  int load;
  long rows, count; /* components of accelerations; gaps that count */
  long *gap, *group;
  double *table;
  long *row_at, *column_at;
} balancing;

static long group_of(const balancing *b, long block) {
  while (b->group[block] != block) block = b->group[block];
  return block;
}

/* How many groups can slide. `is_held`, by block, is where the ground keeps the group from it. */
static long count_slides(balancing *b, bool *is_held) {
  const tp_virtual_frame *f = b->s->p->frame;
  for (long k = 0; k < f->block_count; k++) b->group[k] = k;
  for (long k = 0; k < b->count; k++) {
    const tp_virtual_contact *c = f->contacts + b->gap[k] / 2;
    if (fmpz_is_zero(c->gap[b->gap[k] % 2]) || c->block[0] < 0 || c->block[1] < 0) continue;
    b->group[group_of(b, c->block[0])] = group_of(b, c->block[1]);
  }
  for (long k = 0; k < b->count; k++) {
    const tp_virtual_contact *c = f->contacts + b->gap[k] / 2;
    if (fmpz_is_zero(c->gap[b->gap[k] % 2])) continue;
    for (int side = 0; side < 2; side++) {
      if (c->block[side] < 0) is_held[group_of(b, c->block[1 - side])] = true;
    }
  }
  long slides = 0;
  for (long k = 0; k < f->block_count; k++) slides += b->group[k] == k && !is_held[k];
  return slides;
}

static tp_near entry_of(const balancing *b, long row, long gap) {
  const tp_virtual_contact *c = b->s->p->frame->contacts + gap / 2;
  const tp_near entry = c->gaps[gap % 2].of[row % 3];
  return c->block[0] == row / 3   ? entry
         : c->block[1] == row / 3 ? tp_near_neg(entry)
                                  : (tp_near){0, 0};
}

/* Rows and columns of as many pivots, the largest that is left each time. */
static bool choose_pivots(balancing *b, long rank) {
  static const double least = 1e-9;
  const long n = b->rows, m = b->count;
  for (long r = 0; r < n; r++) b->row_at[r] = r;
  for (long c = 0; c < m; c++) b->column_at[c] = c;
  for (long r = 0; r < n; r++) {
    for (long c = 0; c < m; c++) b->table[r * m + c] = entry_of(b, r, b->gap[c]).value;
  }
  for (long k = 0; k < rank; k++) {
    long row = k, column = k;
    double most = 0;
    for (long r = k; r < n; r++) {
      for (long c = k; c < m; c++) {
        const double size = fabs(b->table[b->row_at[r] * m + b->column_at[c]]);
        if (size <= most) continue;
        most = size;
        row = r;
        column = c;
      }
    }
    if (!(most > least)) return false;
    const long own_row = b->row_at[row], own_column = b->column_at[column];
    b->row_at[row] = b->row_at[k];
    b->row_at[k] = own_row;
    b->column_at[column] = b->column_at[k];
    b->column_at[k] = own_column;
    for (long r = k + 1; r < n; r++) {
      double *other = b->table + b->row_at[r] * m;
      const double factor = other[own_column] / b->table[own_row * m + own_column];
      if (factor == 0) continue;
      for (long c = k; c < m; c++) {
        other[b->column_at[c]] -= factor * b->table[own_row * m + b->column_at[c]];
      }
    }
  }
  return true;
}

static void set_ball(arb_t ball, tp_near number) {
  arf_set_d(arb_midref(ball), number.value);
  mag_set_d(arb_radref(ball), number.error);
}

/* What each gap makes up for; by gap. */
static bool make_up(bool *proven, tp_near *more, const balancing *b, long rank) {
  enum { BITS = 128 };
  const tp_virtual_program *p = b->s->p;
  const long first = b->load * b->rows;
  arb_mat_t a, right, x;
  arb_mat_init(a, rank, rank);
  arb_mat_init(right, rank, 1);
  arb_mat_init(x, rank, 1);
  for (long r = 0; r < rank; r++) {
    for (long c = 0; c < rank; c++) {
      set_ball(arb_mat_entry(a, r, c), entry_of(b, b->row_at[r], b->gap[b->column_at[c]]));
    }
    set_ball(arb_mat_entry(right, r, 0),
             tp_linear_forms_value(&p->powers, first + b->row_at[r], b->s->x));
  }
  const bool made = tp_enclosed_solve(proven, x, a, right, BITS);
  for (long c = 0; c < rank && made && *proven; c++) {
    more[b->gap[b->column_at[c]]] = tp_ball_near(arb_mat_entry(x, c, 0));
  }
  arb_mat_clear(a);
  arb_mat_clear(right);
  arb_mat_clear(x);
  return made;
}

static bool balance(bool *proven, tp_near *more, balancing *b) {
  const tp_virtual_program *p = b->s->p;
  const long gaps = 2 * p->frame->contact_count;
  bool *is_held = calloc((size_t)p->frame->block_count + 1, sizeof *is_held);
  if (is_held == NULL) return false;
  for (long gap = 0; gap < gaps; gap++) {
    if (!b->s->out[p->reach[b->load][gap]]) b->gap[b->count++] = gap;
  }
  const long rank = b->rows - count_slides(b, is_held);
  free(is_held);
  *proven = rank <= b->count && choose_pivots(b, rank);
  if (*proven && !make_up(proven, more, b, rank)) return false;
  const long first = tp_virtual_first_of_load(p, b->load);
  for (long gap = 0; gap < gaps && *proven; gap++) {
    const tp_near work = tp_linear_forms_value(&p->signs, first + gap, b->s->x);
    *proven = is_at_most_zero(tp_near_plus(work, more[gap]));
  }
  return true;
}

static bool load_does_no_work(bool *proven, const solving *s, int load) {
  const tp_virtual_frame *f = s->p->frame;
  const size_t rows = 3 * (size_t)f->block_count + 1, gaps = 2 * (size_t)f->contact_count + 1;
  balancing b = {.s = s,
                 .load = load,
                 .rows = 3 * f->block_count,
                 .gap = calloc(gaps, sizeof *b.gap),
                 .group = calloc(rows, sizeof *b.group),
                 .table = calloc(rows * gaps, sizeof *b.table),
                 .row_at = calloc(rows, sizeof *b.row_at),
                 .column_at = calloc(gaps, sizeof *b.column_at)};
  tp_near *more = calloc(gaps, sizeof *more);
  const bool made = b.gap != NULL && b.group != NULL && b.table != NULL && b.row_at != NULL &&
                    b.column_at != NULL && more != NULL && balance(proven, more, &b);
  free(b.gap);
  free(b.group);
  free(b.table);
  free(b.row_at);
  free(b.column_at);
  free(more);
  return made;
}

static tp_status prove(bool *proven, const solving *s, tp_message *message) {
  *proven = forces_do_no_work(s) && dominates(s);
  for (int k = 0; k < s->p->load_count && *proven; k++) {
    if (!load_does_no_work(proven, s, k)) return tp_fail_memory(message, "a proof");
  }
  return TP_OK;
}

/* ---- all ---------------------------------------------------------------------------------------
 */

/* Of what an earlier proof left out; and what this one does, for those to come. */
static void recall(solving *s, const tp_virtual_known *known) {
  for (long k = 0; k < s->p->unknown_count && known->count == s->p->role_count; k++) {
    s->out[k] = known->is_out[s->p->role[k]];
  }
}

static tp_status keep(tp_virtual_known *known, const solving *s, tp_message *message) {
  if (known->count != s->p->role_count) {
    free(known->is_out);
    known->count = s->p->role_count;
    known->is_out = calloc((size_t)known->count + 1, sizeof *known->is_out);
    if (known->is_out == NULL) {
      known->count = 0;
      return tp_fail_memory(message, "a proof");
    }
  }
  for (long k = 0; k < s->p->unknown_count; k++) {
    if (s->out[k]) known->is_out[s->p->role[k]] = true;
  }
  return TP_OK;
}

bool tp_virtual_known_copy(tp_virtual_known *known, const tp_virtual_known *other) {
  tp_virtual_known_clear(known);
  if (other->count == 0) return true;
  known->is_out = malloc((size_t)other->count * sizeof *known->is_out);
  if (known->is_out == NULL) return false;
  known->count = other->count;
  memcpy(known->is_out, other->is_out, (size_t)other->count * sizeof *known->is_out);
  return true;
}

void tp_virtual_known_clear(tp_virtual_known *known) {
  free(known->is_out);
  *known = (tp_virtual_known){.count = 0};
}

static tp_status find(bool *proven, tp_virtual_known *known, tp_virtual_program *p,
                      tp_message *message) {
  enum { MOST_ROUNDS = 4 };
  solving s;
  tp_status status = init(&s, p) ? TP_OK : tp_fail_memory(message, "a proof");
  bool goes_on = status == TP_OK;
  if (goes_on) recall(&s, known);
  for (int k = 0; k < MOST_ROUNDS && goes_on; k++) {
    bool found = false;
    status = solve(&found, &s, message);
    goes_on = status == TP_OK && found && leave_out(&s);
    if (status == TP_OK && found) status = prove(proven, &s, message);
    goes_on = goes_on && status == TP_OK && !*proven;
  }
  if (status == TP_OK && *proven) status = keep(known, &s, message);
  clear(&s);
  return status;
}

tp_status tp_virtual_motion_find(bool *proven, tp_virtual_known *known, const tp_arranged *arranged,
                                 const tp_modes_question *q, tp_message *message) {
  tp_near load[2] = {{0, 0}, {0, 0}};
  for (long r = 0; r < arranged->resting.rows; r++) {
    if (r % 3 < 2) load[r % 3] = tp_near_plus(load[r % 3], q->loads[0][r]);
  }
  tp_virtual_frame f;
  tp_virtual_program p;
  bool exists = false;
  *proven = false;
  tp_status status = tp_virtual_frame_init(&exists, &f, arranged, load, message);
  if (status != TP_OK) return status;
  if (exists) status = tp_virtual_program_init(&exists, &p, &f, q, message);
  if (status == TP_OK && exists) {
    status = find(proven, known, &p, message);
    tp_virtual_program_clear(&p);
  }
  tp_virtual_frame_clear(&f);
  return status;
}
