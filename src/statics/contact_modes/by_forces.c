/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reactions c, and a share s >= 0 of the loads, whose accelerations y = M^-1 (A c + s w) no force
 * of the node resists: e . y < 0 for each of its edges, and w . y < 0. Searched by a linear program
 * that makes all of them as negative as they can be, with what cohesion and bonds may add, then
 * evaluated with bounds from the c and s that are found (contact_modes/forces_proof.h). */

#include "contact_modes/bond_pull.h"
#include "contact_modes/cohesive_shear.h"
#include "contact_modes/dense_program.h"
#include "contact_modes/forces_proof.h"
#include "contact_modes/pushed.h"
#include "contact_modes/reactions.h"
#include "contact_modes/refutation.h"
#include "contact_modes/refuted_node.h"
#include "contact_modes/resisting_edges.h"

#include "plane/contact_rows.h"

#include <stdlib.h>

/* What cohesion may add along a contact. */
typedef struct cohesive {
  const tp_force_column *along;
  tp_cohesive_shear own;
} cohesive;

/* A contact whose bond may pull by less than all, or elsewhere: the greatest bond of the question.
 */
typedef struct bonded {
  const tp_force_column *normal; /* at both ends */
  tp_near bond[2];
} bonded;

typedef struct resisting {
  const tp_modes_node *node;
  const tp_modes_question *q;
  tp_bearing_reactions reactions;
  tp_resisting_edges edges;
  long shear_count; /* of contacts that have some by cohesion */
  cohesive *shears;
  long bond_count; /* of contacts whose bonds may pull by less */
  bonded *bonds;
  double *columns, *factors;
  double share; /* of the loads */
  bool takes_loads;
  bool *idle;            /* by number of a free block: no reaction acts on it, so that its y is 0 */
  double *load_y;        /* by row: room */
  tp_near *wrenches, *y; /* by row */
} resisting;

/* ---- cohesion
 * -------------------------------------------------------------------------------------
 */

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

/* ---- bonds -------------------------------------------------------------------------------------
 */

/* Bonds of two loads are those of one over two numbers. */
static void set_bond(bonded *joint, const tp_modes_question *q, long contact) {
  joint->normal = q->resting->contacts[contact].normal;
  for (int e = 0; e < 2; e++) joint->bond[e] = (tp_near){0, 0};
  for (int load = 0; load < q->load_count; load++) {
    const tp_near *bond = q->bond[load] + 2 * contact;
    for (int e = 0; e < 2; e++) joint->bond[e] = tp_near_larger(joint->bond[e], bond[e]);
  }
}

static bool find_bonds(resisting *s) {
  const long count = s->q->resting->contact_count;
  s->bonds = calloc((size_t)count + 1, sizeof *s->bonds);
  for (long k = 0; k < count && s->bonds != NULL; k++) {
    if (tp_bond_varies(s->node, s->q, k)) set_bond(s->bonds + s->bond_count++, s->q, k);
  }
  return s->bonds != NULL;
}

/* ---- search ------------------------------------------------------------------------------------
 */

/* Edges are asked for each load where y has a share of it. */
static int copies_of_edges(const resisting *s) {
  return s->takes_loads ? s->q->load_count : 1;
}

static long row_of_power(const resisting *s, int load) {
  return copies_of_edges(s) * s->edges.count + load;
}

static long row_of_shear(const resisting *s, long shear) {
  return row_of_power(s, s->q->load_count) + shear;
}

static long row_of_bond(const resisting *s, long bond) {
  return row_of_shear(s, s->shear_count) + TP_BOND_WAYS * bond;
}

static long count_rows(const resisting *s) {
  return row_of_bond(s, s->bond_count) + 1;
}

/* What a column of the program opens at both ends. */
static void set_bond_rows(tp_dense_program *p, const resisting *s, long bond, const double u[2],
                          long column) {
  double powers[TP_BOND_WAYS];
  tp_bond_powers(powers, s->bonds[bond].bond, u);
  for (int way = 0; way < TP_BOND_WAYS; way++) {
    *tp_dense_program_entry(p, row_of_bond(s, bond) + way, column) = powers[way];
  }
}

