/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rows in whole numbers and in doubles with bounds side by side: the first over powers of two that
 * the components of all twists and each contact have. Relations are read from a reduced echelon
 * form of the first. */

#include "contact_modes/virtual_frame.h"

#include "number/ball.h"

#include <stdlib.h>
#include <string.h>

void tp_virtual_frame_clear(tp_virtual_frame *f) {
  for (long k = 0; k < f->contact_count && f->contacts != NULL; k++) {
    for (int c = 0; c < 9; c++) {
      fmpz_clear(c < 3 ? f->contacts[k].slip + c : f->contacts[k].gap[c / 3 - 1] + c % 3);
    }
  }
  for (long b = 0; b < f->block_count && f->blocks != NULL; b++) free(f->blocks[b].near);
  for (int k = 0; k < 2; k++) {
    fmpz_clear(f->direction[k]);
    fmpz_clear(f->origin[k]);
  }
  free(f->blocks);
  free(f->contacts);
  memset(f, 0, sizeof *f);
}

/* ---- the direction -----------------------------------------------------------------------------
 */

/* From one point of the lattice to another, x mirrored as blocks are arranged. */
static void set_difference(fmpz_t x, fmpz_t y, const tp_virtual_frame *f, long from, long to) {
  const tp_lattice *l = &f->arranged->assemblage.lattice;
  fmpz_sub(x, l->x + to, l->x + from);
  fmpz_sub(y, l->y + to, l->y + from);
  if (f->arranged->mirrored) fmpz_neg(x, x);
}

/* t and n of a contact, n into its first block. */
static void set_axes(fmpz_t tx, fmpz_t ty, fmpz_t nx, fmpz_t ny, const tp_virtual_frame *f,
                     const tp_resting_contact *c) {
  set_difference(tx, ty, f, c->of.along[0], c->of.along[1]);
  fmpz_neg(nx, ty);
  fmpz_set(ny, tx);
  if (!f->arranged->mirrored) return;
  fmpz_neg(nx, nx);
  fmpz_neg(ny, ny);
}

static void set_dot(fmpz_t dot, const fmpz_t ax, const fmpz_t ay, const fmpz_t bx,
                    const fmpz_t by) {
  fmpz_mul(dot, ax, bx);
  fmpz_addmul(dot, ay, by);
}

static bool is_of_ground(const tp_resting_contact *c) {
  return c->normal[0].row[0] < 0 || c->normal[0].row[1] < 0;
}

/* Does a slide of all blocks along it open contacts with the ground, or leave them? */
static bool can_slide(const tp_virtual_frame *f, const fmpz_t dx, const fmpz_t dy) {
  const tp_resting *r = &f->arranged->resting;
  bool can = true;
  fmpz_t tx, ty, nx, ny, opens;
  fmpz_init(tx);
  fmpz_init(ty);
  fmpz_init(nx);
  fmpz_init(ny);
  fmpz_init(opens);
  for (long k = 0; k < r->contact_count && can; k++) {
    const tp_resting_contact *c = r->contacts + k;
    if (!is_of_ground(c)) continue;
    set_axes(tx, ty, nx, ny, f, c);
    set_dot(opens, nx, ny, dx, dy);
    can = fmpz_sgn(opens) * (c->normal[0].row[0] >= 0 ? 1 : -1) >= 0;
  }
  fmpz_clear(tx);
  fmpz_clear(ty);
  fmpz_clear(nx);
  fmpz_clear(ny);
  fmpz_clear(opens);
  return can;
}

/* Of the directions of contacts with the ground that blocks can slide along the one that the load
 * drives most. */
static bool choose_direction(tp_virtual_frame *f, const tp_near load[2]) {
  const tp_resting *r = &f->arranged->resting;
  double most = -INFINITY;
  fmpz_t tx, ty, nx, ny;
  fmpz_init(tx);
  fmpz_init(ty);
  fmpz_init(nx);
  fmpz_init(ny);
  for (long k = 0; k < 2 * r->contact_count; k++) {
    const tp_resting_contact *c = r->contacts + k / 2;
    if (!is_of_ground(c)) continue;
    set_axes(tx, ty, nx, ny, f, c);
    if (k % 2 == 1) {
      fmpz_neg(tx, tx);
      fmpz_neg(ty, ty);
    }
    const double x = fmpz_get_d(tx), y = fmpz_get_d(ty);
    const double drive = (load[0].value * x + load[1].value * y) / hypot(x, y);
    if (!(drive > most) || !can_slide(f, tx, ty)) continue;
    most = drive;
    fmpz_set(f->direction[0], tx);
    fmpz_set(f->direction[1], ty);
  }
  fmpz_clear(tx);
  fmpz_clear(ty);
  fmpz_clear(nx);
  fmpz_clear(ny);
  return most > -INFINITY;
}

