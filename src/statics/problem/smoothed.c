/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Finds the stretches of short facets along the underside, moves their vertices onto a line by
 * exact sums, and leaves out those between its ends. */

#include "problem/smoothed.h"

#include "base/mean_plane.h"
#include "base/underside.h"
#include "problem/as_given.h"
#include "problem/with_outline.h"

#include <stdlib.h>

bool tp_smoothed_is_asked(const tp_scene *scene) {
  const tp_outline_form form = scene->block.form;
  if (scene->friction_is_apparent) return form == TP_OUTLINE_VERTICES || form == TP_OUTLINE_TEETH;
  return scene->base.smooth.given;
}

static tp_place asked_at(const tp_scene *scene) {
  return scene->base.smooth.given ? scene->base.smooth.place : scene->friction_is_place;
}

static tp_status check_form(const tp_scene *scene, tp_message *message) {
  const tp_block_description *block = &scene->block;
  const bool apparent = scene->friction_is_apparent;
  if (!scene->base.mated) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, asked_at(scene),
                     apparent ? "an apparent friction angle holds on the mean plane of a mated "
                                "base; on a 'profile' its facets would add to it: give the basic "
                                "angle, 'friction_is: basic'"
                              : "'smooth' levels a sole and the base that is mated with it; smooth "
                                "a 'profile' and the block on it where they were measured");
  }
  if (block->form != TP_OUTLINE_VERTICES) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, asked_at(scene),
                     apparent
                         ? "teeth would add to an apparent friction angle: give the basic angle, "
                           "'friction_is: basic', or the block as a 'slab'"
                         : "'smooth' is for the sole of an 'outline'; those of other forms are "
                           "as smooth as they are given");
  }
  if (block->arc_count > 0 || block->rounded.count > 0) {
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, asked_at(scene),
        "levelling a sole is for straight edges, without 'arcs' and 'rounded' corners; "
        "'arc_tolerance' of the block makes chords of its arcs");
  }
  if (scene->friction.facet_count > 0) {
    return tp_refuse(
        message, TP_FAULT_KEY, asked_at(scene),
        "facets that are levelled cannot have a friction angle of their own; leave out "
        "'friction.facets', or draw the sole as smooth as it is to be");
  }
  return TP_OK;
}

/* ---- one stretch -------------------------------------------------------------------------------
 */

/* Vertices of the ring, counter-clockwise from the first to the last; both ends of the contact. */
typedef struct sole {
  const tp_polyline *ring;
  tp_polyline *now;
  bool *dropped;
  long first, last;
  bool stated; /* by 'between' */
} sole;

static long next_of(const sole *s, long k) {
  return k + 1 == s->ring->count ? 0 : k + 1;
}

static bool is_short(const sole *s, long k, const tp_scene *scene) {
  const tp_polyline *r = s->ring;
  const long n = next_of(s, k);
  fmpq_t run, dx, u, most;
  if (scene->friction_is_apparent) return true;
  fmpq_init(run);
  fmpq_init(dx);
  fmpq_init(u);
  fmpq_init(most);
  const fmpq *const axes[] = {r->x, r->y};
  for (int axis = 0; axis < 2; axis++) {
    fmpq_sub(dx, axes[axis] + n, axes[axis] + k);
    fmpq_sub(u, axes[axis] + s->last, axes[axis] + s->first);
    fmpq_addmul(run, dx, u);
    fmpq_addmul(most, u, u);
  }
  fmpq_mul(run, run, run); /* times the length between the ends */
  fmpq_mul(u, scene->base.smooth.value, scene->base.smooth.value);
  fmpq_mul(most, most, u);
  const bool result = fmpq_cmp(run, most) < 0;
  fmpq_clear(run);
  fmpq_clear(dx);
  fmpq_clear(u);
  fmpq_clear(most);
  return result;
}

/* y = slope x + offset. */
typedef struct line {
  fmpq_t slope, offset;
} line;

static void through_ends(line *l, const sole *s, long from, long to) {
  const tp_polyline *r = s->ring;
  fmpq_sub(l->slope, r->y + to, r->y + from);
  fmpq_sub(l->offset, r->x + to, r->x + from);
  fmpq_div(l->slope, l->slope, l->offset);
  fmpq_mul(l->offset, l->slope, r->x + from);
  fmpq_sub(l->offset, r->y + from, l->offset);
}

