/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Collects pairs without a gap, merges those seen from both sides, and sets up the laws of
 * acceleration and impact for them. */

#include "rigid_contact/touching.h"

#include "common/grow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Rows that differ by no more are those of one contact, seen from both sides. */
static const double alike_rows = 1e-12;

/* Three unit rows that span no more than this are in one plane. */
static const double pinned_volume = 1e-9;

/* What touches is no farther apart than this, along a face and across. */
static const double touching_reach = 2 * TP_FACE_SLACK;

/* A speed that is told from none. */
static const double told_speed = 2 * TP_NO_SPEED;

void tp_touching_clear(tp_touching *t) {
  free(t->items);
  free(t->law);
  free(t->of_law);
  free(t->can_stay);
  *t = (tp_touching){0};
}

static bool is_alike(const tp_touching_contact *a, const tp_touching_contact *b) {
  if (fabs(a->friction - b->friction) > alike_rows) return false;
  for (int e = 0; e < 3; e++) {
    if (fabs(a->gap.across[e] - b->gap.across[e]) > alike_rows ||
        fabs(a->gap.along[e] - b->gap.along[e]) > alike_rows) {
      return false;
    }
  }
  return true;
}

static bool make_room(tp_touching *t) {
  const long room = t->room;
  tp_touching_contact *items = tp_grow(t->items, t->count, &t->room, sizeof *items);
  if (items == NULL) return false;
  t->items = items;
  if (t->room == room) return true;
  tp_law_contact *law = realloc(t->law, sizeof *law * (size_t)t->room);
  if (law != NULL) t->law = law;
  long *of_law = realloc(t->of_law, sizeof *of_law * (size_t)t->room);
  if (of_law != NULL) t->of_law = of_law;
  long *can_stay = realloc(t->can_stay, sizeof *can_stay * (size_t)t->room);
  if (can_stay != NULL) t->can_stay = can_stay;
  if (law != NULL && of_law != NULL && can_stay != NULL) return true;
  t->room = room; /* all that every array is sure to have */
  return false;
}

/* Are these a corner of the block at the end of a face of the base, and that end of the base at the
 * end of a face of the block? The block may slip off either way, which no normal of one of the two
 * alone forbids: the corner on the face of the base stands for both. */
static bool is_corner_on_corner(const tp_touching_contact *a, const tp_touching_contact *b) {
  return a->pair.kind != b->pair.kind && a->gap.margin <= TP_FACE_SLACK &&
         b->gap.margin <= TP_FACE_SLACK &&
         hypot(a->gap.at.x - b->gap.at.x, a->gap.at.y - b->gap.at.y) <= TP_FACE_SLACK;
}

/* Faces of the base come first in the list of pairs. */
static bool add(tp_touching *t, const tp_touching_contact *own) {
  for (long k = 0; k < t->count; k++) {
    if (is_alike(t->items + k, own) || is_corner_on_corner(t->items + k, own)) return true;
  }
  if (!make_room(t)) return false;
  t->items[t->count++] = *own;
  return true;
}

bool tp_touching_collect(tp_touching *t, tp_contact_system *system, const tp_motion_state *state) {
  const tp_turned_block block = tp_turned_block_at(state);
  t->count = 0;
  t->can_stay_count = -1;
  tp_contact_system_near(system, state, touching_reach);
  for (long k = 0; k < system->near_count; k++) {
    tp_gap_pair *pair = system->pairs + system->near[k];
    pair->touching = false;
    if (!tp_gap_in_reach(&system->shapes, pair, &block, touching_reach)) continue;
    tp_touching_contact own = {.pair = *pair, .gap = tp_gap_at(&system->shapes, pair, state)};
    const double width = own.gap.width;
    pair->touching =
        width >= -TP_DEEPEST_GAP && width <= 2 * TP_CLOSED_GAP && tp_gap_faces(&own.gap);
    if (!pair->touching) continue;
    own.friction = tp_contact_friction(&own.facet, system, &own.gap);
    own.approach = tp_gap_speed(own.gap.across, state->speed);
    own.slip = tp_gap_speed(own.gap.along, state->speed);
    if (!add(t, &own)) return false;
  }
  return true;
}

