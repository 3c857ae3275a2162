/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* From the dual solution of the linear program: multipliers of its rows are forces, its columns say
 * that the accelerations are those of the node. In doubles: nothing is proven by them. */

#include "contact_modes/relaxed_motions.h"

#include "contact_modes/corner_modes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of an end e: it parts, or would enter; an edge of its cone is used, against a slip forward or
 * back. */
enum {
  PARTS = 1,
  ENTERS = 4,
  RESISTS_FORWARD = 16,
  RESISTS_BACK = 64, /* each times 1 or 2, by end */
  SLIPS_FORWARD = 256,
  SLIPS_BACK = 512
};

static const double tiny = 1e-9;

static void clear_one(tp_relaxed_motion *m) {
  free(m->does);
  free(m->still);
  free(m->idle);
  *m = (tp_relaxed_motion){.does = NULL};
}

bool tp_relaxed_motions_init(tp_relaxed_motions *m, const tp_modes_question *q) {
  const size_t rows = (size_t)q->resting->rows + 1;
  *m = (tp_relaxed_motions){.question = q,
                            .rows = calloc(rows, sizeof *m->rows),
                            .accelerations = calloc(rows, sizeof *m->accelerations),
                            .sum = calloc(rows, sizeof *m->sum)};
  if (m->rows != NULL && m->accelerations != NULL && m->sum != NULL) return true;
  tp_relaxed_motions_clear(m);
  return false;
}

void tp_relaxed_motions_clear(tp_relaxed_motions *m) {
  for (long k = 0; k < m->count; k++) clear_one(m->all + k);
  free(m->rows);
  free(m->accelerations);
  free(m->sum);
  *m = (tp_relaxed_motions){.question = m->question};
}

/* ---- what it does ------------------------------------------------------------------------------
 */

static void push(double *rows, const tp_force_column *c, double factor) {
  for (int side = 0; side < 2; side++) {
    for (int e = 0; e < 3 && c->row[side] >= 0; e++) {
      rows[c->row[side] + e] += factor * c->entry[side][e].value;
    }
  }
}

static void accelerate(tp_relaxed_motions *m, const tp_modes_node *n) {
  const tp_resting *r = m->question->resting;
  for (long b = 0; b < r->rows / 3; b++) {
    const tp_rigid_block *own = r->assemblage->blocks + r->block[b];
    tp_resting_accelerate_double(m->accelerations + 3 * b, own, m->rows + 3 * b);
    for (int e = 0; e < 3 && n->still[b]; e++) m->accelerations[3 * b + e] = 0;
  }
}

/* Of one load; its power is added. */
static void add_load(tp_relaxed_motion *own, double *power, tp_relaxed_motions *m,
                     const tp_modes_node *n, const tp_resisting_edges *edges,
                     const double *of_edges, double of_load, int load) {
  const tp_resting *r = m->question->resting;
  const tp_near *loads = m->question->loads[load];
  for (long k = 0; k < r->rows; k++) m->rows[k] = of_load * loads[k].value;
  for (long k = 0; k < edges->count && of_edges != NULL; k++) {
    const tp_resisting_edge *e = edges->all + k;
    if (!(of_edges[k] > tiny)) continue;
    push(m->rows, e->normal, of_edges[k]);
    push(m->rows, e->along, of_edges[k] * e->shear.value);
    const unsigned resists = (unsigned)(e->shear.value < 0 ? RESISTS_FORWARD : RESISTS_BACK);
    own->does[e->contact] |= (uint16_t)(resists << e->end);
  }
  accelerate(m, n);
  for (long k = 0; k < r->rows; k++) {
    m->sum[k] += m->accelerations[k];
    *power += loads[k].value * m->accelerations[k];
    if (fabs(m->accelerations[k]) > tiny) own->idle[k / 3] = false;
  }
}

static uint16_t velocities_of(const tp_resting_contact *c, const double *a) {
  unsigned does = 0;
  for (int e = 0; e < c->ends; e++) {
    const double parts = tp_resting_along_double(c->normal + e, a);
    if (parts > tiny) does |= PARTS << e;
    if (parts < -tiny) does |= ENTERS << e;
  }
  const double slips = tp_resting_along_double(&c->along, a);
  if (slips > tiny) does |= SLIPS_FORWARD;
  if (slips < -tiny) does |= SLIPS_BACK;
  return (uint16_t)does;
}

static bool init_one(tp_relaxed_motion *own, const tp_modes_node *n, const tp_resting *r) {
  const size_t blocks = (size_t)r->rows / 3;
  *own = (tp_relaxed_motion){.does = calloc((size_t)r->contact_count + 1, sizeof *own->does),
                             .still = calloc(blocks + 1, sizeof *own->still),
                             .idle = calloc(blocks + 1, sizeof *own->idle)};
  if (own->does == NULL || own->still == NULL || own->idle == NULL) {
    clear_one(own); /* it only saves work */
    return false;
  }
  memcpy(own->still, n->still, blocks * sizeof *own->still);
  for (size_t b = 0; b < blocks; b++) own->idle[b] = true;
  return true;
}

