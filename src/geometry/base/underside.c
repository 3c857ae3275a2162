/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Ends of the mated contact on the outline by exact comparisons: supporting lines at 45 degrees,
 * corners below an overhang, or the two points that a scene names. */

#include "base/underside.h"

#include "number/word.h"

/* The rightmost vertex, the lowest of them. */
static long rightmost(const tp_polyline *line) {
  long best = 0;
  for (long k = 1; k < line->count; k++) {
    const int side = tp_word_order(line->x + k, line->x + best);
    if (side > 0 || (side == 0 && tp_word_order(line->y + k, line->y + best) < 0)) best = k;
  }
  return best;
}

static long next_vertex(const tp_polyline *line, long k) {
  return k + 1 == line->count ? 0 : k + 1;
}

static long vertex_before(const tp_polyline *line, long k) {
  return (k == 0 ? line->count : k) - 1;
}

/* The last vertex of the chain, from its lower end up, from which on the rest rises by more than it
 * runs to every point: the largest x - y (`right`), or the smallest x + y. */
static long support(const tp_polyline *line, long first, long last, bool right) {
  long best = right ? first : last;
  fmpq_t most, own;
  fmpq_init(most);
  fmpq_init(own);
  for (long k = best, end = right ? last : first, seen = 0;; seen++) {
    if (right) {
      fmpq_sub(own, line->x + k, line->y + k);
    } else {
      fmpq_add(own, line->x + k, line->y + k);
      fmpq_neg(own, own);
    }
    const int side = seen == 0 ? 1 : tp_word_order(own, most);
    if (side >= 0) { /* of those alike, the one furthest out: on a line at 45 degrees, the later */
      const int out = side > 0 ? 1 : tp_word_order(line->x + k, line->x + best);
      if (side > 0 || (right ? out > 0 : out < 0)) best = k;
      if (side > 0) fmpq_swap(most, own);
    }
    if (k == end) break;
    k = right ? next_vertex(line, k) : vertex_before(line, k);
  }
  fmpq_clear(most);
  fmpq_clear(own);
  return best;
}

/* The lowest vertex of the chain, of several the one furthest to that side. */
static long lowest(const tp_polyline *line, long first, long last, bool right) {
  long best = first;
  for (long k = first; k != last;) {
    k = next_vertex(line, k);
    const int side = tp_word_order(line->y + k, line->y + best);
    const int out = side == 0 ? tp_word_order(line->x + k, line->x + best) : 0;
    if (side < 0 || (right ? out > 0 : out < 0)) best = k;
  }
  return best;
}

/* How far in an edge between two vertices reaches, where it passes below the vertex `under`, whose
 * upright end face would cut it; NULL where it does not. */
static const fmpq *blocks(const tp_polyline *line, long from, long to, long under, bool right) {
  const fmpq *x = line->x + under, *x0 = line->x + from, *x1 = line->x + to;
  const bool upwards = tp_word_order(x0, x1) < 0;
  const fmpq *low = upwards ? x0 : x1, *high = upwards ? x1 : x0;
  if (tp_word_order(low, x) > 0 || tp_word_order(high, x) < 0 || fmpq_equal(low, high)) return NULL;
  const int side = tp_polyline_turn(line, from, to, under);
  if (upwards ? side <= 0 : side >= 0) return NULL;
  return right ? low : high;
}

static long outwards(const tp_polyline *line, long k, bool right) {
  return right ? next_vertex(line, k) : vertex_before(line, k);
}

/* From the vertex k back towards `from`: the last corner before `reach`. A vertex on a straight
 * edge is none, or the contact would depend on how many pieces an edge is given in. */
static long corner_before(const tp_polyline *line, long k, long from, const fmpq *reach,
                          bool right) {
  while (k != from) {
    const int out = tp_word_order(line->x + k, reach);
    const bool clear = right ? out < 0 : out > 0;
    if (clear && tp_polyline_turn(line, vertex_before(line, k), k, next_vertex(line, k)) != 0)
      break;
    k = outwards(line, k, !right);
  }
  return k;
}

/* From the lowest vertex out to `end`: the vertex before the first edge that runs back. Where the
 * block then passes below that vertex, it is the last corner before all that does: what passes
 * below comes in from there without a gap, so that one walk sees each edge that is still in the
 * way; of the edge that runs back only the turn tells whether it does so below. */
static long before_overhang(const tp_polyline *line, long from, long end, bool right) {
  long k = from;
  while (k != end) {
    const int side = tp_word_order(line->x + outwards(line, k, right), line->x + k);
    if (right ? side < 0 : side > 0) break;
    k = outwards(line, k, right);
  }
  if (k == end || k == from) return k;
  const long next = outwards(line, k, right);
  const int turn = tp_polyline_turn(line, outwards(line, k, !right), k, next);
  if (right ? turn < 0 : turn > 0) k = corner_before(line, k, from, line->x + next, right);
  for (long j = next; j != from && k != from; j = outwards(line, j, right)) {
    const fmpq *reach = blocks(line, j, outwards(line, j, right), k, right);
    if (reach != NULL) k = corner_before(line, k, from, reach, right);
  }
  return k;
}