static void set_column(tp_dense_program *p, const resisting *s, const tp_bearing_reaction *own,
                       double sign, long column) {
  const tp_pushed of = tp_pushed_by(own, s->node, s->q->resting);
  for (long r = 0; r < s->edges.count; r++) {
    const tp_resisting_edge *e = s->edges.all + r;
    const double entry =
        sign * (tp_pushed_along(&of, e->normal) + e->shear.value * tp_pushed_along(&of, e->along));
    for (int copy = 0; copy < copies_of_edges(s); copy++) {
      *tp_dense_program_entry(p, copy * s->edges.count + r, column) = entry;
    }
  }
  double least = 0; /* of what cohesion adds to the power of the loads */
  for (long k = 0; k < s->shear_count; k++) {
    const cohesive *c = s->shears + k;
    const double slip = sign * tp_pushed_along(&of, c->along);
    least += c->own.least.value * slip;
    *tp_dense_program_entry(p, row_of_shear(s, k), column) = slip;
  }
  for (long k = 0; k < s->bond_count; k++) {
    const tp_force_column *normal = s->bonds[k].normal;
    const double u[2] = {sign * tp_pushed_along(&of, normal + 0),
                         sign * tp_pushed_along(&of, normal + 1)};
    set_bond_rows(p, s, k, u, column);
  }
  for (int k = 0; k < s->q->load_count; k++) {
    *tp_dense_program_entry(p, row_of_power(s, k), column) =
        least + sign * tp_pushed_power(&of, s->q->loads[k]);
  }
}

/* M^-1 w, of one load, as far as blocks are not at rest. */
static void set_load(tp_dense_program *p, const resisting *s, int load, double *y, long column) {
  const tp_resting *r = s->q->resting;
  const tp_near *loads = s->q->loads[load];
  double sum = 0;
  for (long b = 0; b < r->rows / 3; b++) {
    double wrench[3];
    for (int e = 0; e < 3; e++) wrench[e] = s->node->still[b] ? 0 : loads[3 * b + e].value;
    tp_resting_accelerate_double(y + 3 * b, r->assemblage->blocks + r->block[b], wrench);
    for (int e = 0; e < 3; e++) sum += wrench[e] * y[3 * b + e];
  }
  for (long k = 0; k < s->edges.count; k++) {
    const tp_resisting_edge *e = s->edges.all + k;
    *tp_dense_program_entry(p, load * s->edges.count + k, column) =
        tp_resting_along_double(e->normal, y) +
        e->shear.value * tp_resting_along_double(e->along, y);
  }
  for (long k = 0; k < s->shear_count; k++) {
    const double slip = tp_resting_along_double(s->shears[k].along, y);
    sum += s->shears[k].own.least.value * slip;
    *tp_dense_program_entry(p, row_of_shear(s, k), column) = slip;
  }
  for (long k = 0; k < s->bond_count; k++) {
    const tp_force_column *normal = s->bonds[k].normal;
    const double u[2] = {tp_resting_along_double(normal + 0, y),
                         tp_resting_along_double(normal + 1, y)};
    set_bond_rows(p, s, k, u, column);
  }
  *tp_dense_program_entry(p, row_of_power(s, load), column) = sum;
}

/* The most that cohesion adds is its least shear times the slip y . t, and the rest of it times a
 * number that is no less than the slip or zero: a column more for each. */
static void set_shears(tp_dense_program *p, const resisting *s) {
  const long first = p->columns - 1 - s->bond_count - s->shear_count;
  for (long k = 0; k < s->shear_count; k++) {
    const cohesive *c = s->shears + k;
    *tp_dense_program_entry(p, row_of_shear(s, k), first + k) = -1;
    for (int load = 0; load < s->q->load_count; load++) {
      *tp_dense_program_entry(p, row_of_power(s, load), first + k) =
          c->own.most.value - c->own.least.value;
    }
  }
}

/* The most that another pull of a bond adds is a number that is no less than the power of each: a
 * column more for each bond. */
static void set_bonds(tp_dense_program *p, const resisting *s) {
  const long first = p->columns - 1 - s->bond_count;
  for (long k = 0; k < s->bond_count; k++) {
    for (int way = 0; way < TP_BOND_WAYS; way++) {
      *tp_dense_program_entry(p, row_of_bond(s, k) + way, first + k) = -1;
    }
    for (int load = 0; load < s->q->load_count; load++) {
      *tp_dense_program_entry(p, row_of_power(s, load), first + k) = 1;
    }
  }
}

/* All by d below zero, d <= 1 the greatest; what is to be zero is a little above, each by another
 * number, so that the method does not go in circles. */