/* ---- rows --------------------------------------------------------------------------------------
 */

tp_near tp_virtual_times(const tp_virtual_row *row, const tp_virtual_row *twist) {
  tp_near sum = {0, 0};
  for (int c = 0; c < 3; c++) sum = tp_near_plus(sum, tp_near_times(row->of[c], twist->of[c]));
  return sum;
}

tp_virtual_row tp_virtual_about_centroid(const tp_virtual_row *row, const tp_virtual_block *b) {
  tp_virtual_row central = *row;
  central.of[2] = tp_near_plus(central.of[2], tp_near_minus(tp_near_times(row->of[0], b->across),
                                                            tp_near_times(row->of[1], b->along)));
  return central;
}

static tp_near over_power(const fmpz_t number, long exponent) {
  const tp_near whole = tp_near_whole(number);
  return (tp_near){ldexp(whole.value, (int)-exponent), ldexp(whole.error, (int)-exponent)};
}

/* The row of a force at a place, less the origin, over powers of two. */
static void set_row(fmpz exact[3], tp_virtual_row *row, const tp_virtual_frame *f, const fmpz_t x,
                    const fmpz_t y, const fmpz_t force_x, const fmpz_t force_y, long exponent) {
  fmpz_t turned;
  fmpz_init(turned);
  set_dot(exact, force_x, force_y, f->direction[0], f->direction[1]);
  fmpz_neg(turned, f->direction[1]);
  set_dot(exact + 1, force_x, force_y, turned, f->direction[0]);
  fmpz_mul(exact + 2, x, force_y);
  fmpz_submul(exact + 2, y, force_x);
  row->of[0] = over_power(exact, exponent + f->exponent);
  row->of[1] = over_power(exact + 1, exponent + f->exponent);
  row->of[2] = over_power(exact + 2, exponent + f->arranged->assemblage.length_exponent);
  fmpz_clear(turned);
}

/* A place less the origin, over |D|, times D and D'. */
static void set_place(tp_near *along, tp_near *across, const tp_virtual_frame *f, tp_near x,
                      tp_near y) {
  const tp_near dx = over_power(f->direction[0], f->exponent);
  const tp_near dy = over_power(f->direction[1], f->exponent);
  *along = tp_near_div(tp_near_plus(tp_near_times(x, dx), tp_near_times(y, dy)), f->size2);
  *across = tp_near_div(tp_near_minus(tp_near_times(y, dx), tp_near_times(x, dy)), f->size2);
}

static void set_contact(tp_virtual_contact *to, const tp_virtual_frame *f,
                        const tp_resting_contact *c) {
  const tp_lattice *l = &f->arranged->assemblage.lattice;
  const long unit = f->arranged->assemblage.length_exponent;
  fmpz_t tx, ty, nx, ny, x, y;
  fmpz_init(tx);
  fmpz_init(ty);
  fmpz_init(nx);
  fmpz_init(ny);
  fmpz_init(x);
  fmpz_init(y);
  set_axes(tx, ty, nx, ny, f, c);
  const long exponent = ilogb(hypot(fmpz_get_d(tx), fmpz_get_d(ty)));
  for (int e = 1; e >= 0; e--) {
    fmpz_sub(x, l->x + c->of.ends[e], f->origin[0]);
    fmpz_sub(y, l->y + c->of.ends[e], f->origin[1]);
    if (f->arranged->mirrored) fmpz_neg(x, x);
    set_row(to->gap[e], to->gaps + e, f, x, y, nx, ny, exponent);
    tp_near along, across;
    set_place(&along, &across, f, over_power(x, unit), over_power(y, unit));
    to->turn[e] = (tp_virtual_row){{across, tp_near_neg(along), {1, 0}}};
  }
  set_row(to->slip, &to->slips, f, x, y, tx, ty, exponent);
  const tp_near dx = over_power(tx, exponent), dy = over_power(ty, exponent);
  const tp_near size2 = tp_near_plus(tp_near_times(dx, dx), tp_near_times(dy, dy));
  for (int k = 0; k < 2; k++) {
    to->slide.of[k] = tp_near_div(to->slips.of[k], tp_near_times(f->size2, size2));
    to->block[k] = c->normal[0].row[k] < 0 ? -1 : c->normal[0].row[k] / 3;
  }
  to->slide.of[2] = (tp_near){0, 0};
  to->is_joint = to->block[0] >= 0 && to->block[1] >= 0 && !fmpz_is_zero(to->gap[0]);
  fmpz_clear(tx);
  fmpz_clear(ty);
  fmpz_clear(nx);
  fmpz_clear(ny);
  fmpz_clear(x);
  fmpz_clear(y);
}

