/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Loads and rows are those of the program with friction; only its columns are others. */

#include "assemblage/constant_shear.h"

#include <stdlib.h>

/* A share of a column, always. */
static void add_dead(tp_force_program *p, const tp_force_column *column, double force) {
  for (int k = 0; k < 2; k++) {
    if (column->row[k] < 0) continue;
    for (int e = 0; e < 3; e++) {
      tp_near *row = p->dead + column->row[k] + e;
      *row = tp_near_plus(*row, tp_near_times((tp_near){force, 0}, column->entry[k][e]));
    }
  }
}

static int ends_of(const tp_contact_frame *f) {
  return f->ends[0] == f->ends[1] ? 1 : 2;
}

static void add_normals(tp_force_program *p, long contact, const tp_contact_frame *f) {
  const tp_near normal[2] = {tp_near_neg(f->dy), f->dx};
  for (int end = 0; end < ends_of(f); end++) {
    tp_contact_frame_column(p->columns + p->count++, p->assemblage, contact, f, end, normal);
  }
}

/* A contact without shear strength has no such column. */
static void add_shear(tp_force_program *p, long contact, const tp_contact_frame *f, double shear) {
  const tp_near along[2] = {f->dx, f->dy};
  if (!(shear > 0)) return;
  tp_force_column *column = p->columns + p->count++;
  tp_contact_frame_column(column, p->assemblage, contact, f, 0, along);
  column->most = (tp_near){2 * shear, 0};
  add_dead(p, column, -shear);
}

static void add_tension(tp_force_program *p, long contact, const tp_contact_frame *f,
                        tp_near tension) {
  const double all = tension.value * f->length.value;
  if (ends_of(f) == 1 || all == 0) return;
  for (int end = 0; end < 2; end++) add_dead(p, p->columns + p->first[contact] + end, -all / 2);
}

tp_status tp_constant_shear_program(tp_force_program *p, const tp_assemblage *a,
                                    const tp_contact_strength *strengths, const double *shear,
                                    const tp_weight_loads *loads, tp_message *message) {
  tp_contact_strength *none = calloc((size_t)a->contact_count + 1, sizeof *none);
  if (none == NULL) return tp_fail_memory(message, "the forces between blocks");
  tp_status status = tp_force_program_init(p, a, none, loads, message); /* for its loads */
  free(none);
  if (status != TP_OK) return status;
  p->count = 0;
  for (long k = 0; k < a->contact_count; k++) {
    const tp_contact_frame f = tp_contact_frame_of(a, k, (tp_near){0, 0});
    p->first[k] = p->count;
    add_normals(p, k, &f);
    add_tension(p, k, &f, strengths[k].tension);
    add_shear(p, k, &f, shear[k]);
  }
  p->first[a->contact_count] = p->count;
  return TP_OK;
}

double tp_constant_shear_normal(const tp_force_program *p, const double *forces, long contact) {
  double sum = 0;
  for (long k = p->first[contact]; k < p->first[contact + 1]; k++) {
    if (isinf(p->columns[k].most.value)) sum += forces[k];
  }
  return sum;
}
