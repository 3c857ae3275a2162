/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rings of all blocks put on one lattice; areas and first moments as sums of whole numbers,
 * weights and centroids from them with bounds. */

#include "assemblage/assemblage.h"
#include "assemblage/nearest_block.h"

#include "common/outside.h"
#include "number/ball.h"

#include <stdlib.h>
#include <string.h>

enum { BITS = 128 };

void tp_assemblage_clear(tp_assemblage *a) {
  for (long k = 0; k < a->count && a->blocks != NULL; k++) {
    fmpz_clear(a->blocks[k].x);
    fmpz_clear(a->blocks[k].y);
  }
  free(a->blocks);
  free(a->contacts);
  free(a->pairs);
  tp_lattice_clear(&a->lattice);
  memset(a, 0, sizeof *a);
}

static tp_status put_on_lattice(tp_assemblage *a, const fmpq_t metres_per_unit,
                                tp_message *message) {
  long rings = 0;
  for (long k = 0; k < a->count; k++) rings += a->given[k].section->ring_count;
  const tp_polyline **chains = calloc((size_t)rings + 1, sizeof *chains);
  if (chains == NULL) return tp_fail_memory(message, "the blocks");
  long at = 0;
  for (long k = 0; k < a->count; k++) {
    const tp_section *section = a->given[k].section;
    a->blocks[k].ring = at;
    for (long r = 0; r < section->ring_count; r++) chains[at++] = section->rings + r;
  }
  const tp_status status = tp_lattice_init(&a->lattice, chains, rings, metres_per_unit, message);
  free(chains);
  return status;
}

/* Sums over one ring (block/ring_sums.h). */
static void add_ring(fmpz sums[TP_SUM_COUNT], const tp_lattice *l, long first, long end,
                     const fmpz_t weight) {
  fmpz own[TP_SUM_COUNT];
  for (int k = 0; k < TP_SUM_COUNT; k++) fmpz_init(own + k);
  tp_ring_sums_exact(own, l->x + first, l->y + first, end - first);
  for (int k = 0; k < TP_SUM_COUNT; k++) {
    fmpz_addmul(sums + k, own + k, weight);
    fmpz_clear(own + k);
  }
}

/* The whole number next to sum / (3 area2), and what is left of that. */
static void split(fmpz_t whole, arb_t rest, const fmpz_t sum, const fmpz_t area2) {
  fmpz_t thrice, left;
  fmpz_init(thrice);
  fmpz_init(left);
  fmpz_mul_ui(thrice, area2, 3);
  fmpz_fdiv_qr(whole, left, sum, thrice);
  arb_fmpz_div_fmpz(rest, left, thrice, BITS);
  fmpz_clear(thrice);
  fmpz_clear(left);
}

/* Sums of a block to its weight in kN per metre, the arms of its centroid in lattice steps, and the
 * moment of inertia over the mass in their squares. */
typedef struct weighed {
  arb_t weight, arm_x, arm_y, gyration2;
} weighed;

/* int (x - p)^2 + (y - q)^2 = (XX12 + YY12) / 12 - (p X6 + q Y6) / 3 + (p^2 + q^2) A2 / 2 over the
 * area, A2 / 2. */
static void set_gyration(arb_t gyration2, const tp_rigid_block *block,
                         const fmpz sums[TP_SUM_COUNT]) {
  fmpz_t sum, part;
  fmpz_init(sum);
  fmpz_init(part);
  fmpz_mul(part, block->x, block->x);
  fmpz_addmul(part, block->y, block->y);
  fmpz_mul(part, part, sums + TP_A2);
  fmpz_addmul_ui(sum, part, 6);
  fmpz_mul(part, block->x, sums + TP_X6);
  fmpz_addmul(part, block->y, sums + TP_Y6);
  fmpz_submul_ui(sum, part, 4);
  fmpz_add(sum, sum, sums + TP_XX12);
  fmpz_add(sum, sum, sums + TP_YY12);
  fmpz_mul_ui(part, sums + TP_A2, 6);
  arb_fmpz_div_fmpz(gyration2, sum, part, BITS);
  fmpz_clear(sum);
  fmpz_clear(part);
}

void tp_assemblage_sums(fmpz sums[TP_SUM_COUNT], const tp_assemblage *a, long block) {
  const tp_lattice *l = &a->lattice;
  const tp_section *section = a->given[block].section;
  for (int k = 0; k < TP_SUM_COUNT; k++) fmpz_zero(sums + k);
  for (long r = 0; r < section->ring_count; r++) {
    const long *start = l->start + a->blocks[block].ring + r;
    add_ring(sums, l, start[0], start[1], section->ring_weights + r);
  }
}