/* ---- blocks ------------------------------------------------------------------------------------
 */

static void set_block(tp_virtual_block *to, const tp_virtual_frame *f, long number) {
  const long b = f->arranged->resting.block[number];
  const tp_rigid_block *block = f->arranged->blocks + b;
  const tp_rigid_block *given = f->arranged->given->assemblage->blocks + b;
  tp_near x = tp_assemblage_length(&f->arranged->assemblage, f->origin[0], given->x);
  const tp_near y = tp_assemblage_length(&f->arranged->assemblage, f->origin[1], given->y);
  x = tp_near_plus(x, given->arm_x);
  if (f->arranged->mirrored) x = tp_near_neg(x);
  to->weight = block->weight;
  to->gyration2 = block->gyration2;
  set_place(&to->along, &to->across, f, x, tp_near_plus(y, given->arm_y));
}

static bool is_near(const tp_virtual_frame *f, long block, long other) {
  bool near = other < 0 || block == other;
  for (long k = 0; k < f->contact_count && !near; k++) {
    const long *of = f->contacts[k].block;
    near = (of[0] == block && of[1] == other) || (of[1] == block && of[0] == other);
  }
  return near;
}

static bool set_near(const tp_virtual_frame *f, long block, bool *near) {
  tp_virtual_block *centre = f->blocks + block;
  centre->near = calloc(2 * (size_t)f->contact_count + 1, sizeof *centre->near);
  if (centre->near == NULL) return false;
  for (long b = 0; b < f->block_count; b++) near[b] = is_near(f, block, b);
  for (long k = 0; k < f->contact_count; k++) {
    const long *of = f->contacts[k].block;
    if ((of[0] >= 0 && !near[of[0]]) || (of[1] >= 0 && !near[of[1]])) continue;
    for (int e = 0; e < 2; e++) centre->near[centre->near_count++] = 2 * k + e;
  }
  return true;
}

static bool fill(tp_virtual_frame *f) {
  const tp_near dx = over_power(f->direction[0], f->exponent);
  const tp_near dy = over_power(f->direction[1], f->exponent);
  f->size2 = tp_near_plus(tp_near_times(dx, dx), tp_near_times(dy, dy));
  f->contacts = calloc((size_t)f->contact_count + 1, sizeof *f->contacts);
  f->blocks = calloc((size_t)f->block_count + 1, sizeof *f->blocks);
  bool *near = calloc((size_t)f->block_count + 1, sizeof *near);
  bool done = f->contacts != NULL && f->blocks != NULL && near != NULL;
  for (long k = 0; k < f->contact_count && done; k++) {
    set_contact(f->contacts + k, f, f->arranged->resting.contacts + k);
  }
  for (long b = 0; b < f->block_count && done; b++) {
    set_block(f->blocks + b, f, b);
    done = set_near(f, b, near);
  }
  free(near);
  return done;
}

