/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reactions c whose accelerations y = M^-1 A c no force of the node resists: e . y < 0 for each of
 * its edges, and w . y < 0. Searched by a linear program that makes all of them as negative as
 * they can be, with what cohesion may add, then evaluated with bounds from the c that are found:
 * whatever these are, y is theirs. */

#include "contact_modes/cohesive_shear.h"
#include "contact_modes/corner_modes.h"
#include "contact_modes/dense_program.h"
#include "contact_modes/reactions.h"

#include "plane/contact_rows.h"

#include <stdlib.h>

/* An edge of a cone: n at an end, and so much of t. */
typedef struct edge {
  const tp_force_column *normal, *along;
  tp_near shear;
} edge;

/* What cohesion may add along a contact. */
typedef struct cohesive {
  const tp_force_column *along;
  tp_cohesive_shear own;
} cohesive;

typedef struct resisting {
  const tp_modes_node *node;
  const tp_modes_question *q;
  tp_bearing_reactions reactions;
  long edge_count, shear_count; /* shears: of contacts that have some by cohesion */
  edge *edges;
  cohesive *shears;
  double *columns, *factors;
  tp_near *wrenches, *y; /* by row */
} resisting;

/* ---- edges -------------------------------------------------------------------------------------
 */

static void add_edge(resisting *s, const tp_resting_contact *c, int end, tp_near shear) {
  s->edges[s->edge_count++] = (edge){c->normal + end, &c->along, shear};
}

/* Of an end that can be closed: both edges of the cone where it can stick, and against the slip
 * else, with the least friction and the greatest. */
static void add_end(resisting *s, long contact, int end) {
  const tp_resting_contact *c = s->q->resting->contacts + contact;
  const tp_mode_set set =
      tp_modes_bearing(s->node->sets, s->q->resting, contact) & tp_modes_closed(end);
  if (set == 0) return;
  const bool sticks = (set & TP_MODES_STICK) != 0;
  const tp_near least = s->q->friction[0][contact], most = s->q->friction[1][contact];
  const bool same = least.value == most.value && least.error == most.error;
  if (sticks || (set & TP_MODES_FORWARD) != 0) {
    add_edge(s, c, end, tp_near_neg(most));
    if (!sticks && !same) add_edge(s, c, end, tp_near_neg(least));
  }
  if (sticks || (set & TP_MODES_BACK) != 0) {
    add_edge(s, c, end, most);
    if (!sticks && !same) add_edge(s, c, end, least);
  }
}

static bool find_edges(resisting *s) {
  enum { MOST = 8 }; /* of a contact */
  const tp_resting *r = s->q->resting;
  s->edges = calloc(MOST * (size_t)r->contact_count + 1, sizeof *s->edges);
  for (long k = 0; k < r->contact_count && s->edges != NULL; k++) {
    const tp_resting_contact *c = r->contacts + k;
    if (tp_modes_rests(s->node, c->along.row[0]) && tp_modes_rests(s->node, c->along.row[1])) {
      continue;
    }
    for (int e = 0; e < c->ends; e++) add_end(s, k, e);
  }
  return s->edges != NULL;
}

static bool find_shears(resisting *s) {
  const tp_resting *r = s->q->resting;
  s->shears = calloc((size_t)r->contact_count + 1, sizeof *s->shears);
  for (long k = 0; k < r->contact_count && s->shears != NULL; k++) {
    const tp_force_column *along = &r->contacts[k].along;
    if (tp_modes_rests(s->node, along->row[0]) && tp_modes_rests(s->node, along->row[1])) continue;
    const tp_cohesive_shear own = tp_cohesive_shear_of(s->node, s->q, k);
    if (tp_near_is_zero(own.least) && tp_near_is_zero(own.most)) continue;
    s->shears[s->shear_count++] = (cohesive){along, own};
  }
  return s->shears != NULL;
}

/* ---- search ------------------------------------------------------------------------------------
 */

/* Of a unit of a reaction on each of its blocks, in doubles. */
typedef struct pushed {
  long row[2];
  double y[2][3];
} pushed;

