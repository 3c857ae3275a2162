/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a figure of many blocks shows: which case, how far the mechanism is magnified, how long
 * arrows are, where they point. */

#include "figure/blocks.h"

#include "block_system/governing_case.h"

#include <math.h>

/* Sizes as shares of the size of all, and of the mean block. */
static const double moved_of_all = 0.06, moved_of_block = 0.8, most_turn = 0.35;
static const double arrow_of_all = 0.15, arrow_of_block = 0.8;
static const double negligible = 1e-6; /* of the largest force */

/* ---- which case, and how large -----------------------------------------------------------------
 */

bool tp_blocks_governs(const tp_blocks_figure *f) {
  bool governs = true;
  for (size_t k = 0; k < f->system->case_count; k++) {
    const tp_system_case *other = f->system->cases + k;
    governs = governs && (other == f->own || tp_system_case_is_worse(f->own, other));
  }
  return governs;
}

/* The side of a square as large as the mean free block, units. */
static double block_size(const tp_blocks_figure *f) {
  double area = 0, count = 0;
  for (size_t k = 0; k < f->system->block_count; k++) {
    if (f->system->blocks[k].ground) continue;
    area += f->system->blocks[k].area_m2.value / f->shapes.unit_m / f->shapes.unit_m;
    count++;
  }
  return sqrt(area / count);
}

static void set_sizes(tp_blocks_figure *f) {
  const double block = block_size(f);
  f->arrow = fmin(arrow_of_all, arrow_of_block * block);
  for (size_t k = 0; k < f->own->force_count; k++) {
    const tp_system_force *force = f->own->forces + k;
    f->largest_n_m = fmax(f->largest_n_m, hypot(force->normal_n_m, force->shear_n_m));
  }
  f->moved = fmin(moved_of_all, moved_of_block * block);
  for (size_t k = 0; k < f->own->motion_count; k++) {
    const double turn = fabs(f->own->motions[k].turn_per_m) * f->shapes.unit_m;
    if (f->moved * turn > most_turn) f->moved = most_turn / turn;
  }
}

void tp_blocks_set_up(tp_blocks_figure *f) {
  const double degree = atan(1) / 45;
  f->own = tp_system_most_severe(f->system);
  const double tilt = f->own->tilt_angle_deg.value * degree;
  f->turn = f->own->towards == TP_TOWARDS_LEFT ? tilt : -tilt;
  set_sizes(f);
}

/* ---- motions and forces ------------------------------------------------------------------------
 */

bool tp_blocks_moves(const tp_blocks_figure *f, size_t block) {
  return block < f->own->motion_count && f->own->motions[block].mechanism != TP_STANDS;
}

tp_spot tp_blocks_moved(const tp_blocks_figure *f, size_t block, tp_spot at) {
  if (!tp_blocks_moves(f, block)) return at;
  const tp_system_motion *m = f->own->motions + block;
  const tp_spot c = f->shapes.blocks[block].centroid;
  const double turn = m->turn_per_m * f->shapes.unit_m;
  return (tp_spot){at.x + f->moved * (m->velocity_x - turn * (at.y - c.y)),
                   at.y + f->moved * (m->velocity_y + turn * (at.x - c.x))};
}

tp_ink tp_blocks_tint(const tp_blocks_figure *f, size_t block) {
  if (!tp_blocks_moves(f, block)) return TP_INK_BLOCK;
  switch (f->own->motions[block].mechanism) {
  case TP_SLIDES:
    return TP_INK_PART;
  case TP_TOPPLES:
    return TP_INK_TOPPLES;
  default:
    return TP_INK_SLIDES_AND_TOPPLES;
  }
}

/* Does the force on the first block point to where the arrow is to point? */
static bool is_on_first(const tp_blocks_figure *f, const tp_system_contact *contact, tp_spot push) {
  if (f->system->blocks[contact->second].ground) return true;
  if (f->system->blocks[contact->first].ground) return false;
  const tp_spot down = {-sin(f->turn), -cos(f->turn)};
  const double side = f->own->towards == TP_TOWARDS_LEFT ? -1 : 1;
  const double along = push.x * down.x + push.y * down.y;
  const double across = side * (push.y * down.x - push.x * down.y);
  return fabs(along) > 0.1 * hypot(push.x, push.y) ? along > 0 : across > 0;
}

bool tp_blocks_force(tp_spot *from, tp_spot *to, const tp_blocks_figure *f, size_t contact) {
  const tp_system_force *force = f->own->forces + contact;
  const double size = hypot(force->normal_n_m, force->shear_n_m);
  if (!(f->largest_n_m > 0) || size < negligible * f->largest_n_m) return false;
  const tp_spot along = f->shapes.contacts[contact].along;
  const tp_spot push = {(force->shear_n_m * along.x - force->normal_n_m * along.y) / f->largest_n_m,
                        (force->shear_n_m * along.y + force->normal_n_m * along.x) /
                            f->largest_n_m};
  const double sign = is_on_first(f, f->system->contacts + contact, push) ? 1 : -1;
  *to = tp_block_shapes_force(&f->shapes, contact, force->x_m, force->y_m);
  *from = (tp_spot){to->x - sign * f->arrow * push.x, to->y - sign * f->arrow * push.y};
  return true;
}