tp_status tp_virtual_frame_init(bool *exists, tp_virtual_frame *f, const tp_arranged *arranged,
                                const tp_near load[2], tp_message *message) {
  const tp_resting *r = &arranged->resting;
  *f = (tp_virtual_frame){
      .arranged = arranged, .block_count = r->rows / 3, .contact_count = r->contact_count};
  *exists = r->pair_first == r->contact_count;
  for (long k = 0; k < r->contact_count; k++) *exists = *exists && r->contacts[k].ends == 2;
  for (int k = 0; k < 2; k++) {
    fmpz_init(f->direction[k]);
    fmpz_init(f->origin[k]);
  }
  const tp_rigid_block *first = arranged->given->assemblage->blocks + r->block[0];
  fmpz_set(f->origin[0], first->x);
  fmpz_set(f->origin[1], first->y);
  *exists = *exists && choose_direction(f, load);
  if (!*exists) return TP_OK;
  f->exponent = ilogb(hypot(fmpz_get_d(f->direction[0]), fmpz_get_d(f->direction[1])));
  if (fill(f)) return TP_OK;
  tp_virtual_frame_clear(f);
  *exists = false;
  return tp_fail_memory(message, "a proof");
}

/* ---- relations ---------------------------------------------------------------------------------
 */

void tp_virtual_relations_clear(tp_virtual_relations *r) {
  free(r->gaps);
  free(r->slip);
  free(r->turn);
  free(r->relations);
  memset(r, 0, sizeof *r);
}

/* Those of contacts of the two blocks first, joints last. */
static int class_of(const tp_virtual_frame *f, long contact, long gap) {
  const tp_virtual_contact *c = f->contacts + contact, *other = f->contacts + gap / 2;
  if (other->is_joint) return gap / 2 == contact ? 2 : 3;
  for (int k = 0; k < 4; k++) {
    const long block = c->block[k / 2];
    if (block >= 0 && other->block[k % 2] == block) return 0;
  }
  return 1;
}

static bool has_gap(const tp_virtual_frame *f, long block, long gap) {
  bool has = false;
  for (long k = 0; block >= 0 && k < f->blocks[block].near_count && !has; k++) {
    has = f->blocks[block].near[k] == gap;
  }
  return has;
}

static void list_gaps(tp_virtual_relations *r, const tp_virtual_frame *f, long contact) {
  enum { CLASSES = 4 };
  const long *of = f->contacts[contact].block;
  for (int rank = 0; rank < CLASSES; rank++) {
    for (long gap = 0; gap < 2 * f->contact_count; gap++) {
      if (class_of(f, contact, gap) != rank) continue;
      if (has_gap(f, of[0], gap) || has_gap(f, of[1], gap)) r->gaps[r->count++] = gap;
    }
  }
}

/* A column of the rows by block, `place` where a block has three, or -1. */
static void set_column(fmpz_mat_t m, long column, const long *place, const long block[2],
                       const fmpz row[3]) {
  for (int side = 0; side < 2; side++) {
    if (block[side] < 0) continue;
    for (int c = 0; c < 3; c++) {
      fmpz *entry = fmpz_mat_entry(m, place[block[side]] + c, column);
      if (side == 0) fmpz_add(entry, entry, row + c);
      if (side == 1) fmpz_sub(entry, entry, row + c);
    }
  }
}

static tp_near share_of(const fmpz_mat_t m, long row, long column, const fmpz_t over) {
  if (fmpz_is_zero(fmpz_mat_entry(m, row, column))) return (tp_near){0, 0};
  return tp_near_div(tp_near_whole(fmpz_mat_entry(m, row, column)), tp_near_whole(over));
}

/* A power of two. */
static tp_near times_power(tp_near number, long exponent) {
  return (tp_near){ldexp(number.value, (int)exponent), ldexp(number.error, (int)exponent)};
}

/* Each column is of a row in whole numbers, 2^power times that in doubles. */
static void read_column(tp_near *shares, const fmpz_mat_t m, const long *pivot, long rank,
                        long column, const fmpz_t over, const long *power, long own_power) {
  for (long k = 0; k < rank; k++) {
    shares[pivot[k]] = times_power(share_of(m, k, column, over), power[pivot[k]] - own_power);
  }
}

static long power_of(const tp_virtual_frame *f, long contact) {
  const tp_resting_contact *c = f->arranged->resting.contacts + contact;
  const tp_lattice *l = &f->arranged->assemblage.lattice;
  fmpz_t x, y;
  fmpz_init(x);
  fmpz_init(y);
  fmpz_sub(x, l->x + c->of.along[1], l->x + c->of.along[0]);
  fmpz_sub(y, l->y + c->of.along[1], l->y + c->of.along[0]);
  const long power = ilogb(hypot(fmpz_get_d(x), fmpz_get_d(y)));
  fmpz_clear(x);
  fmpz_clear(y);
  return power;
}

