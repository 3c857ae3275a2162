/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Column by column as assemblage/force_program.c has them, with directions of contacts as they are
 * on the lattice and moments in its steps. */

#include "assemblage/exact_program.h"

#include <arb.h>
#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include <string.h>

static const fmpq one = {1, 1};

static fmpq *column_of(const tp_exact_program *p, long k) {
  return p->columns + k * p->forces->rows;
}

static long steps_exponent(const tp_exact_program *p) {
  return p->forces->assemblage->length_exponent;
}

static void scale(fmpq_t number, long exponent) {
  if (exponent >= 0) {
    fmpq_mul_2exp(number, number, (ulong)exponent);
  } else {
    fmpq_div_2exp(number, number, (ulong)-exponent);
  }
}

static void set_double(fmpq_t number, double of) {
  arf_t own;
  arf_init(own);
  arf_set_d(own, of);
  arf_get_fmpq(number, own);
  arf_clear(own);
}

/* The end of what encloses a strength, which is not below zero. False: it is not finite. */
static bool set_strength(fmpq_t number, const tp_exact_program *p, tp_near strength) {
  if (!isfinite(strength.value) || !isfinite(strength.error)) return false;
  fmpq_t error;
  fmpq_init(error);
  set_double(number, strength.value);
  set_double(error, p->greatest ? strength.error : -strength.error);
  fmpq_add(number, number, error);
  if (fmpq_sgn(number) < 0) fmpq_zero(number);
  fmpq_clear(error);
  return true;
}

/* ---- contacts ----------------------------------------------------------------------------------
 */

/* Along a contact, in lattice steps; and what its length is to that of this. */
typedef struct exact_frame {
  const tp_block_contact *of;
  fmpq along[2], length;
} exact_frame;

static void difference(fmpq *to, const fmpz *coordinates, long from, long end) {
  fmpz_sub(fmpq_numref(to), coordinates + end, coordinates + from);
  fmpz_one(fmpq_denref(to));
}

static void frame_init(exact_frame *f, const tp_assemblage *a, long contact) {
  const tp_lattice *l = &a->lattice;
  const tp_block_contact *c = a->contacts + contact;
  fmpq ends[2], size;
  f->of = c;
  fmpq_init(&f->length);
  fmpq_init(&size);
  for (int k = 0; k < 2; k++) {
    fmpq_init(f->along + k);
    fmpq_init(ends + k);
    difference(f->along + k, k == 0 ? l->x : l->y, c->along[0], c->along[1]);
    difference(ends + k, k == 0 ? l->x : l->y, c->ends[0], c->ends[1]);
  }
  _fmpq_vec_dot(&f->length, ends, f->along, 2);
  _fmpq_vec_dot(&size, f->along, f->along, 2);
  fmpq_div(&f->length, &f->length, &size);
  fmpq_abs(&f->length, &f->length);
  for (int k = 0; k < 2; k++) fmpq_clear(ends + k);
  fmpq_clear(&size);
}

static void frame_clear(exact_frame *f) {
  for (int k = 0; k < 2; k++) fmpq_clear(f->along + k);
  fmpq_clear(&f->length);
}

/* So much of a force at an end, on the block to the left, and turned round on the other one. */
static void add_force(fmpq *rows, const tp_exact_program *p, const exact_frame *f, int end,
                      const fmpq force[2], const fmpq_t factor) {
  const tp_assemblage *a = p->forces->assemblage;
  fmpq own[2], arm;
  fmpq_init(&arm);
  for (int k = 0; k < 2; k++) {
    fmpq_init(own + k);
    fmpq_mul(own + k, force + k, factor);
  }
  for (int side = 0; side < 2; side++) {
    const tp_rigid_block *block = a->blocks + f->of->block[side];
    fmpq *to = rows + 3 * block->number;
    if (block->number >= 0) {
      for (int k = 0; k < 2; k++) fmpq_add(to + k, to + k, own + k);
      fmpz_sub(fmpq_numref(&arm), a->lattice.x + f->of->ends[end], block->x);
      fmpq_addmul(to + 2, &arm, own + 1);
      fmpz_sub(fmpq_numref(&arm), a->lattice.y + f->of->ends[end], block->y);
      fmpq_submul(to + 2, &arm, own);
    }
    for (int k = 0; k < 2; k++) fmpq_neg(own + k, own + k);
  }
  for (int k = 0; k < 2; k++) fmpq_clear(own + k);
  fmpq_clear(&arm);
}