void tp_assemblage_density(fmpq_t kn, const tp_assemblage *a, long block) {
  fmpq_mul(kn, a->lattice.step_m, a->lattice.step_m);
  fmpq_mul(kn, kn, a->given[block].section->weight_unit);
  fmpq_div_2exp(kn, kn, 1);
}

static void weigh(weighed *w, tp_assemblage *a, long k) {
  tp_rigid_block *block = a->blocks + k;
  fmpz sums[TP_SUM_COUNT];
  for (int s = 0; s < TP_SUM_COUNT; s++) fmpz_init(sums + s);
  fmpq_t kn;
  fmpq_init(kn);
  tp_assemblage_sums(sums, a, k);
  split(block->x, w->arm_x, sums + TP_X6, sums + TP_A2);
  split(block->y, w->arm_y, sums + TP_Y6, sums + TP_A2);
  set_gyration(w->gyration2, block, sums);
  tp_assemblage_density(kn, a, k);
  fmpq_mul_fmpz(kn, kn, sums + TP_A2);
  arb_set_fmpq(w->weight, kn, BITS);
  fmpq_clear(kn);
  for (int s = 0; s < TP_SUM_COUNT; s++) fmpz_clear(sums + s);
}

/* Powers of two near the size of a block, as a mean of logarithms, and near its weight. */
static void choose_units(tp_assemblage *a, const weighed *w) {
  double size = 0, weight = 0;
  for (long k = 0; k < a->count; k++) {
    if (a->blocks[k].number < 0) continue;
    const long steps = a->blocks[k].end - a->blocks[k].outline;
    double widest = 0;
    for (long p = 1; p < steps; p++) {
      fmpz_t d;
      fmpz_init(d);
      fmpz_sub(d, a->lattice.x + a->blocks[k].outline + p, a->lattice.x + a->blocks[k].outline);
      widest = fmax(widest, (double)fmpz_bits(d));
      fmpz_sub(d, a->lattice.y + a->blocks[k].outline + p, a->lattice.y + a->blocks[k].outline);
      widest = fmax(widest, (double)fmpz_bits(d));
      fmpz_clear(d);
    }
    size += widest / (double)a->free_count;
    weight += tp_ball_log2_above(w[k].weight) / (double)a->free_count;
  }
  a->length_exponent = (long)size;
  a->weight_exponent = (long)weight;
}

/* What is exactly nothing stays so. */
static tp_near scaled(arb_t ball, long exponent) {
  if (arb_is_zero(ball)) return (tp_near){0, 0};
  arb_mul_2exp_si(ball, ball, -exponent);
  return tp_ball_near(ball);
}

static tp_status set_blocks(tp_assemblage *a, tp_message *message) {
  weighed *w = calloc((size_t)a->count, sizeof *w);
  if (w == NULL) return tp_fail_memory(message, "the blocks");
  for (long k = 0; k < a->count; k++) {
    tp_rigid_block *block = a->blocks + k;
    arb_init(w[k].weight);
    arb_init(w[k].arm_x);
    arb_init(w[k].arm_y);
    arb_init(w[k].gyration2);
    weigh(w + k, a, k);
    block->outline = a->lattice.start[block->ring];
    block->end = a->lattice.start[block->ring + 1];
    a->edge_count += block->end - block->outline;
    block->number = a->given[k].fixed ? -1 : a->free_count++;
  }
  if (a->free_count > 0) choose_units(a, w);
  for (long k = 0; k < a->count; k++) {
    a->blocks[k].weight = scaled(w[k].weight, a->weight_exponent);
    a->blocks[k].arm_x = scaled(w[k].arm_x, a->length_exponent);
    a->blocks[k].arm_y = scaled(w[k].arm_y, a->length_exponent);
    a->blocks[k].gyration2 = scaled(w[k].gyration2, 2 * a->length_exponent);
    arb_clear(w[k].weight);
    arb_clear(w[k].arm_x);
    arb_clear(w[k].arm_y);
    arb_clear(w[k].gyration2);
  }
  free(w);
  return TP_OK;
}