static bool search(resisting *s, long *work, tp_dense_program *p) {
  static const double little = 1e-9, margin = 1e-8;
  enum { UNLIKE = 7919, OF = 101 };
  const long last = p->columns - 1;
  long column = 0;
  for (long k = 0; k < s->reactions.count; k++) {
    const tp_bearing_reaction *own = s->reactions.all + k;
    set_column(p, s, own, 1, column++);
    if (own->is_free) set_column(p, s, own, -1, column++);
  }
  if (s->takes_loads) {
    for (int k = 0; k < s->q->load_count; k++) set_load(p, s, k, s->load_y, column);
  }
  set_shears(p, s);
  set_bonds(p, s);
  for (long r = 0; r + 1 < p->rows; r++) {
    *tp_dense_program_entry(p, r, last) = r < row_of_shear(s, 0) ? 1 : 0;
    *tp_dense_program_right(p, r) = little * (1 + (double)(r * UNLIKE % OF) / OF);
  }
  *tp_dense_program_entry(p, p->rows - 1, last) = 1;
  *tp_dense_program_right(p, p->rows - 1) = 1;
  *tp_dense_program_entry(p, p->rows, last) = 1;
  p->is_limited = true; /* d <= 1 */
  p->tie = TP_DENSE_TIE;
  const bool found = tp_dense_program_climb(p, 0);
  *work += p->work;
  tp_dense_program_solution(s->columns, p);
  tp_reactions_join(s->factors, &s->reactions, s->columns);
  s->share = s->takes_loads ? s->columns[column] : 0;
  return found && s->columns[last] > margin;
}

/* Forces are the multipliers of rows. */
static void tell_why(tp_relaxed_motions *relaxed, const resisting *s, const tp_dense_program *p) {
  double *of_row = calloc((size_t)p->rows + (size_t)s->edges.count + 1, sizeof *of_row);
  if (of_row == NULL) return;
  tp_dense_program_multipliers(of_row, p, 0);
  const double *of_loads = of_row + row_of_power(s, 0);
  tp_relaxed_motions_add(relaxed, s->node, &s->edges, of_row, of_loads, copies_of_edges(s));
  free(of_row);
}

/* ---- proof -------------------------------------------------------------------------------------
 */

static bool is_not_above(tp_near number) {
  return number.value + number.error <= 0;
}

static bool prove(tp_forces_proof *p, const resisting *s, int load) {
  if (!tp_forces_proof_drives(p, load)) return false;
  for (long k = 0; k < s->edges.count; k++) {
    const tp_resisting_edge *e = s->edges.all + k;
    const tp_near shear = tp_near_times(e->shear, tp_resting_along(e->along, p->y));
    if (!is_not_above(tp_near_plus(tp_resting_along(e->normal, p->y), shear))) return false;
  }
  return true;
}

/* Edges between blocks that are idle are not asked: y is exactly 0 there, as what is refuted tells.
 */
static bool is_refuted(const tp_modes_node *refuted, const resisting *s) {
  for (long k = 0; k < s->q->resting->contact_count; k++) {
    const long *row = s->q->resting->contacts[k].along.row;
    if (tp_modes_rests(s->node, row[0]) && tp_modes_rests(s->node, row[1])) continue;
    if ((s->node->sets[k] & ~refuted->sets[k]) != 0) return false;
  }
  return true;
}

/* Of all loads; it is kept, with its signs. */
static bool prove_all(const resisting *s, const tp_modes_finding *finding) {
  tp_forces_proof p = {.node = s->node,
                       .question = s->q,
                       .reactions = &s->reactions,
                       .factors = s->factors,
                       .share = s->share,
                       .wrenches = s->wrenches,
                       .y = s->y};
  bool proven = true;
  if (finding != NULL) tp_refuted_node_begin(finding->refuted, s->node, s->q);
  for (int k = 0; k < s->q->load_count && proven; k++) {
    proven = prove(&p, s, k);
    if (proven && finding != NULL) tp_forces_proof_widen(finding->refuted, &p);
  }
  if (finding == NULL || !proven) return proven;
  if (!is_refuted(finding->refuted, s)) return false;
  tp_known_proofs_add_forces(finding->known, &p);
  return proven;
}

static bool rests(const resisting *s, long row) {
  return tp_modes_rests(s->node, row) || s->idle[row / 3];
}

