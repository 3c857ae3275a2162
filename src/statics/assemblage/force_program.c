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

/* The contact's direction over a power of two, so that its size is about one; its ends. */
typedef struct frame {
  tp_near dx, dy, tangent;
  long ends[2];
} frame;

static frame frame_of(const tp_assemblage *a, const tp_block_contact *c, tp_near tangent) {
  const tp_lattice *l = &a->lattice;
  frame f = {.dx = tp_assemblage_length(a, l->x + c->from, l->x + c->to),
             .dy = tp_assemblage_length(a, l->y + c->from, l->y + c->to),
             .tangent = tangent,
             .ends = {c->ends[0], c->ends[1]}};
  const int exponent = ilogb(hypot(f.dx.value, f.dy.value) * hypot(1, tangent.value));
  tp_near *parts[] = {&f.dx, &f.dy};
  for (int k = 0; k < 2; k++) {
    parts[k]->value = ldexp(parts[k]->value, -exponent);
    parts[k]->error = ldexp(parts[k]->error, -exponent);
  }
  return f;
}

/* An edge of the cone at an end, on the block to the left; on the other one turned round. */
static void set_column(tp_force_column *column, const tp_assemblage *a, long contact,
                       const frame *f, int end, bool against) {
  *column = (tp_force_column){.contact = contact, .row = {-1, -1}};
  for (int k = 0; k < 2; k++) {
    const tp_rigid_block *block = a->blocks + a->contacts[contact].block[k];
    if (block->number < 0) continue;
    const tp_near arm_x = tp_assemblage_length(a, block->x, a->lattice.x + f->ends[end]);
    const tp_near arm_y = tp_assemblage_length(a, block->y, a->lattice.y + f->ends[end]);
    column->row[k] = 3 * block->number;
    tp_sparse_cone_edge(column->entry[k], &f->dx, &f->dy, &f->tangent, against);
    tp_sparse_moment(column->entry[k], &arm_x, &arm_y);
    if (k == 1) tp_sparse_reverse(column->entry[k]);
  }
}

static void set_loads(tp_force_program *p, const tp_assemblage *a, bool towards_left) {
  for (long k = 0; k < a->count; k++) {
    const tp_rigid_block *b = a->blocks + k;
    if (b->number < 0) continue;
    p->block[b->number] = k;
    tp_near *dead = p->dead + 3 * b->number, *live = p->live + 3 * b->number;
    dead[1] = tp_near_neg(b->weight);
    live[0] = towards_left ? tp_near_neg(b->weight) : b->weight;
    tp_sparse_moment(dead, &b->arm_x, &b->arm_y);
    tp_sparse_moment(live, &b->arm_x, &b->arm_y);
  }
}

tp_status tp_force_program_tilted(tp_force_program *p, const tp_assemblage *a,
                                  const tp_near *tangents, bool towards_left, tp_message *message) {
  memset(p, 0, sizeof *p);
  p->assemblage = a;
  p->rows = 3 * a->free_count;
  p->block = calloc((size_t)a->free_count + 1, sizeof *p->block);
  p->columns = calloc(4 * (size_t)a->contact_count + 1, sizeof *p->columns);
  p->first = calloc((size_t)a->contact_count + 1, sizeof *p->first);
  p->dead = calloc((size_t)p->rows + 1, sizeof *p->dead);
  p->live = calloc((size_t)p->rows + 1, sizeof *p->live);
  if (p->block == NULL || p->columns == NULL || p->first == NULL || p->dead == NULL ||
      p->live == NULL) {
    tp_force_program_clear(p);
    return tp_fail_memory(message, "the forces between blocks");
  }
  for (long k = 0; k < a->contact_count; k++) {
    const frame f = frame_of(a, a->contacts + k, tangents[k]);
    p->first[k] = p->count;
    for (int end = 0; end < (f.ends[0] == f.ends[1] ? 1 : 2); end++) {
      set_column(p->columns + p->count++, a, k, &f, end, false);
      set_column(p->columns + p->count++, a, k, &f, end, true);
    }
  }
  p->first[a->contact_count] = p->count;
  set_loads(p, a, towards_left);
  return TP_OK;
}