/* Noise of a survey is small beside a block. */
static tp_status fail_floating(const tp_assemblage *a, long block, tp_message *message) {
  static const double small = 0.05;
  const tp_given_block *own = a->given + block;
  double distance = 0;
  const long other = tp_nearest_block(&distance, a->given, a->count, block);
  const tp_quote name = tp_quote_all(own->name), next = tp_quote_all(a->given[other].name);
  if (distance == 0) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, own->place,
                     "block '%s' touches no other but '%s', and that in a corner of both alone, "
                     "which bears nothing: blocks bear on edges that they share, or with a corner "
                     "within an edge of another",
                     name.text, next.text);
  }
  if (distance > small * tp_block_extent(own)) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, own->place,
                     "block '%s' touches no other, and lies %.3g scene lengths from '%s', the "
                     "nearest: put it on what bears it",
                     name.text, distance, next.text);
  }
  return tp_refuse(
      message, TP_FAULT_GEOMETRY, own->place,
      "block '%s' touches no other, and lies %.3g scene lengths from '%s': coordinates that are to "
      "be the same must be given with the same digits, or 'contact: {within: %.1g}' "
      "closes gaps of a survey",
      name.text, distance, next.text, 2 * distance);
}

/* Blocks in the air that touch each other. */
static tp_status fail_floating_group(const tp_assemblage *a, long block, tp_message *message) {
  const tp_given_block *own = a->given + block;
  const tp_quote name = tp_quote_all(own->name);
  return tp_refuse(message, TP_FAULT_GEOMETRY, own->place,
                   "block '%s' and those that it touches touch no ground, nor a block that stands "
                   "on it, but for corners of both alone: put them on what bears them, with the "
                   "same digits of its coordinates",
                   name.text);
}

static long group_of(long *group, long block) {
  while (group[block] != block) block = group[block] = group[group[block]];
  return block;
}

/* By block: which others it is joined to by contacts; all ground is joined. */
static void join_blocks(long *group, const tp_assemblage *a) {
  long ground = -1;
  for (long k = 0; k < a->count; k++) {
    const bool fixed = a->blocks[k].number < 0;
    if (fixed && ground < 0) ground = k;
    group[k] = fixed ? ground : k;
  }
  for (long k = 0; k < a->contact_count; k++) {
    const long *block = a->contacts[k].block;
    group[group_of(group, block[0])] = group_of(group, block[1]);
  }
}

static tp_status check_held(const tp_assemblage *a, tp_message *message) {
  const tp_given_block *first = a->given;
  if (a->free_count == 0 || a->free_count == a->count) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, first->place,
                     a->free_count == 0
                         ? "all blocks are ground; at least one must be free to move"
                         : "no block is ground; mark what the others stand on, 'ground: true'");
  }
  long *group = calloc((size_t)a->count, sizeof *group);
  bool *touches = calloc((size_t)a->count, sizeof *touches);
  tp_status status =
      group != NULL && touches != NULL ? TP_OK : tp_fail_memory(message, "the blocks");
  if (status == TP_OK) join_blocks(group, a);
  for (long k = 0; k < a->contact_count && status == TP_OK; k++) {
    touches[a->contacts[k].block[0]] = touches[a->contacts[k].block[1]] = true;
  }
  for (long k = 0; k < a->count && status == TP_OK; k++) {
    if (!touches[k] && a->blocks[k].number >= 0) status = fail_floating(a, k, message);
  }
  long ground = 0;
  while (status == TP_OK && a->blocks[ground].number >= 0) ground++;
  for (long k = 0; k < a->count && status == TP_OK; k++) {
    if (group_of(group, k) != group_of(group, ground)) status = fail_floating_group(a, k, message);
  }
  free(group);
  free(touches);
  return status;
}

tp_status tp_assemblage_init(tp_assemblage *a, const tp_given_block *given, long count,
                             const fmpq_t metres_per_unit, tp_message *message) {
  memset(a, 0, sizeof *a);
  a->given = given;
  a->blocks = calloc((size_t)count + 1, sizeof *a->blocks);
  if (a->blocks == NULL) return tp_fail_memory(message, "the blocks");
  a->count = count;
  for (long k = 0; k < count; k++) {
    fmpz_init(a->blocks[k].x);
    fmpz_init(a->blocks[k].y);
  }
  tp_status status = put_on_lattice(a, metres_per_unit, message);
  if (status == TP_OK) status = set_blocks(a, message);
  if (status == TP_OK) status = tp_block_contacts_find(a, message);
  if (status == TP_OK) status = check_held(a, message);
  if (status != TP_OK) tp_assemblage_clear(a);
  return status;
}

tp_near tp_assemblage_length(const tp_assemblage *a, const fmpz_t from, const fmpz_t to) {
  fmpz_t difference;
  fmpz_init(difference);
  fmpz_sub(difference, to, from);
  const bool exact = fmpz_bits(difference) <= 53;
  slong exponent = 0; /* a step of the lattice may be smaller than a double tells */
  const double head = fmpz_get_d_2exp(&exponent, difference);
  const double value = ldexp(head, (int)(exponent - a->length_exponent));
  fmpz_clear(difference);
  return (tp_near){value, exact ? 0 : fabs(value) * 2 * DBL_EPSILON};
}