/* The default. */
static void cut(tp_underside *u, const tp_polyline *line) {
  const long first = support(line, u->first, u->last, false);
  const long last = support(line, u->first, u->last, true);
  if (first == last) {
    u->none = "is steeper than 45° from the mean plane all over";
    return;
  }
  const long from = before_overhang(line, lowest(line, first, last, false), first, false);
  const long to = before_overhang(line, lowest(line, first, last, true), last, true);
  u->left = from != first ? TP_END_OVERHANG : first != u->first ? TP_END_STEEP : TP_END_WHOLE;
  u->right = to != last ? TP_END_OVERHANG : last != u->last ? TP_END_STEEP : TP_END_WHOLE;
  u->first = from;
  u->last = to;
}

tp_status tp_underside_fail(const char *none, const tp_scene *scene, tp_message *message) {
  const tp_place place = scene->base.place.file != NULL ? scene->base.place : scene->block.place;
  return tp_refuse(
      message, TP_FAULT_GEOMETRY, place,
      "the underside %s, and the scene does not say where on it the block rests: say "
      "'base: {mated: true, between: [[x, y], [x, y]]}' with the first and the last "
      "vertex of the contact, 'mated: whole' for all of the underside, or 'frame: world' "
      "for coordinates as they lie on a slope",
      none);
}

static bool allowed(const tp_base_description *base, const tp_polyline *line, long k) {
  return !((base->below.given && tp_word_order(line->y + k, base->below.value) > 0) ||
           (base->left_of.given && tp_word_order(line->x + k, base->left_of.value) > 0) ||
           (base->right_of.given && tp_word_order(line->x + k, base->right_of.value) < 0));
}

/* The stretch of the underside about its lowest vertex that the scene's limits allow; on a side
 * that they leave open the default holds. */
static tp_status limit(tp_underside *u, const tp_base_description *base, const tp_polyline *line,
                       tp_message *message) {
  const tp_underside whole = *u;
  const bool left = base->below.given || base->right_of.given;
  const bool right = base->below.given || base->left_of.given;
  if (!left || !right) cut(u, line);
  if (left) u->first = whole.first;
  if (right) u->last = whole.last;
  long from = -1;
  for (long k = u->first;; k = next_vertex(line, k)) {
    if (allowed(base, line, k) && (from < 0 || tp_word_order(line->y + k, line->y + from) < 0))
      from = k;
    if (k == u->last) break;
  }
  long first = from, last = from;
  while (from >= 0 && first != u->first && allowed(base, line, vertex_before(line, first))) {
    first = vertex_before(line, first);
  }
  while (from >= 0 && last != u->last && allowed(base, line, next_vertex(line, last))) {
    last = next_vertex(line, last);
  }
  if (first == last) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, base->between_place,
                     "no edge of the underside lies within 'between': its ends are vertices, and "
                     "'below', 'left_of' and 'right_of' must leave two of them next to each other");
  }
  if (left) u->left = first != whole.first ? TP_END_STATED : TP_END_WHOLE;
  if (right) u->right = last != whole.last ? TP_END_STATED : TP_END_WHOLE;
  u->first = first;
  u->last = last;
  u->stated = true;
  return TP_OK;
}

static tp_status find_vertex(long *vertex, const tp_polyline *outline, const tp_polyline *between,
                             long k, tp_message *message) {
  for (*vertex = 0; *vertex < outline->count; ++*vertex) {
    if (fmpq_equal(outline->x + *vertex, between->x + k) &&
        fmpq_equal(outline->y + *vertex, between->y + k)) {
      return TP_OK;
    }
  }
  return tp_refuse(
      message, TP_FAULT_GEOMETRY, tp_polyline_place(between, k),
      "this is not a vertex of the outline; 'between' names two of its vertices exactly");
}

static tp_status find_named(tp_underside *u, const tp_polyline *line, const tp_polyline *between,
                            tp_message *message) {
  *u = (tp_underside){.left = TP_END_STATED, .right = TP_END_STATED, .stated = true};
  tp_status status = find_vertex(&u->first, line, between, 0, message);
  if (status == TP_OK) status = find_vertex(&u->last, line, between, 1, message);
  if (status == TP_OK && u->first == u->last) {
    status = tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(between, 1),
                       "the contact begins and ends in the same vertex");
  }
  if (status == TP_OK && tp_word_order(line->x + u->first, line->x + u->last) > 0) {
    status = tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(between, 0),
                       "'between' names the left end of the contact first");
  }
  return status;
}

tp_status tp_underside_find(tp_underside *u, const tp_scene *scene, const tp_section *section,
                            tp_message *message) {
  const tp_base_description *base = &scene->base;
  const tp_polyline *line = section->rings;
  if (base->between.count == 2) return find_named(u, line, &base->between, message);
  *u = (tp_underside){.left = TP_END_WHOLE, .right = TP_END_WHOLE};
  if (section->ellipse != NULL) { /* the flat: from the last vertex of the hull to the first */
    u->first = line->count - 1;
    return TP_OK;
  }
  u->first = tp_polyline_leftmost(line);
  u->last = rightmost(line);
  if (base->below.given || base->left_of.given || base->right_of.given) {
    return limit(u, base, line, message);
  }
  /* teeth and slabs have no walls that lean out */
  if (!base->whole && scene->block.form == TP_OUTLINE_VERTICES) {
    cut(u, line);
    if (u->first == u->last) u->none = "turns back over its base beside its lowest vertex";
  }
  return TP_OK;
}
