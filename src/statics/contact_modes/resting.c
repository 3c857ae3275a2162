/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* About a block's own point p, with r from there to its centroid, F = m (a + theta z x r) and the
 * moment about p is I theta + r x F, I = m (k_p^2 - r^2) about the centroid. */

#include "contact_modes/resting.h"

#include "plane/contact_rows.h"

#include <stdlib.h>
#include <string.h>

void tp_resting_clear(tp_resting *r) {
  free(r->block);
  free(r->contacts);
  memset(r, 0, sizeof *r);
}

static void set_contact(tp_resting_contact *own, const tp_assemblage *a, long contact) {
  const tp_contact_frame f = tp_contact_frame_of(a, contact, (tp_near){0, 0});
  const tp_near normal[2] = {tp_near_neg(f.dy), f.dx}, along[2] = {f.dx, f.dy};
  own->ends = f.ends[0] == f.ends[1] ? 1 : 2;
  for (int e = 0; e < own->ends; e++) {
    tp_contact_frame_column(own->normal + e, a, contact, &f, e, normal);
  }
  tp_contact_frame_column(&own->along, a, contact, &f, 0, along);
  own->length = f.length;
}

/* Contacts of two blocks follow each other. */
static long line_of(const tp_assemblage *a, long contact) {
  const tp_block_contact *own = a->contacts + contact;
  for (long k = contact - 1; k >= 0; k--) {
    const tp_block_contact *c = a->contacts + k;
    const bool alike = c->block[0] == own->block[0] && c->block[1] == own->block[1];
    const bool other = c->block[0] == own->block[1] && c->block[1] == own->block[0];
    if (!alike && !other) break;
    if (!alike || c->ends[0] == c->ends[1]) continue;
    const long p = c->along[0], q = c->along[1];
    if (tp_lattice_cross(&a->lattice, p, q, own->along[0], own->along[1]) == 0 &&
        tp_lattice_cross(&a->lattice, p, q, c->ends[0], own->ends[0]) == 0) {
      return k;
    }
  }
  return contact;
}

/* The first of them all. */
static void set_line(tp_resting *r, long contact) {
  const long before = line_of(r->assemblage, contact);
  r->contacts[contact].line = before < contact ? r->contacts[before].line : contact;
}

tp_status tp_resting_init(tp_resting *r, const tp_assemblage *a, tp_message *message) {
  *r = (tp_resting){.assemblage = a, .rows = 3 * a->free_count, .contact_count = a->contact_count};
  r->block = calloc((size_t)a->free_count + 1, sizeof *r->block);
  r->contacts = calloc((size_t)a->contact_count + 1, sizeof *r->contacts);
  if (r->block == NULL || r->contacts == NULL) {
    tp_resting_clear(r);
    return tp_fail_memory(message, "the contacts of the blocks");
  }
  for (long k = 0; k < a->count; k++) {
    if (a->blocks[k].number >= 0) r->block[a->blocks[k].number] = k;
  }
  for (long k = 0; k < a->contact_count; k++) {
    set_contact(r->contacts + k, a, k);
    set_line(r, k);
  }
  return TP_OK;
}

tp_status tp_resting_loads(tp_near *rows, tp_near *central, const tp_resting *r,
                           const tp_weight_loads *loads, tp_near live, const tp_near *tension,
                           tp_message *message) {
  tp_contact_strength *own = calloc((size_t)r->contact_count + 1, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "the loads");
  bool pulls = false;
  for (long k = 0; k < r->contact_count; k++) {
    own[k].tension = tension[k];
    pulls = pulls || !tp_near_is_zero(tension[k]);
  }
  tp_force_program p;
  const tp_status status = tp_force_program_init(&p, r->assemblage, own, loads, message);
  free(own);
  if (status != TP_OK) return status;
  for (long k = 0; k < r->rows; k++) {
    rows[k] = tp_near_plus(p.dead[k], tp_near_times(live, p.live[k]));
    central[k] = rows[k];
  }
  const bool weights_alone = loads->applied == NULL && loads->push == NULL && !pulls;
  for (long b = 0; b < r->rows / 3; b++) {
    const tp_rigid_block *block = r->assemblage->blocks + r->block[b];
    tp_near moment[3] = {rows[3 * b], rows[3 * b + 1]};
    tp_sparse_moment(moment, &block->arm_x, &block->arm_y);
    central[3 * b + 2] =
        weights_alone ? (tp_near){0, 0} : tp_near_minus(rows[3 * b + 2], moment[2]);
  }
  tp_force_program_clear(&p);
  return TP_OK;
}

void tp_resting_accelerate(tp_near own[3], const tp_rigid_block *b, const tp_near wrench[3]) {
  const tp_near x = tp_near_div(wrench[0], b->weight), y = tp_near_div(wrench[1], b->weight);
  const tp_near arm2 =
      tp_near_plus(tp_near_times(b->arm_x, b->arm_x), tp_near_times(b->arm_y, b->arm_y));
  const tp_near force_moment =
      tp_near_minus(tp_near_times(b->arm_x, y), tp_near_times(b->arm_y, x));
  const tp_near moment = tp_near_minus(tp_near_div(wrench[2], b->weight), force_moment);
  own[2] = tp_near_div(moment, tp_near_minus(b->gyration2, arm2));
  own[0] = tp_near_plus(x, tp_near_times(own[2], b->arm_y));
  own[1] = tp_near_minus(y, tp_near_times(own[2], b->arm_x));
}

void tp_resting_accelerate_double(double own[3], const tp_rigid_block *b, const double wrench[3]) {
  const double x = wrench[0] / b->weight.value, y = wrench[1] / b->weight.value;
  const double rx = b->arm_x.value, ry = b->arm_y.value;
  const double moment = wrench[2] / b->weight.value - (rx * y - ry * x);
  own[2] = moment / (b->gyration2.value - rx * rx - ry * ry);
  own[0] = x + own[2] * ry;
  own[1] = y - own[2] * rx;
}

tp_near tp_resting_along(const tp_force_column *c, const tp_near *rows) {
  tp_near sum = {0, 0};
  for (int side = 0; side < 2; side++) {
    for (int e = 0; e < 3 && c->row[side] >= 0; e++) {
      sum = tp_near_plus(sum, tp_near_times(c->entry[side][e], rows[c->row[side] + e]));
    }
  }
  return sum;
}

double tp_resting_along_double(const tp_force_column *c, const double *rows) {
  double sum = 0;
  for (int side = 0; side < 2; side++) {
    for (int e = 0; e < 3 && c->row[side] >= 0; e++) {
      sum += c->entry[side][e].value * rows[c->row[side] + e];
    }
  }
  return sum;
}