static void normal_of(fmpq normal[2], const exact_frame *f) {
  fmpq_neg(normal, f->along + 1);
  fmpq_set(normal + 1, f->along);
}

/* n + t tan(phi), then n - t tan(phi), of each end. */
static bool set_cones(tp_exact_program *p, long first, long end, const exact_frame *f,
                      tp_near tangent) {
  fmpq edge[2], own;
  fmpq_init(&own);
  for (int k = 0; k < 2; k++) fmpq_init(edge + k);
  const bool finite = set_strength(&own, p, tangent);
  for (long c = first; c < end; c++) {
    normal_of(edge, f);
    for (int k = 0; k < 2; k++) fmpq_addmul(edge + k, f->along + k, &own);
    add_force(column_of(p, c), p, f, (c - first) / 2 == 1, edge, &one);
    fmpq_neg(&own, &own);
  }
  for (int k = 0; k < 2; k++) fmpq_clear(edge + k);
  fmpq_clear(&own);
  return finite;
}

/* Half of it at each end moves the apex of the cones. */
static bool add_tension(tp_exact_program *p, const exact_frame *f, tp_near tension) {
  fmpq normal[2], half;
  fmpq_init(&half);
  for (int k = 0; k < 2; k++) fmpq_init(normal + k);
  const bool finite = set_strength(&half, p, tension);
  fmpq_mul(&half, &half, &f->length);
  scale(&half, -1 - steps_exponent(p));
  normal_of(normal, f);
  for (int end = 0; end < 2; end++) add_force(p->target, p, f, end, normal, &half);
  for (int k = 0; k < 2; k++) fmpq_clear(normal + k);
  fmpq_clear(&half);
  return finite;
}

static bool set_cohesion(tp_exact_program *p, long column, const exact_frame *f, tp_near cohesion) {
  fmpq half;
  fmpq_init(&half);
  const bool finite = set_strength(&half, p, cohesion);
  fmpq_mul(&half, &half, &f->length);
  scale(&half, -steps_exponent(p));
  add_force(column_of(p, column), p, f, 0, f->along, &one);
  add_force(p->target, p, f, 0, f->along, &half);
  fmpq_mul_2exp(p->bounds + column, &half, 1);
  p->most[column] = p->bounds + column;
  fmpq_clear(&half);
  return finite;
}

static bool set_contact(tp_exact_program *p, long contact) {
  const tp_force_program *forces = p->forces;
  const tp_contact_strength *strength = p->strengths + contact;
  const tp_contact_frame in_doubles =
      tp_contact_frame_of(forces->assemblage, contact, strength->tangent);
  const bool is_point = in_doubles.ends[0] == in_doubles.ends[1];
  const long first = forces->first[contact], end = forces->first[contact + 1];
  const long cones = first + (is_point ? 2 : 4);
  exact_frame f;
  frame_init(&f, forces->assemblage, contact);
  bool finite = set_cones(p, first, cones, &f, strength->tangent);
  if (!is_point) finite = add_tension(p, &f, strength->tension) && finite;
  if (cones < end) finite = set_cohesion(p, cones, &f, strength->cohesion) && finite;
  for (long c = first; c < end; c++) {
    p->exponents[c] = steps_exponent(p) + in_doubles.exponent;
  }
  frame_clear(&f);
  return finite;
}

/* ---- loads -------------------------------------------------------------------------------------
 */

/* False: it is enclosed only. */
static bool set_exact(fmpq_t number, tp_near of) {
  const bool exact = of.error == 0 && isfinite(of.value);
  if (exact) set_double(number, of.value);
  return exact;
}