/* From the reduced echelon form: what has no pivot is linear in the pivots before it. */
static void read(tp_virtual_relations *r, const tp_virtual_frame *f, long contact,
                 const fmpz_mat_t m, long rank, const fmpz_t over, long *pivot, long *power) {
  const long n = r->count;
  long found = 0;
  for (long k = 0; k < n; k++) power[k] = power_of(f, r->gaps[k] / 2);
  for (long row = 0; row < rank; row++) {
    long c = 0;
    while (fmpz_is_zero(fmpz_mat_entry(m, row, c))) c++;
    pivot[row] = c;
    if (c < n) found = row + 1;
  }
  r->has_slip = r->has_turn = true;
  for (long row = found; row < rank; row++) {
    if (!fmpz_is_zero(fmpz_mat_entry(m, row, n))) r->has_slip = false;
    if (!fmpz_is_zero(fmpz_mat_entry(m, row, n + 1))) r->has_turn = false;
  }
  if (r->has_slip) {
    read_column(r->slip, m, pivot, found, n, over, power, power_of(f, contact));
  }
  if (r->has_turn) {
    const long unit = f->arranged->assemblage.length_exponent;
    read_column(r->turn, m, pivot, found, n + 1, over, power, -unit);
  }
  for (long c = 0, row = 0; c < n; c++) {
    if (row < found && pivot[row] == c) {
      row++;
      continue;
    }
    tp_near *relation = r->relations + n * r->relation_count++;
    read_column(relation, m, pivot, row, c, over, power, power[c]);
    relation[c] = (tp_near){-1, 0};
  }
}

static bool relate(tp_virtual_relations *r, const tp_virtual_frame *f, long contact, long *place,
                   long *pivot, long *power) {
  long rows = 0;
  for (long b = 0; b < f->block_count; b++) place[b] = -1;
  for (long k = 0; k < r->count; k++) {
    for (int side = 0; side < 2; side++) {
      const long block = f->contacts[r->gaps[k] / 2].block[side];
      if (block < 0 || place[block] >= 0) continue;
      place[block] = rows;
      rows += 3;
    }
  }
  const tp_virtual_contact *of = f->contacts + contact;
  fmpz_mat_t m;
  fmpz_t over;
  fmpz_init(over);
  fmpz_mat_init(m, rows, r->count + 2);
  for (long k = 0; k < r->count; k++) {
    const tp_virtual_contact *c = f->contacts + r->gaps[k] / 2;
    set_column(m, k, place, c->block, c->gap[r->gaps[k] % 2]);
  }
  set_column(m, r->count, place, of->block, of->slip);
  const fmpz turn[3] = {0, 0, 1};
  set_column(m, r->count + 1, place, of->block, turn);
  const long rank = fmpz_mat_rref(m, over, m);
  const size_t most = (size_t)(r->count - rank > 0 ? r->count - rank : 0) + 3;
  r->relations = calloc(most * (size_t)(r->count + 1), sizeof *r->relations);
  if (r->relations != NULL) read(r, f, contact, m, rank, over, pivot, power);
  fmpz_mat_clear(m);
  fmpz_clear(over);
  return r->relations != NULL;
}

bool tp_virtual_relations_init(tp_virtual_relations *r, const tp_virtual_frame *f, long contact) {
  const size_t gaps = 2 * (size_t)f->contact_count + 3, blocks = (size_t)f->block_count + 1;
  *r = (tp_virtual_relations){.gaps = calloc(gaps, sizeof *r->gaps),
                              .slip = calloc(gaps, sizeof *r->slip),
                              .turn = calloc(gaps, sizeof *r->turn)};
  long *place = calloc(blocks, sizeof *place), *pivot = calloc(gaps + 3 * blocks, sizeof *pivot);
  long *power = calloc(gaps, sizeof *power);
  bool done = r->gaps != NULL && r->slip != NULL && r->turn != NULL && place != NULL &&
              pivot != NULL && power != NULL;
  if (done) {
    list_gaps(r, f, contact);
    done = relate(r, f, contact, place, pivot, power);
  }
  free(place);
  free(pivot);
  free(power);
  if (!done) tp_virtual_relations_clear(r);
  return done;
}
