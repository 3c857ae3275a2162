/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Groups by union of their lowest blocks; the space of free accelerations as the null space of all
 * rows, in whole numbers (FLINT). */

#include "contact_modes/rigid_groups.h"

#include "contact_modes/null_space.h"

#include <stdlib.h>
#include <string.h>

void tp_rigid_groups_clear(tp_rigid_groups *g) {
  free(g->group);
  free(g->first);
  free(g->scale);
  free(g->modes);
  if (g->resting != NULL) fmpz_mat_clear(g->free);
  memset(g, 0, sizeof *g);
}

/* Numbers of groups run down to that of the lowest block in them, or to -1 with the ground. */
static void join_all(tp_rigid_groups *g, const tp_mode_set *modes) {
  const tp_assemblage *a = g->resting->assemblage;
  for (long b = 0; b < a->count; b++) g->group[b] = a->blocks[b].number < 0 ? -1 : b;
  for (bool changed = true; changed;) {
    changed = false;
    for (long k = 0; k < g->resting->contact_count; k++) {
      const tp_resting_contact *c = g->resting->contacts + k;
      if (c->ends < 2 || modes[k] != tp_modes_at_rest(2)) continue;
      long *one = g->group + c->of.block[0], *other = g->group + c->of.block[1];
      if (*one == *other) continue;
      *one = *other = *one < *other ? *one : *other;
      changed = true;
    }
  }
}

static void number_all(tp_rigid_groups *g) {
  const tp_assemblage *a = g->resting->assemblage;
  for (long b = 0; b < a->count; b++) {
    if (g->group[b] < 0) continue;
    if (g->group[b] == b) {
      g->first[g->count] = b;
      g->group[b] = g->count++;
    } else {
      g->group[b] = g->group[g->group[b]];
    }
  }
}

/* So much of the group on a side of a contact: of n = (-dy, dx) or t = (dx, dy) at the end, turned
 * round for the second block. */
static void set_side(fmpz row[3], const tp_rigid_groups *g, long contact, int side, int end,
                     bool along) {
  const tp_assemblage *a = g->resting->assemblage;
  const tp_block_contact *c = &g->resting->contacts[contact].of;
  const tp_lattice *l = &a->lattice;
  const tp_rigid_block *about = a->blocks + g->first[g->group[c->block[side]]];
  fmpz_t x, y;
  fmpz_init(x);
  fmpz_init(y);
  fmpz_sub(row + 0, l->x + c->along[1], l->x + c->along[0]);
  fmpz_sub(row + 1, l->y + c->along[1], l->y + c->along[0]);
  if (!along) {
    fmpz_swap(row + 0, row + 1);
    fmpz_neg(row + 0, row + 0);
  }
  fmpz_sub(x, l->x + c->ends[end], about->x);
  fmpz_sub(y, l->y + c->ends[end], about->y);
  fmpz_mul(row + 2, x, row + 1);
  fmpz_submul(row + 2, y, row + 0);
  for (int e = 0; e < 3 && side == 1; e++) fmpz_neg(row + e, row + e);
  fmpz_clear(x);
  fmpz_clear(y);
}

/* The same on all groups; `add` has 3 count numbers. */
static void add_row(fmpz *add, const tp_rigid_groups *g, long contact, int end, bool along) {
  fmpz own[3];
  for (int e = 0; e < 3; e++) fmpz_init(own + e);
  for (int side = 0; side < 2; side++) {
    const long group = g->group[g->resting->contacts[contact].of.block[side]];
    if (group < 0) continue;
    set_side(own, g, contact, side, end, along);
    for (int e = 0; e < 3; e++) fmpz_add(add + 3 * group + e, add + 3 * group + e, own + e);
  }
  for (int e = 0; e < 3; e++) fmpz_clear(own + e);
}

/* Two ends that stay closed turn alike. */
static void add_turn(fmpz *add, const tp_rigid_groups *g, long contact) {
  for (int side = 0; side < 2; side++) {
    const long group = g->group[g->resting->contacts[contact].of.block[side]];
    if (group < 0) continue;
    fmpz_set_si(add + 3 * group + 2, side == 0 ? 1 : -1);
  }
}

