/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Distances from edges, and stretches of a line along them, in rationals: squares are compared. */

#include "block_system/block_faces.h"

#include "common/outside.h"
#include "load/outline.h"
#include "number/between.h"

#include <stdlib.h>

enum { MILLION = 1000000 };

/* ---- points ------------------------------------------------------------------------------------
 */

bool tp_block_holds(const tp_placed_blocks *blocks, long block, const fmpq_t x, const fmpq_t y) {
  const tp_section *section = blocks->sections + block;
  if (!tp_loads_in_outline(section->rings, x, y)) return false;
  for (long h = 1; h <= section->hole_count; h++) {
    const tp_polyline *hole = section->rings + h;
    bool on_border = false;
    for (long k = 0; k < hole->count && !on_border; k++) {
      on_border = tp_loads_on_edge(hole, k, x, y);
    }
    if (!on_border && tp_loads_in_outline(hole, x, y)) return false;
  }
  return true;
}

/* The square of a millionth of the greater side of the box around a block. */
static void find_reach(fmpq_t square, const tp_polyline *ring) {
  fmpq_t width, height;
  fmpq_init(width);
  fmpq_init(height);
  const fmpq *least[2] = {ring->x, ring->y}, *most[2] = {ring->x, ring->y};
  for (long k = 1; k < ring->count; k++) {
    const fmpq *own[2] = {ring->x + k, ring->y + k};
    for (int axis = 0; axis < 2; axis++) {
      if (fmpq_cmp(own[axis], least[axis]) < 0) least[axis] = own[axis];
      if (fmpq_cmp(own[axis], most[axis]) > 0) most[axis] = own[axis];
    }
  }
  fmpq_sub(width, most[0], least[0]);
  fmpq_sub(height, most[1], least[1]);
  fmpq_set(square, fmpq_cmp(width, height) > 0 ? width : height);
  fmpq_div_fmpz(square, square, (const fmpz[]){MILLION});
  fmpq_mul(square, square, square);
  fmpq_clear(width);
  fmpq_clear(height);
}

/* Of (a - o) and (b - o): their product along, and across. */
static void products(fmpq_t along, fmpq_t across, const fmpq *const o[2], const fmpq *const a[2],
                     const fmpq *const b[2]) {
  fmpq_t ax, ay, bx, by;
  fmpq *const all[] = {ax, ay, bx, by};
  for (int k = 0; k < 4; k++) fmpq_init(all[k]);
  fmpq_sub(ax, a[0], o[0]);
  fmpq_sub(ay, a[1], o[1]);
  fmpq_sub(bx, b[0], o[0]);
  fmpq_sub(by, b[1], o[1]);
  fmpq_mul(along, ax, bx);
  fmpq_addmul(along, ay, by);
  fmpq_mul(across, ax, by);
  fmpq_submul(across, ay, bx);
  for (int k = 0; k < 4; k++) fmpq_clear(all[k]);
}

/* Where a point lies along the way from one to another, as a share of it; false: aside of their
 * line by more than the reach. */
static bool share_along(fmpq_t share, const fmpq *const from[2], const fmpq *const to[2],
                        const fmpq *const at[2], const fmpq_t reach) {
  fmpq_t square, across, most;
  fmpq_init(square);
  fmpq_init(across);
  fmpq_init(most);
  products(square, across, from, to, to);
  products(share, across, from, to, at);
  fmpq_mul(across, across, across);
  fmpq_mul(most, reach, square);
  const bool near = !fmpq_is_zero(square) && fmpq_cmp(across, most) <= 0;
  if (near) fmpq_div(share, share, square);
  fmpq_clear(square);
  fmpq_clear(across);
  fmpq_clear(most);
  return near;
}

static bool is_beside(const tp_polyline *ring, const fmpq_t x, const fmpq_t y) {
  const fmpq *const at[2] = {x, y};
  fmpq_t reach, share;
  fmpq_init(reach);
  fmpq_init(share);
  find_reach(reach, ring);
  bool near = false;
  for (long k = 0; k < ring->count && !near; k++) {
    const long next = k + 1 == ring->count ? 0 : k + 1;
    const fmpq *const from[2] = {ring->x + k, ring->y + k};
    const fmpq *const to[2] = {ring->x + next, ring->y + next};
    near = share_along(share, from, to, at, reach) && fmpq_sgn(share) >= 0 &&
           fmpq_cmp_si(share, 1) <= 0;
  }
  fmpq_clear(reach);
  fmpq_clear(share);
  return near;
}

bool tp_block_is_near(const tp_placed_blocks *blocks, long block, const fmpq_t x, const fmpq_t y) {
  return tp_block_holds(blocks, block, x, y) || is_beside(blocks->sections[block].rings, x, y);
}

tp_status tp_block_find_at(long *block, const tp_placed_blocks *blocks, const fmpq_t x,
                           const fmpq_t y, const char *what, tp_place place, tp_message *message) {
  const tp_block_list *many = &blocks->scene->many;
  long first = -1, second = -1;
  for (long k = 0; k < many->count && second < 0; k++) {
    if (!tp_block_is_near(blocks, k, x, y)) continue;
    if (first < 0) {
      first = k;
    } else {
      second = k;
    }
  }
  if (first < 0) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, place, "'at' of this %s lies in no block", what);
  }
  if (second >= 0) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, place,
                     "'at' of this %s lies on the border of '%s' and '%s': name its 'block'", what,
                     tp_quote_all(many->blocks[first].name).text,
                     tp_quote_all(many->blocks[second].name).text);
  }
  *block = first;
  return TP_OK;
}