/* Along the mean plane, with the area below the stretch as it is. */
static bool along_mean_plane(line *l, const sole *s, const tp_scene *scene) {
  const tp_polyline *r = s->ring, *plane = &scene->mean_plane;
  fmpq_t u, v, sum, dx;
  fmpq_init(u);
  fmpq_init(v);
  fmpq_init(sum);
  fmpq_init(dx);
  bool known = true;
  fmpq_one(u);
  if (plane->count == 2) {
    fmpq_sub(u, plane->x + 1, plane->x);
    fmpq_sub(v, plane->y + 1, plane->y);
  } else if (scene->frame == TP_FRAME_WORLD) {
    known = tp_mean_plane_of_outline(u, v, r, s->first, s->last) && fmpq_sgn(u) > 0;
  }
  if (known) fmpq_div(l->slope, v, u);
  for (long k = s->first; k != s->last && known; k = next_of(s, k)) {
    const long n = next_of(s, k);
    fmpq_sub(dx, r->x + n, r->x + k);
    fmpq_add(u, r->x + n, r->x + k);
    fmpq_mul(u, u, l->slope);
    fmpq_add(v, r->y + n, r->y + k);
    fmpq_sub(v, v, u);
    fmpq_addmul(sum, v, dx);
  }
  fmpq_sub(dx, r->x + s->last, r->x + s->first);
  fmpq_div(l->offset, sum, dx);
  fmpq_div_2exp(l->offset, l->offset, 1);
  fmpq_clear(u);
  fmpq_clear(v);
  fmpq_clear(sum);
  fmpq_clear(dx);
  return known;
}

/* Is the mean line of a contact that is levelled along x off it by more than 1 in 100? */
static void note_incline(tp_smoothed *own, const sole *s, const tp_scene *scene) {
  fmpq_t u, v;
  if (scene->frame == TP_FRAME_WORLD) return;
  fmpq_init(u);
  fmpq_init(v);
  if (tp_mean_plane_of_outline(u, v, s->ring, s->first, s->last) && fmpq_sgn(u) > 0) {
    fmpq_div(own->incline, v, u);
    fmpq_abs(u, own->incline);
    fmpq_set_si(v, 1, 100);
    own->inclined = fmpq_cmp(u, v) > 0;
  }
  fmpq_clear(u);
  fmpq_clear(v);
}

static void put_on(tp_smoothed *own, const sole *s, long k, const line *l) {
  fmpq_t moved;
  fmpq_init(moved);
  fmpq_set(moved, l->offset);
  fmpq_addmul(moved, l->slope, s->ring->x + k);
  fmpq_set(s->now->y + k, moved);
  fmpq_sub(moved, moved, s->ring->y + k);
  fmpq_abs(moved, moved);
  if (fmpq_cmp(moved, own->farthest) > 0) fmpq_set(own->farthest, moved);
  fmpq_clear(moved);
}

static bool runs_right(const sole *s, long from, long to) {
  for (long k = from; k != to; k = next_of(s, k)) {
    if (fmpq_cmp(s->ring->x + next_of(s, k), s->ring->x + k) <= 0) return false;
  }
  return true;
}

static tp_status level(tp_smoothed *own, const sole *s, const tp_scene *scene, long from, long to,
                       tp_message *message) {
  const bool whole = from == s->first && to == s->last;
  line l;
  if (!runs_right(s, from, to)) {
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, tp_polyline_place(s->ring, from),
        "the sole from vertex %ld to vertex %ld is to be levelled, and a facet of it is "
        "upright or runs back; draw that part as smooth as it is to be",
        tp_polyline_number(s->ring, from), tp_polyline_number(s->ring, to));
  }
  fmpq_init(l.slope);
  fmpq_init(l.offset);
  bool known = true;
  if (whole) {
    known = along_mean_plane(&l, s, scene);
    note_incline(own, s, scene);
  } else {
    through_ends(&l, s, from, to);
  }
  for (long k = from; known; k = next_of(s, k)) {
    if (k != from) own->levelled++;
    if (k != from && k != to) s->dropped[k] = true;
    if (whole || s->dropped[k]) put_on(own, s, k, &l);
    if (k == to) break;
  }
  own->stretches++;
  fmpq_clear(l.slope);
  fmpq_clear(l.offset);
  if (known) return TP_OK;
  return tp_refuse(message, TP_FAULT_GEOMETRY, scene->frame_place,
                   "the contact defines no mean plane that runs from left to right; give it: "
                   "'frame: {mean_plane: [[x, y], [x, y]]}'");
}

/* ---- all of them -------------------------------------------------------------------------------
 */

static tp_status level_all(tp_smoothed *own, const sole *s, const tp_scene *scene,
                           tp_message *message) {
  tp_status status = TP_OK;
  for (long k = s->first; k != s->last && status == TP_OK;) {
    long to = k;
    while (to != s->last && is_short(s, to, scene)) to = next_of(s, to);
    if (to != k && to != next_of(s, k)) status = level(own, s, scene, k, to, message);
    k = to != k ? to : next_of(s, k);
  }
  return status;
}