static pushed push(const resisting *s, const tp_bearing_reaction *own) {
  const tp_resting *r = s->q->resting;
  pushed p = {.row = {-1, -1}};
  for (int side = 0; side < 2; side++) {
    const long row = own->column->row[side];
    if (tp_modes_rests(s->node, row)) continue;
    double wrench[3];
    for (int e = 0; e < 3; e++) wrench[e] = own->sign * own->column->entry[side][e].value;
    p.row[side] = row;
    tp_resting_accelerate_double(p.y[side], r->assemblage->blocks + r->block[row / 3], wrench);
  }
  return p;
}

static double along(const tp_force_column *c, const pushed *p) {
  double sum = 0;
  for (int side = 0; side < 2; side++) {
    for (int own = 0; own < 2 && c->row[side] >= 0; own++) {
      if (p->row[own] != c->row[side]) continue;
      for (int e = 0; e < 3; e++) sum += c->entry[side][e].value * p->y[own][e];
    }
  }
  return sum;
}

static double power(const tp_near *loads, const pushed *p) {
  double sum = 0;
  for (int own = 0; own < 2; own++) {
    for (int e = 0; e < 3 && p->row[own] >= 0; e++) {
      sum += loads[p->row[own] + e].value * p->y[own][e];
    }
  }
  return sum;
}

static long row_of_shear(const resisting *s, long shear) {
  return s->edge_count + s->q->load_count + shear;
}

static void set_column(tp_dense_program *p, const resisting *s, const tp_bearing_reaction *own,
                       double sign, long column) {
  const pushed of = push(s, own);
  for (long r = 0; r < s->edge_count; r++) {
    const edge *e = s->edges + r;
    *tp_dense_program_entry(p, r, column) =
        sign * (along(e->normal, &of) + e->shear.value * along(e->along, &of));
  }
  double least = 0; /* of what cohesion adds to the power of the loads */
  for (long k = 0; k < s->shear_count; k++) {
    const cohesive *c = s->shears + k;
    const double slip = sign * along(c->along, &of);
    least += c->own.least.value * slip;
    *tp_dense_program_entry(p, row_of_shear(s, k), column) = slip;
  }
  for (int k = 0; k < s->q->load_count; k++) {
    *tp_dense_program_entry(p, s->edge_count + k, column) =
        least + sign * power(s->q->loads[k], &of);
  }
}

/* The most that cohesion adds is its least shear times the slip y . t, and the rest of it times a
 * number that is no less than the slip or zero: a column more for each. */
static void set_shears(tp_dense_program *p, const resisting *s) {
  const long first = p->columns - 1 - s->shear_count;
  for (long k = 0; k < s->shear_count; k++) {
    const cohesive *c = s->shears + k;
    *tp_dense_program_entry(p, row_of_shear(s, k), first + k) = -1;
    for (int load = 0; load < s->q->load_count; load++) {
      *tp_dense_program_entry(p, s->edge_count + load, first + k) =
          c->own.most.value - c->own.least.value;
    }
  }
}

/* All by d below zero, d <= 1 the greatest; what is to be zero is a little above, each by another
 * number, so that the method does not go in circles. */
static bool search(resisting *s, long *work, tp_dense_program *p) {
  static const double little = 1e-9, margin = 1e-6;
  enum { UNLIKE = 7919, OF = 101 };
  const long last = p->columns - 1;
  long column = 0;
  for (long k = 0; k < s->reactions.count; k++) {
    const tp_bearing_reaction *own = s->reactions.all + k;
    set_column(p, s, own, 1, column++);
    if (own->is_free) set_column(p, s, own, -1, column++);
  }
  set_shears(p, s);
  for (long r = 0; r + 1 < p->rows; r++) {
    *tp_dense_program_entry(p, r, last) = r < row_of_shear(s, 0) ? 1 : 0;
    *tp_dense_program_right(p, r) = little * (1 + (double)(r * UNLIKE % OF) / OF);
  }
  *tp_dense_program_entry(p, p->rows - 1, last) = 1;
  *tp_dense_program_right(p, p->rows - 1) = 1;
  *tp_dense_program_entry(p, p->rows, last) = 1;
  const bool found = tp_dense_program_climb(p, 0);
  *work += p->work;
  tp_dense_program_solution(s->columns, p);
  tp_reactions_join(s->factors, &s->reactions, s->columns);
  return found && s->columns[last] > margin;
}

