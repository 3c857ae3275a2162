/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Columns from the lattice: differences of whole numbers, exact or rounded once, times powers of
 * two.
 */

#include "assemblage/force_program.h"

#include "plane/contact_rows.h"

#include <stdlib.h>
#include <string.h>

void tp_force_program_clear(tp_force_program *p) {
  free(p->block);
  free(p->columns);
  free(p->first);
  free(p->dead);
  free(p->live);
  memset(p, 0, sizeof *p);
}

/* So much of a column, always. */
static void add_dead(tp_force_program *p, const tp_force_column *column, tp_near force) {
  for (int k = 0; k < 2; k++) {
    if (column->row[k] < 0) continue;
    for (int e = 0; e < 3; e++) {
      tp_near *own = p->dead + column->row[k] + e;
      *own = tp_near_plus(*own, tp_near_times(force, column->entry[k][e]));
    }
  }
}

static void add_cones(tp_force_program *p, long contact, const tp_contact_frame *f,
                      const tp_contact_strength *strength) {
  for (int end = 0; end < (f->ends[0] == f->ends[1] ? 1 : 2); end++) {
    for (int against = 0; against < 2; against++) {
      tp_near edge[2];
      tp_sparse_cone_edge(edge, &f->dx, &f->dy, &strength->tangent, against == 1);
      tp_contact_frame_column(p->columns + p->count++, p->assemblage, contact, f, end, edge);
    }
  }
}

/* Half of it at each end, on the block to the left to its right. */
static void add_tension(tp_force_program *p, long contact, const tp_contact_frame *f,
                        tp_near tension) {
  const tp_near normal[2] = {tp_near_neg(f->dy), f->dx};
  const tp_near half = tp_near_neg(tp_near_times(tension, f->length));
  if (tp_near_is_zero(half)) return;
  for (int end = 0; end < 2; end++) {
    tp_force_column column;
    tp_contact_frame_column(&column, p->assemblage, contact, f, end, normal);
    add_dead(p, &column, (tp_near){half.value / 2, half.error / 2});
  }
}

static void add_cohesion(tp_force_program *p, long contact, const tp_contact_frame *f,
                         tp_near cohesion) {
  const tp_near along[2] = {f->dx, f->dy};
  const tp_near half = tp_near_times(cohesion, f->length);
  if (tp_near_is_zero(half)) return;
  tp_force_column *column = p->columns + p->count++;
  tp_contact_frame_column(column, p->assemblage, contact, f, 0, along);
  column->most = (tp_near){2 * half.value, 2 * half.error};
  add_dead(p, column, tp_near_neg(half));
}

static void set_other_loads(tp_force_program *p, const tp_weight_loads *loads) {
  for (long r = 0; r < p->rows; r++) {
    if (loads->push != NULL) p->live[r] = tp_near_plus(p->live[r], loads->push[r]);
    if (loads->applied == NULL) continue;
    const tp_applied_load *own = loads->applied + r;
    tp_near sum = tp_near_plus(p->dead[r], own->steady);
    for (int axis = 0; axis < 2; axis++) {
      sum = tp_near_plus(sum, tp_near_times(own->down[axis], loads->down[axis]));
    }
    p->dead[r] = sum;
  }
}

static void set_loads(tp_force_program *p, const tp_assemblage *a, const tp_weight_loads *loads) {
  for (long k = 0; k < a->count; k++) {
    const tp_rigid_block *b = a->blocks + k;
    if (b->number < 0) continue;
    p->block[b->number] = k;
    tp_near *dead = p->dead + 3 * b->number, *live = p->live + 3 * b->number;
    for (int axis = 0; axis < 2; axis++) {
      dead[axis] = tp_near_times(b->weight, loads->dead[axis]);
      live[axis] = tp_near_times(b->weight, loads->live[axis]);
    }
    tp_sparse_moment(dead, &b->arm_x, &b->arm_y);
    tp_sparse_moment(live, &b->arm_x, &b->arm_y);
  }
  set_other_loads(p, loads);
}

tp_weight_loads tp_weight_loads_tilted(bool towards_left) {
  return (tp_weight_loads){.dead = {{0, 0}, {-1, 0}},
                           .live = {{towards_left ? -1 : 1, 0}, {0, 0}},
                           .down = {{0, 0}, {-1, 0}}};
}

tp_status tp_force_program_init(tp_force_program *p, const tp_assemblage *a,
                                const tp_contact_strength *strengths, const tp_weight_loads *loads,
                                tp_message *message) {
  enum { MOST_COLUMNS = 5 }; /* of a contact */
  memset(p, 0, sizeof *p);
  p->assemblage = a;
  p->rows = 3 * a->free_count;
  p->block = calloc((size_t)a->free_count + 1, sizeof *p->block);
  p->columns = calloc(MOST_COLUMNS * (size_t)a->contact_count + 1, sizeof *p->columns);
  p->first = calloc((size_t)a->contact_count + 1, sizeof *p->first);
  p->dead = calloc((size_t)p->rows + 1, sizeof *p->dead);
  p->live = calloc((size_t)p->rows + 1, sizeof *p->live);
  if (p->block == NULL || p->columns == NULL || p->first == NULL || p->dead == NULL ||
      p->live == NULL) {
    tp_force_program_clear(p);
    return tp_fail_memory(message, "the forces between blocks");
  }
  set_loads(p, a, loads);
  for (long k = 0; k < a->contact_count; k++) {
    const tp_contact_frame f = tp_contact_frame_of(a, k, strengths[k].tangent);
    p->first[k] = p->count;
    add_cones(p, k, &f, strengths + k);
    if (f.ends[0] == f.ends[1]) continue; /* a point has no area */
    add_tension(p, k, &f, strengths[k].tension);
    add_cohesion(p, k, &f, strengths[k].cohesion);
  }
  p->first[a->contact_count] = p->count;
  return TP_OK;
}

double tp_force_column_work(const tp_force_column *c, const double *twists) {
  double sum = 0;
  for (int k = 0; k < 2; k++) {
    if (c->row[k] < 0) continue;
    for (int e = 0; e < 3; e++) sum += c->entry[k][e].value * twists[c->row[k] + e];
  }
  return sum;
}
