/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Differences of whole numbers, exact or rounded once, times powers of two. */

#include "assemblage/contact_frame.h"

#include "plane/contact_rows.h"

static void scale(tp_near *number, int exponent) {
  number->value = ldexp(number->value, exponent);
  number->error = ldexp(number->error, exponent);
}

tp_contact_frame tp_contact_frame_between(const tp_assemblage *a, const tp_block_contact *c,
                                          tp_near tangent) {
  const tp_lattice *l = &a->lattice;
  tp_contact_frame f = {.dx = tp_assemblage_length(a, l->x + c->along[0], l->x + c->along[1]),
                        .dy = tp_assemblage_length(a, l->y + c->along[0], l->y + c->along[1]),
                        .ends = {c->ends[0], c->ends[1]}};
  f.exponent = ilogb(hypot(f.dx.value, f.dy.value) * hypot(1, tangent.value));
  scale(&f.dx, -f.exponent);
  scale(&f.dy, -f.exponent);
  if (f.ends[0] == f.ends[1]) return f;
  const tp_near x = tp_assemblage_length(a, l->x + c->ends[0], l->x + c->ends[1]);
  const tp_near y = tp_assemblage_length(a, l->y + c->ends[0], l->y + c->ends[1]);
  const tp_near along = tp_near_plus(tp_near_times(x, f.dx), tp_near_times(y, f.dy));
  const tp_near size = tp_near_plus(tp_near_times(f.dx, f.dx), tp_near_times(f.dy, f.dy));
  f.length = tp_near_div(along, size);
  if (f.length.value < 0) f.length = tp_near_neg(f.length);
  return f;
}

tp_contact_frame tp_contact_frame_of(const tp_assemblage *a, long contact, tp_near tangent) {
  return tp_contact_frame_between(a, a->contacts + contact, tangent);
}

void tp_contact_frame_column(tp_force_column *column, const tp_assemblage *a, long contact,
                             const tp_contact_frame *f, int end, const tp_near force[2]) {
  tp_contact_frame_column_between(column, a, a->contacts + contact, f, end, force);
  column->contact = contact;
}

void tp_contact_frame_column_between(tp_force_column *column, const tp_assemblage *a,
                                     const tp_block_contact *contact, const tp_contact_frame *f,
                                     int end, const tp_near force[2]) {
  *column = (tp_force_column){.contact = -1, .row = {-1, -1}, .most = {INFINITY, 0}};
  for (int k = 0; k < 2; k++) {
    const tp_rigid_block *block = a->blocks + contact->block[k];
    if (block->number < 0) continue;
    const tp_near arm_x = tp_assemblage_length(a, block->x, a->lattice.x + f->ends[end]);
    const tp_near arm_y = tp_assemblage_length(a, block->y, a->lattice.y + f->ends[end]);
    column->row[k] = 3 * block->number;
    column->entry[k][0] = force[0];
    column->entry[k][1] = force[1];
    tp_sparse_moment(column->entry[k], &arm_x, &arm_y);
    if (k == 1) tp_sparse_reverse(column->entry[k]);
  }
}