/* ---- proof -------------------------------------------------------------------------------------
 */

static void find_y(resisting *s) {
  const tp_resting *r = s->q->resting;
  for (long k = 0; k < s->reactions.count; k++) {
    const tp_bearing_reaction *own = s->reactions.all + k;
    const tp_near factor = {own->sign * s->factors[k], 0};
    for (int side = 0; side < 2; side++) {
      const long row = own->column->row[side];
      for (int e = 0; e < 3 && !tp_modes_rests(s->node, row); e++) {
        s->wrenches[row + e] =
            tp_near_plus(s->wrenches[row + e], tp_near_times(factor, own->column->entry[side][e]));
      }
    }
  }
  for (long b = 0; b < r->rows / 3; b++) {
    if (s->node->still[b]) continue;
    tp_resting_accelerate(s->y + 3 * b, r->assemblage->blocks + r->block[b], s->wrenches + 3 * b);
  }
}

static bool is_not_above(tp_near number) {
  return number.value + number.error <= 0;
}

static bool prove(resisting *s) {
  find_y(s);
  for (long k = 0; k < s->edge_count; k++) {
    const edge *e = s->edges + k;
    const tp_near shear = tp_near_times(e->shear, tp_resting_along(e->along, s->y));
    if (!is_not_above(tp_near_plus(tp_resting_along(e->normal, s->y), shear))) return false;
  }
  tp_near cohesion = {0, 0};
  for (long k = 0; k < s->shear_count; k++) {
    const cohesive *c = s->shears + k;
    const tp_near slip = tp_resting_along(c->along, s->y);
    cohesion = tp_near_plus(cohesion, tp_near_larger(tp_near_times(c->own.least, slip),
                                                     tp_near_times(c->own.most, slip)));
  }
  for (int k = 0; k < s->q->load_count; k++) {
    tp_near sum = cohesion;
    for (long r = 0; r < s->q->resting->rows; r++) {
      sum = tp_near_plus(sum, tp_near_times(s->q->loads[k][r], s->y[r]));
    }
    if (tp_near_sign(sum) >= 0) return false;
  }
  return true;
}

static bool make(resisting *s, tp_dense_program *p) {
  const size_t rows = (size_t)s->q->resting->rows + 1;
  if (!tp_reactions_init(&s->reactions, s->node, s->q->resting) || !find_edges(s) ||
      !find_shears(s)) {
    return false;
  }
  const size_t most = 2 * (size_t)s->reactions.count + (size_t)s->shear_count + 2;
  s->columns = calloc(most, sizeof *s->columns);
  s->factors = calloc(most, sizeof *s->factors);
  s->wrenches = calloc(rows, sizeof *s->wrenches);
  s->y = calloc(rows, sizeof *s->y);
  return s->columns != NULL && s->factors != NULL && s->wrenches != NULL && s->y != NULL &&
         tp_dense_program_init(p, row_of_shear(s, s->shear_count) + 1,
                               tp_reactions_columns(&s->reactions) + s->shear_count + 1);
}

tp_status tp_modes_refute_by_forces(bool *refuted, long *work, const tp_modes_node *node,
                                    const tp_modes_question *q, tp_message *message) {
  resisting s = {.node = node, .q = q};
  tp_dense_program p = {.rows = 0};
  const bool made = make(&s, &p);
  *refuted = made && search(&s, work, &p) && prove(&s);
  tp_dense_program_clear(&p);
  tp_reactions_clear(&s.reactions);
  free(s.edges);
  free(s.shears);
  free(s.columns);
  free(s.factors);
  free(s.wrenches);
  free(s.y);
  return made ? TP_OK : tp_fail_memory(message, "a proof");
}
