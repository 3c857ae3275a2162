/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Finds the vertices that a scene rounds, by coordinates or as ends of the underside, and checks in
 * balls that tangent lengths fit the edges and that no point of the section lies in a tip. */

#include "block/corners.h"

#include "block/ring_meetings.h"
#include "block/tangents.h"
#include "number/ratio.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A point that these do not tell from the arc counts as within the tip. */
enum { BITS = 128 };

/* The end of the underside: the leftmost or rightmost vertex, of several the lowest. */
static long find_end(const tp_lattice *l, long count, bool left) {
  long best = 0;
  for (long k = 1; k < count; k++) {
    const int side = fmpz_cmp(l->x + k, l->x + best);
    if ((left ? side < 0 : side > 0) || (side == 0 && fmpz_cmp(l->y + k, l->y + best) < 0)) {
      best = k;
    }
  }
  return best;
}

static long find_vertex(const tp_polyline *outline, const tp_corner_description *c) {
  for (long k = 0; k < outline->count; k++) {
    if (fmpq_equal(outline->x + k, c->x.value) && fmpq_equal(outline->y + k, c->y.value)) return k;
  }
  return -1;
}

static void name_corner(char *text, size_t size, const tp_section *section, long vertex) {
  char x[80], y[80];
  tp_ratio_text(x, sizeof x, section->rings[0].x + vertex);
  tp_ratio_text(y, sizeof y, section->rings[0].y + vertex);
  snprintf(text, size, "(%.40s, %.40s)", x, y);
}

static tp_status locate(tp_corner *corner, const tp_corner_description *c, const long ends[2],
                        const tp_section *section, const tp_lattice *l, tp_message *message) {
  const long count = section->rings[0].count;
  const bool left = c->at == TP_CORNER_LEFT_END;
  if (c->at == TP_CORNER_VERTEX) {
    corner->vertex = find_vertex(section->rings, c);
  } else {
    corner->vertex = ends != NULL ? ends[left ? 0 : 1] : find_end(l, count, left);
  }
  if (corner->vertex < 0) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, c->place,
                     "the outline has no such vertex to round");
  }
  corner->before = (corner->vertex + count - 1) % count;
  corner->after = (corner->vertex + 1) % count;
  const int turns =
      tp_lattice_cross(l, corner->before, corner->vertex, corner->before, corner->after);
  if (turns > 0) return TP_OK;
  char name[100];
  name_corner(name, sizeof name, section, corner->vertex);
  return tp_refuse(message, TP_FAULT_GEOMETRY, c->place,
                   "the corner at %s is %s; only convex corners are rounded", name,
                   turns < 0 ? "reflex" : "straight");
}

/* Does a corner, with the one at the end `to` of its edge where that is rounded too, take up more
 * than the edge? */
static bool overlaps(const tp_corners *corners, const tp_corner *corner, long to,
                     const tp_lattice *l) {
  const tp_corner *other = tp_corners_at(corners, to);
  const int room =
      to == corner->after ? tp_tangents_room(corner, other, l) : tp_tangents_room(other, corner, l);
  return room < 0;
}

static tp_status check_fit(const tp_corners *corners, const tp_corner *corner,
                           const tp_section *section, const tp_lattice *l, tp_message *message) {
  const long ends[2] = {corner->before, corner->after};
  for (int k = 0; k < 2; k++) {
    if (!overlaps(corners, corner, ends[k], l)) continue;
    char name[100], edge[200];
    name_corner(name, sizeof name, section, corner->vertex);
    tp_rings_edge_text(edge, sizeof edge, section->rings, k == 0 ? corner->before : corner->vertex);
    return tp_refuse(message, TP_FAULT_GEOMETRY, corner->radius_place,
                     "the radius at %s is too large: rounding %s take up more than %s", name,
                     tp_corners_at(corners, ends[k]) != NULL ? "it and the next corner would"
                                                             : "it would",
                     edge);
  }
  return TP_OK;
}

/* Does a point that lies between the two edges of a corner lie in its tip: beyond the chord, and
 * not within a radius of the centre? */
static bool in_tip(const tp_corner_ball *c, const tp_lattice *l, long point, long bits) {
  tp_ball_point own;
  arb_t side, x, y;
  tp_ball_point_init(&own);
  arb_init(side);
  arb_init(x);
  arb_init(y);
  arb_set_fmpz(own.x, l->x + point);
  arb_set_fmpz(own.y, l->y + point);
  tp_ball_point_cross(side, &c->before, &c->after, &own, bits);
  arb_sub(x, c->centre.x, own.x, bits);
  arb_sub(y, c->centre.y, own.y, bits);
  arb_hypot(x, x, y, bits);
  const bool inside = arb_is_negative(side) && !arb_lt(x, c->radius);
  tp_ball_point_clear(&own);
  arb_clear(side);
  arb_clear(x);
  arb_clear(y);
  return inside;
}

/* A ring reaches into the tip of a vertex only with one of its points, from `first` on: an edge
 * cannot enter and leave it by its arc. */