/* Reactions on blocks that are idle, and edges between these alone, are not asked. */
static void drop_idle(resisting *s) {
  long kept = 0;
  for (long k = 0; k < s->reactions.count; k++) {
    const long *row = s->reactions.all[k].column->row;
    bool acts = true;
    for (int side = 0; side < 2; side++) acts = acts && (row[side] < 0 || !s->idle[row[side] / 3]);
    if (acts) s->reactions.all[kept++] = s->reactions.all[k];
  }
  s->reactions.count = kept;
  kept = 0;
  for (long k = 0; k < s->edges.count; k++) {
    const long *row = s->edges.all[k].normal->row;
    if (!rests(s, row[0]) || !rests(s, row[1])) s->edges.all[kept++] = s->edges.all[k];
  }
  s->edges.count = kept;
}

/* Forces of the multipliers that hold each other, without any load, keep blocks wedged: these
 * become idle. False: there are none. */
static bool find_wedged(resisting *s, const tp_dense_program *p) {
  static const double tiny = 1e-9;
  double *of_row = calloc((size_t)p->rows + 1, sizeof *of_row);
  bool found = false, loaded = of_row == NULL;
  if (of_row != NULL) tp_dense_program_multipliers(of_row, p, 0);
  for (int k = 0; k < s->q->load_count && !loaded; k++) loaded = of_row[row_of_power(s, k)] > tiny;
  for (long k = 0; k < copies_of_edges(s) * s->edges.count && !loaded; k++) {
    if (!(of_row[k] > tiny)) continue;
    const long *row = s->edges.all[k % s->edges.count].normal->row;
    for (int side = 0; side < 2; side++) {
      if (rests(s, row[side])) continue;
      s->idle[row[side] / 3] = found = true;
    }
  }
  free(of_row);
  return found;
}

static void clear(resisting *s, tp_dense_program *p) {
  tp_dense_program_clear(p);
  tp_reactions_clear(&s->reactions);
  tp_resisting_edges_clear(&s->edges);
  free(s->shears);
  free(s->bonds);
  free(s->columns);
  free(s->factors);
  free(s->wrenches);
  free(s->y);
  free(s->load_y);
}

/* With some blocks idle, or none. */
static bool make(resisting *s, tp_dense_program *p, bool some_idle) {
  const size_t rows = (size_t)s->q->resting->rows + 1;
  if (!tp_reactions_init(&s->reactions, s->node, s->q->resting) ||
      !tp_resisting_edges_init(&s->edges, s->node, s->q) || !find_shears(s) || !find_bonds(s)) {
    return false;
  }
  if (some_idle) drop_idle(s);
  s->takes_loads =
      !some_idle && (s->q->load_count == 1 || (s->shear_count == 0 && s->bond_count == 0));
  const long more = s->shear_count + s->bond_count;
  const size_t most = 2 * (size_t)s->reactions.count + (size_t)more + 3;
  s->columns = calloc(most, sizeof *s->columns);
  s->factors = calloc(most, sizeof *s->factors);
  s->wrenches = calloc(rows, sizeof *s->wrenches);
  s->y = calloc(rows, sizeof *s->y);
  s->load_y = calloc(rows, sizeof *s->load_y);
  return s->columns != NULL && s->factors != NULL && s->wrenches != NULL && s->y != NULL &&
         s->load_y != NULL &&
         tp_dense_program_init(p, count_rows(s),
                               tp_reactions_columns(&s->reactions) + s->takes_loads + more + 1);
}

/* Once; again where blocks became idle. */
static bool try_forces(bool *refuted, bool *again, const tp_modes_finding *finding, long *work,
                       resisting *s) {
  tp_dense_program p = {.rows = 0};
  const bool made = make(s, &p, *again);
  const bool is_first = !*again, tells = made && finding != NULL;
  *again = false;
  *refuted = made && search(s, work, &p);
  const bool is_plain = s->shear_count == 0 && s->bond_count == 0;
  if (tells && !*refuted && is_first && is_plain) tell_why(finding->relaxed, s, &p);
  if (tells && !*refuted && finding->is_last) *again = find_wedged(s, &p);
  if (*refuted) *refuted = prove_all(s, finding);
  clear(s, &p);
  return made;
}

tp_status tp_modes_refute_by_forces(bool *refuted, const tp_modes_finding *finding, long *work,
                                    const tp_modes_node *node, const tp_modes_question *q,
                                    tp_message *message) {
  bool *idle = calloc((size_t)(q->resting->rows / 3) + 1, sizeof *idle);
  bool made = idle != NULL, again = false;
  *refuted = false;
  do {
    resisting s = {.node = node, .q = q, .idle = idle};
    made = made && try_forces(refuted, &again, finding, work, &s);
  } while (made && again && !*refuted);
  free(idle);
  return made ? TP_OK : tp_fail_memory(message, "a proof");
}