static void set_rows(fmpz_mat_t rows, const tp_rigid_groups *g, const tp_mode_set *modes) {
  long at = 0;
  for (long k = 0; k < g->resting->contact_count; k++) {
    const tp_block_contact *c = &g->resting->contacts[k].of;
    if (g->group[c->block[0]] == g->group[c->block[1]]) continue;
    const bool both = (modes[k] & tp_modes_closed(0)) != 0 && (modes[k] & tp_modes_closed(1)) != 0;
    if (both) add_turn(rows->rows[at++], g, k);
    for (int e = 0; e < (both ? 1 : g->resting->contacts[k].ends); e++) {
      if ((modes[k] & tp_modes_closed(e)) != 0) add_row(rows->rows[at++], g, k, e, false);
    }
    if ((modes[k] & TP_MODES_STICK) != 0) add_row(rows->rows[at++], g, k, 0, true);
  }
}

static bool find_free(tp_rigid_groups *g, const tp_mode_set *modes) {
  enum { MOST = 3 }; /* rows of a contact */
  fmpz_mat_t rows;
  fmpz_mat_init(rows, MOST * g->resting->contact_count, 3 * g->count);
  set_rows(rows, g, modes);
  fmpz_mat_clear(g->free);
  const bool made = tp_null_space(g->free, rows);
  g->freedom = fmpz_mat_ncols(g->free);
  fmpz_mat_clear(rows);
  return made;
}

tp_status tp_rigid_groups_init(tp_rigid_groups *g, const tp_resting *r, tp_message *message) {
  memset(g, 0, sizeof *g);
  g->resting = r;
  fmpz_mat_init(g->free, 0, 0);
  g->group = calloc((size_t)r->assemblage->count + 1, sizeof *g->group);
  g->first = calloc((size_t)r->assemblage->count + 1, sizeof *g->first);
  g->scale = calloc((size_t)r->rows + 1, sizeof *g->scale);
  g->modes = calloc((size_t)r->contact_count + 1, sizeof *g->modes);
  if (g->group != NULL && g->first != NULL && g->scale != NULL && g->modes != NULL) return TP_OK;
  tp_rigid_groups_clear(g);
  return tp_fail_memory(message, "a proof");
}

static void set_scales(tp_rigid_groups *g) {
  fmpz_t own;
  fmpz_init(own);
  for (long f = 0; f < g->freedom; f++) {
    g->scale[f] = 0;
    for (long b = 0; b < g->resting->rows / 3; b++) {
      for (int axis = 0; axis < 2; axis++) {
        tp_rigid_groups_acceleration(own, g, g->resting->block[b], axis, f);
        const long bits = (long)fmpz_bits(own);
        if (bits > g->scale[f]) g->scale[f] = bits;
      }
    }
  }
  fmpz_clear(own);
}

tp_status tp_rigid_groups_find(tp_rigid_groups *g, const tp_mode_set *modes, tp_message *message) {
  const size_t size = (size_t)g->resting->contact_count * sizeof *modes;
  if (memcmp(g->modes, modes, size) == 0) return TP_OK;
  memcpy(g->modes, modes, size);
  g->count = g->freedom = 0;
  join_all(g, modes);
  number_all(g);
  if (g->count > 0 && !find_free(g, modes)) return tp_fail_memory(message, "a proof");
  set_scales(g);
  return TP_OK;
}

void tp_rigid_groups_row(fmpz *row, const tp_rigid_groups *g, long contact, int end, bool along) {
  fmpz own[3];
  for (int e = 0; e < 3; e++) fmpz_init(own + e);
  _fmpz_vec_zero(row, g->freedom);
  for (int side = 0; side < 2; side++) {
    const long group = g->group[g->resting->contacts[contact].of.block[side]];
    if (group < 0) continue;
    set_side(own, g, contact, side, end, along);
    for (int e = 0; e < 3; e++) {
      _fmpz_vec_scalar_addmul_fmpz(row, g->free->rows[3 * group + e], g->freedom, own + e);
    }
  }
  for (int e = 0; e < 3; e++) fmpz_clear(own + e);
}

void tp_rigid_groups_acceleration(fmpz_t own, const tp_rigid_groups *g, long block, int axis,
                                  long freedom) {
  const tp_rigid_block *blocks = g->resting->assemblage->blocks;
  const long group = g->group[block];
  fmpz_zero(own);
  if (group < 0) return;
  fmpz_set(own, fmpz_mat_entry(g->free, 3 * group + axis, freedom));
  if (axis == 2) return;
  const tp_rigid_block *about = blocks + g->first[group], *at = blocks + block;
  fmpz_t arm;
  fmpz_init(arm);
  if (axis == 0) { /* a_x = g_x - theta (y - y_0), a_y = g_y + theta (x - x_0) */
    fmpz_sub(arm, about->y, at->y);
  } else {
    fmpz_sub(arm, at->x, about->x);
  }
  fmpz_addmul(own, fmpz_mat_entry(g->free, 3 * group + 2, freedom), arm);
  fmpz_clear(arm);
}