static tp_status check_reach(const tp_corner_ball *c, const tp_corner *corner, long first,
                             const tp_section *section, const tp_lattice *l, tp_message *message) {
  bool reaches = false;
  for (long k = first; k < l->start[1 + section->hole_count] && !reaches; k++) {
    if (k == corner->vertex || k == corner->before || k == corner->after) continue;
    reaches = tp_lattice_cross(l, corner->vertex, corner->after, corner->vertex, k) >= 0 &&
              tp_lattice_cross(l, corner->before, corner->vertex, corner->before, k) >= 0 &&
              in_tip(c, l, k, BITS);
  }
  if (!reaches) return TP_OK;
  return tp_refuse(message, TP_FAULT_GEOMETRY, corner->radius_place, "%s reaches across this arc",
                   first == 0 ? "a hole, or another part of the outline," : "a hole");
}

static tp_status check_corner_reach(const tp_corner *corner, const tp_section *section,
                                    const tp_lattice *l, tp_message *message) {
  tp_corner_ball c;
  tp_corner_ball_init(&c);
  tp_corner_evaluate(&c, corner, l, BITS);
  const tp_status status = check_reach(&c, corner, 0, section, l, message);
  tp_corner_ball_clear(&c);
  return status;
}

tp_status tp_arcs_check(const tp_section *section, const tp_lattice *l,
                        const tp_block_description *block, const fmpq_t metres_per_unit,
                        tp_message *message) {
  if (block->part_count > 0) {
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, block->arcs[0].place,
        "a block with parts takes no arcs: it is not determined which part they bound");
  }
  tp_status status = TP_OK;
  tp_corner_ball c;
  tp_corner_ball_init(&c);
  for (long k = 0; k < section->arc_tips.count && status == TP_OK; k++) {
    const tp_arc_tip *tip = section->arc_tips.items + k;
    if (tip->inwards && block->hole_count > 0) {
      status = tp_refuse(message, TP_FAULT_GEOMETRY, block->arcs[0].place,
                         "a block with holes takes arcs outwards alone");
      break;
    }
    if (tip->inwards) continue;
    tp_arc_tip_evaluate(&c, tip, l, metres_per_unit, BITS);
    const long count = section->rings[0].count;
    const tp_corner corner = {.radius_place = block->arcs[0].place,
                              .vertex = tip->vertex,
                              .before = (tip->vertex + count - 1) % count,
                              .after = (tip->vertex + 1) % count};
    status = check_reach(&c, &corner, l->start[1], section, l, message);
  }
  tp_corner_ball_clear(&c);
  return status;
}

/* Add the corner of a description; one of radius zero is none. */
static tp_status add(tp_corners *corners, const tp_corner_description *description,
                     const long ends[2], const tp_section *section, const tp_lattice *l,
                     const fmpq_t metres_per_unit, tp_message *message) {
  tp_corner corner = {.radius_place = description->radius.place};
  const tp_status status = locate(&corner, description, ends, section, l, message);
  if (status != TP_OK || fmpq_is_zero(description->radius.value)) return status;
  for (long k = 0; k < corners->count; k++) {
    if (corners->items[k].vertex == corner.vertex) {
      return tp_refuse(message, TP_FAULT_KEY, description->place, "this corner is rounded twice");
    }
  }
  if (tp_section_is_arc(section, corner.before) || tp_section_is_arc(section, corner.vertex)) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, description->place,
                     "a corner where an arc ends is not rounded: let the arc run into the edge");
  }
  tp_corner *own = corners->items + corners->count++;
  *own = corner;
  fmpq_init(own->radius);
  fmpq_mul(own->radius, description->radius.value, metres_per_unit);
  fmpq_div(own->radius, own->radius, l->step_m);
  return TP_OK;
}

static int compare_vertices(const void *a, const void *b) {
  const tp_corner *one = a, *other = b;
  return one->vertex < other->vertex ? -1 : one->vertex > other->vertex;
}

tp_status tp_corners_init(tp_corners *corners, const tp_block_description *block,
                          const long ends[2], const tp_section *section, const tp_lattice *lattice,
                          const fmpq_t metres_per_unit, tp_message *message) {
  const tp_rounded_description *rounded = &block->rounded;
  *corners = (tp_corners){0};
  if (rounded->count <= 0) return TP_OK;
  corners->keeps_mass = rounded->keeps_mass;
  corners->items = calloc((size_t)rounded->count, sizeof *corners->items);
  if (corners->items == NULL) return tp_fail_memory(message, "the corners");
  tp_status status = TP_OK;
  for (long k = 0; k < rounded->count && status == TP_OK; k++) {
    status = add(corners, rounded->corners + k, ends, section, lattice, metres_per_unit, message);
  }
  qsort(corners->items, (size_t)corners->count, sizeof *corners->items, compare_vertices);
  for (long k = 0; k < corners->count && status == TP_OK; k++) {
    status = check_fit(corners, corners->items + k, section, lattice, message);
    if (status == TP_OK) status = check_corner_reach(corners->items + k, section, lattice, message);
  }
  if (status == TP_OK && corners->count > 0 && !corners->keeps_mass && block->part_count > 0) {
    status =
        tp_refuse(message, TP_FAULT_GEOMETRY, rounded->place,
                  "corners of a block with parts are rounded by 'model: paper' alone: it is not "
                  "determined which part would lose mass");
  }
  if (status != TP_OK) tp_corners_clear(corners);
  return status;
}