void tp_touching_open(tp_contact_system *system, const tp_motion_state *state) {
  tp_contact_system_near(system, state, 0);
  for (long k = 0; k < system->near_count; k++) {
    tp_gap_pair *pair = system->pairs + system->near[k];
    if (!pair->touching) continue;
    pair->touching = tp_gap_at(&system->shapes, pair, state).width <= 2 * TP_CLOSED_GAP;
  }
}

bool tp_touching_closes(const tp_touching *t) {
  for (long k = 0; k < t->count; k++) {
    if (t->items[k].approach < -told_speed) return true;
  }
  return false;
}

static tp_law begin_law(tp_touching *t, const tp_contact_system *system) {
  tp_law law = {.contacts = t->law};
  memcpy(law.inertia, system->inertia, sizeof law.inertia);
  t->law_count = 0;
  return law;
}

static tp_law_contact *add_to_law(tp_touching *t, long contact) {
  const tp_touching_contact *own = t->items + contact;
  tp_law_contact *added = t->law + t->law_count;
  t->of_law[t->law_count++] = contact;
  *added = (tp_law_contact){.friction = own->friction};
  memcpy(added->across, own->gap.across, sizeof added->across);
  memcpy(added->along, own->gap.along, sizeof added->along);
  return added;
}

tp_law tp_touching_accelerations(tp_touching *t, const tp_contact_system *system, double time) {
  tp_law law = begin_law(t, system);
  tp_contact_system_free(law.free, system, time);
  for (long k = 0; k < t->count; k++) {
    const tp_touching_contact *own = t->items + k;
    if (own->approach > told_speed) continue;
    tp_law_contact *added = add_to_law(t, k);
    added->least = -own->gap.across_rate;
    added->rest = -own->gap.along_rate;
    added->slip = own->slip > told_speed ? 1 : own->slip < -told_speed ? -1 : 0;
  }
  law.count = t->law_count;
  return law;
}

tp_law tp_touching_impact(tp_touching *t, const tp_contact_system *system,
                          const tp_motion_state *state, double restitution) {
  tp_law law = begin_law(t, system);
  memcpy(law.free, state->speed, sizeof law.free);
  for (long k = 0; k < t->count; k++) {
    tp_law_contact *added = add_to_law(t, k);
    added->least = fmax(0, -restitution * t->items[k].approach);
  }
  law.count = t->law_count;
  return law;
}

/* Is the slip of an edge's contact none because of what other contacts forbid: is its row along a
 * combination of theirs across? Of two contacts alone, at one place; of three, always. */
static bool is_pinned(const tp_law *law, const tp_law_solution *s, const tp_law_contact *own) {
  if (own->slip != 0 || s->count < 2) return own->friction == 0;
  if (s->count == 3) return true;
  double across[3];
  tp_double_cross(across, law->contacts[s->edges[0].contact].across,
                  law->contacts[s->edges[1].contact].across);
  const double volume = tp_double_dot(own->along, across);
  return fabs(volume) <= pinned_volume || own->friction == 0;
}

void tp_touching_set_smooth(tp_smooth *smooth, const tp_touching *t, const tp_law *law,
                            const tp_law_solution *solution) {
  smooth->count = 0;
  for (int k = 0; k < solution->count; k++) {
    const tp_law_edge *edge = solution->edges + k;
    const tp_law_contact *own = law->contacts + edge->contact;
    const tp_touching_contact *contact = t->items + t->of_law[edge->contact];
    if (k > 0 && edge->contact == edge[-1].contact) {
      smooth->pressing[smooth->count - 1].sticks = true;
      continue;
    }
    smooth->pressing[smooth->count++] = (tp_pressing){.pair = contact->pair,
                                                      .friction = contact->friction,
                                                      .facet = contact->facet,
                                                      .side = edge->side,
                                                      .pinned = is_pinned(law, solution, own)};
  }
}
