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
  free(r->pieces);
  memset(r, 0, sizeof *r);
}

static void set_columns(tp_resting_contact *own, const tp_assemblage *a) {
  const tp_contact_frame f = tp_contact_frame_between(a, &own->of, (tp_near){0, 0});
  const tp_near normal[2] = {tp_near_neg(f.dy), f.dx}, along[2] = {f.dx, f.dy};
  own->ends = f.ends[0] == f.ends[1] ? 1 : 2;
  for (int e = 0; e < own->ends; e++) {
    tp_contact_frame_column_between(own->normal + e, a, &own->of, &f, e, normal);
  }
  tp_contact_frame_column_between(&own->along, a, &own->of, &f, 0, along);
}

/* ---- pieces of a line --------------------------------------------------------------------------
 */

/* Do two contacts of the same two blocks, edges both, lie on one line? */
static bool is_of_line(const tp_assemblage *a, const tp_block_contact *c,
                       const tp_block_contact *own) {
  const tp_lattice *l = &a->lattice;
  const long p = c->along[0], q = c->along[1];
  return c->ends[0] != c->ends[1] && own->ends[0] != own->ends[1] &&
         tp_lattice_cross(l, p, q, own->along[0], own->along[1]) == 0 &&
         tp_lattice_cross(l, p, q, c->ends[0], own->ends[0]) == 0;
}

static bool has_friction_of(const tp_contact_strength *one, const tp_contact_strength *other) {
  return one->tangent.value == other->tangent.value && one->tangent.error == other->tangent.error;
}

/* From end to end, as far as both reach; where the one lies along a line. */
static void reach(tp_block_contact *own, const tp_lattice *l, const tp_block_contact *piece) {
  const long p = own->along[0], q = own->along[1];
  if (tp_lattice_dot(l, p, q, own->ends[0], piece->ends[0]) < 0) own->ends[0] = piece->ends[0];
  if (tp_lattice_dot(l, p, q, own->ends[1], piece->ends[1]) > 0) own->ends[1] = piece->ends[1];
}

/* A contact of the assemblage becomes one of its own, or part of one before it. Those of two blocks
 * follow each other. */
static void take(tp_resting *r, const tp_contact_strength *strengths, long contact) {
  const tp_assemblage *a = r->assemblage;
  const tp_block_contact *own = a->contacts + contact;
  long line = -1;
  for (long k = contact - 1; k >= 0; k--) {
    const tp_block_contact *c = a->contacts + k;
    const bool alike = c->block[0] == own->block[0] && c->block[1] == own->block[1];
    const bool other = c->block[0] == own->block[1] && c->block[1] == own->block[0];
    if (!alike && !other) break;
    if (!alike || !is_of_line(a, c, own)) continue;
    const long of = r->pieces[k].contact;
    if (has_friction_of(strengths + k, strengths + contact)) {
      r->pieces[contact].contact = of;
      reach(&r->contacts[of].of, &a->lattice, own);
      return;
    }
    line = r->contacts[of].line;
  }
  const long added = r->contact_count++;
  r->pieces[contact].contact = added;
  r->contacts[added].of = *own;
  r->contacts[added].line = line < 0 ? added : line;
  r->contacts[added].twin = -1;
}

static void take_pair(tp_resting *r, const tp_corner_pair *pair) {
  const long first = r->contact_count;
  for (int side = 0; side < 2; side++) {
    const long added = r->contact_count++;
    r->contacts[added] = (tp_resting_contact){
        .of = pair->side[side], .line = added, .twin = side == 0 ? first + 1 : first};
  }
}

/* From one point to another of a contact's line, over the size of its columns. */
static tp_near length_between(const tp_assemblage *a, const tp_block_contact *of, long from,
                              long to) {
  tp_block_contact part = *of;
  part.ends[0] = from;
  part.ends[1] = to;
  return tp_contact_frame_between(a, &part, (tp_near){0, 0}).length;
}

static void measure(tp_resting *r, long contact) {
  static const tp_near half = {0.5, 0};
  const tp_assemblage *a = r->assemblage;
  tp_resting_piece *piece = r->pieces + contact;
  const tp_block_contact *of = &r->contacts[piece->contact].of;
  const long *ends = a->contacts[contact].ends;
  piece->length = length_between(a, of, ends[0], ends[1]);
  piece->share[0] = piece->share[1] = half;
  if (ends[0] == ends[1] || (ends[0] == of->ends[0] && ends[1] == of->ends[1])) return;
  const tp_near all =
      tp_near_times((tp_near){2, 0}, length_between(a, of, of->ends[0], of->ends[1]));
  for (int e = 0; e < 2; e++) { /* half of what is between its ends and the other end */
    const tp_near sum = tp_near_plus(length_between(a, of, ends[0], of->ends[1 - e]),
                                     length_between(a, of, ends[1], of->ends[1 - e]));
    piece->share[e] = tp_near_div(sum, all);
  }
}

tp_status tp_resting_init(tp_resting *r, const tp_assemblage *a,
                          const tp_contact_strength *strengths, tp_message *message) {
  *r = (tp_resting){.assemblage = a, .rows = 3 * a->free_count};
  r->block = calloc((size_t)a->free_count + 1, sizeof *r->block);
  r->contacts = calloc((size_t)(a->contact_count + 2 * a->pair_count) + 1, sizeof *r->contacts);
  r->pieces = calloc((size_t)a->contact_count + 1, sizeof *r->pieces);
  if (r->block == NULL || r->contacts == NULL || r->pieces == NULL) {
    tp_resting_clear(r);
    return tp_fail_memory(message, "the contacts of the blocks");
  }
  for (long k = 0; k < a->count; k++) {
    if (a->blocks[k].number >= 0) r->block[a->blocks[k].number] = k;
  }
  for (long k = 0; k < a->contact_count; k++) take(r, strengths, k);
  r->pair_first = r->contact_count;
  for (long k = 0; k < a->pair_count; k++) take_pair(r, a->pairs + k);
  for (long k = 0; k < r->contact_count; k++) set_columns(r->contacts + k, a);
  for (long k = 0; k < a->contact_count; k++) measure(r, k);
  return TP_OK;
}

tp_status tp_resting_loads(tp_near *rows, tp_near *central, bool *weights_alone,
                           const tp_resting *r, const tp_weight_loads *loads, tp_near live,
                           const tp_near *tension, tp_message *message) {
  tp_contact_strength *own = calloc((size_t)r->assemblage->contact_count + 1, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "the loads");
  bool pulls = false;
  for (long k = 0; k < r->assemblage->contact_count; k++) {
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
  *weights_alone = loads->applied == NULL && loads->push == NULL && !pulls;
  for (long b = 0; b < r->rows / 3; b++) {
    const tp_rigid_block *block = r->assemblage->blocks + r->block[b];
    tp_near moment[3] = {rows[3 * b], rows[3 * b + 1]};
    tp_sparse_moment(moment, &block->arm_x, &block->arm_y);
    central[3 * b + 2] =
        *weights_alone ? (tp_near){0, 0} : tp_near_minus(rows[3 * b + 2], moment[2]);
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
