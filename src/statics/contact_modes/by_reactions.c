/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* w + A c = 0 for every block that is not at rest. Searched by a linear program with all factors
 * that have a sign at least d above zero, d the greatest, so that the solution of a basis in balls
 * keeps them there. Rows of which all entries are exactly zero hold by themselves: of blocks on
 * level beds without friction. */

#include "contact_modes/basis_proof.h"
#include "contact_modes/dense_program.h"
#include "contact_modes/reactions.h"
#include "contact_modes/refutation.h"
#include "contact_modes/refuted_node.h"

#include "number/ball.h"

#include <stdlib.h>
#include <string.h>

enum { BITS = 128 };

typedef struct balancing {
  const tp_modes_node *node;
  const tp_modes_question *q;
  const tp_near *loads;
  const tp_modes_finding *finding; /* or NULL */
  double *signs;                   /* by row of the program: times which it was taken */
  tp_bearing_reactions reactions;
  long rows;                 /* that take part */
  long *row;                 /* by row of the question: which of them; -1 */
  double *columns, *factors; /* of the program, and by reaction */
  bool *idle;                /* by column of the program */
} balancing;

static tp_near entry_of(const tp_bearing_reaction *r, int side, int e) {
  const tp_near own = r->column->entry[side][e];
  return r->sign < 0 ? tp_near_neg(own) : own;
}

static void number_rows(balancing *s) {
  const long all = s->q->resting->rows;
  for (long r = 0; r < all; r++) {
    s->row[r] = s->node->still[r / 3] || tp_near_is_zero(s->loads[r]) ? -1 : 0;
  }
  for (long k = 0; k < s->reactions.count; k++) {
    const tp_bearing_reaction *own = s->reactions.all + k;
    for (int side = 0; side < 2; side++) {
      const long first = own->column->row[side];
      if (tp_modes_rests(s->node, first)) continue;
      for (int e = 0; e < 3; e++) {
        if (!tp_near_is_zero(own->column->entry[side][e])) s->row[first + e] = 0;
      }
    }
  }
  for (long r = 0; r < all; r++) {
    if (s->row[r] == 0) s->row[r] = s->rows++;
  }
}

/* ---- search ------------------------------------------------------------------------------------
 */

static void set_column(tp_dense_program *p, const balancing *s, long k, long column, double sign,
                       bool is_held) {
  const tp_bearing_reaction *own = s->reactions.all + k;
  for (int side = 0; side < 2; side++) {
    const long first = own->column->row[side];
    for (int e = 0; e < 3 && !tp_modes_rests(s->node, first); e++) {
      const long row = s->row[first + e];
      if (row < 0) continue;
      const double entry = sign * entry_of(own, side, e).value;
      *tp_dense_program_entry(p, row, column) += entry;
      if (is_held) *tp_dense_program_entry(p, row, p->columns - 1) += entry;
    }
  }
}

/* Rows with a right-hand side that is not negative; their sum is what is to fall to zero. */
static void finish_rows(tp_dense_program *p, balancing *s) {
  for (long r = 0; r < s->q->resting->rows; r++) {
    if (s->row[r] >= 0) *tp_dense_program_right(p, s->row[r]) = -s->loads[r].value;
  }
  for (long r = 0; r < s->rows; r++) {
    p->exact[r] = true;
    double *own = tp_dense_program_entry(p, r, 0);
    const double sign = own[p->columns] < 0 ? -1 : 1;
    s->signs[r] = sign;
    for (long c = 0; c <= p->columns; c++) {
      own[c] *= sign;
      *tp_dense_program_entry(p, p->rows, c) += own[c];
    }
  }
  *tp_dense_program_entry(p, s->rows, p->columns - 1) = 1; /* d <= 1 */
  *tp_dense_program_right(p, s->rows) = 1;
  *tp_dense_program_entry(p, p->rows + 1, p->columns - 1) = 1;
}