/* Weight and its first moments about the block's point. */
static void set_weight(fmpq weight[3], const tp_exact_program *p, long block) {
  const tp_assemblage *a = p->forces->assemblage;
  fmpz sums[TP_SUM_COUNT];
  static const fmpq third_part = {1, 3};
  fmpq_t density, third;
  for (int k = 0; k < TP_SUM_COUNT; k++) fmpz_init(sums + k);
  fmpq_init(density);
  tp_assemblage_sums(sums, a, block);
  tp_assemblage_density(density, a, block);
  scale(density, -a->weight_exponent);
  fmpq_init(third);
  fmpq_mul(third, density, &third_part);
  fmpq_mul_fmpz(weight, density, sums + TP_A2);
  fmpq_mul_fmpz(weight + 1, third, sums + TP_X6);
  fmpq_mul_fmpz(weight + 2, third, sums + TP_Y6);
  fmpq_clear(third);
  for (int axis = 0; axis < 2; axis++) {
    fmpq_mul_fmpz(density, weight, axis == 0 ? a->blocks[block].x : a->blocks[block].y);
    fmpq_sub(weight + 1 + axis, weight + 1 + axis, density);
  }
  fmpq_clear(density);
  for (int k = 0; k < TP_SUM_COUNT; k++) fmpz_clear(sums + k);
}

/* A weight times a direction, on the rows of its block. */
static bool add_weight(fmpq *to, const fmpq weight[3], const tp_near direction[2], bool reversed) {
  fmpq own[2];
  bool exact = true;
  for (int k = 0; k < 2; k++) {
    fmpq_init(own + k);
    exact = set_exact(own + k, direction[k]) && exact;
    if (reversed) fmpq_neg(own + k, own + k);
    fmpq_addmul(to + k, weight, own + k);
  }
  fmpq_addmul(to + 2, weight + 1, own + 1);
  fmpq_submul(to + 2, weight + 2, own);
  for (int k = 0; k < 2; k++) fmpq_clear(own + k);
  return exact;
}

static bool set_weights(tp_exact_program *p, const tp_weight_loads *loads) {
  bool exact = true;
  fmpq weight[3];
  for (int k = 0; k < 3; k++) fmpq_init(weight + k);
  for (long b = 0; b < p->forces->rows / 3 && exact; b++) {
    set_weight(weight, p, p->forces->block[b]);
    exact = add_weight(p->target + 3 * b, weight, loads->dead, true) &&
            add_weight(p->live + 3 * b, weight, loads->live, false);
  }
  for (int k = 0; k < 3; k++) fmpq_clear(weight + k);
  return exact;
}

/* Loads besides weights are enclosed in doubles: where there is nothing of them they are exact. */
static bool has_weights_alone(const tp_exact_program *p, const tp_weight_loads *loads) {
  for (long r = 0; r < p->forces->rows; r++) {
    if (loads->push != NULL && !tp_near_is_zero(loads->push[r])) return false;
    if (loads->applied == NULL) continue;
    const tp_applied_load *own = loads->applied + r;
    if (!tp_near_is_zero(own->steady) || !tp_near_is_zero(own->down[0]) ||
        !tp_near_is_zero(own->down[1])) {
      return false;
    }
  }
  return true;
}

/* ---- all ---------------------------------------------------------------------------------------
 */

void tp_exact_program_clear(tp_exact_program *p) {
  if (p->forces == NULL) return;
  _fmpq_vec_clear(p->columns, p->forces->rows * p->forces->count);
  _fmpq_vec_clear(p->bounds, p->forces->count);
  _fmpq_vec_clear(p->live, p->forces->rows);
  _fmpq_vec_clear(p->target, p->forces->rows);
  free(p->most);
  free(p->exponents);
  *p = (tp_exact_program){.forces = NULL};
}

tp_status tp_exact_program_init(bool *made, tp_exact_program *p, const tp_force_program *forces,
                                const tp_contact_strength *strengths, const tp_weight_loads *loads,
                                bool greatest, tp_message *message) {
  *p = (tp_exact_program){.forces = forces,
                          .strengths = strengths,
                          .greatest = greatest,
                          .columns = _fmpq_vec_init(forces->rows * forces->count),
                          .bounds = _fmpq_vec_init(forces->count),
                          .live = _fmpq_vec_init(forces->rows),
                          .target = _fmpq_vec_init(forces->rows),
                          .most = calloc((size_t)forces->count + 1, sizeof *p->most),
                          .exponents = calloc((size_t)forces->count + 1, sizeof *p->exponents)};
  *made = p->most != NULL && p->exponents != NULL;
  const tp_status status = *made ? TP_OK : tp_fail_memory(message, "the forces between blocks");
  *made = *made && has_weights_alone(p, loads) && set_weights(p, loads);
  for (long k = 0; k < forces->assemblage->contact_count && *made; k++) *made = set_contact(p, k);
  if (!*made) tp_exact_program_clear(p);
  return status;
}