/* The outline without what was left out. */
static bool put_outline(tp_scene *scene, const sole *s) {
  tp_polyline *outline = &scene->block.outline;
  const tp_polyline *now = s->now;
  bool done = true;
  outline->file = now->file;
  outline->mark = now->mark;
  outline->reversed = now->reversed;
  for (long k = 0; k < now->count && done; k++) {
    if (!s->dropped[k]) done = tp_polyline_append(outline, now->x + k, now->y + k, now->marks[k]);
  }
  return done;
}

static bool is_end(const tp_polyline *ring, long k, const sole *s, long end) {
  return fmpq_equal(ring->x + k, s->now->x + end) && fmpq_equal(ring->y + k, s->now->y + end);
}

/* The ends of the contact by name, where they were so given, or would not be found again. */
static bool put_ends(tp_scene *scene, const sole *s) {
  tp_polyline *between = &scene->base.between;
  tp_section section;
  tp_underside u;
  tp_message message;
  if (!s->stated && tp_section_init(&section, &scene->block, &message) == TP_OK) {
    const bool found = tp_underside_find(&u, scene, &section, &message) == TP_OK &&
                       u.none == NULL && is_end(section.rings, u.first, s, s->first) &&
                       is_end(section.rings, u.last, s, s->last);
    tp_section_clear(&section);
    if (found) return true;
  }
  const tp_polyline *now = s->now;
  between->file = now->file;
  between->mark = now->mark;
  scene->base.whole = false;
  return tp_polyline_append(between, now->x + s->first, now->y + s->first, now->marks[s->first]) &&
         tp_polyline_append(between, now->x + s->last, now->y + s->last, now->marks[s->last]);
}

static bool move(tp_smoothed *own, const tp_scene *scene, const tp_section *section,
                 const sole *s) {
  const tp_moved_outline context = {s->ring, s->now};
  const tp_point_map map = {tp_move_with_outline, &context}, stay = {NULL, NULL};
  const tp_polyline none = {0};
  fmpq_t turn;
  fmpq_init(turn);
  own->scene.block.form = TP_OUTLINE_VERTICES;
  const bool done = tp_moved_rings(&own->scene, scene, &none, section->rings + 1, &map) &&
                    tp_moved_block(&own->scene, scene, turn, &map) &&
                    tp_moved_profile(&own->scene, scene, &stay) && put_outline(&own->scene, s) &&
                    put_ends(&own->scene, s);
  fmpq_clear(turn);
  return done;
}

static tp_status find_ends(sole *s, const tp_scene *scene, const tp_section *section,
                           tp_message *message) {
  tp_underside u;
  tp_lattice lattice;
  tp_status status = tp_as_given_check(&lattice, scene, section, NULL, message);
  if (status != TP_OK) return status;
  tp_lattice_clear(&lattice);
  status = tp_underside_find(&u, scene, section, message);
  if (status == TP_OK && u.none != NULL) status = tp_underside_fail(u.none, scene, message);
  s->first = u.first;
  s->last = u.last;
  s->stated = u.stated;
  return status;
}

static tp_status fill(tp_smoothed *own, const tp_scene *scene, const tp_section *section,
                      tp_message *message) {
  tp_polyline now = {0};
  sole s = {.ring = section->rings, .now = &now};
  tp_status status = find_ends(&s, scene, section, message);
  if (status != TP_OK) return status;
  s.dropped = calloc((size_t)s.ring->count, sizeof *s.dropped);
  if (s.dropped == NULL || !tp_polyline_copy(&now, s.ring)) {
    status = tp_fail_memory(message, "the levelled sole");
  }
  if (status == TP_OK) status = level_all(own, &s, scene, message);
  if (status == TP_OK && !move(own, scene, section, &s)) {
    status = tp_fail_memory(message, "the levelled sole");
  }
  free(s.dropped);
  tp_polyline_clear(&now);
  return status;
}

void tp_smoothed_free(tp_smoothed *own) {
  if (own == NULL) return;
  tp_moved_clear(&own->scene);
  fmpq_clear(own->farthest);
  fmpq_clear(own->incline);
  free(own);
}

tp_status tp_smoothed_init(tp_smoothed **smoothed, const tp_scene *scene, tp_message *message) {
  tp_section section;
  tp_status status = check_form(scene, message);
  if (status == TP_OK) status = tp_section_init(&section, &scene->block, message);
  if (status != TP_OK) return status;
  tp_smoothed *own = calloc(1, sizeof *own);
  if (own == NULL) {
    status = tp_fail_memory(message, "the levelled sole");
  } else {
    tp_moved_begin(&own->scene, scene);
    fmpq_init(own->farthest);
    fmpq_init(own->incline);
    own->all = scene->friction_is_apparent;
    status = fill(own, scene, &section, message);
  }
  tp_section_clear(&section);
  if (status == TP_OK) {
    *smoothed = own;
  } else {
    tp_smoothed_free(own);
  }
  return status;
}