/* How far each row is from holding, less its multiplier, are accelerations that loads drive. */
static void tell_why(balancing *s, const tp_dense_program *p) {
  const long rows = s->q->resting->rows;
  double *of_row = calloc((size_t)p->rows + 1, sizeof *of_row);
  double *a = calloc((size_t)rows + 1, sizeof *a);
  if (of_row != NULL && a != NULL) {
    tp_dense_program_multipliers(of_row, p, 0);
    for (long r = 0; r < rows; r++) {
      const long own = s->row[r];
      if (own >= 0) a[r] = (of_row[own] - 1) * s->signs[own];
    }
    tp_relaxed_motions_add_driven(s->finding->relaxed, s->node, a);
  }
  free(of_row);
  free(a);
}

static bool search(bool *is_flat, balancing *s, long *work, tp_dense_program *p) {
  static const double enough = 1e-9, margin = 1e-7;
  long column = 0;
  for (long k = 0; k < s->reactions.count; k++) {
    const bool is_free = s->reactions.all[k].is_free;
    set_column(p, s, k, column++, 1, !is_free);
    if (is_free) set_column(p, s, k, column++, -1, false);
  }
  finish_rows(p, s);
  p->is_limited = true;
  p->tie = TP_DENSE_TIE;
  const bool climbed = tp_dense_program_climb(p, 0);
  const bool balanced = climbed && *tp_dense_program_right(p, p->rows) < enough;
  if (climbed && !balanced && s->finding != NULL) tell_why(s, p);
  const bool found = balanced && tp_dense_program_climb(p, 1);
  *work += p->work;
  tp_dense_program_solution(s->columns, p);
  const double least = s->columns[p->columns - 1];
  tp_reactions_join(s->factors, &s->reactions, s->columns);
  for (long k = 0; k < s->reactions.count; k++) {
    if (!s->reactions.all[k].is_free) s->factors[k] += least;
  }
  *is_flat = found && least <= margin;
  return found && least > margin;
}

/* Where d is 0, reactions that the second objective falls with bear nothing in any equilibrium:
 * between bricks side by side, say. Without them it may be more. False: there are none. */
static bool drop_idle(balancing *s, const tp_dense_program *p) {
  static const double falls = 1e-7;
  const double *objective = p->entries + (p->rows + 1) * (p->columns + 1);
  bool *idle = s->idle;
  memset(idle, 0, (size_t)p->columns * sizeof *idle);
  for (long c = 0; c < p->columns; c++) {
    if (p->outside[c] < p->columns && objective[c] < -falls) idle[p->outside[c]] = true;
  }
  long column = 0, kept = 0;
  const long count = s->reactions.count;
  for (long k = 0; k < count; k++) {
    const tp_bearing_reaction own = s->reactions.all[k];
    const bool drops = !own.is_free && idle[column];
    column += own.is_free ? 2 : 1;
    if (!drops) s->reactions.all[kept++] = own;
  }
  s->reactions.count = kept;
  return kept < count;
}

/* ---- proof -------------------------------------------------------------------------------------
 */

static void set_ball(arb_t ball, tp_near number) {
  tp_ball_set_bounded(ball, number.value, number.error);
}

static void set_matrices(arb_mat_t columns, arb_mat_t right, arb_mat_t factors, double *preference,
                         const balancing *s) {
  static const double at_will = 1e3;
  for (long k = 0; k < s->reactions.count; k++) {
    const tp_bearing_reaction *own = s->reactions.all + k;
    for (int side = 0; side < 2; side++) {
      const long first = own->column->row[side];
      for (int e = 0; e < 3 && !tp_modes_rests(s->node, first); e++) {
        const long row = s->row[first + e];
        if (row >= 0) set_ball(arb_mat_entry(columns, row, k), entry_of(own, side, e));
      }
    }
    arb_set_d(arb_mat_entry(factors, k, 0), s->factors[k]);
    preference[k] = own->is_free ? at_will : s->factors[k];
  }
  for (long r = 0; r < s->q->resting->rows; r++) {
    if (s->row[r] >= 0) {
      set_ball(arb_mat_entry(right, s->row[r], 0), tp_near_neg(s->loads[r]));
    }
  }
}

static bool keep_their_sign(const arb_mat_t factors, const balancing *s) {
  for (long k = 0; k < s->reactions.count; k++) {
    if (!s->reactions.all[k].is_free && !arb_is_nonnegative(arb_mat_entry(factors, k, 0))) {
      return false;
    }
  }
  return true;
}