/* ---- lines -------------------------------------------------------------------------------------
 */

typedef struct finding {
  tp_line_stretches *found;
  const tp_line_load *line;
  const fmpq *up; /* of a surcharge on any block; NULL: edges that run the same way, or any */
  bool any_way;
  fmpq_t covered; /* shares of the line, added up */
} finding;

static bool make_room(tp_line_stretches *s) {
  if (s->count < s->room) return true;
  const long room = 2 * s->room + 2;
  tp_line_stretch *items = realloc(s->items, (size_t)room * sizeof *items);
  if (items == NULL) return false;
  s->items = items;
  s->room = room;
  return true;
}

static bool add(finding *f, long block, const fmpq_t from, const fmpq_t to) {
  if (!make_room(f->found)) return false;
  tp_line_stretch *own = f->found->items + f->found->count++;
  const tp_line_load *l = f->line;
  *own = (tp_line_stretch){.block = block};
  tp_line_load_init(&own->line);
  own->line.place = l->place;
  tp_ratio_between(own->line.x0.value, l->x0.value, l->x1.value, from);
  tp_ratio_between(own->line.y0.value, l->y0.value, l->y1.value, from);
  tp_ratio_between(own->line.x1.value, l->x0.value, l->x1.value, to);
  tp_ratio_between(own->line.y1.value, l->y0.value, l->y1.value, to);
  tp_ratio_between(own->line.first_kpa.value, l->first_kpa.value, l->last_kpa.value, from);
  tp_ratio_between(own->line.last_kpa.value, l->first_kpa.value, l->last_kpa.value, to);
  fmpq_add(f->covered, f->covered, to);
  fmpq_sub(f->covered, f->covered, from);
  return true;
}

/* Outwards of an edge is (dy, -dx). */
static bool faces_up(const fmpq *const from[2], const fmpq *const to[2], const fmpq *up) {
  fmpq_t rise, run;
  fmpq_init(rise);
  fmpq_init(run);
  fmpq_sub(rise, to[1], from[1]);
  fmpq_sub(run, to[0], from[0]);
  fmpq_mul(rise, rise, up);
  fmpq_submul(rise, run, up + 1);
  const bool faces = fmpq_sgn(rise) > 0;
  fmpq_clear(rise);
  fmpq_clear(run);
  return faces;
}

/* What lies on an edge of the line; nothing: true as well. */
static bool try_edge(finding *f, long block, const fmpq *const from[2], const fmpq *const to[2],
                     const fmpq_t reach) {
  const tp_line_load *l = f->line;
  const fmpq *const ends[2][2] = {{l->x0.value, l->y0.value}, {l->x1.value, l->y1.value}};
  if (f->up != NULL && !faces_up(from, to, f->up)) return true;
  fmpq_t first, last;
  fmpq_init(first);
  fmpq_init(last);
  bool done = true;
  if (share_along(first, ends[0], ends[1], from, reach) &&
      share_along(last, ends[0], ends[1], to, reach)) {
    const bool backwards = fmpq_cmp(first, last) > 0;
    if (backwards) fmpq_swap(first, last);
    if (fmpq_sgn(first) < 0) fmpq_zero(first);
    if (fmpq_cmp_si(last, 1) > 0) fmpq_one(last);
    const bool runs = f->up != NULL || f->any_way || !backwards;
    if (runs && fmpq_cmp(first, last) < 0) done = add(f, block, first, last);
  }
  fmpq_clear(first);
  fmpq_clear(last);
  return done;
}

static bool try_block(finding *f, const tp_placed_blocks *blocks, long block) {
  const tp_polyline *ring = blocks->sections[block].rings;
  fmpq_t reach;
  fmpq_init(reach);
  find_reach(reach, ring);
  bool done = true;
  for (long k = 0; k < ring->count && done; k++) {
    const long next = k + 1 == ring->count ? 0 : k + 1;
    const fmpq *const from[2] = {ring->x + k, ring->y + k};
    const fmpq *const to[2] = {ring->x + next, ring->y + next};
    done = try_edge(f, block, from, to, reach);
  }
  fmpq_clear(reach);
  return done;
}

/* To a millionth, as corners are that near. */
static bool is_one(const fmpq_t covered) {
  fmpq_t away;
  fmpq_init(away);
  fmpq_sub_si(away, covered, 1);
  fmpq_abs(away, away);
  fmpq_mul_si(away, away, MILLION);
  const bool is = fmpq_cmp_si(away, 1) <= 0;
  fmpq_clear(away);
  return is;
}

bool tp_line_stretches_find(tp_line_stretches *stretches, bool *covered,
                            const tp_placed_blocks *blocks, const tp_line_load *line, long block,
                            const fmpq up[2]) {
  *stretches = (tp_line_stretches){0};
  finding f = {
      .found = stretches, .line = line, .up = block < 0 ? up : NULL, .any_way = up != NULL};
  fmpq_init(f.covered);
  bool done = true;
  for (long k = 0; k < blocks->scene->many.count && done; k++) {
    if (block < 0 || k == block) done = try_block(&f, blocks, k);
  }
  *covered = is_one(f.covered);
  fmpq_clear(f.covered);
  return done;
}

void tp_line_stretches_clear(tp_line_stretches *stretches) {
  for (long k = 0; k < stretches->count; k++) tp_line_load_clear(&stretches->items[k].line);
  free(stretches->items);
  *stretches = (tp_line_stretches){0};
}