static void keep(tp_relaxed_motions *m, const tp_relaxed_motion *own) {
  if (m->count == TP_MOST_RELAXED) clear_one(m->all + --m->count);
  memmove(m->all + 1, m->all, (size_t)m->count * sizeof *m->all);
  m->all[0] = *own;
  m->count++;
}

void tp_relaxed_motions_add(tp_relaxed_motions *m, const tp_modes_node *n,
                            const tp_resisting_edges *edges, const double *of_edges,
                            const double *of_loads, int copies) {
  const tp_resting *r = m->question->resting;
  tp_relaxed_motion own;
  if (!init_one(&own, n, r)) return;
  double power = 0;
  memset(m->sum, 0, (size_t)r->rows * sizeof *m->sum);
  for (int k = 0; k < m->question->load_count; k++) {
    const double *of_copy = k < copies ? of_edges + k * edges->count : NULL;
    add_load(&own, &power, m, n, edges, of_copy, of_loads[k], k);
  }
  for (long k = 0; k < r->contact_count; k++) {
    own.does[k] |= velocities_of(r->contacts + k, m->sum);
  }
  own.has_forces = true;
  own.drives = power > tiny;
  keep(m, &own);
}

void tp_relaxed_motions_add_driven(tp_relaxed_motions *m, const tp_modes_node *n, const double *a) {
  const tp_resting *r = m->question->resting;
  tp_relaxed_motion own;
  if (!init_one(&own, n, r)) return;
  for (long k = 0; k < r->rows; k++) {
    if (fabs(a[k]) > tiny) own.idle[k / 3] = false;
  }
  for (long k = 0; k < r->contact_count; k++) own.does[k] = velocities_of(r->contacts + k, a);
  own.drives = true;
  keep(m, &own);
}

/* ---- is it one of a node? ----------------------------------------------------------------------
 */

/* Does a set allow the velocities of a contact? */
static bool allows_velocity(tp_mode_set set, unsigned does, int ends) {
  for (int e = 0; e < ends; e++) {
    if ((does & (ENTERS << e)) != 0) return false;
    if ((does & (PARTS << e)) != 0 && (set & ~tp_modes_closed(e)) == 0) return false;
  }
  if ((does & SLIPS_FORWARD) != 0 && (set & (TP_MODES_FORWARD | TP_MODES_OPEN)) == 0) return false;
  return (does & SLIPS_BACK) == 0 || (set & (TP_MODES_BACK | TP_MODES_OPEN)) != 0;
}

static bool allows_forces(tp_mode_set set, unsigned does, int ends) {
  for (int e = 0; e < ends; e++) {
    const tp_mode_set closed = set & tp_modes_closed(e);
    if ((does & (RESISTS_FORWARD << e)) != 0 &&
        (closed & (TP_MODES_STICK | TP_MODES_FORWARD)) == 0) {
      return false;
    }
    if ((does & (RESISTS_BACK << e)) != 0 && (closed & (TP_MODES_STICK | TP_MODES_BACK)) == 0) {
      return false;
    }
  }
  return true;
}

static bool is_of(const tp_relaxed_motion *m, tp_relaxed_kind kind, long *work,
                  const tp_modes_node *n, const tp_resting *r) {
  for (long b = 0; b < r->rows / 3; b++) {
    if (m->still[b] ? !n->still[b] : n->still[b] && !m->idle[b]) return false;
  }
  for (long k = 0; k < r->contact_count; k++) {
    const tp_resting_contact *c = r->contacts + k;
    if (tp_modes_rests(n, c->along.row[0]) && tp_modes_rests(n, c->along.row[1])) continue;
    const tp_mode_set set = n->sets[k], bearing = tp_modes_bearing(n->sets, r, k);
    const bool is_told = set != 0 && tp_modes_is_told(n->sets, r, k);
    ++*work;
    if (is_told && !allows_velocity(set, m->does[k], c->ends)) return false;
    if (kind == TP_RELAXED_BY_FORCES && !allows_forces(bearing, m->does[k], c->ends)) return false;
  }
  return true;
}

bool tp_relaxed_motions_have(tp_relaxed_motions *m, tp_relaxed_kind kind, long *work,
                             const tp_modes_node *n) {
  for (long k = 0; k < m->count; k++) {
    const tp_relaxed_motion own = m->all[k];
    if (!(kind == TP_RELAXED_DRIVEN ? own.drives : own.has_forces)) continue;
    if (!is_of(&own, kind, work, n, m->question->resting)) continue;
    memmove(m->all + 1, m->all, (size_t)k * sizeof *m->all);
    m->all[0] = own;
    return true;
  }
  return false;
}