static tp_factor_sign sign_of(const arb_struct *factor) {
  if (arb_is_zero(factor)) return TP_FACTOR_NONE;
  if (arb_is_nonnegative(factor)) return TP_FACTOR_POSITIVE;
  return arb_is_negative(factor) ? TP_FACTOR_NEGATIVE : TP_FACTOR_EITHER;
}

static void widen(const balancing *s, const arb_mat_t factors) {
  for (long k = 0; k < s->reactions.count; k++) {
    const tp_factor_sign sign = sign_of(arb_mat_entry(factors, k, 0));
    tp_refuted_node_bears(s->finding->refuted, s->q->resting, s->reactions.all + k, sign);
  }
}

static tp_status prove(bool *proven, const balancing *s, tp_message *message) {
  const long count = s->reactions.count;
  double *preference = calloc((size_t)count + 1, sizeof *preference);
  if (preference == NULL) return tp_fail_memory(message, "a proof");
  arb_mat_t columns, right, factors;
  arb_mat_init(columns, s->rows, count);
  arb_mat_init(right, s->rows, 1);
  arb_mat_init(factors, count, 1);
  set_matrices(columns, right, factors, preference, s);
  const tp_basis_task task = {columns, right, preference, BITS};
  tp_status status = tp_basis_solve(factors, &task, message);
  *proven = status == TP_OK && keep_their_sign(factors, s);
  if (status == TP_NO_ANSWER) status = TP_OK;
  if (*proven && s->finding != NULL) widen(s, factors);
  arb_mat_clear(columns);
  arb_mat_clear(right);
  arb_mat_clear(factors);
  free(preference);
  return status;
}

/* Once; again where reactions were dropped. */
static tp_status try_balance(bool *balanced, bool *again, long *work, balancing *s,
                             tp_message *message) {
  tp_dense_program p;
  bool is_flat = false;
  s->rows = 0;
  number_rows(s);
  *again = *balanced = false;
  if (!tp_dense_program_init(&p, s->rows + 1, tp_reactions_columns(&s->reactions) + 1)) {
    return tp_fail_memory(message, "a proof");
  }
  const bool found = search(&is_flat, s, work, &p);
  if (is_flat) *again = drop_idle(s, &p);
  tp_dense_program_clear(&p);
  return found ? prove(balanced, s, message) : TP_OK;
}

static tp_status balance(bool *balanced, long *work, balancing *s, tp_message *message) {
  enum { MOST_ROUNDS = 64 };
  if (!tp_reactions_init(&s->reactions, s->node, s->q->resting)) {
    return tp_fail_memory(message, "a proof");
  }
  const size_t most = 2 * (size_t)s->reactions.count + 2;
  s->row = calloc((size_t)s->q->resting->rows + 1, sizeof *s->row);
  s->columns = calloc(most, sizeof *s->columns);
  s->factors = calloc(most, sizeof *s->factors);
  s->idle = calloc(most, sizeof *s->idle);
  s->signs = calloc((size_t)s->q->resting->rows + 1, sizeof *s->signs);
  const bool made = s->row != NULL && s->columns != NULL && s->factors != NULL && s->idle != NULL &&
                    s->signs != NULL;
  tp_status status = made ? TP_OK : tp_fail_memory(message, "a proof");
  bool again = true;
  for (int k = 0; k < MOST_ROUNDS && again && status == TP_OK; k++) {
    status = try_balance(balanced, &again, work, s, message);
  }
  tp_reactions_clear(&s->reactions);
  free(s->row);
  free(s->columns);
  free(s->factors);
  free(s->idle);
  free(s->signs);
  return status;
}

tp_status tp_modes_refute_by_reactions(bool *refuted, const tp_modes_finding *finding, long *work,
                                       const tp_modes_node *node, const tp_modes_question *q,
                                       tp_message *message) {
  tp_status status = TP_OK;
  *refuted = true;
  if (finding != NULL) tp_refuted_node_begin(finding->refuted, node, q);
  for (int k = 0; k < q->load_count && *refuted && status == TP_OK; k++) {
    balancing s = {.node = node, .q = q, .loads = q->loads[k], .finding = finding};
    *refuted = false;
    status = balance(refuted, work, &s, message);
  }
  if (status == TP_OK && *refuted && finding != NULL) {
    tp_known_proofs_add_reactions(finding->known, finding->refuted);
  }
  return status;
}
